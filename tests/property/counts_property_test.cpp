// SPDX-License-Identifier: MIT
// TransitionCounts against a map of maps, for generated sequences of operations; rapidcheck shrinks a failing one.
#ifdef SSPQL_HAS_RAPIDCHECK
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstddef>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include <sspql/model/probability.hpp>
#include <sspql/model/transition_counts.hpp>

namespace {

using sspql::action_id;
using sspql::state_id;

constexpr int states = 40;

/// {state, action, next state, fades if 0}: state 0 turns up often enough to become a hub.
using Operation = std::tuple<int, int, int, int>;

std::vector<Operation> operations(int actions) {
    const auto state = rc::gen::weightedOneOf<int>({{1, rc::gen::just(0)}, {1, rc::gen::inRange(0, states)}});
    const auto sequence = rc::gen::container<std::vector<Operation>>(
        rc::gen::tuple(state, rc::gen::inRange(0, actions), state, rc::gen::inRange(0, 8)));
    return *rc::gen::scale(4.0, sequence);
}

struct Reference {
    std::map<std::tuple<std::size_t, std::size_t, std::size_t>, double> n;

    void fade(std::size_t s, std::size_t a, double factor, double least) {
        for (auto at = n.begin(); at != n.end();) {
            if (std::get<0>(at->first) == s && std::get<1>(at->first) == a) at->second *= factor;
            at = at->second < least ? n.erase(at) : std::next(at);
        }
    }
    [[nodiscard]] std::size_t pairs() const {
        std::map<std::pair<std::size_t, std::size_t>, bool> seen;
        for (const auto& [key, count] : n) seen[{std::get<0>(key), std::get<2>(key)}] = true;
        return seen.size();
    }
};

/// Runs the operations on both and compares all there is.
template <class Cell>
void compare(int actions, bool fading) {
    sspql::TransitionCounts<Cell> counts(states, static_cast<std::size_t>(actions));
    Reference reference;
    for (const auto& [s, a, next, what] : operations(actions)) {
        const auto from = static_cast<std::size_t>(s), action = static_cast<std::size_t>(a);
        if (fading && what == 0) {
            if constexpr (!std::is_integral_v<typename Cell::Number>) {
                counts.fade(state_id(from), action_id(action), 0.5, 0.75);
            }
            reference.fade(from, action, 0.5, 0.75);
        } else {
            counts.record(state_id(from), action_id(action), state_id(static_cast<std::size_t>(next)));
            reference.n[{from, action, static_cast<std::size_t>(next)}] += 1.0;
        }
    }
    RC_ASSERT(counts.pairs() == reference.pairs());
    std::size_t in = 0, seen = 0;
    for (std::size_t s = 0; s < counts.states(); ++s) {
        in += counts.in_degree(state_id(s));
        counts.for_each_successor(state_id(s), [&](const auto& successor) {
            successor.for_each_action([&](sspql::ActionId a, const Cell& cell) {
                ++seen;
                const auto found = reference.n.find({s, index(a), index(successor.state())});
                RC_ASSERT(found != reference.n.end());
                RC_ASSERT(static_cast<double>(cell.count()) == found->second);
                RC_ASSERT(static_cast<double>(counts.n(state_id(s), a, successor.state())) == found->second);
            });
        });
    }
    RC_ASSERT(seen == reference.n.size());
    RC_ASSERT(in == counts.pairs());
}

}  // namespace

RC_GTEST_PROP(CountsProperty, CountCellEqualsTheReference, ()) {
    compare<sspql::CountCell>(*rc::gen::inRange(1, 12), false);
}

RC_GTEST_PROP(CountsProperty, FadingCellEqualsTheReference, ()) {
    compare<sspql::FadingCell>(*rc::gen::inRange(1, 12), true);
}

RC_GTEST_PROP(CountsProperty, SaturatedCountsStayBelowTheLimitAndForgetNothing, ()) {
    sspql::TransitionCounts<sspql::BasicCountCell<20>> counts(5, 2);
    std::map<std::size_t, bool> seen;
    for (const int next : *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 5))) {
        const auto outcome = static_cast<std::size_t>(next);
        for (int i = 0; i < 3; ++i) counts.record(state_id(0), action_id(0), state_id(outcome));
        seen[outcome] = true;
        RC_ASSERT(counts.n(state_id(0), action_id(0)) <= 20u);
        double sum = 0.0;
        for (const auto& [other, was] : seen) {
            const double p = sspql::probability(counts, state_id(0), action_id(0), state_id(other));
            RC_ASSERT(p > 0.0);
            sum += p;
        }
        RC_ASSERT(std::fabs(sum - 1.0) < 1e-12);
    }
}
#endif
