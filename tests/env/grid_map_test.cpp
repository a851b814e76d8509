// SPDX-License-Identifier: MIT
#include <sspql/env/grid_map.hpp>

#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

using sspql::GridCell;
using sspql::GridMap;
using sspql::state_id;
using sspql::StateId;

namespace {

template <class F>
std::string error_of(F&& f) {
    try {
        f();
    } catch (const std::exception& error) {
        return error.what();
    }
    return "no error";
}

std::string parse_error(const std::string& text) {
    return error_of([&] { (void)GridMap::parse(text, "m.txt"); });
}

}  // namespace

TEST(GridMap, ReadsCellsRowByRow) {
    const GridMap map = GridMap::parse(
        ".#G\n"
        "S.H\n");
    EXPECT_EQ(map.rows(), 2u);
    EXPECT_EQ(map.columns(), 3u);
    EXPECT_EQ(map.size(), 6u);
    EXPECT_EQ(map.cell(state_id(0)), GridCell::free);
    EXPECT_EQ(map.cell(state_id(1)), GridCell::wall);
    EXPECT_EQ(map.cell(state_id(2)), GridCell::goal);
    EXPECT_EQ(map.cell(state_id(3)), GridCell::start);
    EXPECT_EQ(map.cell(state_id(5)), GridCell::hazard);
    EXPECT_EQ(map.state(1, 2), state_id(5));
    EXPECT_EQ(map.row(state_id(5)), 1u);
    EXPECT_EQ(map.column(state_id(5)), 2u);
    EXPECT_EQ(map.goals(), std::vector<StateId>{state_id(2)});
    EXPECT_EQ(map.starts(), std::vector<StateId>{state_id(3)});
}

TEST(GridMap, WithoutStartEveryFreeCellIsOne) {
    EXPECT_EQ(GridMap::parse(".#G\n.H.").starts(), (std::vector<StateId>{state_id(0), state_id(3), state_id(5)}));
    EXPECT_EQ(GridMap::parse("S.G\n..S").starts(), (std::vector<StateId>{state_id(0), state_id(5)}));
    EXPECT_EQ(GridMap::parse("SG").starts(), std::vector<StateId>{state_id(0)});
}

TEST(GridMap, SurvivesTheWayThroughText) {
    const std::string text = "S.#G\n.H..\n";
    EXPECT_EQ(GridMap::parse(text).text(), text);
    EXPECT_EQ(GridMap::parse("S.#G\r\n.H..\r\n\r\n\n"), GridMap::parse(text));
    EXPECT_EQ(GridMap::parse("S.#G\n.H.."), GridMap::parse(text));
    EXPECT_NE(GridMap::parse("S.#G.H.."), GridMap::parse(text));
}

TEST(GridMap, DescribesItsCells) {
    const GridMap map = GridMap::parse(".#G\nS.H");
    EXPECT_EQ(map.describe(state_id(0)), "row 0, column 0");
    EXPECT_EQ(map.describe(state_id(1)), "row 0, column 1 (wall)");
    EXPECT_EQ(map.describe(state_id(2)), "row 0, column 2 (goal)");
    EXPECT_EQ(map.describe(state_id(3)), "row 1, column 0 (start)");
    EXPECT_EQ(map.describe(state_id(5)), "row 1, column 2 (hazard)");
    EXPECT_EQ(error_of([&] { (void)map.describe(state_id(6)); }), "state must be below the number of states 6, got 6");
    EXPECT_EQ(error_of([&] { (void)map.state(2, 0); }), "row must be below 2, got 2");
    EXPECT_EQ(error_of([&] { (void)map.state(0, 3); }), "column must be below 3, got 3");
}

TEST(GridMap, SaysWhereAMapIsWrong) {
    EXPECT_EQ(parse_error(""), "m.txt:1:1: map is empty");
    EXPECT_EQ(parse_error("\n\n"), "m.txt:1:1: map is empty");
    EXPECT_EQ(parse_error("..G\n..x\n"), "m.txt:2:3: unknown cell 'x'; a map consists of . # G S H");
    EXPECT_EQ(parse_error("..G \n"), "m.txt:1:4: unknown cell ' '; a map consists of . # G S H");
    EXPECT_EQ(parse_error("..g\n"), "m.txt:1:3: unknown cell 'g'; a map consists of . # G S H");
    EXPECT_EQ(parse_error("\t.G\n"), "m.txt:1:1: unknown cell '\\x09'; a map consists of . # G S H");
    EXPECT_EQ(parse_error("..G\n..\n"), "m.txt:2:3: row has 2 cells, the first row has 3");
    EXPECT_EQ(parse_error("..G\n...\n.....\n"), "m.txt:3:4: row has 5 cells, the first row has 3");
    EXPECT_EQ(parse_error("..G\n\n...\n"), "m.txt:2:1: empty line before the end of the map");
    EXPECT_EQ(parse_error("\n..G\n"), "m.txt:1:1: empty line before the end of the map");
    EXPECT_EQ(parse_error("...\n.#.\n"), "m.txt:1:1: map has no goal 'G'");
    EXPECT_EQ(parse_error("#G\nH#\n"), "m.txt:1:1: map has no cell to start from, '.' or 'S'");
    EXPECT_EQ(parse_error(std::string("..\0G", 4)), "m.txt:1:3: NUL byte in what should be text");
    EXPECT_EQ(parse_error("G" + std::string(1048576, '.')), "m.txt:1:1048577: line is longer than 1048576 bytes");
}

TEST(GridMap, RefusesMoreCellsThanItHolds) {
    std::string text;
    for (int i = 0; i < 17; ++i) text += std::string(1048576, '.') + "\n";
    EXPECT_EQ(parse_error(text), "m.txt:17:1: map has more than 16777216 cells");
}

TEST(GridMap, LoadsFiles) {
    const std::string path = ::testing::TempDir() + "sspql_grid_map_test.txt";
    std::ofstream(path) << "S.G\n";
    EXPECT_EQ(GridMap::load(path), GridMap::parse("S.G"));
    std::ofstream(path) << "S.?\n";
    EXPECT_EQ(error_of([&] { (void)GridMap::load(path); }),
              path + ":1:3: unknown cell '?'; a map consists of . # G S H");
    EXPECT_EQ(error_of([] { (void)GridMap::load("/no/such/map"); }), "/no/such/map: cannot be opened");
}
