// SPDX-License-Identifier: MIT
#include <sspql/model/record_slab.hpp>

#include <cstdint>
#include <cstring>
#include <map>
#include <vector>

#include <gtest/gtest.h>

#include <sspql/core/random.hpp>

using sspql::detail::RecordSlab;

TEST(RecordSlab, ClassesHoldFourSixEightTwelveAndSoOn) {
    const std::uint32_t sizes[] = {4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128};
    for (std::uint8_t c = 0; c < 11; ++c) EXPECT_EQ(RecordSlab::capacity(c), sizes[c]);
    EXPECT_EQ(RecordSlab::capacity(RecordSlab::no_block), 0u);
    EXPECT_EQ(RecordSlab::capacity(RecordSlab::classes - 1), 1u << 31) << "the largest class";
    for (std::uint8_t c = 1; c < RecordSlab::classes; ++c) {
        EXPECT_GT(RecordSlab::capacity(c), RecordSlab::capacity(static_cast<std::uint8_t>(c - 1)));
    }
}

TEST(RecordSlab, ReusesReleasedBlocksLastInFirstOut) {
    RecordSlab slab(12);
    const std::uint32_t a = slab.allocate(0);
    const std::uint32_t b = slab.allocate(0);
    const std::uint32_t c = slab.allocate(1);
    EXPECT_EQ(a, 0u);
    EXPECT_EQ(b, 4u);
    EXPECT_EQ(c, 8u);
    EXPECT_EQ(slab.extent(), 14u);
    slab.release(a, 0);
    slab.release(b, 0);
    EXPECT_EQ(slab.allocate(1), 14u) << "another class is no substitute";
    EXPECT_EQ(slab.allocate(0), b);
    EXPECT_EQ(slab.allocate(0), a);
    EXPECT_EQ(slab.allocate(0), 20u);
    EXPECT_EQ(slab.extent(), 24u);
}

TEST(RecordSlab, ReserveIsBytesOfAllRecords) {
    RecordSlab slab(20);
    slab.reserve(100);
    EXPECT_GE(slab.bytes(), 2000u);
    EXPECT_EQ(slab.extent(), 0u);
    EXPECT_EQ(slab.stride(), 20u);
}

TEST(RecordSlab, BlocksNeverOverlap) {
    for (std::uint64_t seed = 0; seed < 30; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        sspql::Random random(seed);
        RecordSlab slab(4 + random.below(3) * 4);
        struct Block {
            std::uint8_t size_class;
            unsigned char fill;
        };
        std::map<std::uint32_t, Block> live;
        for (int i = 0; i < 400; ++i) {
            if (live.empty() || random.chance(0.6)) {
                const auto size_class = static_cast<std::uint8_t>(random.below(8));
                const std::uint32_t begin = slab.allocate(size_class);
                const auto fill = static_cast<unsigned char>(i % 251);
                const std::size_t length = RecordSlab::capacity(size_class) * slab.stride();
                ASSERT_LE(begin + RecordSlab::capacity(size_class), slab.extent());
                std::memset(slab.record(begin), fill, length);
                ASSERT_TRUE(live.insert({begin, Block{size_class, fill}}).second);
            } else {
                auto victim = live.begin();
                std::advance(victim, static_cast<std::ptrdiff_t>(random.below(live.size())));
                slab.release(victim->first, victim->second.size_class);
                live.erase(victim);
            }
            for (const auto& [begin, block] : live) {
                const std::size_t length = RecordSlab::capacity(block.size_class) * slab.stride();
                const std::byte* bytes = slab.record(begin);
                ASSERT_EQ(static_cast<unsigned char>(bytes[0]), block.fill);
                ASSERT_EQ(static_cast<unsigned char>(bytes[length - 1]), block.fill);
            }
        }
    }
}
