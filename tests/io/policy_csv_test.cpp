// SPDX-License-Identifier: MIT
#include <sspql/io/policy_csv.hpp>

#include <gtest/gtest.h>

#include <cstddef>
#include <string>

#include <sspql/learn/agent.hpp>
#include <sspql/learn/q_learning.hpp>
#include <sspql/learn/sspql.hpp>
#include <sspql/spaces/hashed_state.hpp>

#include "io/file_testing.hpp"

namespace sspql {
namespace {

using testing::content;
using PolicyCsv = testing::FileTest;

const std::string header = "state,visits,action,value,path_next,path_distance\n";

struct Words : HashedState<std::string> {
    [[nodiscard]] std::string describe(StateId s) const { return key(s); }
};

/// Right leads on from 0 to 2, the goal.
template <class L>
void teach_chain(L& learner) {
    learner.observe(state_id(0), action_id(1), 0.0, state_id(1), false);
    learner.observe(state_id(0), action_id(0), 0.0, state_id(0), false);
    learner.observe(state_id(1), action_id(1), 1.0, state_id(2), true);
}

}  // namespace

TEST_F(PolicyCsv, HasALineForEachState) {
    QLearning<> learner(3, 2);
    teach_chain(learner);
    save_policy_csv(path("p.csv"), learner);
    EXPECT_EQ(content(path("p.csv")), header + "0,2,0,0,,\n1,1,1,0.8,,\n2,0,0,0,,\n");
}

// One sure step costs e^-2 (eq. 2), the distance of 1.
TEST_F(PolicyCsv, HasPathsWhereTheLearnerHasThem) {
    Sspql<> learner(4, 2);
    teach_chain(learner);
    save_policy_csv(path("p.csv"), learner);
    const double step = learner.tree().distance[1];
    EXPECT_DOUBLE_EQ(step, 0.1353352832366127);
    EXPECT_EQ(content(path("p.csv")), header + "0,2,1,0,1," + detail::exact_text(step + step) + "\n1,1,1,0.8,2," +
                                          detail::exact_text(step) + "\n2,0,0,0,,0\n3,0,0,0,,\n");
}

TEST_F(PolicyCsv, HasTheLengthOfThePathWhereTheLearnerHasThat) {
    AdaptiveSspql<> learner(3, 2);
    teach_chain(learner);
    learner.set_goals({{state_id(2), 0.0}});
    save_policy_csv(path("p.csv"), learner);
    const std::string text = content(path("p.csv"));
    const std::string length = detail::exact_text(learner.path_length(state_id(1)));
    EXPECT_NE(length, "");
    EXPECT_NE(text.find(",," + length + "\n"), std::string::npos) << text;
}

TEST_F(PolicyCsv, AnAgentSpeaksItsOwnWords) {
    Agent robot(Words(), ActionTable<int>{-1, 1}, QLearningParams<>{});
    robot.observe(std::string("hall, \"north\""), action_id(1), 1.0, std::string("door"), true);
    save_policy_csv(path("p.csv"), robot);
    EXPECT_EQ(content(path("p.csv")), header + "\"hall, \"\"north\"\"\",1,1,0.8,,\ndoor,0,0,0,,\n");
}

TEST_F(PolicyCsv, WithoutStatesThereIsTheHeader) {
    save_policy_csv(path("p.csv"), QLearning<>(StateCount::growing(), 2));
    EXPECT_EQ(content(path("p.csv")), header);
}

}  // namespace sspql
