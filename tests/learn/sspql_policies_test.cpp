// SPDX-License-Identifier: MIT
#include <sspql/learn/sspql.hpp>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "learn/learner_testing.hpp"

#include <sspql/paths/dary_heap.hpp>

namespace sspql_sspql_policies_test {

using namespace sspql;
using namespace sspql::testing;

namespace {

/// A user's own of each kind.
struct SquaredCost {
    double operator()(double weight, double probability) const {
        return weight * weight * (2.0 - std::min(probability, 1.0));
    }
};
struct HalfOfBest {
    template <class Counts, class Successor>
    double operator()(const Counts& counts, StateId s, const Successor& successor) const {
        return 0.5 * BestAction{}(counts, s, successor);
    }
};
struct Lazy {  // the first allowed action among the best
    template <class Allowed, class Score>
    ActionId operator()(std::size_t actions, const Allowed& allowed, const Score& score, Random&) const {
        ActionId best = no_action;
        for (std::size_t i = 0; i < actions; ++i) {
            const ActionId a = action_id(i);
            if (allowed.contains(a) && (best == no_action || score(a) > score(best))) best = a;
        }
        return best;
    }
};
class SortedQueue {
public:
    void prepare(std::size_t, double, double) { items_.clear(); }
    void push(std::uint32_t vertex, double key) { items_.push_back({key, vertex}); }
    void decrease(std::uint32_t vertex, double key) {
        for (auto& item : items_) {
            if (item.second == vertex) item.first = key;
        }
    }
    std::uint32_t pop() {
        std::sort(items_.rbegin(), items_.rend());
        const std::uint32_t vertex = items_.back().second;
        items_.pop_back();
        return vertex;
    }
    bool empty() const { return items_.empty(); }

private:
    std::vector<std::pair<double, std::uint32_t>> items_;
};

struct Default : SspqlPolicies {};
struct Tries : SspqlPolicies {
    using Cost = ExpectedTries;
    using Probability = BestAction;
};
struct Logarithmic : SspqlPolicies {
    using Cost = LogRisk;
    using Probability = BestAction;
};
struct Hops : SspqlPolicies {
    using Cost = HopCount;
};
struct OwnCost : SspqlPolicies {
    using Cost = SquaredCost;
    using Probability = HalfOfBest;
};
struct Quaternary : SspqlPolicies {
    using Queue = DaryHeap<4>;
};
struct Binary : SspqlPolicies {
    using Queue = DaryHeap<2>;
};
struct Sorted : SspqlPolicies {
    using Queue = SortedQueue;
};
struct Fading : SspqlPolicies {
    using Cell = FadingCell;
};
struct Saturating : SspqlPolicies {
    using Cell = BasicCountCell<4>;
};
struct Epsilon : SspqlPolicies {
    using Selector = EpsilonGreedy;
};
struct Soft : SspqlPolicies {
    using Selector = Boltzmann;
};
struct Own : SspqlPolicies {
    using Selector = Lazy;
};
struct Unmasked : SspqlPolicies {
    using LegalActions = AllActions;
};

}  // namespace

template <class Policies>
class SspqlWithPolicies : public ::testing::Test {};
using AllPolicies = ::testing::Types<Default, Tries, Logarithmic, Hops, OwnCost, Quaternary, Binary, Sorted, Fading,
                                     Saturating, Epsilon, Soft, Own, Unmasked>;
TYPED_TEST_SUITE(SspqlWithPolicies, AllPolicies);

TYPED_TEST(SspqlWithPolicies, LearnsTheWayThroughTheRoom) {
    Sspql<TypeParam> learner(Room::states, Room::actions, {}, 1);
    Room room(1, 0.1);
    for (int k = 0; k < 60; ++k) (void)walk(learner, room, Room::at(0, 0), Room::at(4, 4));
    const std::vector<StateId> path = learner.tree().path(Room::at(0, 0));
    ASSERT_FALSE(path.empty());
    EXPECT_EQ(path.back(), Room::at(4, 4));
    EXPECT_GE(path.size(), 9u);
    EXPECT_LE(path.size(), 13u);
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        const ActionId a = learner.ssp_values().action(path[i]);
        ASSERT_NE(a, no_action);
        EXPECT_GT(learner.counts().n(path[i], a, path[i + 1]), 0u) << "seen to lead there";
    }
}

TYPED_TEST(SspqlWithPolicies, FollowsANewGoalAtOnce) {
    Sspql<TypeParam> learner(Room::states, Room::actions, {}, 2);
    show_room(learner);
    learner.set_goals({{Room::at(4, 4)}});
    StateId s = Room::at(0, 0);
    std::size_t steps = 0;
    for (; s != Room::at(4, 4) && steps < 100; ++steps) s = Room::moved(s, learner.best(s));
    EXPECT_EQ(steps, 8u);
}

TEST(SspqlQueues, GiveTheSameTree) {
    Sspql<Default> fibonacci(Room::states, Room::actions, {}, 3);
    Sspql<Quaternary> quaternary(Room::states, Room::actions, {}, 3);
    Sspql<Sorted> sorted(Room::states, Room::actions, {}, 3);
    Room a(3, 0.2);
    Room b(3, 0.2);
    Room c(3, 0.2);
    for (int k = 0; k < 20; ++k) {
        const auto chosen = walk(fibonacci, a, Room::at(0, 0), Room::at(4, 4));
        EXPECT_EQ(walk(quaternary, b, Room::at(0, 0), Room::at(4, 4)), chosen);
        EXPECT_EQ(walk(sorted, c, Room::at(0, 0), Room::at(4, 4)), chosen);
        EXPECT_EQ(quaternary.tree().next, fibonacci.tree().next);
        EXPECT_EQ(sorted.tree().next, fibonacci.tree().next);
    }
}

TEST(SspqlParams, CarryThePolicyObjects) {
    SspqlParams<Logarithmic> params;
    params.cost = LogRisk(0.25);
    const Sspql<Logarithmic> learner(2, 2, params);
    EXPECT_EQ(learner.params().cost.lambda(), 0.25);
}

}  // namespace sspql_sspql_policies_test
