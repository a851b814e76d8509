// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <sspql/core/concepts.hpp>
#include <sspql/core/errors.hpp>
#include <sspql/core/ids.hpp>
#include <sspql/io/checkpoint.hpp>
#include <sspql/io/explain.hpp>
#include <sspql/learn/transition.hpp>
#include <sspql/paths/shortest_paths.hpp>
#include <sspql/spaces/action_set.hpp>

#include "any_learner.hpp"
#include "parameters.hpp"

namespace sspql::python {

namespace detail {

template <class L>
using CountsExpression = decltype(std::declval<const L&>().counts());
template <class L>
using TreeExpression = decltype(std::declval<const L&>().tree());
template <class L>
using GoalsExpression = decltype(std::declval<const L&>().goals());
template <class L>
using StatusExpression = decltype(std::declval<const L&>().status());
template <class L>
using UpdatePathsExpression = decltype(std::declval<L&>().update_paths());

}  // namespace detail

/// Lists a Params object's members.
template <class Params>
using Lister = void (*)(Parameters&, Params&);

/// L behind AnyLearner's virtual functions.
template <class L>
class LearnerOf final : public AnyLearner {
public:
    using Params = typename L::Params;

    LearnerOf(L learner, Lister<Params> lister) : learner_(std::move(learner)), lister_(lister) {}

    std::size_t states() const override { return learner_.states(); }
    std::size_t actions() const override { return learner_.actions(); }
    bool running() const override { return learner_.running(); }
    Number state() const override { return running() ? number(learner_.state()) : -1; }
    Number action() const override { return running() ? number(learner_.action()) : -1; }

    Number begin(Number s) override { return number(learner_.begin(state_of(s))); }
    Number step(double reward, Number next, double weight) override {
        return number(learner_.step(reward, state_of(next, "next state"), weight));
    }
    void end(double reward, Number next, bool terminated, double weight) override {
        learner_.end(reward, state_of(next, "next state"), terminated, weight);
    }
    void abort() override { learner_.abort(); }
    void replace_action(Number a) override { learner_.replace_action(action_of(a)); }
    void observe(Number s, Number a, double reward, Number next, bool terminated, double weight) override {
        const Transition t = transition(s, a, reward, next, terminated, weight);
        learner_.observe(t.state, t.action, t.reward, t.next, t.terminated, t.weight);
    }
    void teach(Number s, Number a, double strength) override { learner_.teach(state_of(s), action_of(a), strength); }
    void demonstrate(Number s, Number a, double reward, Number next, bool terminated, double weight,
                     double strength) override {
        learner_.demonstrate(transition(s, a, reward, next, terminated, weight), strength);
    }
    Number best(Number s) const override { return number(learner_.best(state_of(s))); }
    ActionTerms terms(Number s, Number a) const override { return learner_.terms(state_of(s), action_of(a)); }

    void set_goals(const std::vector<std::pair<Number, double>>& goals) override {
        std::vector<Goal> list;
        for (const auto& [s, offset] : goals) list.push_back({state_of(s, "goal"), offset});
        learner_.set_goals(list);
    }
    void set_legal_actions(Number s, const std::vector<bool>& mask) override {
        ActionSet set = ActionSet::none(mask.empty() ? actions() : mask.size());
        for (std::size_t a = 0; a < mask.size(); ++a) {
            if (mask[a]) set.insert(action_id(a));
        }
        learner_.set_legal_actions(state_of(s), set);
    }
    std::vector<bool> legal_actions(Number s) const override {
        const auto& allowed = learner_.legal_actions().allowed(state_of(s));
        std::vector<bool> mask(actions());
        for (std::size_t a = 0; a < actions(); ++a) mask[a] = allowed.contains(action_id(a));
        return mask;
    }

    const double* q() const override { return learner_.q().matrix().data(); }
    std::vector<std::uint32_t> visits() const override {
        std::vector<std::uint32_t> visits;
        visits.reserve(states() * actions());
        for (std::size_t s = 0; s < states(); ++s) {
            for (std::size_t a = 0; a < actions(); ++a) visits.push_back(learner_.visits()(state_id(s), action_id(a)));
        }
        return visits;
    }
    CountsPointer counts() const override {
        if constexpr (has<detail::CountsExpression>) {
            return &learner_.counts();
        } else {
            return {};
        }
    }
    std::optional<std::vector<Goal>> goals() const override {
        if constexpr (has<detail::GoalsExpression>) {
            return learner_.goals();
        } else {
            return std::nullopt;
        }
    }
    const ShortestPathTree* tree() const override {
        if constexpr (has<detail::TreeExpression>) {
            return &learner_.tree();
        } else {
            return nullptr;
        }
    }
    Explanation explain(Number s, const ShortestPathTree& tree, const ExplainOptions& options) const override {
        return sspql::explain(learner_, state_of(s), tree, options);
    }
    std::vector<std::pair<std::string, double>> status() const override {
        if constexpr (has<detail::StatusExpression>) {
            const auto now = learner_.status();
            return {{"steps", static_cast<double>(now.steps)},
                    {"states_known", static_cast<double>(now.states_known)},
                    {"pairs_tried", static_cast<double>(now.pairs_tried)},
                    {"edge_touches", static_cast<double>(now.edge_touches)},
                    {"alarms", static_cast<double>(now.alarms)},
                    {"goal_known", now.goal_known ? 1.0 : 0.0},
                    {"typical_cost", now.typical_cost},
                    {"optimism", now.optimism},
                    {"noise", now.noise},
                    {"kappa", now.kappa}};
        }
        lacks("status()");
    }
    void update_paths() override {
        if constexpr (has<detail::UpdatePathsExpression>) return learner_.update_paths();
        lacks("update_paths()");
    }

