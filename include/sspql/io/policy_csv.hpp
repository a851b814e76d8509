// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>

#include <sspql/core/concepts.hpp>
#include <sspql/core/ids.hpp>
#include <sspql/io/atomic_file.hpp>
#include <sspql/io/label_text.hpp>
#include <sspql/io/learnt_paths.hpp>
#include <sspql/spaces/action_policy.hpp>
#include <sspql/spaces/state_policy.hpp>

namespace sspql {

/// The words of save_policy_csv; numbers where empty.
struct PolicyLabels {
    std::function<std::string(StateId)> state{};    ///< a state in words
    std::function<std::string(ActionId)> action{};  ///< an action in words
};

namespace detail {

template <class Learner>
using PathLengthExpression = decltype(std::declval<const Learner&>().path_length(StateId{}));

/// The two last columns, as far as the learner knows them.
template <class Learner>
std::string path_fields(const Learner& learner, StateId s) {
    if constexpr (is_detected_v<TreeExpression, Learner>) {
        const auto& tree = learner.tree();
        if (!tree.reaches_goal(s)) return ",";
        const StateId next = tree.next[index(s)];
        return (next == no_state ? std::string() : std::to_string(index(next))) + "," +
               exact_text(tree.distance[index(s)]);
    } else if constexpr (is_detected_v<PathLengthExpression, Learner>) {
        return "," + exact_text(learner.path_length(s));
    } else {
        return ",";
    }
}

}  // namespace detail

/// What the learner would do where, as a table for spreadsheets and data frames:
///
///     state,visits,action,value,path_next,path_distance
///
/// One line a state, ascending: how often its actions were learnt from, the action that best() answers, Q of it, the
/// next state on the shortest path known and that path's length. The last two are empty where the learner keeps no
/// paths, at a goal, or where no path is known. Texts are quoted as RFC 4180 wants it, numbers have the digits that
/// give the same double again, lines end with LF. Written whole or not at all (AtomicFile). O(states x actions).
/// \throws std::runtime_error "cannot write PATH: REASON", and what best() throws.
template <class Learner>
auto save_policy_csv(const std::string& path, const Learner& learner, const PolicyLabels& labels = {})
    -> decltype(learner.visits(), void()) {
    AtomicFile file(path);
    file.write("state,visits,action,value,path_next,path_distance\n");
    for (std::size_t i = 0; i < learner.states(); ++i) {
        const StateId s = state_id(i);
        const ActionId best = learner.best(s);
        std::uint64_t visits = 0;
        for (std::size_t a = 0; a < learner.actions(); ++a) visits += learner.visits()(s, action_id(a));
        file.write(labels.state ? detail::csv_quoted(labels.state(s)) : std::to_string(i));
        file.write("," + std::to_string(visits) + ",");
        file.write(labels.action ? detail::csv_quoted(labels.action(best)) : std::to_string(index(best)));
        file.write("," + detail::exact_text(learner.q()(s, best)) + "," + detail::path_fields(learner, s) + "\n");
    }
    file.commit();
}

/// The same for an Agent, states and actions in its policies' own words where they have some.
template <class Agent>
auto save_policy_csv(const std::string& path, const Agent& agent) -> decltype(agent.learner(), void()) {
    PolicyLabels labels;
    labels.state = [&agent](StateId s) { return describe_state(agent.states(), s); };
    labels.action = [&agent](ActionId a) { return describe_action(agent.actions(), a); };
    save_policy_csv(path, agent.learner(), labels);
}

}  // namespace sspql
