// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <sspql/core/concepts.hpp>
#include <sspql/core/ids.hpp>
#include <sspql/io/explanation.hpp>
#include <sspql/io/learnt_paths.hpp>
#include <sspql/learn/action_selector.hpp>
#include <sspql/paths/shortest_paths.hpp>
#include <sspql/spaces/action_policy.hpp>
#include <sspql/spaces/state_policy.hpp>

namespace sspql {

/// The words of explain, and how much of the way it tells.
struct ExplainOptions {
    std::function<std::string(StateId)> state{};    ///< the state in words; its number if empty
    std::function<std::string(ActionId)> action{};  ///< the action in words; its number if empty
    std::size_t most_states = 8;                    ///< of the way to the goal are listed, at least two
};

namespace detail {

/// Makes an Explanation; see explain.
template <class Learner>
class Explainer {
public:
    Explainer(const Learner& learner, const ShortestPathTree& tree, const ExplainOptions& options)
        : learner_(learner), tree_(tree), options_(options) {}

    [[nodiscard]] Explanation operator()(StateId s) const {
        Explanation why;
        why.state = s;
        why.best = learner_.best(s);  // checks s
        if (options_.state) why.label = options_.state(s);
        if (learner_.running() && learner_.state() == s) why.chosen = learner_.action();
        const auto& allowed = learner_.legal_actions().allowed(s);
        for (std::size_t a = 0; a < learner_.actions(); ++a) {
            why.actions.push_back(action(s, action_id(a), allowed.contains(action_id(a))));
        }
        why.leading =
            argmax(learner_.actions(), allowed, [&](ActionId a) { return why.actions[index(a)].terms.sum(); });
        if constexpr (is_detected_v<CountsExpression, Learner>) {
            why.has_model = true;
            why.distance_in_steps = !is_detected_v<TreeExpression, Learner>;
            why.distance = distance(s);
            if (tree_.reaches_goal(s)) add_way(why);
        }
        return why;
    }

private:
    [[nodiscard]] ActionExplanation action(StateId s, ActionId a, bool legal) const {
        ActionExplanation told;
        told.action = a;
        told.label = word(a);
        told.legal = legal;
        told.terms = learner_.terms(s, a);
        if constexpr (is_detected_v<CountsExpression, Learner>) {
            double most = 0.0;
            learner_.counts().for_each_outcome(s, a, [&](StateId next, const auto& cell) {
                const auto n = static_cast<double>(cell.count());
                if (n < most || (!(n > most) && !(next < told.likely))) return;
                most = n;
                told.likely = next;
                told.ends = cell.terminal();
            });
            if (told.likely != no_state) {
                told.likely_label = word(told.likely);
                told.probability = most / static_cast<double>(learner_.counts().n(s, a));
                told.distance = distance(told.likely);
            }
        }
        return told;
    }

    void add_way(Explanation& why) const {
        why.next = tree_.next[index(why.state)];
        const std::size_t most = std::max<std::size_t>(options_.most_states, 2);
        std::vector<StateId> way;
        std::size_t length = 0;
        StateId last = why.state;
        for (StateId s = why.state; s != no_state; s = tree_.next[index(s)]) {
            if (way.size() < most) way.push_back(s);
            last = s;
            ++length;
        }
        way.back() = length > most ? last : way.back();
        why.path_left_out = length - way.size();
        for (const StateId s : way) {
            PathStep step{s, word(s), no_action, {}};
            if (tree_.next[index(s)] != no_state) {
                step.action = action_to(s, tree_.next[index(s)]);
                step.action_label = word(step.action);
            }
            why.path.push_back(std::move(step));
        }
    }

