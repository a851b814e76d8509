// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <sspql/core/errors.hpp>
#include <sspql/core/step_budget.hpp>
#include <sspql/learn/action_selector.hpp>
#include <sspql/learn/exploration_bonus.hpp>
#include <sspql/learn/schedule.hpp>
#include <sspql/paths/cost.hpp>

namespace sspql::python {

/// One of some words.
struct Choice {
    std::size_t at = 0;
    std::vector<std::string> words{};
};

/// What a parameter may be, whichever learner has it: a truth value, a whole number, a number, a word, a schedule, or
/// the two numbers of a StepBudget.
using Value = std::variant<bool, std::uint64_t, double, Choice, Schedule::Rule, std::array<std::uint64_t, 2>>;

/// A member of a learner's Params, by name.
struct Parameter {
    std::string name;                       ///< "gamma"; "trust.cap" for the member of a member
    std::string help;                       ///< a few words
    Value value;                            ///< what it is
    std::function<void(const Value&)> set;  ///< of the same alternative; throws what its type's constructor throws
};

/// The members of one Params object, which must outlive the list.
class Parameters {
public:
    template <class T>
    void add(std::string name, T& member, std::string help) {
        Parameter parameter{std::move(name), std::move(help), {}, {}};
        if constexpr (std::is_same_v<T, bool> || std::is_same_v<T, double>) {
            parameter.value = member;
            parameter.set = [&member](const Value& value) { member = std::get<T>(value); };
        } else {
            static_assert(std::is_integral_v<T> && std::is_unsigned_v<T>);
            parameter.value = std::uint64_t{member};
            parameter.set = [&member](const Value& value) { member = static_cast<T>(std::get<std::uint64_t>(value)); };
        }
        list_.push_back(std::move(parameter));
    }
    void add(std::string name, Schedule& member, std::string help) {
        list_.push_back({std::move(name), std::move(help), member.rule(),
                         [&member](const Value& value) { member = Schedule(std::get<Schedule::Rule>(value)); }});
    }
    void add(std::string name, StepBudget& member, std::string help) {
        list_.push_back({std::move(name), std::move(help),
                         std::array<std::uint64_t, 2>{member.per_step(), member.bank()}, [&member](const Value& value) {
                             const auto& [per_step, bank] = std::get<std::array<std::uint64_t, 2>>(value);
                             member = StepBudget(per_step, bank);
                         }});
    }
    void add(std::string name, ExplorationBonus& member, std::string help) {
        add_made_of_number(std::move(name), member, member.eta(), std::move(help));
    }
    void add(std::string name, ActionSelector& member, std::string help) {
        add_made_of_number(std::move(name), member, member.noise(), std::move(help));
    }
    void add(std::string name, RiskWeighted& member, std::string help) {
        add_made_of_number(std::move(name), member, member.lambda(), std::move(help));
    }

    /// An enumeration whose values are 0, 1, ... in the order of `words`.
    template <class Enum>
    void add(std::string name, Enum& member, std::vector<std::string> words, std::string help) {
        list_.push_back({std::move(name), std::move(help), Choice{static_cast<std::size_t>(member), std::move(words)},
                         [&member](const Value& value) { member = static_cast<Enum>(std::get<Choice>(value).at); }});
    }

    [[nodiscard]] const std::vector<Parameter>& list() const noexcept { return list_; }

private:
    template <class T>
    void add_made_of_number(std::string name, T& member, double value, std::string help) {
        list_.push_back({std::move(name), std::move(help), value,
                         [&member](const Value& given) { member = T(std::get<double>(given)); }});
    }

    std::vector<Parameter> list_;
};

}  // namespace sspql::python
