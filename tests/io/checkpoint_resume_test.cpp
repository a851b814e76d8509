// SPDX-License-Identifier: MIT
#include <sspql/io/checkpoint.hpp>

#include "io/checkpoint_testing.hpp"
#include "learn/learner_testing.hpp"

using namespace sspql;
using namespace sspql::testing;

namespace {

constexpr std::size_t states = 24;
constexpr std::size_t actions = 4;

/// n steps, saved, loaded into `other`, m more steps of both: the same to the bit, at many places.
template <class L>
void expect_resumes(L learner, const L& other, std::uint64_t seed, std::size_t room = states) {
    Story story(seed, room);
    for (const std::size_t n : {0u, 1u, 7u, 50u, 333u, 1000u}) {
        story.go_on(learner, n);
        const std::string saved = save_to_bytes(learner);
        L loaded = other;
        load_from_bytes(saved, loaded);
        ASSERT_EQ(save_to_bytes(loaded), saved) << "seed " << seed << ", after " << n << " more steps";
        L uninterrupted = learner;
        Story same = story;
        Story again = story;
        same.go_on(uninterrupted, 200);
        again.go_on(loaded, 200);
        ASSERT_EQ(save_to_bytes(loaded), save_to_bytes(uninterrupted))
            << "seed " << seed << ", 200 steps after " << n << " more steps";
    }
}

}  // namespace

template <class L>
class CheckpointResume : public ::testing::Test {};
TYPED_TEST_SUITE(CheckpointResume, AllLearners, LearnerNames);

TYPED_TEST(CheckpointResume, GoesOnAsIfItHadNeverStopped) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        expect_resumes(TypeParam(states, actions, {}, seed), TypeParam(states, actions, {}, 99), seed);
    }
}

TYPED_TEST(CheckpointResume, WithAGrowingNumberOfStates) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        expect_resumes(TypeParam(StateCount::growing(), actions, {}, seed),
                       TypeParam(StateCount::growing(), actions, {}, 99), seed);
    }
}

TYPED_TEST(CheckpointResume, WithManyActionsAndHubs) {  // sparse cells, more than 32 successors
    expect_resumes(TypeParam(60, 12, {}, 1), TypeParam(60, 12, {}, 99), 1, 60);
}

TYPED_TEST(CheckpointResume, AfterGoalsWereSet) {
    TypeParam learner(states, actions, {}, 1);
    Story story(4, states);
    story.go_on(learner, 200);
    learner.set_goals({{state_id(5), 0.0}, {state_id(9), 2.0}});
    expect_resumes(learner, TypeParam(states, actions, {}, 99), 7);
}

// ---- parameters and policies that take other paths -----------------------------------------------------------------

TEST(CheckpointResumeSspql, InTheMiddleOfASolveInInstalments) {
    for (const std::uint64_t budget : {1u, 2u, 5u, 20u}) {
        SspqlParams<> params;
        params.path_budget = budget;
        for (std::uint64_t seed = 1; seed <= 8; ++seed) {
            expect_resumes(Sspql<>(states, actions, params, seed), Sspql<>(states, actions), seed);
        }
    }
}

TEST(CheckpointResumeSspql, WithATolerance) {
    SspqlParams<> params;
    params.path_tolerance = 0.05;
    expect_resumes(Sspql<>(states, actions, params, 1), Sspql<>(states, actions), 1);
}

struct OtherPolicies : SspqlPolicies {
    using Cell = FadingCell;
    using Probability = BestAction;
    using Cost = LogRisk;
    using Queue = RingQueue<>;
    using Selector = EpsilonGreedy;
};

TEST(CheckpointResumeSspql, WithOtherPolicies) {
    SspqlParams<OtherPolicies> params;
    params.cost = LogRisk(0.5);
    params.selector = EpsilonGreedy(0.2);
    params.path_budget = 6;
    expect_resumes(Sspql<OtherPolicies>(states, actions, params, 1), Sspql<OtherPolicies>(states, actions), 1);
}

TEST(CheckpointResumeAdaptive, InTheMiddleOfChoresAndSearches) {
    AdaptiveParams<> params;
    params.trust.tau = 50.0;
    for (const std::uint64_t slice : {1u, 3u, 10u, 100u}) {
        params.slice = slice;
        for (std::uint64_t seed = 1; seed <= 8; ++seed) {
            expect_resumes(AdaptiveSspql<>(states, actions, params, seed), AdaptiveSspql<>(states, actions, params), seed);
        }
    }
}

TEST(CheckpointResumeOthers, WithEveryParameterChanged) {
    DynaQParams<> dyna;
    dyna.replay = Replay::last_outcome;
    dyna.planning_steps = 3;
    dyna.alpha = ExponentialDecay{0.5, 0.1, 0.01};
    expect_resumes(DynaQ<>(states, actions, dyna, 1), DynaQ<>(states, actions), 1);
    dyna.replay = Replay::from_counts;
    dyna.kappa = 0.3;
    dyna.cap = 4.0;
    expect_resumes(DynaQ<>(states, actions, dyna, 1), DynaQ<>(states, actions), 2);
    expect_resumes(PrioritizedSweeping<>(states, actions, PrioritizedSweepingParams<>::optimistic(), 1),
                   PrioritizedSweeping<>(states, actions), 3);
    SarsaParams<> sarsa;
    sarsa.expected = true;
    sarsa.hint_fading = Constant{0.5};
    expect_resumes(Sarsa<>(states, actions, sarsa, 1), Sarsa<>(states, actions), 4);
    RMaxParams<> rmax;
    rmax.known_after = 2;
    rmax.cap = 3.0;
    expect_resumes(RMax<>(states, actions, rmax, 1), RMax<>(states, actions), 5);
}

TEST(CheckpointResume, ParametersComeFromTheFile) {
    QLearningParams<> params;
    params.gamma = 0.5;
    params.alpha = VisitDecay{0.7};
    params.selector = ActionSelector(0.25);
    QLearning<> loaded(states, actions);
    load_from_bytes(save_to_bytes(QLearning<>(states, actions, params)), loaded);
    EXPECT_EQ(loaded.params().gamma, 0.5);
    EXPECT_EQ(std::get<VisitDecay>(loaded.params().alpha.rule()).p, 0.7);
    EXPECT_EQ(loaded.params().alpha(16), Schedule(VisitDecay{0.7})(16));
    EXPECT_EQ(loaded.params().selector.noise(), 0.25);
}
