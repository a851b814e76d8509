// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

#include "report/belief_picture.hpp"
#include "report/occurrences.hpp"

namespace sspql::report {
namespace {

/// ". . G" over "# . .": the first cell would try up, the second goes right; the last was never seen.
BeliefPanel small() {
    BeliefPanel panel{"before & after", "10 steps", std::vector<BeliefCell>(6), {}, {}};
    panel.cells[0].steps = 8.0;
    panel.cells[0].next = GridMove::up;
    panel.cells[0].untried = {true, false, true, false};
    panel.cells[1].steps = 1.0;
    panel.cells[1].next = GridMove::right;
    panel.cells[2].kind = GridCellKind::goal;
    panel.cells[3].kind = GridCellKind::wall;
    panel.cells[4].steps = 2.0;
    return panel;
}

std::string drawn(const BeliefPanel& panel) { return belief_picture({panel}, 2, 3, 1, "a map").element(); }

TEST(BeliefPicture, EveryMarkIsDrawnAndExplained) {
    const BeliefPanel plain = small();
    const std::string before = drawn(plain);
    EXPECT_NE(before.find("before &amp; after"), std::string::npos);
    EXPECT_NE(before.find(">8</text>"), std::string::npos);  // the scale ends at the farthest cell
    EXPECT_EQ(count(before, "<circle"), 4u);                 // two never tried; in the legend one and the robot
    EXPECT_EQ(count(before, "<polygon"), 4u);                // two arrows, two in the legend

    BeliefPanel marked = plain;
    marked.cells[1].alarmed = {false, true, false, false};
    marked.robot = 4;
    marked.way = {0, 1, 4};
    const std::string after = drawn(marked);
    EXPECT_EQ(count(after, "<circle"), 5u);
    EXPECT_EQ(count(before, "alarm"), 0u);
    EXPECT_EQ(count(after, "alarm"), 1u);
    EXPECT_EQ(count(before, "<polyline"), 1u);  // the legend's
    EXPECT_EQ(count(after, "<polyline"), 6u);   // and an alarm with its edge, the alarm in the legend, the way
    EXPECT_EQ(after, drawn(marked));
}

TEST(BeliefPicture, NearerCellsAreStronger) {
    const std::string text = drawn(small());
    EXPECT_NE(text.find("opacity=\"0.06\""), std::string::npos);  // 8 of 8 steps
    EXPECT_NE(text.find("opacity=\"0.88\""), std::string::npos);  // 1 of 8
}

TEST(BeliefPicture, AsManyAcrossAsAsked) {
    const Svg row = belief_picture({small(), small(), small()}, 2, 3, 3, "maps");
    const Svg column = belief_picture({small(), small(), small()}, 2, 3, 1, "maps");
    EXPECT_EQ(row.width(), 720.0);
    EXPECT_EQ(column.width(), 720.0);
    EXPECT_GT(column.height(), 3.0 * row.height());
}

TEST(BeliefPicture, RefusesWhatDoesNotFit) {
    BeliefPanel panel = small();
    const auto draw = [&](std::size_t rows, std::size_t columns, std::size_t across) {
        static_cast<void>(belief_picture({panel}, rows, columns, across, "a map"));
    };
    EXPECT_THROW(draw(3, 3, 1), std::invalid_argument);
    EXPECT_THROW(draw(2, 0, 1), std::invalid_argument);
    EXPECT_THROW(draw(2, 3, 0), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(belief_picture({}, 2, 3, 1, "a map")), std::invalid_argument);
    panel.robot = 6;
    EXPECT_THROW(draw(2, 3, 1), std::invalid_argument);
    panel.robot.reset();
    panel.way = {0, 7};
    EXPECT_THROW(draw(2, 3, 1), std::invalid_argument);
}

}  // namespace
}  // namespace sspql::report
