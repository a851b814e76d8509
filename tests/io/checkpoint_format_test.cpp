// SPDX-License-Identifier: MIT
#include <sspql/io/checkpoint.hpp>

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "io/checkpoint_testing.hpp"
#include "io/file_testing.hpp"

#include <sspql/learn/dyna_q.hpp>
#include <sspql/learn/dyna_q_plus.hpp>
#include <sspql/learn/prioritized_sweeping.hpp>
#include <sspql/learn/q_learning.hpp>
#include <sspql/learn/r_max.hpp>
#include <sspql/learn/rtdp.hpp>
#include <sspql/learn/sarsa.hpp>
#include <sspql/spaces/hashed_state.hpp>

using namespace sspql;
using namespace sspql::testing;

namespace {

std::string data(const std::string& name) {
    return (std::filesystem::path(__FILE__).parent_path() / "data" / "format-1" / (name + ".sspql")).string();
}

/// Loads a file that an earlier version wrote. While its format is the current one it is also written as it was.
template <class T>
T loaded(const std::string& name, T object) {
    load(data(name), object);
    EXPECT_EQ(detail::checkpoint_format, 1u) << "these files are of an older format now: drop the next line";
    EXPECT_EQ(save_to_bytes(object), content(data(name))) << name;
    return object;
}

}  // namespace

/// The promise: what format 1 holds stays readable. The files are never written anew.
TEST(CheckpointFormat, FilesOfFormat1AreRead) {
    EXPECT_EQ(loaded("q-learning", QLearning<>(3, 2)).visits()(state_id(1), action_id(1)), 11u);
    loaded("sarsa", Sarsa<>(3, 2));
    loaded("rtdp", Rtdp<>(3, 2));
    loaded("dyna-q", DynaQ<>(3, 2));
    loaded("dyna-q-plus", DynaQPlus<>(3, 2));
    loaded("prioritized-sweeping", PrioritizedSweeping<>(3, 2));
    loaded("r-max", RMax<>(3, 9));
    EXPECT_EQ(loaded("sspql", Sspql<>(3, 2)).counts().pairs(), 6u);
    EXPECT_EQ(loaded("sspql-instalments", Sspql<>(3, 2)).params().path_budget, 3u);
    EXPECT_TRUE(loaded("adaptive", AdaptiveSspql<>(3, 2)).scale().goal_known());
    EXPECT_EQ(loaded("adaptive-chore", AdaptiveSspql<>(3, 2)).params().slice, 2u);
    const auto agent = loaded("agent", Agent(HashedState<std::string>{}, TwoCommands{}, QLearningParams<>{}));
    EXPECT_EQ(agent.states().key(state_id(1)), "hall");
}

/// The header, byte by byte, as docs/checkpoint-format.md has it.
TEST(CheckpointFormat, Header) {
    const std::string bytes = save_to_bytes(QLearning<>(1, 1));
    EXPECT_EQ(bytes.substr(0, 8), std::string("\xF3SSPQ\r\n\x1A", 8));
    EXPECT_EQ(bytes.substr(8, 4), std::string("\1\0\0\0", 4));
    EXPECT_EQ(bytes.substr(20, 16), std::string("type\0\0\0\0\0\0\0\0\0\0\0\0", 16));
    const std::string end = bytes.substr(bytes.size() - 24);
    EXPECT_EQ(end.substr(0, 20), std::string("end\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0", 20));
}
