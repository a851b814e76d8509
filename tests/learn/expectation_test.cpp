// SPDX-License-Identifier: MIT
// expectation(): the mean value of the actions a selector would choose, by hand and against how often it chooses them.
#include <sspql/learn/action_selector.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include <sspql/spaces/action_set.hpp>

namespace sspql_expectation_test {

using namespace sspql;

namespace {

constexpr std::size_t draws = 40000;

/// The scores of some actions, and which of them are legal.
struct Choice {
    std::vector<double> scores;
    ActionSet legal;

    explicit Choice(std::vector<double> all) : scores(std::move(all)), legal(ActionSet::all(scores.size())) {}

    template <class S, class Value>
    [[nodiscard]] double expectation(const S& selector, const Value& value) const {
        return selector.expectation(
            scores.size(), legal, [&](ActionId a) { return scores[index(a)]; }, value);
    }

    /// The chance of each action, as the expectation of "it was this one".
    template <class S>
    [[nodiscard]] std::vector<double> chances(const S& selector) const {
        std::vector<double> chances;
        for (std::size_t i = 0; i < scores.size(); ++i) {
            chances.push_back(expectation(selector, [i](ActionId a) { return index(a) == i ? 1.0 : 0.0; }));
        }
        return chances;
    }

    template <class S>
    [[nodiscard]] std::vector<double> frequencies(const S& selector, std::uint64_t seed) const {
        std::vector<double> seen(scores.size(), 0.0);
        Random random(seed);
        for (std::size_t k = 0; k < draws; ++k) {
            const ActionId a = selector(
                scores.size(), legal, [&](ActionId b) { return scores[index(b)]; }, random);
            seen[index(a)] += 1.0 / static_cast<double>(draws);
        }
        return seen;
    }
};

/// Frequencies of 40000 draws are within 4.5 standard deviations of at most 0.0025.
template <class S>
void expect_as_often_as_chosen(const S& selector) {
    Random random(7, RandomStream::noise);
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        Choice choice(std::vector<double>(2 + random.below(6)));
        for (double& score : choice.scores) score = random.uniform(0.0, 1.5);
        if (seed % 3 == 0) choice.scores.back() = choice.scores.front();  // a tie
        if (seed % 4 == 0) choice.legal.erase(action_id(1));
        const std::vector<double> chances = choice.chances(selector);
        const std::vector<double> seen = choice.frequencies(selector, seed);
        double sum = 0.0;
        for (std::size_t i = 0; i < chances.size(); ++i) {
            EXPECT_NEAR(seen[i], chances[i], 0.0113) << "seed " << seed << ", action " << i;
            sum += chances[i];
        }
        EXPECT_NEAR(sum, 1.0, 1e-12);
    }
}

const auto first = [](ActionId a) { return index(a) == 0 ? 1.0 : 0.0; };

}  // namespace

TEST(Expectation, OfNoisySelectionIsHowOftenItChooses) {
    for (const double noise : {0.01, 0.3, 1.0, 5.0}) expect_as_often_as_chosen(ActionSelector(noise));
}

TEST(Expectation, OfEpsilonGreedyIsHowOftenItChooses) {
    for (const double epsilon : {0.0, 0.1, 1.0}) expect_as_often_as_chosen(EpsilonGreedy(epsilon));
}

TEST(Expectation, OfBoltzmannIsHowOftenItChooses) {
    for (const double temperature : {0.05, 0.5, 10.0}) expect_as_often_as_chosen(Boltzmann(temperature));
}

// Two actions, the second behind by g of the noise: it wins with probability (1 - g)^2 / 2.
TEST(Expectation, OfNoisySelectionBetweenTwo) {
    for (const double g : {0.0, 0.1, 0.5, 0.9}) {
        EXPECT_NEAR(Choice({2.0, 2.0 - 0.5 * g}).expectation(ActionSelector(0.5), first),
                    1.0 - (1.0 - g) * (1.0 - g) / 2.0, 1e-14);
    }
    EXPECT_EQ(Choice({2.0, 1.5}).expectation(ActionSelector(0.5), first), 1.0) << "out of reach";
    EXPECT_EQ(Choice({1.0, 2.0}).expectation(ActionSelector(0.5), first), 0.0);
}

