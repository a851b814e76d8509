// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "report/occurrences.hpp"
#include "report/sensitivity_picture.hpp"

namespace sspql::report {
namespace {

SensitivityPanel panel_of(std::vector<std::vector<Sensitivity>> tasks) {
    return {"lambda", {"1", "2", "4"}, 1, std::move(tasks)};
}

TEST(SensitivityPicture, HasALineForEachTaskAndADotForEachValue) {
    const auto panel = panel_of({{{2.0, 0.1}, {1.0, 0.0}, {0.7, 0.1}}, {{1.0, 0.0}, {1.0, 0.0}, {1.5, 0.2}}});
    const std::string picture = sensitivity_picture({panel, panel}, {"open", "walls"}, 4.0, "label").document();
    EXPECT_EQ(count(picture, "<polyline"), 4u);
    EXPECT_EQ(count(picture, "<circle"), 2u + 2u * 6u);  // the legend's, then two panels of two tasks
    EXPECT_EQ(count(picture, ">lambda<"), 2u);
    EXPECT_EQ(count(picture, "1: 2 times"), 2u);
    EXPECT_EQ(count(picture, ">open<"), 1u);
    EXPECT_EQ(count(picture, "aria-label=\"label\""), 1u);
}

TEST(SensitivityPicture, WritesWhatIsBeyondTheScale) {
    const auto panel = panel_of({{{29.3, 1.0}, {1.0, 0.0}, {3.9, 0.0}}});
    const std::string picture = sensitivity_picture({panel}, {"open"}, 4.0, "label").document();
    EXPECT_EQ(count(picture, ">29<"), 1u);  // the number beside the dot at the end of the scale
    EXPECT_EQ(count(picture, ">3.9<"), 0u);
}

TEST(SensitivityPicture, FourPanelsStandInARow) {
    const std::vector<SensitivityPanel> four(4, panel_of({{{1.0, 0.0}, {1.0, 0.0}, {1.0, 0.0}}}));
    std::vector<SensitivityPanel> five = four;
    five.push_back(four.front());
    const Svg one_row = sensitivity_picture(four, {"open"}, 4.0, "label");
    const Svg two_rows = sensitivity_picture(five, {"open"}, 4.0, "label");
    EXPECT_EQ(one_row.width(), two_rows.width());
    EXPECT_LT(one_row.height(), two_rows.height());
}

TEST(SensitivityPicture, RefusesPanelsThatLackSomething) {
    const auto draw = [](const SensitivityPanel& panel) { (void)sensitivity_picture({panel}, {"open"}, 4.0, "label"); };
    SensitivityPanel panel = panel_of({{{1.0, 0.0}, {1.0, 0.0}, {1.0, 0.0}}});
    EXPECT_NO_THROW(draw(panel));
    panel.standard = 3;
    EXPECT_THROW(draw(panel), std::invalid_argument);
    EXPECT_THROW(draw(panel_of({})), std::invalid_argument);
    EXPECT_THROW(draw(panel_of({{{1.0, 0.0}, {1.0, 0.0}}})), std::invalid_argument);
}

}  // namespace
}  // namespace sspql::report
