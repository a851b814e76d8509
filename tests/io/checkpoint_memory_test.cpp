// SPDX-License-Identifier: MIT
#include <sspql/io/checkpoint.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <string>

#include "counting_new.hpp"
#include "io/checkpoint_testing.hpp"
#include "io/file_testing.hpp"

#include <sspql/core/random.hpp>
#include <sspql/learn/q_learning.hpp>
#include <sspql/spaces/hashed_state.hpp>

using namespace sspql;
using namespace sspql::testing;

namespace {

/// Loads `bytes` with lengths that are lies, damaged or with the checksums set right.
template <class T>
void expect_modest(const std::string& bytes, const T& like) {
    const std::size_t most = std::max(std::size_t{1} << 20, 2 * bytes.size());
    Random random(1);
    std::size_t refused = 0;
    for (int k = 0; k < 4000; ++k) {
        std::string forged = bytes;
        const std::uint64_t lie = std::uint64_t{1} << (8 + random.below(55));
        const std::size_t at = 20 + random.below(bytes.size() - 28);
        std::memcpy(forged.data() + at, &lie, sizeof lie);
        for (const bool right : {false, true}) {
            if (right) forged = with_checksums(forged);
            if (forged.empty()) break;
            T target = like;
            sspql_test::largest_allocation = 0;
            const std::string error = error_of<std::runtime_error>([&] { load_from_bytes(forged, target); });
            ASSERT_LE(sspql_test::largest_allocation, most) << "bytes " << at << " on set to " << lie << ": " << error;
            ASSERT_EQ(error.rfind("another type", 0), std::string::npos) << error;
            refused += error != "no error" ? 1u : 0u;
        }
    }
    EXPECT_GT(refused, 4000u);
}

template <class L>
std::string story(L learner) {
    Story story(1, 8);
    story.go_on(learner, 200);
    return save_to_bytes(learner);
}

}  // namespace

/// A forged length must not make a robot's memory run out.
TEST(CheckpointMemory, NoAllocationIsLargerThanTheFileExplains) {
    expect_modest(story(Sspql<>(StateCount::growing(), 2)), Sspql<>(StateCount::growing(), 2));
    expect_modest(story(AdaptiveSspql<>(StateCount::growing(), 2)), AdaptiveSspql<>(StateCount::growing(), 2));
    Agent agent(HashedState<std::string>{}, sspql::testing::TwoCommands{}, QLearningParams<>{});
    static_cast<void>(agent.begin(std::string("kitchen")));
    static_cast<void>(agent.step(0.0, std::string("hall")));
    expect_modest(save_to_bytes(agent), agent);
}

/// Saving asks for no more than its buffers, whatever there is to save.
TEST(CheckpointMemory, SavingTakesBuffersOnly) {
    const Sspql<> learner(100000, 4);
    struct Counting {
        std::size_t bytes = 0;
        void write(const void*, std::size_t n) { bytes += n; }
    } sink;
    sspql_test::largest_allocation = 0;
    detail::write_checkpoint(sink, learner, detail::NoUserData{});
    EXPECT_GT(sink.bytes, 5000000u);
    EXPECT_LE(sspql_test::largest_allocation, std::size_t{1} << 17);
}