// Three actions, two level and one behind by half of the noise: it wins if its noise u > 1/2 and both others are below
// u - 1/2: the integral of (u - 1/2)^2 from 1/2 to 1, 1/24. The other two share the rest.
TEST(Expectation, OfNoisySelectionAmongThree) {
    const auto chances = Choice({1.0, 0.5, 1.0}).chances(ActionSelector(1.0));
    EXPECT_NEAR(chances[1], 1.0 / 24.0, 1e-15);
    EXPECT_NEAR(chances[0], 23.0 / 48.0, 1e-15);
    EXPECT_NEAR(chances[2], 23.0 / 48.0, 1e-15);
}

TEST(Expectation, OfNoisySelectionAmongEqualsIsTheirMean) {
    for (const std::size_t actions : {1u, 2u, 10u, 30u}) {
        for (const double chance : Choice(std::vector<double>(actions, -3.0)).chances(ActionSelector(0.01))) {
            EXPECT_NEAR(chance, 1.0 / static_cast<double>(actions), 1e-12);
        }
    }
}

// Scores so large, or noise so small, that adding it changes nothing: still a choice, the best one's.
TEST(Expectation, OfNoiseThatDrownsInTheScoresIsThatOfTheBest) {
    EXPECT_EQ(Choice({1.0, 2.0}).expectation(ActionSelector(1e-20), first), 0.0);
    EXPECT_EQ(Choice({1e18, 0.0}).expectation(ActionSelector(0.01), first), 1.0);
    EXPECT_DOUBLE_EQ(Choice({1e18, 1e18, 0.0}).expectation(ActionSelector(0.01), first), 0.5);
    EXPECT_EQ(Choice({-1e18, 1e18}).expectation(ActionSelector(0.01), first), 0.0);
}

// epsilon / n each, and the rest for the best, shared by ties.
TEST(Expectation, OfEpsilonGreedyBetweenTwo) {
    EXPECT_DOUBLE_EQ(Choice({1.0, 0.0}).expectation(EpsilonGreedy(0.2), first), 0.9);
    EXPECT_DOUBLE_EQ(Choice({0.0, 1.0}).expectation(EpsilonGreedy(0.2), first), 0.1);
    EXPECT_DOUBLE_EQ(Choice({1.0, 1.0}).expectation(EpsilonGreedy(0.2), first), 0.5);
}

// 1 / (1 + e^{-difference / T}).
TEST(Expectation, OfBoltzmannBetweenTwo) {
    EXPECT_NEAR(Choice({1.0, 0.0}).expectation(Boltzmann(0.5), first), 1.0 / (1.0 + std::exp(-2.0)), 1e-15);
    EXPECT_DOUBLE_EQ(Choice({1000.0, 1000.0}).expectation(Boltzmann(0.001), first), 0.5);
    EXPECT_EQ(Choice({-1000.0, 1000.0}).expectation(Boltzmann(0.001), first), 0.0);
}

TEST(Expectation, IsOverLegalActionsOnly) {
    Choice choice({9.0, 1.0, 1.0});
    choice.legal.erase(action_id(0));
    const auto by_id = [](ActionId a) { return static_cast<double>(index(a)); };
    EXPECT_DOUBLE_EQ(choice.expectation(ActionSelector(0.5), by_id), 1.5);
    EXPECT_DOUBLE_EQ(choice.expectation(EpsilonGreedy(0.5), by_id), 1.5);
    EXPECT_DOUBLE_EQ(choice.expectation(Boltzmann(0.5), by_id), 1.5);
}

}  // namespace sspql_expectation_test
