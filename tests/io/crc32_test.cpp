// SPDX-License-Identifier: MIT
#include <sspql/io/crc32.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include <boost/crc.hpp>
#include <gtest/gtest.h>

#include <sspql/core/random.hpp>

namespace {

using sspql::detail::Crc32;

std::uint32_t of(std::string_view text) {
    Crc32 crc;
    crc.add(text.data(), text.size());
    return crc.value();
}

std::uint32_t by_boost(const std::vector<unsigned char>& bytes) {
    boost::crc_32_type crc;
    crc.process_bytes(bytes.data(), bytes.size());
    return crc.checksum();
}

TEST(Crc32, HasThePublishedCheckValues) {
    EXPECT_EQ(of(""), 0u);
    EXPECT_EQ(of("123456789"), 0xCBF43926u);
    EXPECT_EQ(of("The quick brown fox jumps over the lazy dog"), 0x414FA339u);
}

TEST(Crc32, IsBoostsForEveryLengthAndPlaceInMemory) {
    sspql::Random random(1);
    for (std::size_t size = 0; size <= 700; ++size) {
        const std::size_t shift = size % 17;
        std::vector<unsigned char> memory(shift + size);
        for (unsigned char& byte : memory) byte = static_cast<unsigned char>(random.below(256));
        const std::vector<unsigned char> bytes(memory.begin() + static_cast<std::ptrdiff_t>(shift), memory.end());
        Crc32 crc;
        crc.add(memory.data() + shift, size);
        ASSERT_EQ(crc.value(), by_boost(bytes)) << size << " bytes";
        Crc32 tables;
        tables.add_by_tables(bytes.data(), bytes.size());
        ASSERT_EQ(tables.value(), crc.value()) << size << " bytes";
    }
}

TEST(Crc32, DoesNotDependOnHowTheBytesAreCut) {
    sspql::Random random(2);
    std::vector<unsigned char> bytes(5000);
    for (unsigned char& byte : bytes) byte = static_cast<unsigned char>(random.below(256));
    const std::uint32_t expected = by_boost(bytes);
    for (int round = 0; round < 200; ++round) {
        Crc32 crc;
        for (std::size_t at = 0; at < bytes.size();) {
            const std::size_t piece = std::min(bytes.size() - at, random.below(round % 2 == 0 ? 40 : 1000));
            crc.add(bytes.data() + at, piece);
            at += piece;
        }
        ASSERT_EQ(crc.value(), expected) << "round " << round;
    }
}

#if SSPQL_HAS_CRC_FOLDING
TEST(Crc32, FoldingIsUsedWhereTheProcessorCan) {
    if (!sspql::detail::can_fold_crc()) GTEST_SKIP() << "this processor does not multiply without carries";
    const std::vector<unsigned char> bytes(160, 7);
    std::vector<unsigned char> folded(16);
    sspql::detail::fold_crc(0xFFFFFFFFu, bytes.data(), 10, folded.data());
    Crc32 crc;
    crc.add_by_tables(bytes.data(), bytes.size());
    // From a remainder of zero on, the sixteen bytes lead where all did.
    boost::crc_optimal<32, 0x04C11DB7, 0, 0, true, true> rest;
    rest.process_bytes(folded.data(), folded.size());
    EXPECT_EQ(~rest.checksum(), crc.value());
}
#endif

}  // namespace
