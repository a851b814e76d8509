// SPDX-License-Identifier: MIT
#include <sspql/learn/action_selector.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include <sspql/spaces/action_set.hpp>

namespace sspql_action_selector_test {

using namespace sspql;

namespace {

constexpr std::size_t actions = 4;
using Scores = std::array<double, actions>;

/// How often each action was chosen in 40 000 draws.
template <class Selector>
std::array<double, actions> frequencies(const Selector& selector, const Scores& scores, const ActionSet& mask,
                                        std::uint64_t seed) {
    Random random(seed);
    std::array<double, actions> chosen{};
    constexpr int draws = 40000;
    for (int k = 0; k < draws; ++k) {
        const ActionId a = selector(
            actions, mask, [&](ActionId i) { return scores[index(i)]; }, random);
        ++chosen.at(index(a));
    }
    for (double& count : chosen) count /= draws;
    return chosen;
}

constexpr double tolerance = 4.5 * 0.5 / 200.0;  // 4.5 standard errors of a frequency near 1/2

const ActionSet all = ActionSet::all(actions);
const ActionSet odd = ActionSet::of(actions, {action_id(1), action_id(3)});

}  // namespace

static_assert(is_selector_v<ActionSelector> && is_selector_v<EpsilonGreedy> && is_selector_v<Boltzmann>);
static_assert(!is_selector_v<int>);

TEST(ActionSelector, ChoosesTheLargestWhereNoiseCannotReach) {
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
        EXPECT_EQ(frequencies(ActionSelector(0.01), {0.0, 0.02, 0.031, -1.0}, all, seed)[2], 1.0) << "seed " << seed;
    }
}

TEST(ActionSelector, BreaksTiesUniformly) {
    const auto chosen = frequencies(ActionSelector(0.01), {0.5, 0.5, 0.5, 0.5}, all, 4);
    for (const double f : chosen) EXPECT_NEAR(f, 0.25, tolerance);
}

TEST(ActionSelector, NoiseIsUniform) {
    // Scores x and x + d, noise uniform in [0, e): the lower one wins with probability (1 - d/e)^2 / 2.
    const auto chosen = frequencies(ActionSelector(0.01), {0.0, -1.0, 0.0025, -1.0}, all, 5);
    EXPECT_NEAR(chosen[0], 0.75 * 0.75 / 2.0, tolerance);
    EXPECT_NEAR(chosen[2], 1.0 - 0.75 * 0.75 / 2.0, tolerance);
}

TEST(ActionSelector, RefusesNoNoise) {
    for (const double bad :
         {0.0, -0.01, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        EXPECT_THROW(ActionSelector{bad}, std::invalid_argument);
    }
    EXPECT_EQ(ActionSelector().noise(), 0.01);
}

TEST(EpsilonGreedy, ExploresWithProbabilityEpsilon) {
    const auto chosen = frequencies(EpsilonGreedy(0.2), {0.0, 0.0, 1.0, 0.0}, all, 6);
    EXPECT_NEAR(chosen[2], 0.85, tolerance);
    for (const std::size_t a : {0u, 1u, 3u}) EXPECT_NEAR(chosen[a], 0.05, tolerance);
}

TEST(EpsilonGreedy, BreaksTiesUniformly) {
    const auto chosen = frequencies(EpsilonGreedy(0.0), {1.0, 0.0, 1.0, 1.0}, all, 7);
    EXPECT_EQ(chosen[1], 0.0);
    for (const std::size_t a : {0u, 2u, 3u}) EXPECT_NEAR(chosen[a], 1.0 / 3.0, tolerance);
    for (const double f : frequencies(EpsilonGreedy(1.0), {9.0, 0.0, 1.0, 1.0}, all, 8))
        EXPECT_NEAR(f, 0.25, tolerance);
}

TEST(EpsilonGreedy, RefusesEpsilonOutside) {
    for (const double bad : {-0.1, 1.1, std::numeric_limits<double>::quiet_NaN()}) {
        EXPECT_THROW(EpsilonGreedy{bad}, std::invalid_argument);
    }
    EXPECT_EQ(EpsilonGreedy().epsilon(), 0.1);
}

TEST(Boltzmann, ChoosesInProportionToTheExponential) {
    const double e = std::exp(1.0);
    const auto chosen = frequencies(Boltzmann(0.5), {0.0, 0.5, 0.0, 1.0}, all, 9);
    const double sum = 2.0 + e + e * e;
    EXPECT_NEAR(chosen[0], 1.0 / sum, tolerance);
    EXPECT_NEAR(chosen[1], e / sum, tolerance);
    EXPECT_NEAR(chosen[2], 1.0 / sum, tolerance);
    EXPECT_NEAR(chosen[3], e * e / sum, tolerance);
}

TEST(Boltzmann, DoesNotOverflow) {
    EXPECT_EQ(frequencies(Boltzmann(1e-3), {1e300, -1e300, 0.0, 1e299}, all, 10)[0], 1.0);
    for (const double f : frequencies(Boltzmann(0.1), {1e6, 1e6, 1e6, 1e6}, all, 11)) EXPECT_NEAR(f, 0.25, tolerance);
    EXPECT_THROW(Boltzmann{0.0}, std::invalid_argument);
    EXPECT_THROW(Boltzmann{-1.0}, std::invalid_argument);
    EXPECT_EQ(Boltzmann().temperature(), 0.1);
}

TEST(Selectors, HonourTheMask) {
    const Scores scores{9.0, 0.0, 9.0, 0.005};
    for (const std::uint64_t seed : {1u, 2u}) {
        const auto noisy = frequencies(ActionSelector(0.01), scores, odd, seed);
        EXPECT_NEAR(noisy[1], 0.125, tolerance);
        EXPECT_NEAR(noisy[3], 0.875, tolerance);
        const auto greedy = frequencies(EpsilonGreedy(0.5), scores, odd, seed);
        EXPECT_NEAR(greedy[1], 0.25, tolerance);
        EXPECT_NEAR(greedy[3], 0.75, tolerance);
        const auto soft = frequencies(Boltzmann(1.0), {9.0, 1.0, 9.0, 1.0}, odd, seed);
        EXPECT_NEAR(soft[1], 0.5, tolerance);
        EXPECT_NEAR(soft[3], 0.5, tolerance);
    }
}

TEST(Selectors, SameRandomStateGivesTheSameAction) {
    Random a(12);
    Random b(12);
    const auto score = [](ActionId i) { return index(i) == 1 ? 0.001 : 0.0; };
    for (int k = 0; k < 200; ++k) {
        EXPECT_EQ(ActionSelector()(actions, all, score, a), ActionSelector()(actions, all, score, b));
        EXPECT_EQ(EpsilonGreedy()(actions, all, score, a), EpsilonGreedy()(actions, all, score, b));
        EXPECT_EQ(Boltzmann()(actions, all, score, a), Boltzmann()(actions, all, score, b));
    }
}

TEST(Argmax, TakesTheLeastIdOnTiesAndNoneOfNothing) {
    const auto score = [](ActionId a) { return index(a) == 0 ? 0.0 : 1.0; };
    EXPECT_EQ(sspql::detail::argmax(actions, all, score), action_id(1));
    EXPECT_EQ(sspql::detail::argmax(actions, ActionSet::none(actions), score), no_action);
    const auto least = [](ActionId) { return -std::numeric_limits<double>::infinity(); };
    EXPECT_EQ(sspql::detail::argmax(actions, odd, least), action_id(1));
}

}  // namespace sspql_action_selector_test
