// SPDX-License-Identifier: MIT
#include <sspql/core/random.hpp>

#include <array>
#include <cstdint>

#include <gtest/gtest.h>

using sspql::Random;
using sspql::RandomStream;

namespace {

/// xoshiro256** and splitmix64 as their authors publish them (prng.di.unimi.it), written down once more.
struct Reference {
    std::array<std::uint64_t, 4> s{};

    static std::uint64_t splitmix64(std::uint64_t& x) {
        std::uint64_t z = (x += 0x9e3779b97f4a7c15);
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
        z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
        return z ^ (z >> 31);
    }

    static std::uint64_t rotl(std::uint64_t x, int k) { return (x << k) | (x >> (64 - k)); }

    std::uint64_t next() {
        const std::uint64_t result = rotl(s[1] * 5, 7) * 9;
        const std::uint64_t t = s[1] << 17;
        s[2] ^= s[0];
        s[3] ^= s[1];
        s[1] ^= s[2];
        s[0] ^= s[3];
        s[2] ^= t;
        s[3] = rotl(s[3], 45);
        return result;
    }
};

}  // namespace

TEST(Random, EngineIsXoshiro256StarStar) {
    for (const std::uint64_t seed : {0ull, 1ull, 42ull, ~0ull}) {
        Random random(seed, 7);
        Reference reference{random.state()};
        for (int i = 0; i < 1000; ++i) ASSERT_EQ(random.bits(), reference.next()) << "seed " << seed << ", draw " << i;
        EXPECT_EQ(random.state(), reference.s);
    }
}

TEST(Random, EngineGivesTheAuthorsFirstNumbers) {
    // State {1, 2, 3, 4}: the vector other implementations (Rust's rand_xoshiro) test against.
    Random random = Random::from_state({1, 2, 3, 4});
    const std::array<std::uint64_t, 5> expected{11520u, 0u, 1509978240u, 1215971899390074240u, 1216172134540287360u};
    for (const std::uint64_t bits : expected) EXPECT_EQ(random.bits(), bits);
}

TEST(Random, StateIsFilledBySplitmix) {
    for (const std::uint64_t seed : {0ull, 5ull, 123456789ull}) {
        for (const std::uint64_t stream : {0ull, 1ull, 3ull, 1017ull}) {
            std::uint64_t x = seed;
            std::uint64_t y = stream ^ 0x6A09E667F3BCC909ull;
            std::uint64_t z = Reference::splitmix64(x);
            z ^= Reference::splitmix64(y);
            Random::State expected{};
            for (auto& word : expected) word = Reference::splitmix64(z);
            EXPECT_EQ(Random(seed, stream).state(), expected) << "seed " << seed << ", stream " << stream;
        }
    }
}

/// Golden values: a compiler, a flag or a change that moves a single bit shows here first.
TEST(Random, FirstDrawsStayWhatTheyAre) {
    Random bits(1);
    EXPECT_EQ(bits.bits(), 1776257037560566265u);
    EXPECT_EQ(bits.bits(), 8453824117294385699u);
    EXPECT_EQ(bits.bits(), 15849508975954375260u);
    Random learner(1, RandomStream::learner);
    EXPECT_EQ(learner.bits(), 7402386557060374965u);
    Random uniform(2);
    EXPECT_EQ(uniform.uniform(), 0x1.97e37be00f4p-8);
    EXPECT_EQ(uniform.uniform(), 0x1.ce84c2df2a8e4p-3);
    Random below(3);
    EXPECT_EQ(below.below(10), 5u);
    EXPECT_EQ(below.below(1000000007), 193857422u);
    Random normal(4);
    EXPECT_EQ(normal.normal(), 0x1.ae05185d712cp-1);
    EXPECT_EQ(normal.normal(), 0x1.c51f15da72c6dp-1);
    EXPECT_EQ(normal.normal(), 0x1.1c47e3157d2aap+0);
    double sum = 0.0;
    for (int i = 0; i < 100000; ++i) sum += normal.normal();  // through every branch of the rejection
    EXPECT_EQ(sum, 0x1.69d17eb9ef16cp+7);
}

TEST(Random, SameSeedAndStreamGiveTheSameSequence) {
    Random a(9, RandomStream::environment);
    Random b(9, 1);
    for (int i = 0; i < 100; ++i) EXPECT_EQ(a.bits(), b.bits());
}

TEST(Random, SeedsAndStreamsDiffer) {
    const auto first = [](std::uint64_t seed, std::uint64_t stream) { return Random(seed, stream).bits(); };
    EXPECT_NE(first(1, 0), first(2, 0));
    EXPECT_NE(first(1, 1), first(1, 2));
    EXPECT_NE(first(1, 2), first(2, 1));
    // Neighbouring streams are no shifted copies of each other: 64 draws have no word in common.
    std::array<std::uint64_t, 64> a{};
    Random one(1, 1);
    for (auto& word : a) word = one.bits();
    Random two(1, 2);
    for (int i = 0; i < 64; ++i) {
        const std::uint64_t word = two.bits();
        for (const std::uint64_t other : a) EXPECT_NE(word, other);
    }
}

TEST(Random, GoesOnFromItsState) {
    Random random(11);
    for (int i = 0; i < 17; ++i) (void)random.normal();
    Random resumed = Random::from_state(random.state());
    Random copy = random;
    for (int i = 0; i < 100; ++i) {
        const double expected = random.normal();
        EXPECT_EQ(resumed.normal(), expected);
        EXPECT_EQ(copy.normal(), expected);
    }
    EXPECT_EQ(resumed.state(), random.state());
}

#if SSPQL_ENABLE_ASSERTIONS && GTEST_HAS_DEATH_TEST
TEST(RandomDeathTest, AssertsWhatItCannotDo) {
    EXPECT_DEATH((void)Random(1).below(0), "a draw needs at least one value");
    EXPECT_DEATH((void)Random::from_state({0, 0, 0, 0}), "an all-zero state never leaves zero");
}
#endif
