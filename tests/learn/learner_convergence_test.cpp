// SPDX-License-Identifier: MIT
// With rates that decay by visits and a selector that keeps exploring, the greedy policy comes close to the optimum.
#include <sspql/learn/learner.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "learn/learner_testing.hpp"

using namespace sspql;
using namespace sspql::testing;

namespace {

constexpr std::size_t state_count = 8;  // the last one is terminal
constexpr std::size_t action_count = 3;
constexpr double discount = 0.9;

/// A random Markov decision process: three successors for each (s,a), a reward for each (s,a,s').
struct Process {
    struct Outcome {
        double probability = 0.0;
        std::size_t next = 0;
        double reward = 0.0;
    };
    std::array<std::array<std::array<Outcome, 3>, action_count>, state_count> outcomes{};

    explicit Process(std::uint64_t seed) {
        Random random(seed, RandomStream::noise);
        for (std::size_t s = 0; s + 1 < state_count; ++s) {
            for (auto& of_action : outcomes[s]) {
                double sum = 0.0;
                for (Outcome& outcome : of_action) {
                    outcome.probability = 0.1 + random.uniform();
                    outcome.next = random.below(state_count);
                    outcome.reward = random.uniform(-1.0, 1.0);
                    sum += outcome.probability;
                }
                for (Outcome& outcome : of_action) outcome.probability /= sum;
            }
        }
    }

    [[nodiscard]] double backup(std::size_t s, std::size_t a, const std::array<double, state_count>& value) const {
        double sum = 0.0;
        for (const Outcome& outcome : outcomes[s][a]) {
            sum += outcome.probability * (outcome.reward + discount * value[outcome.next]);
        }
        return sum;
    }

    /// Values under `choose(s, backups)`, by iteration to machine precision. The terminal state's is 0.
    template <class Choose>
    [[nodiscard]] std::array<double, state_count> values(const Choose& choose) const {
        std::array<double, state_count> value{};
        for (int sweep = 0; sweep < 2000; ++sweep) {
            for (std::size_t s = 0; s + 1 < state_count; ++s) {
                std::array<double, action_count> backups{};
                for (std::size_t a = 0; a < action_count; ++a) backups[a] = backup(s, a, value);
                value[s] = choose(s, backups);
            }
        }
        return value;
    }

    [[nodiscard]] const Outcome& draw(std::size_t s, std::size_t a, Random& random) const {
        double left = random.uniform();
        for (const Outcome& outcome : outcomes[s][a]) {
            left -= outcome.probability;
            if (left < 0.0) return outcome;
        }
        return outcomes[s][a].back();
    }
};

struct ExploringQ : ValuePolicies {
    using Selector = EpsilonGreedy;
};
struct ExploringSspql : SspqlPolicies {
    using Selector = EpsilonGreedy;
};

}  // namespace

template <class L>
class LearnerConvergence : public ::testing::Test {};
using Exploring = ::testing::Types<QLearning<ExploringQ>, Sspql<ExploringSspql>>;
TYPED_TEST_SUITE(LearnerConvergence, Exploring);

TYPED_TEST(LearnerConvergence, GreedyPolicyIsWithinOnePercentOfTheOptimum) {
    for (const std::uint64_t seed : {1u, 2u, 3u, 4u, 5u}) {
        const Process process(seed);
        typename TypeParam::Params params;
        params.gamma = discount;
        params.alpha = VisitDecay{0.8};
        params.w_exp = 0.0;
        params.selector = EpsilonGreedy(0.5);
        TypeParam learner(state_count, action_count, params, seed);
        Random world(seed, RandomStream::environment);
        std::size_t s = world.below(state_count - 1);
        ActionId a = learner.begin(state_id(s));
        for (int k = 0; k < 250000; ++k) {
            const Process::Outcome& outcome = process.draw(s, index(a), world);
            s = outcome.next;
            if (s + 1 < state_count) {
                a = learner.step(outcome.reward, state_id(s));
                continue;
            }
            learner.end(outcome.reward, state_id(s), true);
            s = world.below(state_count - 1);
            a = learner.begin(state_id(s));
        }
        const auto optimal =
            process.values([](std::size_t, const auto& b) { return *std::max_element(b.begin(), b.end()); });
        const auto achieved =
            process.values([&](std::size_t at, const auto& b) { return b[index(learner.best(state_id(at)))]; });
        double scale = 0.0;
        for (const double value : optimal) scale = std::max(scale, std::fabs(value));
        for (std::size_t at = 0; at + 1 < state_count; ++at) {
            EXPECT_GE(achieved[at], optimal[at] - 0.01 * scale) << "seed " << seed << ", state " << at;
        }
    }
}
