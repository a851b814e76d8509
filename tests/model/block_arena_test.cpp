// SPDX-License-Identifier: MIT
#include <sspql/model/block_arena.hpp>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <map>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <sspql/core/random.hpp>

using sspql::detail::BlockArena;
using sspql::detail::ZeroedBytes;

TEST(BlockArena, ClassesHoldFourSixEightTwelveAndSoOn) {
    const std::uint32_t sizes[] = {4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128};
    for (std::uint8_t c = 0; c < 11; ++c) {
        EXPECT_EQ(BlockArena::capacity(c), sizes[c]);
        EXPECT_EQ(BlockArena::class_of(sizes[c]), c);
        if (c > 0) {
            EXPECT_EQ(BlockArena::grown(sizes[c - 1]), sizes[c]);
        }
    }
    EXPECT_EQ(BlockArena::grown(0), 4u);
    EXPECT_EQ(BlockArena::capacity(BlockArena::classes - 1), 1u << 30) << "the largest class";
    EXPECT_THROW((void)BlockArena::grown(1u << 30), std::length_error);
}

TEST(BlockArena, ReusesReleasedBlocksLastInFirstOut) {
    BlockArena arena(0, 24);  // 3 units for 4 records, 5 for 6
    const std::uint32_t a = arena.allocate(4);
    const std::uint32_t b = arena.allocate(4);
    const std::uint32_t c = arena.allocate(6);
    EXPECT_EQ(a, 1u) << "unit 0 belongs to nobody";
    EXPECT_EQ(b, 4u);
    EXPECT_EQ(c, 7u);
    EXPECT_EQ(arena.extent(), 12u);
    arena.release(a, 4);
    arena.release(b, 4);
    EXPECT_EQ(arena.allocate(6), 12u) << "another class is no substitute";
    EXPECT_EQ(arena.allocate(4), b);
    EXPECT_EQ(arena.allocate(4), a);
    EXPECT_EQ(arena.allocate(4), 17u);
}

TEST(BlockArena, UnitsHoldHeadAndRecords) {
    for (const std::size_t head : {0u, 8u}) {
        for (const std::size_t record : {1u, 8u, 12u, 24u, 104u}) {
            const BlockArena arena(head, record);
            for (std::uint8_t c = 0; c < 20; ++c) {
                const std::uint32_t capacity = BlockArena::capacity(c);
                EXPECT_GE(arena.units(capacity) * BlockArena::unit, head + capacity * record);
                EXPECT_LT(arena.units(capacity) * BlockArena::unit, head + capacity * record + BlockArena::unit);
            }
        }
    }
}

// Whatever the blocks, as long as they hold no more records than were reserved.
TEST(BlockArena, WithinTheReserveNothingMoves) {
    for (const std::size_t record : {5u, 12u, 24u, 104u}) {
        for (std::uint8_t c = 0; c < 16; ++c) {
            BlockArena arena(8, record);
            const std::uint32_t capacity = BlockArena::capacity(c);
            const std::size_t blocks = 1 + 1000 / capacity;
            arena.reserve(blocks * capacity);
            const std::size_t bytes = arena.bytes();
            const std::byte* first = arena.at(0);
            for (std::size_t i = 0; i < blocks; ++i) (void)arena.allocate(capacity);
            EXPECT_EQ(arena.at(0), first) << record << " bytes, " << capacity << " records a block";
            EXPECT_EQ(arena.bytes(), bytes);
        }
    }
}

TEST(BlockArena, BlocksNeverOverlap) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        SCOPED_TRACE(seed);
        sspql::Random random(seed);
        BlockArena arena(8 * random.below(2), 4 + random.below(30));
        struct Block {
            std::uint32_t capacity;
            unsigned char fill;
        };
        std::map<std::uint32_t, Block> live;
        for (int i = 0; i < 500; ++i) {
            if (live.empty() || random.chance(0.6)) {
                const auto capacity = BlockArena::capacity(static_cast<std::uint8_t>(random.below(6)));
                const auto fill = static_cast<unsigned char>(random.below(256));
                const std::uint32_t begin = arena.allocate(capacity);
                ASSERT_EQ(live.count(begin), 0u);
                ASSERT_LE(begin + arena.units(capacity), arena.extent());
                std::memset(arena.at(begin), fill, arena.units(capacity) * BlockArena::unit);
                live[begin] = {capacity, fill};
            } else {
                auto at = live.begin();
                std::advance(at, static_cast<std::ptrdiff_t>(random.below(live.size())));
                arena.release(at->first, at->second.capacity);
                live.erase(at);
            }
            for (const auto& [begin, block] : live) {
                const std::size_t length = arena.units(block.capacity) * BlockArena::unit;
                const std::byte* bytes = arena.at(begin);
                ASSERT_EQ(static_cast<unsigned char>(bytes[0]), block.fill);
                ASSERT_EQ(static_cast<unsigned char>(bytes[length - 1]), block.fill);
            }
        }
    }
}

TEST(ZeroedBytes, AreZeroAlignedAndKeptWhileTheyGrow) {
    ZeroedBytes bytes;
    std::size_t written = 0;
    for (std::size_t size : {1u, 63u, 64u, 100u, 5000u, 1u << 20}) {
        bytes.resize(size);
        EXPECT_EQ(reinterpret_cast<std::uintptr_t>(bytes.data()) % ZeroedBytes::alignment, 0u);
        for (std::size_t i = 0; i < written; ++i) ASSERT_EQ(bytes.data()[i], std::byte{7});
        for (std::size_t i = written; i < size; ++i) ASSERT_EQ(bytes.data()[i], std::byte{0});
        std::memset(bytes.data(), 7, size);
        written = size;
    }
}

TEST(ZeroedBytes, AreCopiedAndMovedWhole) {
    ZeroedBytes bytes;
    bytes.resize(1000);
    std::memset(bytes.data(), 9, 1000);
    ZeroedBytes copy = bytes;
    bytes.data()[0] = std::byte{1};
    EXPECT_EQ(copy.data()[0], std::byte{9});
    EXPECT_EQ(copy.size(), 1000u);
    const std::byte* where = copy.data();
    const ZeroedBytes moved = std::move(copy);
    EXPECT_EQ(moved.data(), where);
    bytes = moved;
    EXPECT_EQ(bytes.data()[0], std::byte{9});
}

TEST(ZeroedBytes, GrowByAQuarterAtLeast) {
    ZeroedBytes bytes;
    int moves = 0;
    for (std::size_t size = 1; size <= 100000; ++size) {
        const std::size_t before = bytes.capacity();
        bytes.resize(size);
        moves += bytes.capacity() != before ? 1 : 0;
    }
    EXPECT_LT(moves, 60);
    EXPECT_LE(bytes.capacity(), 125000u);
    bytes.reserve(200000);
    EXPECT_EQ(bytes.capacity(), 200000u) << "what is asked for, no more";
}
