// SPDX-License-Identifier: MIT
// What both kinds of cell must say through model/probability.hpp; the equations by hand are in tests/paper.
#include <sspql/model/probability.hpp>

#include <cmath>
#include <cstdint>

#include <gtest/gtest.h>

#include <sspql/core/random.hpp>

using sspql::action_id;
using sspql::ActionId;
using sspql::CountCell;
using sspql::FadingCell;
using sspql::Random;
using sspql::state_id;
using sspql::TransitionCounts;

namespace {

constexpr std::size_t states = 12;

template <class Cell>
TransitionCounts<Cell> random_counts(std::uint64_t seed, std::size_t actions) {
    Random random(seed);
    TransitionCounts<Cell> counts(states, actions);
    for (int i = 0; i < 500; ++i) {
        const std::size_t s = random.below(states);
        const std::size_t a = random.below(actions);
        counts.record(state_id(s), action_id(a), state_id(random.below(states)));
    }
    return counts;
}

template <class Cell>
class ProbabilityOf : public testing::Test {};

using Cells = testing::Types<CountCell, FadingCell>;

}  // namespace

TYPED_TEST_SUITE(ProbabilityOf, Cells, );

TYPED_TEST(ProbabilityOf, OutcomesOfATriedActionSumToOne) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const std::size_t actions = 1 + seed;
        const auto counts = random_counts<TypeParam>(seed, actions);
        for (std::size_t s = 0; s < states; ++s) {
            for (std::size_t a = 0; a < actions; ++a) {
                double sum = 0.0;
                for (std::size_t next = 0; next < states; ++next) {
                    const double p = sspql::probability(counts, state_id(s), action_id(a), state_id(next));
                    ASSERT_GE(p, 0.0);
                    ASSERT_LE(p, 1.0);
                    sum += p;
                }
                const bool tried = counts.n(state_id(s), action_id(a)) > 0;
                EXPECT_NEAR(sum, tried ? 1.0 : 0.0, 1e-12);
            }
        }
    }
}

TYPED_TEST(ProbabilityOf, BestActionIsTheLargestTermOfTheSum) {
    for (std::uint64_t seed = 20; seed < 40; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const std::size_t actions = seed - 19;
        const auto counts = random_counts<TypeParam>(seed, actions);
        for (std::size_t s = 0; s < states; ++s) {
            counts.for_each_successor(state_id(s), [&](const auto& successor) {
                double sum = 0.0, best = 0.0;
                for (std::size_t a = 0; a < actions; ++a) {
                    const double p = sspql::probability(counts, state_id(s), action_id(a), successor.state());
                    sum += p;
                    best = std::max(best, p);
                }
                EXPECT_NEAR(sspql::SumOverActions{}(counts, state_id(s), successor), sum, 1e-12);
                EXPECT_EQ(sspql::BestAction{}(counts, state_id(s), successor), best);
                EXPECT_GT(best, 0.0) << "an edge has been seen";
            });
        }
    }
}

TYPED_TEST(ProbabilityOf, EntropyLiesBetweenZeroAndTheLogOfTheOutcomes) {
    for (std::uint64_t seed = 40; seed < 60; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const auto counts = random_counts<TypeParam>(seed, 3);
        for (std::size_t s = 0; s < states; ++s) {
            const double most = std::log(static_cast<double>(counts.out_degree(state_id(s))));
            for (std::size_t a = 0; a < 3; ++a) {
                const double h = sspql::entropy(counts, state_id(s), action_id(a));
                EXPECT_GE(h, 0.0);
                EXPECT_LE(h, most + 1e-12);
            }
        }
    }
}
