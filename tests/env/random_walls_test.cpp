// SPDX-License-Identifier: MIT
#include <sspql/env/random_walls.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include <sspql/env/grid_maps.hpp>
#include <sspql/env/grid_world.hpp>
#include <sspql/learn/exact_steps.hpp>

using namespace sspql;

namespace {

std::size_t free_cells(const GridMap& map) {
    std::size_t n = 0;
    for (std::size_t s = 0; s < map.size(); ++s) n += map.cell(state_id(s)) == GridCell::wall ? 0u : 1u;
    return n;
}

}  // namespace

TEST(RandomWalls, TheGoalIsInTheLastCornerAndTheStartAnywhere) {
    const GridMap map = random_walls(20, 0.2, 1);
    EXPECT_EQ(map.rows(), 20u);
    EXPECT_EQ(map.columns(), 20u);
    ASSERT_EQ(map.goals().size(), 1u);
    EXPECT_EQ(map.goals()[0], map.state(19, 19));
    EXPECT_EQ(map.starts().size(), free_cells(map) - 1);
}

TEST(RandomWalls, EveryFreeCellReachesTheGoal) {
    for (const std::size_t size : {2u, 3u, 5u, 12u, 40u}) {
        for (const double walls : {0.0, 0.1, 0.2, 0.3}) {
            for (std::uint64_t seed = 1; seed <= 5; ++seed) {
                const GridMap map = random_walls(size, walls, seed);
                for (const double steps : least_expected_steps(GridWorld(map).table())) {
                    ASSERT_TRUE(std::isfinite(steps)) << size << ' ' << walls << " seed " << seed;
                }
            }
        }
    }
}

TEST(RandomWalls, AreAsManyAsWereAskedFor) {
    EXPECT_EQ(free_cells(random_walls(50, 0.0, 1)), 2500u);
    for (const double walls : {0.1, 0.2, 0.3}) {
        for (std::uint64_t seed = 1; seed <= 10; ++seed) {
            const double share = static_cast<double>(free_cells(random_walls(100, walls, seed))) / 1e4;
            EXPECT_GE(share, 0.9 * (1.0 - walls)) << "seed " << seed;
            EXPECT_LE(share, 1.0 - walls + 0.02) << "seed " << seed << ", four standard deviations";
        }
    }
}

TEST(RandomWalls, TheSameSeedGivesTheSameMap) {
    EXPECT_EQ(random_walls(30, 0.2, 7), random_walls(30, 0.2, 7));
    EXPECT_NE(random_walls(30, 0.2, 7), random_walls(30, 0.2, 8));
    // Drawn once and kept: what was measured on these maps stays comparable.
    EXPECT_EQ(random_walls(6, 0.3, 1).text(),
              "##...#\n"
              "##....\n"
              ".....#\n"
              "...#..\n"
              "#.....\n"
              ".....G\n");
}

TEST(RandomWalls, AreKnownByName) {
    EXPECT_EQ(grid_task("walls20").map, random_walls(20, 0.2, 1));
    EXPECT_EQ(grid_task("walls20:3").map, random_walls(20, 0.2, 3));
    EXPECT_EQ(grid_task("walls20:3").params.slip, 0.1);
    EXPECT_EQ(grid_task("walls20:3").name, "walls20:3");
    for (const char* bad :
         {"walls", "walls3", "walls301", "walls20:", "walls20:x", "walls20:3x", "walls20x", "walls-5"}) {
        EXPECT_FALSE(find_grid_task(bad).has_value()) << bad;
    }
}

TEST(RandomWalls, RefusesWhatSeldomHangsTogether) {
    for (const std::size_t size : {0u, 1u, 4097u})
        EXPECT_THROW((void)random_walls(size, 0.2, 1), std::invalid_argument);
    for (const double walls : {-0.1, 0.31, std::numeric_limits<double>::quiet_NaN()}) {
        EXPECT_THROW((void)random_walls(10, walls, 1), std::invalid_argument);
    }
}
