// SPDX-License-Identifier: MIT
#include <sspql/io/step_log.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>

#include <sspql/io/step_log_reader.hpp>

#include "io/file_testing.hpp"
#include "io/logged_steps.hpp"

namespace sspql {
namespace {

namespace fs = std::filesystem;
using testing::content;
using testing::error_of;
using testing::set_content;

using StepLogTest = testing::FileTest;

using sspql::testing::header;
using sspql::testing::step;

TEST_F(StepLogTest, OneLineAStep) {
    StepLog log(path("run.csv"));
    log.write(step(4, 1, -0.1, 5));
    log.write(step(5, 0, 1.0, 6, true));
    log.write(step(2, 3, 0.0, 2), true);
    log.write(step(7, 0, 1e300, 8));
    log.abort();
    log.abort();
    log.write(step(1, 2, -0.0, 1));
    EXPECT_EQ(log.episode(), 3u);
    log.close();
    EXPECT_EQ(content(path("run.csv")), header +
                                            "0,0,4,1,-0.1,5,0,0\n0,1,5,0,1,6,1,0\n1,0,2,3,0,2,0,1\n"
                                            "2,0,7,0,1e+300,8,0,0\n3,0,1,2,-0,1,0,0\n");
}

TEST_F(StepLogTest, WeightsAreAColumnIfAskedFor) {
    StepLogOptions options;
    options.weights = true;
    StepLog log(path("run.csv"), options);
    Transition t = step(0, 0, 0.5, 1, true);
    t.weight = 2.5;
    log.write(t);
    log.close();
    EXPECT_EQ(content(path("run.csv")),
              "episode,step,state,action,reward,next,terminated,truncated,weight\n"
              "0,0,0,0,0.5,1,1,0,2.5\n");
    EXPECT_EQ(error_of<std::runtime_error>([&] { StepLog other(path("run.csv")); }),
              path("run.csv") +
                  ":1:1: header must be episode,step,state,action,reward,next,terminated,truncated to "
                  "continue this log, got 'episode,step,state,action,reward,next,te...'");
}

TEST_F(StepLogTest, EveryStepOrEveryEpisodeIsThere) {
    StepLogOptions options;
    options.flush = LogFlush::every_step;
    StepLog eager(path("eager.csv"), options);
    eager.write(step(0, 0, 0.0, 1));
    EXPECT_EQ(content(path("eager.csv")), header + "0,0,0,0,0,1,0,0\n");

    StepLog lazy(path("lazy.csv"));
    lazy.write(step(0, 0, 0.0, 1));
    EXPECT_EQ(content(path("lazy.csv")), header);
    lazy.write(step(1, 0, 0.0, 2), true);
    EXPECT_EQ(content(path("lazy.csv")), header + "0,0,0,0,0,1,0,0\n0,1,1,0,0,2,0,1\n");
    lazy.write(step(1, 0, 0.0, 2));
    lazy.flush();
    EXPECT_EQ(content(path("lazy.csv")), header + "0,0,0,0,0,1,0,0\n0,1,1,0,0,2,0,1\n1,0,1,0,0,2,0,0\n");
}

// An endless episode does not fill the memory.
TEST_F(StepLogTest, LongEpisodesAreWrittenMeanwhile) {
    StepLogOptions options;
    options.synchronise = false;
    StepLog log(path("run.csv"), options);
    for (std::size_t i = 0; i < 10000; ++i) log.write(step(i, 0, 0.0, i + 1));
    EXPECT_GT(fs::file_size(path("run.csv")), 65536u);
    EXPECT_EQ(content(path("run.csv")).back(), '\n') << "whole lines only";
}

TEST_F(StepLogTest, RewardsComeBackBitByBit) {
    constexpr double largest = std::numeric_limits<double>::max();
    const double rewards[] = {0.1,
                              1.0 / 3.0,
                              -largest,
                              largest,
                              std::numeric_limits<double>::denorm_min(),
                              -0.0,
                              123456789.123456789,
                              5e-324,
                              2.2250738585072011e-308,
                              0x1.fffffffffffffp-3};
    {
        StepLog log(path("run.csv"));
        for (const double reward : rewards) log.write(step(0, 0, reward, 0));
    }
    std::size_t i = 0;
    for_each_step(path("run.csv"), [&](const LoggedStep& logged) {
        ASSERT_LT(i, std::size(rewards));
        EXPECT_EQ(logged.transition.reward, rewards[i]) << i;
        EXPECT_EQ(std::signbit(logged.transition.reward), std::signbit(rewards[i])) << i;
        ++i;
    });
    EXPECT_EQ(i, std::size(rewards));
}

TEST_F(StepLogTest, ContinuesAnExistingLog) {
    { StepLog(path("run.csv")).write(step(0, 0, 0.0, 1, true)); }
    { StepLog(path("run.csv")).write(step(3, 0, 0.0, 4)); }
    { StepLog(path("run.csv")).write(step(5, 0, 0.0, 6)); }
    { StepLog nothing(path("run.csv")); }
    EXPECT_EQ(content(path("run.csv")), header + "0,0,0,0,0,1,1,0\n1,0,3,0,0,4,0,0\n2,0,5,0,0,6,0,0\n");
}

// Cut anywhere, the log goes on behind its last whole line.
TEST_F(StepLogTest, ContinuesALogCutAtAnyByte) {
    const std::string whole = header + "0,0,4,1,-0.1,5,0,0\n7,0,5,0,1,6,1,0\n";
    for (std::size_t size = 0; size <= whole.size(); ++size) {
        SCOPED_TRACE(size);
        const std::string cut = whole.substr(0, size);
        set_content(path("run.csv"), cut);
        { StepLog(path("run.csv")).write(step(9, 0, 2.0, 9, true)); }
        std::string kept = cut.substr(0, cut.rfind('\n') + 1);
        const char* episode = kept.size() <= header.size() ? "0" : kept.size() == whole.size() ? "8" : "1";
        if (kept.empty()) kept = header;
        EXPECT_EQ(content(path("run.csv")), kept + episode + ",0,9,0,2,9,1,0\n");
    }
}

// Line ends of another system, cut between the two: the lines written from now on end as ours do.
TEST_F(StepLogTest, ContinuesALogOfAnotherSystem) {
    const std::string first = header.substr(0, header.size() - 1) + "\r";
    set_content(path("run.csv"), first);
    { StepLog(path("run.csv")).write(step(9, 0, 2.0, 9, true)); }
    EXPECT_EQ(content(path("run.csv")), header + "0,0,9,0,2,9,1,0\n");
    set_content(path("run.csv"), first + "\n0,0,9,0,2,9,1,0\r\n1,0,9,0,2,9,1,0\r");
    { StepLog(path("run.csv")).write(step(9, 0, 2.0, 9, true)); }
    EXPECT_EQ(content(path("run.csv")), first + "\n0,0,9,0,2,9,1,0\r\n1,0,9,0,2,9,1,0\n");
}

// What a power cut leaves in the place of what was not written yet: zeros.
TEST_F(StepLogTest, ContinuesBehindALongTailOfZeros) {
    set_content(path("run.csv"), header + "4,0,4,1,-0.1,5,1,0\n5,0" + std::string(20000, '\0'));
    { StepLog(path("run.csv")).write(step(9, 0, 2.0, 9, true)); }
    EXPECT_EQ(content(path("run.csv")), header + "4,0,4,1,-0.1,5,1,0\n5,0,9,0,2,9,1,0\n");
}

TEST_F(StepLogTest, OtherFilesAreRefusedAndStay) {
    const std::string name = path("other");
    const auto refusal = [&](const std::string& text) {
        set_content(name, text);
        const std::string error = error_of<std::runtime_error>([&] { StepLog log(name); });
        EXPECT_EQ(content(name), text);
        return error;
    };
    const std::string expected =
        name + ":1:1: header must be " + header.substr(0, header.size() - 1) + " to continue this log, got ";
    EXPECT_EQ(refusal("a letter\nto a friend"), expected + "'a letter'");
    EXPECT_EQ(refusal("a letter"), expected + "'a letter'");
    EXPECT_EQ(refusal("\n"), expected + "''");
    EXPECT_EQ(refusal("episode\r"), expected + "'episode'");
    EXPECT_EQ(refusal(header + "0,0,4,1,-0.1,5,0\n"), name + " (last line):1:17: line has 7 fields, not 8");
    EXPECT_EQ(refusal(header + std::string(5000, 'x') + "\n1"),
              name + " (last line):1:257: line is longer than 256 bytes");
    EXPECT_EQ(refusal(header + "18446744073709551615,0,4,1,-0.1,5,0,0\n"),
              name + " (last line):1:1: episode must be at most 18446744073709551614, got '18446744073709551615'");
    EXPECT_EQ(refusal(header + "18446744073709551614,0,4,1,-0.1,5,0,0\n"),
              name + " (last line):1:1: no log has an episode after 18446744073709551614");
    EXPECT_EQ(error_of<std::runtime_error>([] { StepLog log("/dev/null"); }),
              "cannot write /dev/null: not a regular file");
    EXPECT_EQ(error_of<std::runtime_error>([&] { StepLog log(path("missing/x")); }),
              "cannot write " + path("missing/x") + ": No such file or directory");
}

TEST_F(StepLogTest, TwoWritersAreRefused) {
    StepLog log(path("run.csv"));
    EXPECT_EQ(error_of<std::runtime_error>([&] { StepLog other(path("run.csv")); }),
              "cannot write " + path("run.csv") + ": somebody else is writing it");
}

TEST_F(StepLogTest, BadStepsAreRefusedAndNotLogged) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    StepLog log(path("run.csv"));
    log.write(step(0, 0, 0.0, 1));
    const auto refusal = [&](const Transition& t) { return error_of<std::invalid_argument>([&] { log.write(t); }); };
    EXPECT_EQ(refusal(step(2, 0, 0.0, 1)), "state must be where the last step led, 1, got 2");
    EXPECT_EQ(refusal(step(1, 0, infinity, 1)), "reward must be finite, got inf");
    EXPECT_EQ(refusal({state_id(1), no_action, 0.0, state_id(1)}), "action must be an action's id, got 4294967295");
    EXPECT_EQ(refusal({state_id(1), action_id(0), 0.0, no_state}), "next must be a state's id, got 4294967295");
    EXPECT_EQ(refusal({state_id(1), action_id(0), 0.0, state_id(1), false, 2.0}),
              "weight must be 1 in a step log without weights, got 2");
    log.write(step(1, 0, 0.0, 1, true));
    log.close();
    EXPECT_EQ(content(path("run.csv")), header + "0,0,0,0,0,1,0,0\n0,1,1,0,0,1,1,0\n");
    EXPECT_EQ(error_of<std::logic_error>([&] { log.write(step(1, 0, 0.0, 1)); }),
              "StepLog: " + path("run.csv") + " was closed before");
}

}  // namespace
}  // namespace sspql
