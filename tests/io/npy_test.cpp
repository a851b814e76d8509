// SPDX-License-Identifier: MIT
#include <sspql/io/npy.hpp>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include <sspql/model/cells.hpp>

#include "io/file_testing.hpp"

namespace sspql {
namespace {

using testing::content;
using NpyTest = testing::FileTest;

constexpr ActionId a0{0}, a1{1};

/// Bytes of little-endian numbers.
std::string bytes(std::int64_t value) {
    std::string out;
    for (int i = 0; i < 8; ++i) out += static_cast<char>((static_cast<std::uint64_t>(value) >> (8 * i)) & 0xFF);
    return out;
}
std::string bytes(double value) {
    std::int64_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    return bytes(bits);
}

/// Checks the ten bytes before the header and its padding; the header without padding, and what follows it.
void split(const std::string& file, std::string& header, std::string& data) {
    ASSERT_GE(file.size(), 64u);
    ASSERT_EQ(file.substr(0, 8), std::string("\x93NUMPY\x01\x00", 8));
    const std::size_t size = static_cast<unsigned char>(file[8]) + 256u * static_cast<unsigned char>(file[9]);
    ASSERT_EQ((10 + size) % 64, 0u);
    ASSERT_GE(file.size(), 10 + size);
    ASSERT_EQ(file[10 + size - 1], '\n');
    header = file.substr(10, size - 1);
    header.erase(header.find_last_not_of(' ') + 1);
    data = file.substr(10 + size);
}

}  // namespace

TEST_F(NpyTest, QIsAMatrixOfStatesAndActions) {
    QTable q(2, 3, 0.5);
    q(state_id(1), action_id(2)) = -1e300;
    q(state_id(0), action_id(1)) = std::numeric_limits<double>::denorm_min();
    save_npy(path("q.npy"), q);
    std::string header, data;
    split(content(path("q.npy")), header, data);
    EXPECT_EQ(header, "{'descr': '<f8', 'fortran_order': False, 'shape': (2, 3), }");
    EXPECT_EQ(data, bytes(0.5) + bytes(std::numeric_limits<double>::denorm_min()) + bytes(0.5) + bytes(0.5) +
                        bytes(0.5) + bytes(-1e300));
}

TEST_F(NpyTest, WithoutStates) {
    save_npy(path("q.npy"), QTable(0, 3));
    std::string header, data;
    split(content(path("q.npy")), header, data);
    EXPECT_EQ(header, "{'descr': '<f8', 'fortran_order': False, 'shape': (0, 3), }");
    EXPECT_EQ(data, "");
    save_npy(path("counts.npy"), TransitionCounts<>(0, 1));
    split(content(path("counts.npy")), header, data);
    EXPECT_NE(header.find("'shape': (0,), }"), std::string::npos);
    EXPECT_EQ(data, "");
}

TEST_F(NpyTest, ListsOfNumbers) {
    std::string header, data;
    save_npy(path("x.npy"), std::vector<double>{1.5, -0.0});
    split(content(path("x.npy")), header, data);
    EXPECT_EQ(header, "{'descr': '<f8', 'fortran_order': False, 'shape': (2,), }");
    EXPECT_EQ(data, bytes(1.5) + bytes(-0.0));
    save_npy(path("x.npy"), std::vector<int>{-1, 7, 0});
    split(content(path("x.npy")), header, data);
    EXPECT_EQ(header, "{'descr': '<i8', 'fortran_order': False, 'shape': (3,), }");
    EXPECT_EQ(data, bytes(std::int64_t{-1}) + bytes(std::int64_t{7}) + bytes(std::int64_t{0}));
}

// Rows ascend by s, a, next, whatever the order of the records.
TEST_F(NpyTest, CountsAreRowsInOrder) {
    TransitionCounts<CountCell> counts(3, 2);
    counts.record(state_id(2), a1, state_id(0));
    counts.record(state_id(2), a0, state_id(1), true);
    counts.record(state_id(2), a1, state_id(0));
    counts.record(state_id(0), a1, state_id(2), false, 0.0, 2.5);
    save_npy(path("counts.npy"), counts);
    std::string header, data;
    split(content(path("counts.npy")), header, data);
    EXPECT_EQ(header,
              "{'descr': [('s', '<i8'), ('a', '<i8'), ('next', '<i8'), ('n', '<i8'), ('weight', '<f8'), "
              "('terminal', '|b1')], 'fortran_order': False, 'shape': (3,), }");
    const auto row = [](int s, int a, int next, int n, double weight, bool terminal) {
        return bytes(std::int64_t{s}) + bytes(std::int64_t{a}) + bytes(std::int64_t{next}) + bytes(std::int64_t{n}) +
               bytes(weight) + std::string(1, terminal ? '\1' : '\0');
    };
    EXPECT_EQ(data, row(0, 1, 2, 1, 2.5, false) + row(2, 0, 1, 1, 1.0, true) + row(2, 1, 0, 2, 1.0, false));
}

TEST_F(NpyTest, FadingCountsHaveFractionsAndRewards) {
    TransitionCounts<FadingCell> counts(2, 12);
    counts.record(state_id(0), action_id(11), state_id(1), true, 3.0);
    counts.fade(state_id(0), action_id(11), 0.5, 0.01);
    save_npy(path("counts.npy"), counts);
    std::string header, data;
    split(content(path("counts.npy")), header, data);
    EXPECT_EQ(header,
              "{'descr': [('s', '<i8'), ('a', '<i8'), ('next', '<i8'), ('n', '<f8'), ('weight', '<f8'), "
              "('terminal', '|b1'), ('reward_sum', '<f8')], 'fortran_order': False, 'shape': (1,), }");
    EXPECT_EQ(data, bytes(std::int64_t{0}) + bytes(std::int64_t{11}) + bytes(std::int64_t{1}) + bytes(0.5) +
                        bytes(1.0) + "\1" + bytes(1.5));
}

TEST_F(NpyTest, AFullDiskLeavesTheOldFile) {
    save_npy(path("q.npy"), QTable(1, 1));
    const std::string before = content(path("q.npy"));
    EXPECT_TRUE(testing::in_child([&] {
        if (!testing::limit_files_to(4096)) return false;
        return testing::error_of<std::runtime_error>([&] { save_npy(path("q.npy"), QTable(100000, 4)); }) ==
               "cannot write " + path("q.npy") + ": File too large";
    }));
    EXPECT_EQ(content(path("q.npy")), before);
    EXPECT_EQ(files(), 1u);
}

}  // namespace sspql
