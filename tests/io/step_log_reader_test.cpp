// SPDX-License-Identifier: MIT
#include <sspql/io/step_log_reader.hpp>

#include <gtest/gtest.h>

#include <cstddef>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "io/logged_steps.hpp"

namespace sspql {
namespace {

using sspql::testing::header;

struct Reading {
    StepLogContent content;
    std::vector<LoggedStep> steps;
    std::string error = "no error";
};

Reading read(const std::string& text) {
    std::istringstream in(text);
    Reading reading;
    try {
        reading.content = for_each_step(in, "log", [&](const LoggedStep& step) { reading.steps.push_back(step); });
    } catch (const std::runtime_error& error) {
        reading.error = error.what();
    }
    return reading;
}

/// The error of a log whose second step is this line.
std::string error_of(const std::string& line) { return read(header + "4,0,7,1,-0.5,8,0,0\n" + line + "\n").error; }

}  // namespace

TEST(StepLogReader, ReadsStepsAndCountsEpisodes) {
    const Reading log = read(header + "0,0,4,1,-0.1,5,0,0\n0,1,5,0,1e3,6,1,0\n3,0,2,3,0,2,0,0\n4,0,9,0,0,9,0,1\n");
    EXPECT_EQ(log.error, "no error");
    EXPECT_EQ(log.content.episodes, 3u);
    EXPECT_EQ(log.content.unfinished, 1u) << "episode 3";
    EXPECT_EQ(log.content.steps, 4u);
    EXPECT_EQ(log.content.cut_line, 0u);
    ASSERT_EQ(log.steps.size(), 4u);
    const LoggedStep& second = log.steps[1];
    EXPECT_EQ(second.episode, 0u);
    EXPECT_EQ(second.step, 1u);
    EXPECT_EQ(second.transition.state, state_id(5));
    EXPECT_EQ(second.transition.action, action_id(0));
    EXPECT_EQ(second.transition.reward, 1000.0);
    EXPECT_EQ(second.transition.next, state_id(6));
    EXPECT_TRUE(second.transition.terminated);
    EXPECT_FALSE(second.truncated);
    EXPECT_EQ(second.transition.weight, 1.0);
    EXPECT_TRUE(log.steps[3].truncated);
}

TEST(StepLogReader, ReadsWeightsAndLineEndsOfOtherSystems) {
    const Reading log = read(
        "episode,step,state,action,reward,next,terminated,truncated,weight\r\n"
        "0,0,4,1,-0.1,5,1,1,1e-30\r\n1,0,4,1,-0.1,5,1,1,1e30\r\n");
    EXPECT_EQ(log.error, "no error");
    ASSERT_EQ(log.steps.size(), 2u);
    EXPECT_EQ(log.steps[0].transition.weight, 1e-30);
    EXPECT_EQ(log.steps[1].transition.weight, 1e30);
    EXPECT_EQ(log.content.unfinished, 0u);
}

// Cut at any byte, a log is one without its last line, and says so.
TEST(StepLogReader, EveryBeginningOfALogIsALog) {
    const std::string lf = header + "0,0,4,1,-0.1,5,0,0\n0,1,5,0,1,6,1,0\n1,0,6,2,-3e-7,6,0,1\n";
    std::string crlf;
    for (const char c : lf) crlf += c == '\n' ? std::string("\r\n") : std::string(1, c);
    for (const std::string& whole : {lf, crlf}) {
        for (std::size_t size = 0; size <= whole.size(); ++size) {
            SCOPED_TRACE(size);
            const std::string cut = whole.substr(0, size);
            std::size_t lines = 0;
            for (const char c : cut) lines += c == '\n';
            const Reading log = read(cut);
            EXPECT_EQ(log.error, "no error");
            EXPECT_EQ(log.content.steps, lines == 0 ? 0 : lines - 1);
            EXPECT_EQ(log.content.cut_line, cut.empty() || cut.back() == '\n' ? 0 : lines + 1);
            EXPECT_EQ(log.content.unfinished, lines == 2 ? 1u : 0u);
        }
    }
}

TEST(StepLogReader, OtherHeadersAreRefused) {
    const std::string expected = "log:1:1: header must be " + header.substr(0, header.size() - 1) + "[,weight], got ";
    EXPECT_EQ(read("s,a,next,p,reward,terminal\n").error, expected + "'s,a,next,p,reward,terminal'");
    EXPECT_EQ(read("a letter").error, expected + "'a letter'");
    EXPECT_EQ(read("\n").error, expected + "''");
    EXPECT_EQ(read("episode\r").error, expected + "'episode?'");
    EXPECT_EQ(read(header.substr(0, header.size() - 2) + "\n").error,
              expected + "'episode,step,state,action,reward,next,te...'");
}

TEST(StepLogReader, BadFieldsAreNamedWithTheirPlace) {
    EXPECT_EQ(error_of("4,1,8,1,0,9,0,0"), "no error");
    EXPECT_EQ(error_of(""), "log:3:1: line has 1 fields, not 8");
    EXPECT_EQ(error_of("4,1,8,1,0,9,0"), "log:3:14: line has 7 fields, not 8");
    EXPECT_EQ(error_of("4,1,8,1,0,9,0,0,1"), "log:3:17: line has more than 8 fields");
    EXPECT_EQ(error_of("x,1,8,1,0,9,0,0"), "log:3:1: episode must be a whole number from 0 on, got 'x'");
    EXPECT_EQ(error_of("4, 1,8,1,0,9,0,0"), "log:3:3: step must be a whole number from 0 on, got ' 1'");
    EXPECT_EQ(error_of("4,1,-8,1,0,9,0,0"), "log:3:5: state must be a whole number from 0 on, got '-8'");
    EXPECT_EQ(error_of("4,1,8,,0,9,0,0"), "log:3:7: action must be a whole number from 0 on, got ''");
    EXPECT_EQ(error_of("4,1,8,4294967295,0,9,0,0"), "log:3:7: action must be at most 4294967294, got '4294967295'");
    EXPECT_EQ(error_of("4,1,8,1,nan,9,0,0"), "log:3:9: reward must be a finite number, got 'nan'");
    EXPECT_EQ(error_of("4,1,8,1,1e999,9,0,0"), "log:3:9: reward must be a finite number, got '1e999'");
    EXPECT_EQ(error_of("4,1,8,1,0x1,9,0,0"), "log:3:9: reward must be a finite number, got '0x1'");
    EXPECT_EQ(error_of("4,1,8,1,0,18446744073709551616,0,0"),
              "log:3:11: next must be at most 4294967294, got '18446744073709551616'");
    EXPECT_EQ(error_of("4,1,8,1,0,9,2,0"), "log:3:13: terminated must be at most 1, got '2'");
    EXPECT_EQ(error_of("4,1,8,1,0,9,0,true"), "log:3:15: truncated must be a whole number from 0 on, got 'true'");
    EXPECT_EQ(error_of("# note"), "log:3:7: line has 1 fields, not 8");
    EXPECT_EQ(error_of(std::string(300, '1')), "log:3:257: line is longer than 256 bytes");
    EXPECT_EQ(error_of(std::string("4,1,8\0", 6)), "log:3:6: NUL byte in what should be text");
    const std::string weighted = "episode,step,state,action,reward,next,terminated,truncated,weight\n0,0,1,1,1,1,0,0,";
    EXPECT_EQ(read(weighted + "0\n").error, "log:2:17: weight must lie in [1e-30, 1e+30], got '0'");
    EXPECT_EQ(read(weighted + "1e31\n").error, "log:2:17: weight must lie in [1e-30, 1e+30], got '1e31'");
    EXPECT_EQ(read(weighted + "inf\n").error, "log:2:17: weight must be a finite number, got 'inf'");
}

TEST(StepLogReader, StepsThatDoNotFollowAreRefused) {
    EXPECT_EQ(error_of("4,1,7,1,0,9,0,0"), "log:3:5: state 7 is not where the last step led, 8");
    EXPECT_EQ(error_of("4,2,8,1,0,9,0,0"), "log:3:3: step 2 comes after step 0");
    EXPECT_EQ(error_of("4,0,8,1,0,9,0,0"), "log:3:3: step 0 comes after step 0");
    EXPECT_EQ(error_of("3,0,8,1,0,9,0,0"), "log:3:1: episode 3 comes after episode 4");
    EXPECT_EQ(error_of("5,1,8,1,0,9,0,0"), "log:3:3: episode 5 begins with step 1, not 0");
    EXPECT_EQ(read(header + "0,1,8,1,0,9,0,0\n").error, "log:2:3: episode 0 begins with step 1, not 0");
    EXPECT_EQ(read(header + "0,0,8,1,0,9,1,0\n0,1,9,1,0,9,0,0\n").error, "log:3:1: episode 0 goes on after its end");
    EXPECT_EQ(read(header + "0,0,8,1,0,9,0,1\n0,1,9,1,0,9,0,0\n").error, "log:3:1: episode 0 goes on after its end");
}

TEST(StepLogReader, AMissingFileIsNamed) {
    EXPECT_THROW((void)for_each_step("/nowhere/run.csv", [](const LoggedStep&) {}), std::runtime_error);
}

}  // namespace sspql
