// SPDX-License-Identifier: MIT
#include <sspql/io/logged.hpp>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <sspql/env/grid_maps.hpp>
#include <sspql/env/grid_world.hpp>
#include <sspql/io/replay.hpp>
#include <sspql/io/step_log.hpp>
#include <sspql/learn/agent.hpp>
#include <sspql/learn/q_learning.hpp>
#include <sspql/learn/sspql.hpp>
#include <sspql/run/episode.hpp>
#include <sspql/spaces/action_policy.hpp>
#include <sspql/spaces/hashed_state.hpp>

#include "io/file_testing.hpp"
#include "io/logged_steps.hpp"

namespace sspql {
namespace {

using testing::error_of;

using sspql::testing::header;

/// Q, counts and tree.
std::vector<double> learnt(const Sspql<>& learner) {
    std::vector<double> seen = learner.tree().distance;
    for (std::size_t s = 0; s < learner.states(); ++s) {
        for (std::size_t a = 0; a < learner.actions(); ++a) {
            const ActionTerms terms = learner.terms(state_id(s), action_id(a));
            for (const double x : {terms.q, terms.ssp, terms.n}) seen.push_back(x);
        }
    }
    return seen;
}

using LoggedAgent = testing::FileTest;

// Observations in, ids in the log; the replayed learner is the agent's own.
TEST_F(LoggedAgent, RunsAsTheAgentDoes) {
    GridWorld world = grid_task("dyna-maze").world();
    using Robot = Agent<HashedState<StateId>, EnumActions<Move>, Sspql<>>;
    Robot robot(HashedState<StateId>{}, EnumActions<Move>(4), {}, 3);
    Robot unlogged = robot;
    {
        StepLog log(path("run.csv"));
        Logged logged(robot, log);
        for (std::uint64_t k = 0; k < 5; ++k) {
            const EpisodeResult with = run_episode(world, logged, k);
            EXPECT_EQ(with.steps, run_episode(world, unlogged, k).steps);
        }
        EXPECT_EQ(log.episode(), 5u);
    }
    EXPECT_EQ(learnt(robot.learner()), learnt(unlogged.learner()));
    Sspql<> pupil(StateCount::growing(), 4, {}, 3);
    EXPECT_EQ(replay(path("run.csv"), pupil).episodes, 5u);
    EXPECT_EQ(pupil.begin(state_id(0)), unlogged.learner().begin(state_id(0)));
    EXPECT_EQ(learnt(pupil), learnt(unlogged.learner()));
}

TEST_F(LoggedAgent, WeightsThatCannotBeLoggedAreRefusedBeforeAnythingIsLearnt) {
    QLearning<> learner(3, 1);
    StepLog log(path("run.csv"));
    Logged logged(learner, log);
    (void)logged.begin(state_id(0));
    EXPECT_EQ(error_of<std::invalid_argument>([&] { (void)logged.step(0.0, state_id(1), 2.0); }),
              "weight must be 1 in a step log without weights, got 2");
    EXPECT_EQ(learner.state(), state_id(0));
    EXPECT_THROW((void)logged.step(std::numeric_limits<double>::quiet_NaN(), state_id(1)), std::invalid_argument);
    EXPECT_THROW((void)logged.begin(state_id(1)), std::logic_error);
    logged.end(1.0, state_id(1), true);
    log.flush();
    EXPECT_EQ(testing::content(path("run.csv")), header + "0,0,0,0,1,1,1,0\n");
}

}  // namespace
}  // namespace sspql
