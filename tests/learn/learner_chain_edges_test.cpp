// SPDX-License-Identifier: MIT
// A million states in a row: no learner needs a call on the stack for each.
#include <sspql/learn/learner.hpp>

#include <cmath>
#include <cstddef>
#include <type_traits>

#include <pthread.h>

#include "learn/learner_testing.hpp"

using namespace sspql;
using namespace sspql::testing;

namespace {

constexpr std::size_t n = 1000000;
constexpr ActionId back{0}, on{1};

template <class L>
inline constexpr bool plans_at_random = std::is_same_v<L, DynaQ<>> || std::is_same_v<L, DynaQPlus<>>;

/// Everything about the chain is told, from the goal backwards; then the agent walks to the goal from close by.
template <class L>
void learn_the_chain() {
    typename L::Params params;
    if constexpr (plans_at_random<L>) params.planning_steps = 1;  // ten times as many take ten times as long
    L learner(n, 2, params, 3);
    for (std::size_t s = n - 1; s-- > 0;) {
        const bool home = s + 2 == n;
        learner.observe(state_id(s), on, home ? 1.0 : 0.0, state_id(s + 1), home);
        if (s % 1000 == 0) learner.observe(state_id(s), back, 0.0, state_id(0), false);
    }
    if constexpr (!std::is_same_v<L, RMax<>>) {  // which hopes for more from going back, as long as that is untried
        EXPECT_EQ(learner.best(state_id(n - 2)), on);
        EXPECT_EQ(learner.best(state_id(n - 5)), on);
    }
    StateId s = state_id(n - 20);
    (void)learner.begin(s);
    for (int i = 0; i < 1000; ++i) {
        s = learner.action() == on ? state_id(index(s) + 1) : s;
        if (index(s) + 1 == n) break;
        (void)learner.step(0.0, s);
    }
    learner.end(1.0, state_id(n - 1), true);
    learner.set_goals({{state_id(n - 1), 0.0}});
    (void)learner.begin(state_id(0));
    for (int i = 0; i < 100; ++i) (void)learner.step(0.0, state_id(0));  // work in instalments goes on
    learner.end(0.0, state_id(0), false);
    for (const std::size_t i : {std::size_t{0}, n / 2, n - 2}) {
        EXPECT_TRUE(std::isfinite(learner.terms(state_id(i), on).sum())) << i;
    }
    if constexpr (std::is_same_v<L, Sspql<>>) {
        EXPECT_EQ(learner.tree().path(state_id(0)).size(), n);
        EXPECT_EQ(learner.ssp_values().action(state_id(0)), on);
    }
}

}  // namespace

template <class L>
class LearnerChainSlow : public ::testing::Test {};
TYPED_TEST_SUITE(LearnerChainSlow, AllLearners, LearnerNames);

TYPED_TEST(LearnerChainSlow, AMillionStatesInARowNeedNoStack) {
    pthread_attr_t attributes;
    ASSERT_EQ(pthread_attr_init(&attributes), 0);
    ASSERT_EQ(pthread_attr_setstacksize(&attributes, std::size_t{1} << 18), 0);
    pthread_t thread{};
    const auto run = [](void*) -> void* {
        learn_the_chain<TypeParam>();
        return nullptr;
    };
    ASSERT_EQ(pthread_create(&thread, &attributes, run, nullptr), 0);
    pthread_join(thread, nullptr);
    pthread_attr_destroy(&attributes);
}
