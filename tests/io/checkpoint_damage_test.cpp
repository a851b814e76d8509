// SPDX-License-Identifier: MIT
#include <sspql/io/checkpoint.hpp>

#include <gtest/gtest.h>

#include <cstddef>
#include <string>

#include "io/checkpoint_testing.hpp"
#include "io/file_testing.hpp"

#include <sspql/core/random.hpp>

using namespace sspql;
using namespace sspql::testing;

namespace {

/// Loads damaged bytes and checks that they are refused, with the name of a section.
template <class L>
void expect_refused(const std::string& bytes, L& target, const std::string& what) {
    const std::string error = error_of<std::runtime_error>([&] { load_from_bytes(bytes, target); });
    ASSERT_TRUE(error.find("section '") != std::string::npos || error.find("after its end") != std::string::npos)
        << what << ": " << error;
}

template <class L>
void expect_all_damage_refused(std::size_t states, std::size_t actions) {
    L saved(states, actions, {}, 1);
    Story story(1, states);
    story.go_on(saved, 40);
    const std::string bytes = save_to_bytes(saved);
    L target(states, actions, {}, 2);
    Story other(2, states);
    other.go_on(target, 25);
    const std::string before = save_to_bytes(target);
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        expect_refused(bytes.substr(0, size), target, "cut to " + std::to_string(size));
        ASSERT_EQ(save_to_bytes(target), before) << "cut to " << size;
    }
    std::string damaged = bytes;
    for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
        damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << (bit % 8)));
        expect_refused(damaged, target, "bit " + std::to_string(bit));
        damaged[bit / 8] = bytes[bit / 8];
        if (bit % 64 != 0) continue;
        ASSERT_EQ(save_to_bytes(target), before) << "bit " << bit;
    }
    ASSERT_EQ(save_to_bytes(target), before);
    load_from_bytes(bytes, target);
    EXPECT_EQ(save_to_bytes(target), bytes);
}

}  // namespace

TEST(CheckpointDamage, EveryCutAndEveryBitOfASmallOne) {
    expect_all_damage_refused<Sspql<>>(5, 2);
    expect_all_damage_refused<AdaptiveSspql<>>(4, 2);
}

TEST(CheckpointDamageSlow, AHundredThousandBitsOfALargeOne) {
    constexpr std::size_t states = 400;
    AdaptiveSspql<> saved(states, 4, {}, 1);
    Story story(1, states);
    story.go_on(saved, 1500);
    const std::string bytes = save_to_bytes(saved);
    ASSERT_GT(bytes.size(), 100000u);
    AdaptiveSspql<> target(states, 4, {}, 2);
    const std::string before = save_to_bytes(target);
    Random random(3);
    std::string damaged = bytes;
    for (int k = 0; k < 100000; ++k) {
        const std::size_t bit = random.below(8 * bytes.size());
        damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << (bit % 8)));
        expect_refused(damaged, target, "bit " + std::to_string(bit));
        damaged[bit / 8] = bytes[bit / 8];
    }
    EXPECT_EQ(save_to_bytes(target), before);
}
