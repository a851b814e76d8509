// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "experiment/any_learner.hpp"

/// \file
/// The learners an experiment knows by name, and the parameters `--set NAME.key=value` reaches.

namespace sspql::experiment {

/// Which learner a name stands for.
enum class LearnerKind { q_learning, sarsa, dyna_q, dyna_q_plus, prioritized_sweeping, rtdp, r_max, sspql, adaptive };

/// Every parameter a learner can be given.
struct LearnerSettings {
    double gamma = 0.8;
    double alpha = 0.8;
    double alpha_decay = 0.0;  ///< > 0: the learning rate is N^-alpha_decay instead of alpha
    double initial_q = 0.0;
    double bonus = 0.0;  ///< w_EXP
    double eta = 1.5;
    double noise = 0.01;
    double epsilon = 0.1;            ///< of the selector epsilon-greedy
    double temperature = 0.1;        ///< of the selector boltzmann
    std::string selector = "noise";  ///< noise, epsilon-greedy, boltzmann

    double cap = 0.0;            ///< model-based: how many observations of an (s,a) count; 0 = all
    double kappa = 0.0;          ///< model-based: optimistic pseudo-count
    double unknown_value = 1.0;  ///< ... for this value
    double k = 10.0;             ///< planning steps
    double threshold = 1e-4;     ///< of ps and rmax
    double time_bonus = 1e-4;    ///< of dyna-q-plus
    double known_after = 3.0;    ///< of rmax

    double w_q = 1.0;
    double w_ssp = 1.0;
    double decay = 2.0;  ///< p of min(1, N^-p); 0 = constant
    double lambda = 2.0;
    std::string cost = "risk";        ///< risk (eq. 2), tries, log-risk, hops
    std::string probability = "sum";  ///< sum (eq. 3), best

    // Of adaptive; where a key is shared with others, its preset says what the learner's default is.
    double budget = 40.0;        ///< edge touches a step
    double kappa_noise = 0.4;    ///< pseudo-count by noise
    double tau = 0.0;            ///< > 0: doubt what was not tried lately
    double retrace = 0.1;        ///< how little the way back attracts before a goal is known
    double alarm = 2.0;          ///< the change detector's floor
    double alarm_offset = 3.5;   ///< ... and what is taken off ln(pairs)
    std::string paths = "on";    ///< the shortest path bounds optimism: on, off

    std::string replay = "counts";    ///< of dyna-q: counts, last
    bool expected = false;            ///< of sarsa
};

/// A learner by name with its parameters: makes as many as asked for, all alike but for the seed.
class LearnerRecipe {
public:
    LearnerRecipe(std::string name, LearnerKind kind, LearnerSettings settings)
        : name_(std::move(name)), kind_(kind), settings_(std::move(settings)) {}

    [[nodiscard]] const std::string& name() const noexcept { return name_; }
    [[nodiscard]] LearnerKind kind() const noexcept { return kind_; }
    [[nodiscard]] const LearnerSettings& settings() const noexcept { return settings_; }
    [[nodiscard]] LearnerSettings& settings() noexcept { return settings_; }

    /// \throws std::invalid_argument for parameters out of range.
    [[nodiscard]] std::unique_ptr<AnyLearner> make(std::size_t states, std::size_t actions, std::uint64_t seed) const;

private:
    std::string name_;
    LearnerKind kind_;
    LearnerSettings settings_;
};

/// The names there are, in the order they are documented.
[[nodiscard]] std::vector<std::string> learner_names();

/// The keys of --set that a kind of learner has, in the order they are documented.
[[nodiscard]] std::vector<std::string> keys_of(LearnerKind kind);

/// Recipes for a comma-separated list of names, changed by assignments "NAME.key=value" ("*" reaches every learner that
/// has the key), the later one winning. A name that plans may end in ":20", which sets k.
/// \throws std::invalid_argument, with what would have been right, for a name or key that is not known, an assignment
/// to a learner that takes no part, a value that is no number or out of range, a name given twice, or no name at all.
[[nodiscard]] std::vector<LearnerRecipe> learner_recipes(const std::string& names,
                                                         const std::vector<std::string>& assignments);

}  // namespace sspql::experiment
