// SPDX-License-Identifier: MIT
#include <sspql/env/table_csv.hpp>

#include <clocale>
#include <cstddef>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

using sspql::action_id;
using sspql::state_id;
using sspql::StateId;
using sspql::TransitionTable;

namespace {

const std::string header = "s,a,next,p,reward,terminal\n";

TransitionTable table_of(const std::string& text) {
    std::istringstream in(text);
    return sspql::read_table_csv(in, "t.csv");
}

template <class F>
std::string caught(F&& f) {
    try {
        f();
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "no error";
}

std::string error_of(const std::string& text) {
    return caught([&] { (void)table_of(text); });
}

/// The error of one row after the header, on line 2.
std::string row_error(const std::string& row) { return error_of(header + row + "\n"); }

}  // namespace

TEST(TableCsv, ReadsATable) {
    const TransitionTable table = table_of(
        "# start: 1\n"
        "s,a,next,p,reward,terminal\n"
        "0,1,2,1,-1.5e0,1\n"
        "0,0,0,.25,0,0\n"
        "0,0,1,0.75,0,0\n"
        "1,0,2,1,1,1\n");
    EXPECT_EQ(table.states(), 3u);
    EXPECT_EQ(table.actions(), 2u);
    EXPECT_EQ(table.size(), 4u);
    EXPECT_EQ(table.starts(), std::vector<StateId>{state_id(1)});
    EXPECT_EQ(table.outcomes(state_id(0), action_id(0))[1].probability, 0.75);
    EXPECT_EQ(table.outcomes(state_id(0), action_id(1))[0].reward, -1.5);
    EXPECT_TRUE(table.outcomes(state_id(0), action_id(1))[0].terminal);
    EXPECT_FALSE(table.has_actions(state_id(2)));
}

TEST(TableCsv, StartsEverywhereUnlessTold) {
    const std::string rows = header + "0,0,1,1,0,0\n1,0,0,1,0,0\n3,0,2,1,1,1\n";
    EXPECT_EQ(table_of(rows).starts(), (std::vector<StateId>{state_id(0), state_id(1), state_id(3)}));
    EXPECT_EQ(table_of("#start:3,0\n" + rows).starts(), (std::vector<StateId>{state_id(0), state_id(3)}));
    EXPECT_EQ(table_of("# Made by hand.\n#  start: 3 , 1 \n\n" + rows).starts(),
              (std::vector<StateId>{state_id(1), state_id(3)}));
}

TEST(TableCsv, TakesLinesAsPeopleWriteThem) {
    const TransitionTable table = table_of(
        "\xEF\xBB\xBFs, a, next, p, reward, terminal\r\n"
        "\r\n"
        "0, 0,\t1, 0.5, 1, true\r\n"
        "# half of it\r\n"
        "0, 0, 0, 5e-1, 0, False");
    EXPECT_EQ(table.size(), 2u);
}

TEST(TableCsv, RowsOfTheSamePlaceAddUp) {
    const TransitionTable table = table_of(header + "0,0,0,0.25,0,0\n0,0,1,0.5,1,1\n0,0,0,0.25,0,0\n");
    ASSERT_EQ(table.size(), 2u);
    EXPECT_EQ(table.outcomes(state_id(0), action_id(0))[0].probability, 0.5);
}

TEST(TableCsv, DoesNotMindTheLocale) {
    const std::string before = std::setlocale(LC_ALL, nullptr);
    if (std::setlocale(LC_ALL, "de_DE.UTF-8") == nullptr) (void)std::setlocale(LC_ALL, "C.UTF-8");
    EXPECT_EQ(table_of(header + "0,0,0,0.5,0,0\n0,0,1,0.5,1.5,1\n").outcomes(state_id(0), action_id(0))[1].reward, 1.5);
    (void)std::setlocale(LC_ALL, before.c_str());
}

TEST(TableCsv, SaysWhatIsWrongWithAField) {
    EXPECT_EQ(row_error("x,0,0,1,0,0"), "t.csv:2:1: s must be a whole number from 0 on, got 'x'");
    EXPECT_EQ(row_error("-1,0,0,1,0,0"), "t.csv:2:1: s must be a whole number from 0 on, got '-1'");
    EXPECT_EQ(row_error("0,1.5,0,1,0,0"), "t.csv:2:3: a must be a whole number from 0 on, got '1.5'");
    EXPECT_EQ(row_error("0,0,,1,0,0"), "t.csv:2:5: next must be a whole number from 0 on, got ''");
    EXPECT_EQ(row_error("10000000,0,0,1,0,0"), "t.csv:2:1: s must be below 10000000, got '10000000'");
    EXPECT_EQ(row_error("0,0,99999999999999999999,1,0,0"),
              "t.csv:2:5: next must be below 10000000, got '99999999999999999999'");
    EXPECT_EQ(row_error("0,256,0,1,0,0"), "t.csv:2:3: a must be below 256, got '256'");
    EXPECT_EQ(row_error("9999999,99,0,1,0,0"),
              "t.csv:2:1: table would have 10000000 x 100 states and actions, more than 50000000");
    EXPECT_EQ(row_error("0,0,0,one,0,0"), "t.csv:2:7: p must be a finite number, got 'one'");
    EXPECT_EQ(row_error("0,0,0,1x,0,0"), "t.csv:2:7: p must be a finite number, got '1x'");
    EXPECT_EQ(row_error("0,0,0,nan,0,0"), "t.csv:2:7: p must be a finite number, got 'nan'");
    EXPECT_EQ(row_error("0,0,0,-0.5,0,0"), "t.csv:2:7: p must lie in (0, 1], got -0.5");
    EXPECT_EQ(row_error("0,0,0,0,0,0"), "t.csv:2:7: p must lie in (0, 1], got 0");
    EXPECT_EQ(row_error("0,0,0,1.0001,0,0"), "t.csv:2:7: p must lie in (0, 1], got 1.0001");
    EXPECT_EQ(row_error("0,0,0,1,inf,0"), "t.csv:2:9: reward must be a finite number, got 'inf'");
    EXPECT_EQ(row_error("0,0,0,1,1e999,0"), "t.csv:2:9: reward must be a finite number, got '1e999'");
    EXPECT_EQ(row_error("0,0,0,1,0,2"), "t.csv:2:11: terminal must be 0 or 1, got '2'");
    EXPECT_EQ(row_error("0, 0, 0, 1, 0, yes"), "t.csv:2:16: terminal must be 0 or 1, got 'yes'");
}

TEST(TableCsv, SaysWhatIsWrongWithALine) {
    EXPECT_EQ(error_of(""), "t.csv:1:1: table is empty; it must begin with s,a,next,p,reward,terminal");
    EXPECT_EQ(error_of("# start: 0\n"), "t.csv:1:1: table is empty; it must begin with s,a,next,p,reward,terminal");
    EXPECT_EQ(error_of(header), "t.csv:1:1: table has no rows after its header");
    EXPECT_EQ(error_of("0,0,0,1,0,0\n"), "t.csv:1:1: header must be s,a,next,p,reward,terminal");
    EXPECT_EQ(error_of("s,a,next,prob,reward,terminal\n"), "t.csv:1:10: header must be s,a,next,p,reward,terminal");
    EXPECT_EQ(error_of("s,a,next,p,reward\n"), "t.csv:1:18: header must be s,a,next,p,reward,terminal");
    EXPECT_EQ(error_of("s,a,next,p,reward,terminal,x\n"), "t.csv:1:28: header must be s,a,next,p,reward,terminal");
    EXPECT_EQ(row_error("0,0,0,1,0"), "t.csv:2:10: row has 5 fields, not 6: s,a,next,p,reward,terminal");
    EXPECT_EQ(row_error("0,0,0,1,0,0,7"), "t.csv:2:13: row has 7 fields, not 6: s,a,next,p,reward,terminal");
    EXPECT_EQ(error_of(header + std::string("0,0\0", 4)), "t.csv:2:4: NUL byte in what should be text");
    EXPECT_EQ(error_of(std::string(2000000, 'x')), "t.csv:1:1048577: line is longer than 1048576 bytes");
}

TEST(TableCsv, SaysWhichProbabilitiesDoNotSumToOne) {
    EXPECT_EQ(error_of(header + "0,0,0,1,0,0\n3,1,0,0.5,0,0\n0,1,0,1,0,0\n3,1,3,0.4,0,0\n"),
              "t.csv:3:7: probabilities of state 3, action 1 must sum to 1 within 1e-9, got 0.9");
    EXPECT_EQ(error_of(header + "0,0,0,0.5,0,0\n0,0,0,0.5,0,0\n0,0,0,0.5,0,0\n"),
              "t.csv:2:7: probabilities of state 0, action 0 must sum to 1 within 1e-9, got 1.5");
}

TEST(TableCsv, SaysWhereAnEpisodeCouldNotGoOn) {
    EXPECT_EQ(error_of(header + "0,0,0,0.5,0,0\n0,0,7,0.5,0,0\n"),
              "t.csv:3:5: state 0, action 0 must be terminal where it enters state 7, which has no actions");
}

TEST(TableCsv, SaysWhatIsWrongWithStarts) {
    const std::string rows = header + "0,0,1,1,1,1\n";
    EXPECT_EQ(error_of("# start: 0,9\n" + rows), "t.csv:1:12: start state 9 has no actions");
    EXPECT_EQ(error_of("# start: 1\n" + rows), "t.csv:1:10: start state 1 has no actions");
    EXPECT_EQ(error_of("# start: 0,0\n" + rows), "t.csv:1:12: start state 0 is given twice");
    EXPECT_EQ(error_of("# start: 0;1\n" + rows), "t.csv:1:10: start state must be a whole number from 0 on, got '0;1'");
    EXPECT_EQ(error_of("# start:\n" + rows), "t.csv:1:9: start state must be a whole number from 0 on, got ''");
    EXPECT_EQ(error_of("# start: 0\n# start: 0\n" + rows), "t.csv:2:1: start states are given twice");
    EXPECT_EQ(error_of(rows + "# start: 0\n"), "t.csv:3:1: start states must be given before the header");
}

TEST(TableCsv, LoadsFiles) {
    const std::string path = ::testing::TempDir() + "sspql_table_csv_test.csv";
    std::ofstream(path) << header << "0,0,1,1,1,1\n";
    EXPECT_EQ(sspql::load_table_csv(path).states(), 2u);
    std::ofstream(path) << header << "0,0,1,1,1\n";
    EXPECT_EQ(caught([&] { (void)sspql::load_table_csv(path); }),
              path + ":2:10: row has 5 fields, not 6: s,a,next,p,reward,terminal");
    EXPECT_EQ(caught([] { (void)sspql::load_table_csv("/no/such/table"); }), "/no/such/table: cannot be opened");
}
