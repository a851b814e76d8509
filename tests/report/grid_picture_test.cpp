// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <string>

#include "report/grid_picture.hpp"
#include "report/occurrences.hpp"

namespace sspql::report {
namespace {

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// "S.#" over "H.G"; the two free cells hold 0 and 8.
GridPicture small() {
    GridPicture picture;
    picture.title = "q & co";
    picture.rows = 2;
    picture.columns = 3;
    picture.cells = {{GridCellKind::start, std::nullopt, GridMove::right},
                     {GridCellKind::free, 0.0, GridMove::down},
                     {GridCellKind::wall, 5.0, GridMove::up},
                     {GridCellKind::hazard},
                     {GridCellKind::free, 8.0, GridMove::left},
                     {GridCellKind::goal, 100.0}};
    return picture;
}

TEST(GridPicture, DrawsWhatStandsOnTheCells) {
    const Svg svg = grid_picture(small());
    const std::string text = svg.element();
    EXPECT_TRUE(contains(text, "q &amp; co"));
    EXPECT_TRUE(contains(svg.label(), "2 rows, 3 columns; colours: value; arrows: the learnt actions"));
    EXPECT_TRUE(contains(text, "row 0, column 1: value 0, down"));
    EXPECT_TRUE(contains(text, "row 1, column 1: value 8, left"));
    EXPECT_TRUE(contains(text, "row 0, column 0: right"));
    EXPECT_FALSE(contains(text, "row 0, column 2"));  // walls and goals have neither value nor action
    EXPECT_FALSE(contains(text, "row 1, column 2"));
    for (const char* legend : {">value<", ">0<", ">8<", ">learnt action<", ">start<", ">goal<", ">hazard<", ">wall<"}) {
        EXPECT_TRUE(contains(text, legend)) << legend;
    }
}

TEST(GridPicture, TellsWhyToWhoPointsAtACell) {
    GridPicture picture = small();
    picture.cells[1].why = "4 steps to go\nup: <never tried>";
    EXPECT_TRUE(contains(grid_picture(picture).element(),
                         "row 0, column 1: value 0, down\n4 steps to go\nup: &lt;never tried&gt;</title>"));
}

TEST(GridPicture, ColoursSpanTheRange) {
    // Strengths 0.05 and 1 by themselves; on [0, 16] the 8 stands at 0.05 + 0.95 / 2.
    GridPicture picture = small();
    picture.legend = false;
    EXPECT_TRUE(contains(grid_picture(picture).element(), "opacity=\"0.05\""));
    EXPECT_FALSE(contains(grid_picture(picture).element(), "0.53"));
    picture.range = ValueRange{0.0, 16.0};
    EXPECT_TRUE(contains(grid_picture(picture).element(), "0.53"));
    EXPECT_EQ(value_range({small()}).low, 0.0);
    EXPECT_EQ(value_range({small()}).high, 8.0);
    EXPECT_EQ(value_range({GridPicture{}}).high, 1.0);
}

TEST(GridPicture, OneLegendForMany) {
    GridPicture picture = small();
    picture.legend = false;
    EXPECT_FALSE(contains(grid_picture(picture).element(), "learnt action<"));
    picture.range = ValueRange{-250.0, 8.0};
    const std::string legend = grid_legend({picture, picture}).element();
    EXPECT_TRUE(contains(legend, ">-250<"));
    EXPECT_EQ(count(legend, ">goal<"), 1u);
    EXPECT_FALSE(contains(grid_legend({}).element(), "goal"));
}

TEST(GridPicture, CellsWithoutNumbers) {
    GridPicture picture;
    picture.rows = 1;
    picture.columns = 2;
    picture.cells = {{GridCellKind::free, std::numeric_limits<double>::quiet_NaN()}, {GridCellKind::free}};
    const std::string text = grid_picture(picture).element();
    EXPECT_FALSE(contains(text, "value"));
    EXPECT_FALSE(contains(text, "nan"));
}

TEST(GridPicture, ArrowsPointTheirWay) {
    // One cell of side 44 with its corner at (3, 3): the tip lies 0.3 sides from the centre (25, 25).
    GridPicture picture;
    picture.rows = picture.columns = 1;
    picture.cells.resize(1);
    const std::pair<GridMove, const char*> tips[] = {{GridMove::up, "25,11.8"},
                                                     {GridMove::down, "25,38.2"},
                                                     {GridMove::left, "11.8,25"},
                                                     {GridMove::right, "38.2,25"}};
    for (const auto& [move, tip] : tips) {
        picture.cells[0].action = move;
        EXPECT_TRUE(contains(grid_picture(picture).element(), tip)) << tip;
    }
}

TEST(GridPicture, RefusesWhatIsNoMap) {
    EXPECT_THROW(static_cast<void>(grid_picture(GridPicture{})), std::invalid_argument);
    GridPicture picture = small();
    picture.rows = 3;
    EXPECT_THROW(static_cast<void>(grid_picture(picture)), std::invalid_argument);
    picture.rows = 1;
    picture.columns = most_picture_cells + 1;
    picture.cells.assign(picture.columns, {});
    EXPECT_THROW(static_cast<void>(grid_picture(picture)), std::invalid_argument);
}

}  // namespace
}  // namespace sspql::report
