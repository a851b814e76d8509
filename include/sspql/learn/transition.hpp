// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include <sspql/core/errors.hpp>
#include <sspql/core/ids.hpp>

namespace sspql {

/// One observed step: `action` in `state` brought `reward` and led to `next`; `terminated` if the task ended there (then
/// `next` has no future value). `weight` is what the step cost for eq. 2: time, energy, distance; 1 counts steps.
struct Transition {
    StateId state{};          ///< before the action
    ActionId action{};        ///< taken there
    double reward = 0.0;      ///< it brought
    StateId next{};           ///< after the action
    bool terminated = false;  ///< whether the task ended in `next`
    double weight = 1.0;      ///< cost for eq. 2, in [1e-30, 1e30]

    template <class Archive>
    void serialize(Archive& archive) {
        archive(state, action, reward, next, terminated, weight);
    }
};

/// How many states a learner has: a fixed number, or as many as turn up.
class StateCount {
public:
    /// States 0 to n - 1, known in advance; another id is an error.
    /// \throws std::invalid_argument if n is 0 or above 2^32 - 2.
    StateCount(std::size_t n)  // NOLINT(google-explicit-constructor): a number of states reads as one
        : states_(detail::require_id_count("number of states", n)), grows_(false) {}

    /// None at first; the id equal to the current number adds a state, a larger one is an error.
    [[nodiscard]] static StateCount growing() { return StateCount(); }

    /// How many states there are at first; 0 if it grows.
    [[nodiscard]] std::size_t initial() const noexcept { return states_; }
    /// Whether states are added as they turn up.
    [[nodiscard]] bool grows() const noexcept { return grows_; }

private:
    StateCount() : states_(0), grows_(true) {}
    std::size_t states_;
    bool grows_;
};

/// The terms of eq. 8 for one (s,a), as they enter the sum: weights and schedules are in them, the noise is not.
struct ActionTerms {
    double q = 0.0;            ///< w_Q Q(s,a)
    double ssp = 0.0;          ///< w_SSP(N) Q_SSP(s,a)
    double exploration = 0.0;  ///< w_EXP Q_EXP(s,a)
    double hint = 0.0;         ///< what is left of a trainer's hint
    double n = 0.0;            ///< N(s,a)

    /// What actions are chosen by, but for the noise.
    [[nodiscard]] double sum() const noexcept { return q + ssp + exploration + hint; }
};

}  // namespace sspql
