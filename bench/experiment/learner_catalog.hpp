// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "experiment/any_learner.hpp"

/// \file
/// The learners an experiment knows by name, and the parameters `--set NAME.key=value` reaches.

namespace sspql::experiment {

/// Every parameter a learner can be given. The defaults are the paper's (sspql-bonus).
struct LearnerSettings {
    double gamma = 0.8;
    double alpha = 0.8;
    double initial_q = 0.0;
    double w_q = 1.0;
    double w_ssp = 1.0;
    double decay = 2.0;  ///< p of min(1, N^-p); 0 = constant
    double bonus = 0.1;  ///< w_EXP
    double eta = 1.5;
    double noise = 0.01;
    double lambda = 2.0;
    std::string selector = "noise";    ///< noise, epsilon-greedy, boltzmann
    double epsilon = 0.1;              ///< of epsilon-greedy
    double temperature = 0.1;          ///< of boltzmann
    std::string cost = "risk";         ///< risk (eq. 2), tries, log-risk, hops
    std::string probability = "sum";   ///< sum (eq. 3), best
};

/// A learner by name with its parameters: makes as many as asked for, all alike but for the seed.
class LearnerRecipe {
public:
    [[nodiscard]] const std::string& name() const noexcept { return name_; }
    [[nodiscard]] const LearnerSettings& settings() const noexcept { return settings_; }

    [[nodiscard]] std::unique_ptr<AnyLearner> make(std::size_t states, std::size_t actions, std::uint64_t seed) const;

private:
    friend class RecipeBuilder;
    std::string name_;
    bool has_model_ = false;
    LearnerSettings settings_;
};

/// The names there are, in the order they are documented.
[[nodiscard]] std::vector<std::string> learner_names();

/// Recipes for a comma-separated list of names, changed by assignments "NAME.key=value" ("*" reaches every learner that
/// has the key), the later one winning.
/// \throws std::invalid_argument, with what would have been right, for a name or key that is not known, an assignment
/// to a learner that takes no part, a value that is no number or out of range, a name given twice, or no name at all.
[[nodiscard]] std::vector<LearnerRecipe> learner_recipes(const std::string& names,
                                                         const std::vector<std::string>& assignments);

}  // namespace sspql::experiment
