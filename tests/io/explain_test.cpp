// SPDX-License-Identifier: MIT
#include <sspql/io/explain.hpp>

#include <gtest/gtest.h>

#include <cstddef>
#include <limits>
#include <sstream>
#include <string>

#include <sspql/learn/agent.hpp>
#include <sspql/learn/q_learning.hpp>
#include <sspql/learn/rtdp.hpp>
#include <sspql/spaces/hashed_state.hpp>

namespace sspql {
namespace {

constexpr ActionId a0{0}, a1{1};

/// Right leads on from 0 to 2, the goal; left leads nowhere.
template <class L>
void teach_chain(L& learner) {
    learner.observe(state_id(0), a1, 0.0, state_id(1), false);
    learner.observe(state_id(0), a0, 0.0, state_id(0), false);
    learner.observe(state_id(1), a1, 1.0, state_id(2), true);
}

template <class L>
std::string text_of(const L& learner, std::size_t s, const ExplainOptions& options = {}) {
    std::ostringstream out;
    out << explain(learner, state_id(s), options);
    return out.str();
}

struct Steering : ActionTable<int> {
    Steering() : ActionTable{-1, 1} {}
    [[nodiscard]] std::string describe(ActionId a) const { return a == a0 ? "zurück" : "vor"; }
};

struct Rooms : HashedState<std::string> {
    [[nodiscard]] std::string describe(StateId s) const { return key(s); }
};

}  // namespace

// Edges cost e^-2 = 0.1353 (eq. 2). Each action was tried once: w_SSP Q_SSP = 1 e^0 on the path (eqs. 5, 9), and
// w_EXP Q_EXP = 0.1 / 2^1.5 = 0.0354 (eq. 7), for an action never tried 0.1. Q(1,1) = 0.8, backed up to 0 not yet.
TEST(Explain, SspqlInFull) {
    Sspql<> learner(4, 2);
    teach_chain(learner);
    EXPECT_EQ(text_of(learner, 0),
              "state 0: cost 0.2707 to the goal\n"
              "   action  value   path  curiosity    sum  tries  leads to  share   to go\n"
              "   0       0.000  0.000      0.035  0.035      1  0         100 %  0.2707\n"
              ">  1       0.000  1.000      0.035  1.035      1  1         100 %  0.1353\n"
              "would choose 1, but for chance; best as far as known: 1\n"
              "way: 0 -1-> 1 -1-> 2\n");
    EXPECT_EQ(text_of(learner, 1),
              "state 1: cost 0.1353 to the goal\n"
              "   action  value   path  curiosity    sum  tries  leads to     share   to go\n"
              "   0       0.000  0.000      0.100  0.100      0\n"
              ">  1       0.800  1.000      0.035  1.835      1  2 (the end)  100 %  0.0000\n"
              "would choose 1, but for chance; best as far as known: 1\n"
              "way: 1 -1-> 2\n");
    EXPECT_EQ(text_of(learner, 2),
              "state 2: a goal\n"
              "   action   value  curiosity     sum  tries  leads to  share  to go\n"
              ">  0       0.0000     0.1000  0.1000      0\n"
              "   1       0.0000     0.1000  0.1000      0\n"
              "would choose 0, but for chance; best as far as known: 0\n");
    EXPECT_EQ(text_of(learner, 3).substr(0, 35), "state 3: no way to a goal is known\n");
}

// Full backups: Q(1,1) = 1; of four tries in 0 three lead to 1: Q(0,1) = 0.8 (3 x 1 + max Q(0)) / 4, from 0 on with
// each backup of state 0 nearer to 0.75. One step costs 1 / P: 4/3, and 1 from there.
TEST(Explain, ALearnerThatKeepsCountsOnly) {
    RtdpParams<> params;
    params.gamma = 1.0;
    Rtdp<> learner(3, 2, params);
    learner.observe(state_id(1), a1, 1.0, state_id(2), true);
    learner.observe(state_id(0), a1, 0.0, state_id(0), false);
    for (int k = 0; k < 3; ++k) learner.observe(state_id(0), a1, 0.0, state_id(1), false);
    // 0; then (0 + 1) / 2; then (1/2 + 2) / 3; then (5/6 + 3) / 4 = 0.9583.
    EXPECT_EQ(text_of(learner, 0),
              "state 0: 2.333 steps to the goal\n"
              "   action   value  tries  leads to  share  to go\n"
              "   0       0.0000      0\n"
              ">  1       0.9583      4  1          75 %  1.000\n"
              "would choose 1, but for chance; best as far as known: 1\n"
              "way: 0 -1-> 1 -1-> 2\n");
}

TEST(Explain, WithoutAModelThereAreTermsAndTries) {
    QLearning<> learner(3, 3);
    learner.observe(state_id(0), a1, 1.0, state_id(1), true);
    learner.teach(state_id(0), a0, 0.25);
    learner.set_legal_actions(state_id(0), ActionSet::of(3, {a0, a1}));
    EXPECT_EQ(text_of(learner, 0),
              "state 0\n"
              "   action   value    hint     sum  tries\n"
              "   0       0.0000  0.2500  0.2500      0\n"
              ">  1       0.8000  0.0000  0.8000      1\n"
              "   2       not allowed\n"
              "would choose 1, but for chance; best as far as known: 1\n");
    EXPECT_EQ(text_of(learner, 1),
              "state 1\n"
              "   action  value  tries\n"
              ">  0           0      0\n"
              "   1           0      0\n"
              "   2           0      0\n"
              "would choose 0, but for chance; best as far as known: 0\n");
}

TEST(Explain, TheRunningEpisodesChoice) {
    QLearning<> learner(2, 2);
    learner.observe(state_id(0), a1, 1.0, state_id(1), true);
    EXPECT_EQ(learner.begin(state_id(0)), a1);
    const std::string chosen = text_of(learner, 0);
    EXPECT_NE(chosen.find("\n>  1 "), std::string::npos) << chosen;
    EXPECT_NE(chosen.find("\nchose 1, which has the greatest sum; best as far as known: 1\n"), std::string::npos);
    EXPECT_NE(text_of(learner, 1).find("\nwould choose 0"), std::string::npos) << "the episode is elsewhere";
    learner.replace_action(a0);
    const std::string replaced = text_of(learner, 0);
    EXPECT_NE(replaced.find("\n>  0 "), std::string::npos) << replaced;
    EXPECT_NE(replaced.find("\nchose 0, though 1 has the greatest sum; best as far as known: 1\n"), std::string::npos);
}

TEST(Explain, AnAgentSpeaksItsOwnWords) {
    Agent robot(Rooms(), Steering(), paper());
    robot.observe(std::string("Küche"), a1, 0.0, std::string("hall,\nnorth"), false);
    robot.observe(std::string("hall,\nnorth"), a1, 1.0, std::string("door"), true);
    std::ostringstream out;
    out << explain(robot, std::string("Küche"));
    EXPECT_EQ(out.str(),
              "state 0, Küche: cost 0.2707 to the goal\n"
              "   action  value   path  curiosity    sum  tries  leads to     share   to go\n"
              "   zurück  0.000  0.000      0.100  0.100      0\n"
              ">  vor     0.000  1.000      0.035  1.035      1  hall, north  100 %  0.1353\n"
              "would choose vor, but for chance; best as far as known: vor\n"
              "way: Küche -vor-> hall, north -vor-> door\n");
    ExplainOptions options;
    options.state = [](StateId s) { return "#" + std::to_string(index(s)); };
    options.action = [](ActionId) { return std::string("go"); };
    EXPECT_EQ(explain(robot, std::string("Küche"), options).label, "#0");
    EXPECT_EQ(explain(robot, std::string("Küche"), options).actions[1].label, "go");
}

TEST(Explain, ALongWayIsCut) {
    Sspql<> learner(20, 1);
    for (std::size_t s = 0; s < 19; ++s)
        learner.observe(state_id(s), a0, s == 18 ? 1.0 : 0.0, state_id(s + 1), s == 18);
    ExplainOptions options;
    options.most_states = 4;
    EXPECT_EQ(explain(learner, state_id(0), options).path_left_out, 16u);
    const std::string cut = text_of(learner, 0, options);
    EXPECT_NE(cut.find("way: 0 -0-> 1 -0-> 2 -0-> ... 16 more ... 19\n"), std::string::npos) << cut;
    EXPECT_NE(text_of(learner, 16, options).find("way: 16 -0-> 17 -0-> 18 -0-> 19\n"), std::string::npos);
    options.most_states = 0;
    EXPECT_NE(text_of(learner, 16, options).find("way: 16 -0-> ... 2 more ... 19\n"), std::string::npos);
}

TEST(Explain, NumbersOfAnySizeAreReadable) {
    using detail::NumberColumn;
    NumberColumn column;
    EXPECT_EQ(column.text(0.0), "0");
    column.see(0.00123456);
    column.see(std::numeric_limits<double>::infinity());
    EXPECT_EQ(column.text(0.00123456), "0.001235");
    EXPECT_EQ(column.text(-1e-9), "0.000000") << "no minus";
    EXPECT_EQ(column.text(std::numeric_limits<double>::infinity()), "-");
    column.see(-1234.5);
    EXPECT_EQ(column.text(-1234.5678), "-1235");
    column.see(1e100);
    EXPECT_EQ(column.text(1e100), "1e+100");
    EXPECT_EQ(column.text(0.25), "0.25");
}

TEST(LearntGoals, FollowTheRulesOfLearners) {
    TransitionCounts<FadingCell> counts(6, 2);
    counts.record(state_id(0), a0, state_id(5), true, 1.0);
    counts.record(state_id(0), a1, state_id(4), true, -1.0);
    counts.record(state_id(1), a0, state_id(3), true, 0.0);
    counts.record(state_id(1), a1, state_id(0), false, 0.0);
    const auto goals = learnt_goals(counts);
    ASSERT_EQ(goals.size(), 1u);
    EXPECT_EQ(goals[0].state, state_id(5));
    counts.record(state_id(2), a0, state_id(0), false, -1.0);
    EXPECT_EQ(learnt_goals(counts).size(), 3u) << "steps have costs: every end is one";
    EXPECT_EQ(learnt_goals(TransitionCounts<FadingCell>(0, 1)).size(), 0u);
}

TEST(Explain, TheAdaptivePlannersGoals) {
    AdaptiveSspql<> learner(5, 2);
    EXPECT_TRUE(learner.goals().empty());
    learner.observe(state_id(0), a0, 0.0, state_id(1), false);
    learner.observe(state_id(1), a0, 1.0, state_id(4), true);
    learner.observe(state_id(1), a1, -1.0, state_id(3), true);
    ASSERT_EQ(learner.goals().size(), 1u) << "a hazard is none";
    EXPECT_EQ(learner.goals()[0].state, state_id(4));
    EXPECT_EQ(explain(learner, state_id(0)).distance, 2.0);
    learner.set_goals({{state_id(1), 0.5}});
    ASSERT_EQ(learner.goals().size(), 1u);
    EXPECT_EQ(learner.goals()[0].state, state_id(1));
    EXPECT_EQ(explain(learner, state_id(0)).distance, 1.5);
    EXPECT_EQ(explain(learner, state_id(1)).next, no_state);
}

}  // namespace sspql
