// SPDX-License-Identifier: MIT
// What a learner lived through, another one can live through again from its log.
#include <sspql/io/replay.hpp>

#include <gtest/gtest.h>

#include <cstddef>
#include <sstream>
#include <stdexcept>
#include <string>

#include <sspql/io/logged.hpp>
#include <sspql/io/step_log.hpp>

#include "io/file_testing.hpp"
#include "io/logged_steps.hpp"
#include "learn/learner_testing.hpp"

namespace sspql {
namespace {

using testing::error_of;
using testing::fingerprint;
using testing::Room;

using sspql::testing::header;

template <class L>
class Replay : public testing::FileTest {
protected:
    StepLog new_log(bool weights = false) {
        StepLogOptions options;
        options.synchronise = false;
        options.weights = weights;
        return StepLog(path("run.csv"), options);
    }
};
TYPED_TEST_SUITE(Replay, testing::AllLearners, testing::LearnerNames);

// Noise, overrides, truncated and dropped episodes, weights: the pupil ends up as the actor's copy.
TYPED_TEST(Replay, MakesABitwiseCopy) {
    TypeParam actor(Room::states, Room::actions, {}, 2);
    {
        StepLog log = this->new_log(true);
        Logged<TypeParam> logged(actor, log);
        Room room(2, 0.1);
        Random operator_(5);
        for (int episode = 0; episode < 12; ++episode) {
            StateId s = Room::at(0, 0);
            (void)logged.begin(s);
            for (int i = 0;; ++i) {
                if (operator_.chance(0.1)) actor.replace_action(action_id(operator_.below(Room::actions)));
                s = room.step(s, actor.action());
                const bool home = s == Room::at(4, 4);
                const double weight = 1.0 + static_cast<double>(i % 3);
                if (home || i == 200) {
                    logged.end(home ? 1.0 : -0.01, s, home, weight);
                    break;
                }
                (void)logged.step(-0.01, s, weight);
                if (episode % 4 == 3 && i == 20) {
                    logged.abort();
                    break;
                }
            }
        }
    }
    TypeParam pupil(Room::states, Room::actions, {}, 2);
    const StepLogContent content = replay(this->path("run.csv"), pupil);
    EXPECT_EQ(content.episodes, 12u);
    EXPECT_EQ(content.cut_line, 0u);
    EXPECT_FALSE(pupil.running());
    actor.abort();
    // The state where an episode was dropped is not part of what was learnt: begin both anew.
    EXPECT_EQ(actor.begin(Room::at(1, 1)), pupil.begin(Room::at(1, 1))) << "the same random numbers";
    EXPECT_EQ(fingerprint(actor), fingerprint(pupil));
}

TYPED_TEST(Replay, SaysWhereAStepIsNotForTheLearner) {
    TypeParam learner(10, 3, {}, 1);
    const auto error = [&](const std::string& line) {
        std::istringstream in(header + "0,0,1,0,0,2,0,0\n" + line + "\n");
        const std::string what = error_of<std::runtime_error>([&] { (void)replay(in, "log", learner); });
        EXPECT_FALSE(learner.running());
        return what;
    };
    EXPECT_EQ(error("0,1,2,3,0,2,0,0"), "log:3:7: action must be below the learner's number of actions, 3, got '3'");
    EXPECT_EQ(error("0,1,2,0,1e101,2,0,0"), "log:3:9: reward must lie in [-1e+100, 1e+100], got '1e+101'");
    EXPECT_EQ(error("0,1,2,0,0,10,0,0"), "log:3:11: next must be below the learner's number of states, 10, got '10'");
    EXPECT_EQ(error("1,0,12,0,0,1,0,0"), "log:3:5: state must be below the learner's number of states, 10, got '12'");
    EXPECT_EQ(error("0,1,3,0,0,1,0,0"), "log:3:5: state 3 is not where the last step led, 2");
    EXPECT_EQ(learner.visits()(state_id(1), action_id(0)), 5u) << "what came before was learnt";
}

TYPED_TEST(Replay, OfACutLogLearnsTheWholeLines) {
    TypeParam learner(10, 3, {}, 1);
    std::istringstream in(header + "0,0,1,0,0,2,0,0\n0,1,2,1,1,3,1,");
    const StepLogContent content = replay(in, "log", learner);
    EXPECT_EQ(content.cut_line, 3u);
    EXPECT_EQ(content.unfinished, 1u);
    EXPECT_FALSE(learner.running());
    EXPECT_EQ(learner.visits()(state_id(1), action_id(0)), 1u);
    EXPECT_EQ(learner.visits()(state_id(2), action_id(1)), 0u);
}

TYPED_TEST(Replay, DuringAnEpisodeIsRefused) {
    TypeParam learner(10, 3, {}, 1);
    (void)learner.begin(state_id(0));
    std::istringstream in(header);
    EXPECT_EQ(error_of<std::logic_error>([&] { (void)replay(in, "log", learner); }),
              "replay() during an episode: end() or abort() it first");
}

TEST(ReplayGrowing, TakesIdsInTheOrderOfDiscovery) {
    QLearning<> learner(StateCount::growing(), 2);
    std::istringstream in(header + "0,0,0,0,0,1,0,0\n0,1,1,1,1,2,1,0\n1,0,3,0,0,4,1,0\n");
    EXPECT_EQ(replay(in, "log", learner).steps, 3u);
    EXPECT_EQ(learner.states(), 5u);
    std::istringstream gap(header + "0,0,6,0,0,1,0,0\n");
    EXPECT_EQ(error_of<std::runtime_error>([&] { (void)replay(gap, "log", learner); }),
              "log:2:5: state must be at most the learner's number of states so far, 5, got '6'");
}

}  // namespace
}  // namespace sspql
