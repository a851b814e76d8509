// SPDX-License-Identifier: MIT
// TransitionCounts against a map of maps, under random operations.
#include <sspql/model/transition_counts.hpp>

#include <algorithm>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include <sspql/core/random.hpp>

#include "model/counts_reference.hpp"

using sspql::action_id;
using sspql::CountCell;
using sspql::FadingCell;
using sspql::Random;
using sspql::state_id;
using sspql::TransitionCounts;
using sspql_test::CountsReference;

namespace {

/// A state out of n; every other time one of the first two, so that these become hubs.
std::size_t draw_state(Random& random, std::size_t n) {
    return random.chance(0.5) ? random.below(std::min<std::size_t>(n, 2)) : random.below(n);
}

template <class Cell>
void label_everything(TransitionCounts<Cell>& counts, CountsReference& reference, double base) {
    for (std::size_t s = 0; s < counts.states(); ++s) {
        counts.for_each_successor(state_id(s), [&](const auto& successor) {
            const double label = base + 1000.0 * static_cast<double>(s) + static_cast<double>(index(successor.state()));
            counts.set_label(successor, label);
            reference.label(s, index(successor.state()), label);
        });
    }
    counts.clear_dirty();
    reference.clear_dirty();
}

template <class Cell>
void compare(std::uint64_t seed, std::size_t actions, bool weights, bool fading, int operations) {
    SCOPED_TRACE("seed " + std::to_string(seed) + ", actions " + std::to_string(actions));
    Random random(seed);
    std::size_t states = 2 + random.below(70);
    TransitionCounts<Cell> counts(states, actions);
    CountsReference reference;
    for (int i = 0; i < operations; ++i) {
        const double what = random.uniform();
        if (what < 0.01) {
            states += random.below(10);
            counts.grow(states);
        } else if (what < 0.02) {
            label_everything(counts, reference, static_cast<double>(i) / 4096.0);
        } else if (fading && what < 0.25) {
            const std::size_t s = draw_state(random, states);
            const std::size_t a = random.below(actions);
            const double factor = random.chance(0.3) ? 0.0 : random.uniform(0.3, 1.0);
            if constexpr (!std::is_integral_v<typename Cell::Number>) {
                counts.fade(state_id(s), action_id(a), factor, 0.6);
            }
            reference.fade(s, a, factor, 0.6);
        } else {
            const std::size_t s = draw_state(random, states);
            const std::size_t a = random.below(actions);
            const std::size_t next = draw_state(random, states);
            const bool terminal = random.chance(0.1);
            const double reward = random.uniform(-1.0, 1.0);
            const double weight = weights && random.chance(0.5) ? random.uniform(0.1, 10.0) : 1.0;
            counts.record(state_id(s), action_id(a), state_id(next), terminal, reward, weight);
            reference.record(s, a, next, terminal, reward, weight);
        }
        if (i % 97 == 0) reference.expect_same(counts);
        if (testing::Test::HasFailure()) return;
    }
    reference.expect_same(counts);
}

class CountsAgainstReference : public testing::TestWithParam<std::size_t> {};

}  // namespace

// 1 to 8 actions are kept densely, more as pairs.
INSTANTIATE_TEST_SUITE_P(Actions, CountsAgainstReference, testing::Values(1, 2, 3, 4, 5, 6, 7, 8, 9, 12, 40),
                         testing::PrintToStringParamName());

TEST_P(CountsAgainstReference, CountCellIsTheSame) {
    for (std::uint64_t seed = 0; seed < 12; ++seed) compare<CountCell>(seed, GetParam(), false, false, 600);
}

TEST_P(CountsAgainstReference, CountCellWithWeightsIsTheSame) {
    for (std::uint64_t seed = 100; seed < 112; ++seed) compare<CountCell>(seed, GetParam(), true, false, 600);
}

TEST_P(CountsAgainstReference, FadingCellIsTheSame) {
    for (std::uint64_t seed = 200; seed < 212; ++seed) compare<FadingCell>(seed, GetParam(), false, true, 800);
}

TEST_P(CountsAgainstReference, FadingCellWithWeightsIsTheSame) {
    for (std::uint64_t seed = 300; seed < 312; ++seed) compare<FadingCell>(seed, GetParam(), true, true, 800);
}