    Settings parameters() const override {
        Params params = learner_.params();
        Parameters list;
        lister_(list, params);
        Settings settings;
        for (const Parameter& parameter : list.list()) settings.emplace_back(parameter.name, parameter.value);
        return settings;
    }

    std::string to_bytes() const override { return save_to_bytes(learner_); }
    std::shared_ptr<AnyLearner> from_bytes(std::string_view bytes, const std::string& name) const override {
        auto loaded = std::make_shared<LearnerOf>(L(states(), actions()), lister_);
        load_from_bytes(bytes, loaded->learner_, name);
        return loaded;
    }
    std::shared_ptr<AnyLearner> copy() const override { return std::make_shared<LearnerOf>(learner_, lister_); }

private:
    template <template <class> class Expression>
    static constexpr bool has = sspql::detail::is_detected_v<Expression, L>;

    [[noreturn]] static void lacks(const char* what) {
        throw std::logic_error(std::string(L::type_name) + " has no " + what);
    }

    template <class Id>
    static Number number(Id id) {
        return static_cast<Number>(index(id));
    }

    static bool outside(Number n, std::size_t size) { return n < 0 || static_cast<std::uint64_t>(n) >= size; }

    StateId state_of(Number s, const char* what = "state") const {
        if (outside(s, states())) throw_invalid(what, "be below the number of states " + std::to_string(states()), s);
        return state_id(static_cast<std::size_t>(s));
    }
    ActionId action_of(Number a) const {
        if (outside(a, actions())) {
            throw_invalid("action", "be below the number of actions " + std::to_string(actions()), a);
        }
        return action_id(static_cast<std::size_t>(a));
    }
    Transition transition(Number s, Number a, double reward, Number next, bool terminated, double weight) const {
        return {state_of(s), action_of(a), reward, state_of(next, "next state"), terminated, weight};
    }

    L learner_;
    Lister<Params> lister_;
};

template <class Params>
struct Preset {
    const char* name;
    Params (*make)();
};

/// The Kind of L. `lister` names the members of its Params.
template <class L>
[[nodiscard]] Kind kind_of(const char* name, Lister<typename L::Params> lister,
                           std::vector<Preset<typename L::Params>> presets = {}) {
    using Params = typename L::Params;
    Kind kind;
    kind.name = name;
    kind.type_name = L::type_name;
    for (const auto& preset : presets) kind.presets.emplace_back(preset.name);
    const auto params_of = [=, names = kind.presets](const std::string& preset) {
        if (preset.empty()) return Params{};
        std::string all;
        for (const auto& [known, make] : presets) {
            if (preset == known) return make();
            all += (all.empty() ? "" : ", ") + std::string(known);
        }
        throw_invalid("preset", all.empty() ? "not be given: there are none" : "be one of " + all, preset);
    };
    kind.parameters = [=](const std::string& preset) {
        Params params = params_of(preset);
        Parameters list;
        lister(list, params);
        auto copies = list.list();
        for (Parameter& parameter : copies) parameter.set = nullptr;  // the object they would set goes away
        return copies;
    };
    kind.make = [=](Number states, Number actions, const std::string& preset, const Settings& settings,
                    std::uint64_t seed) -> std::shared_ptr<AnyLearner> {
        Params params = params_of(preset);
        Parameters list;
        lister(list, params);
        for (const auto& [setting, value] : settings) {
            for (const Parameter& parameter : list.list()) {
                if (parameter.name == setting) parameter.set(value);
            }
        }
        if (states < 0) throw_invalid("number of states", "lie between 1 and 4294967294", states);
        if (actions < 0) throw_invalid("number of actions", "lie between 1 and 4294967294", actions);
        return std::make_shared<LearnerOf<L>>(
            L(static_cast<std::size_t>(states), static_cast<std::size_t>(actions), params, seed), lister);
    };
    return kind;
}

}  // namespace sspql::python