    /// The action that most probably leads there, the least id on ties: that of eq. 5, and of the tree's edge costs.
    [[nodiscard]] ActionId action_to(StateId s, StateId next) const {
        ActionId likely = action_id(0);
        double most = 0.0;
        for (std::size_t a = 0; a < learner_.actions(); ++a) {
            const auto n = static_cast<double>(learner_.counts().n(s, action_id(a), next));
            const double p = n > 0.0 ? n / static_cast<double>(learner_.counts().n(s, action_id(a))) : 0.0;
            if (p > most) {
                most = p;
                likely = action_id(a);
            }
        }
        return likely;
    }

    [[nodiscard]] double distance(StateId s) const {
        return tree_.reaches_goal(s) ? tree_.distance[index(s)] : std::numeric_limits<double>::infinity();
    }

    [[nodiscard]] std::string word(StateId s) const {
        return options_.state ? options_.state(s) : std::to_string(index(s));
    }
    [[nodiscard]] std::string word(ActionId a) const {
        return options_.action ? options_.action(a) : std::to_string(index(a));
    }

    const Learner& learner_;
    const ShortestPathTree& tree_;
    const ExplainOptions& options_;
};

}  // namespace detail

/// Why the learner does in s what it does: per action the terms of eq. 8, its tries, where it leads and how far the
/// goal is from there; what it chose, and the way to the goal. `std::cout << explain(learner, s)` prints a table
/// (to_text). Nothing about the learner changes. Learners that keep no counts (QLearning, Sarsa, DynaQPlus) know their
/// terms and tries only. Distances are those of learnt_paths(learner): for Sspql its own tree, as of its last update;
/// for the others the shortest paths by expected steps over the counts as they are now (the adaptive planner's
/// path_length() is much the same, as of its last search). On a path, what goes astray counts as standing still: where
/// it leads on as well, the goal is nearer than that. With masks, the way may lead over actions that are not allowed.
/// O(states + |A| x out-degree), and where the learner keeps no tree the O(m n_out + n log n) of learnt_paths: to
/// explain many states, hand over the tree. \throws std::invalid_argument for a state outside.
template <class Learner>
[[nodiscard]] auto explain(const Learner& learner, StateId s, const ExplainOptions& options = {})
    -> decltype(learner.legal_actions(), Explanation()) {
    if constexpr (detail::is_detected_v<detail::TreeExpression, Learner>) {
        return detail::Explainer<Learner>(learner, learner.tree(), options)(s);
    } else if constexpr (detail::is_detected_v<detail::CountsExpression, Learner>) {
        return detail::Explainer<Learner>(learner, learnt_paths(learner), options)(s);
    } else {
        return detail::Explainer<Learner>(learner, ShortestPathTree{}, options)(s);
    }
}

/// The same with a tree that is there already, learnt_paths(learner) for example. O(|A| x out-degree + the way's
/// length).
template <class Learner>
[[nodiscard]] auto explain(const Learner& learner, StateId s, const ShortestPathTree& tree,
                           const ExplainOptions& options = {}) -> decltype(learner.legal_actions(), Explanation()) {
    return detail::Explainer<Learner>(learner, tree, options)(s);
}

/// The same for an Agent: what it does at this observation, in its policies' own words where they have some and
/// `options` has none. A StatePolicy that grows may add the observation's state, as with Agent::state.
template <class Agent, class Observation>
[[nodiscard]] auto explain(Agent& agent, const Observation& observation, ExplainOptions options = {})
    -> decltype(agent.learner(), Explanation()) {
    using States = std::decay_t<decltype(agent.states())>;
    using Actions = std::decay_t<decltype(agent.actions())>;
    const StateId s = agent.state(observation);
    if constexpr (detail::is_detected_v<detail::DescribeStateExpression, States>) {
        if (!options.state) options.state = [&agent](StateId id) { return agent.states().describe(id); };
    }
    if constexpr (detail::is_detected_v<detail::DescribeActionExpression, Actions>) {
        if (!options.action) options.action = [&agent](ActionId id) { return agent.actions().describe(id); };
    }
    return explain(agent.learner(), s, options);
}

}  // namespace sspql
