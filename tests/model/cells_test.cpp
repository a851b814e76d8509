// SPDX-License-Identifier: MIT
#include <sspql/model/cells.hpp>

#include <cstring>
#include <type_traits>

#include <gtest/gtest.h>

using sspql::BasicCountCell;
using sspql::CountCell;
using sspql::FadingCell;

template <class Cell>
class CellOf : public testing::Test {};

using Cells = testing::Types<CountCell, BasicCountCell<5>, FadingCell>;
TYPED_TEST_SUITE(CellOf, Cells, );

TYPED_TEST(CellOf, IsAllZeroAndEmptyWhenNew) {
    static_assert(std::is_trivially_copyable_v<TypeParam>);
    unsigned char zeros[sizeof(TypeParam)] = {};
    TypeParam cell;
    std::memcpy(static_cast<void*>(&cell), zeros, sizeof cell);
    EXPECT_EQ(cell.count(), TypeParam().count());
    EXPECT_EQ(cell.count(), 0);
    EXPECT_FALSE(cell.terminal());
    EXPECT_FALSE(cell.full());
}

TYPED_TEST(CellOf, CountsAndRemembersTheLastEnd) {
    TypeParam cell;
    cell.add(1.0, true);
    cell.add(1.0, true);
    EXPECT_EQ(cell.count(), 2);
    EXPECT_TRUE(cell.terminal());
    cell.add(1.0, false);
    EXPECT_EQ(cell.count(), 3);
    EXPECT_FALSE(cell.terminal());
}

TEST(CountCellTest, HalvesUpwards) {
    BasicCountCell<9> cell;
    for (int i = 0; i < 9; ++i) cell.add(0.0, false);
    EXPECT_TRUE(cell.full());
    cell.halve();
    EXPECT_EQ(cell.count(), 5u);
    cell.halve();
    EXPECT_EQ(cell.count(), 3u);
    cell.halve();
    cell.halve();
    cell.halve();
    EXPECT_EQ(cell.count(), 1u);
    BasicCountCell<9> empty;
    empty.halve();
    EXPECT_EQ(empty.count(), 0u);
}

// Rewards 3 and 1: the mean is 2, before and after fading.
TEST(FadingCellTest, MeanRewardSurvivesScaling) {
    FadingCell cell;
    EXPECT_EQ(cell.mean_reward(), 0.0);
    cell.add(3.0, false);
    cell.add(1.0, true);
    EXPECT_EQ(cell.mean_reward(), 2.0);
    cell.scale(0.25);
    EXPECT_EQ(cell.count(), 0.5);
    EXPECT_EQ(cell.mean_reward(), 2.0);
    EXPECT_TRUE(cell.terminal());
}

TEST(FadingCellTest, IsFullWhereOneMoreWouldChangeNothing) {
    FadingCell cell;
    cell.n = 9007199254740991.0;
    EXPECT_FALSE(cell.full());
    cell.add(0.0, false);
    EXPECT_TRUE(cell.full());
    EXPECT_EQ(cell.n + 1.0, cell.n);
    cell.halve();
    EXPECT_FALSE(cell.full());
}
