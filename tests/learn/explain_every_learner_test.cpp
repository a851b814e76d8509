// SPDX-License-Identifier: MIT
#include <sspql/io/explain.hpp>

#include <gtest/gtest.h>

#include <cstddef>
#include <stdexcept>

#include "learn/learner_testing.hpp"

namespace sspql_explain_every_learner_test {

using namespace sspql;
using namespace sspql::testing;

template <class L>
class ExplainEveryLearner : public ::testing::Test {};
TYPED_TEST_SUITE(ExplainEveryLearner, AllLearners, LearnerNames);

TYPED_TEST(ExplainEveryLearner, TellsWhatTheLearnerTellsAndChangesNothing) {
    TypeParam learner(Room::states, Room::actions, {}, 3);
    Room room(3, 0.1);
    for (int k = 0; k < 20; ++k) (void)walk(learner, room, Room::at(0, 0), Room::at(4, 4));
    learner.set_legal_actions(Room::at(2, 2), ActionSet::of(4, {action_id(2), action_id(3)}));
    (void)learner.begin(Room::at(3, 4));
    const auto before = fingerprint(learner);
    for (std::size_t i = 0; i < Room::states; ++i) {
        const StateId s = state_id(i);
        const Explanation why = explain(learner, s);
        EXPECT_EQ(why.state, s);
        EXPECT_EQ(why.best, learner.best(s));
        EXPECT_EQ(why.chosen, s == Room::at(3, 4) ? learner.action() : no_action);
        ASSERT_EQ(why.actions.size(), Room::actions);
        for (const ActionExplanation& a : why.actions) {
            EXPECT_EQ(a.terms.sum(), learner.terms(s, a.action).sum());
            EXPECT_EQ(a.terms.n, learner.terms(s, a.action).n);
            EXPECT_EQ(a.legal, s != Room::at(2, 2) || index(a.action) >= 2);
            EXPECT_TRUE(!a.legal || a.terms.sum() <= why.actions[index(why.leading)].terms.sum());
            EXPECT_EQ(a.likely != no_state, why.has_model && a.terms.n > 0.0);
        }
        EXPECT_TRUE(why.actions[index(why.leading)].legal);
    }
    EXPECT_EQ(fingerprint(learner), before);
    const Explanation start = explain(learner, Room::at(0, 0));
    EXPECT_EQ(start.has_model, (detail::is_detected_v<detail::CountsExpression, TypeParam>));
    if constexpr (detail::is_detected_v<detail::CountsExpression, TypeParam>) {
        const ShortestPathTree tree = learnt_paths(learner);
        EXPECT_EQ(start.distance, tree.distance[0]);
        EXPECT_EQ(start.next, tree.next[0]);
        EXPECT_EQ(start.path.front().state, Room::at(0, 0));
        EXPECT_EQ(start.path.back().state, Room::at(4, 4));
        EXPECT_EQ(start.path.back().action, no_action);
        EXPECT_EQ(to_text(explain(learner, Room::at(0, 0), tree)), to_text(start));
    } else {
        EXPECT_TRUE(start.path.empty());
    }
    EXPECT_THROW((void)explain(learner, state_id(Room::states)), std::invalid_argument);
}

}  // namespace sspql_explain_every_learner_test
