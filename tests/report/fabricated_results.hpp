// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "report/results.hpp"

namespace sspql::report {

/// A seed's run whose episodes took these steps; all succeed with return 1. Two model operations and 100 ns a step.
inline SeedRun run_of(std::uint64_t seed, const std::vector<std::uint32_t>& steps) {
    SeedRun run;
    run.seed = seed;
    for (const std::uint32_t count : steps) {
        run.episodes.push_back({count, 1.0, true, false});
        run.steps += count;
    }
    run.model_operations = 2 * run.steps;
    run.learning_ns = 100.0 * static_cast<double>(run.steps);
    return run;
}

/// Results with one phase and these learners.
inline ExperimentResults results_of(std::vector<LearnerRuns> learners) {
    ExperimentResults results;
    results.experiment = "pusher_experiment";
    results.settings = {{"task", "approach", true}, {"seeds", "2", false}, {"noise", "0.5", false}};
    results.manifest = {"pusher_experiment --seeds 2", "0.1.0", "g++ 12.2.0"};
    PhaseRuns phase;
    phase.name = "approach";
    phase.learners = std::move(learners);
    results.phases.push_back(std::move(phase));
    return results;
}

/// The paper's four learners, two seeds of 30 episodes of constant length (one step more in the second seed).
inline ExperimentResults four_learners() {
    std::vector<LearnerRuns> learners;
    std::uint32_t steps = 200;
    for (const char* name : {"q", "ssp", "sspql", "sspql-bonus"}) {
        learners.push_back(
            {name,
             {run_of(1, std::vector<std::uint32_t>(30, steps)), run_of(2, std::vector<std::uint32_t>(30, steps + 1))}});
        steps -= 40;
    }
    return results_of(std::move(learners));
}

}  // namespace sspql::report
