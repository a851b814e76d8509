// SPDX-License-Identifier: MIT
//
// What does each parameter do? One at a time is changed, on four tasks. Writes the pictures of docs/tune.md, and the
// numbers they show to standard output: tuning_pictures --help

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <sspql/env/grid_maps.hpp>
#include <sspql/env/grid_world.hpp>
#include <sspql/run/parallel.hpp>
#include <sspql/run/statistics.hpp>
#include <sspql/sim/kinematic_backend.hpp>
#include <sspql/sim/pusher_tasks.hpp>
#include <sspql/spaces/action_policy.hpp>
#include <sspql/spaces/enum_state.hpp>

#include "experiment/learner_catalog.hpp"
#include "experiment/options.hpp"
#include "experiment/runner.hpp"
#include "report/numbers.hpp"
#include "report/output_file.hpp"
#include "report/progress.hpp"
#include "report/sensitivity_picture.hpp"

namespace {

using namespace sspql;
using namespace sspql::experiment;

/// A parameter by its key of --set, and the values tried; one of them is the default.
struct Parameter {
    const char* key;
    const char* says;
    std::vector<const char*> values;
    std::size_t standard;
};

struct Study {
    const char* learner;
    const char* file;
    double most;  ///< the end of the picture's scale
    std::vector<Parameter> parameters;
};

const std::vector<Study>& studies() {
    static const std::vector<Study> all{
        {"sspql-bonus",
         "tune-paper.svg",
         8.0,
         {{"gamma", "gamma: discount", {".5", ".7", ".8", ".9", ".95", ".99"}, 2},
          {"alpha", "alpha: learning rate", {".1", ".3", ".5", ".8", "1"}, 3},
          {"lambda", "lambda: cost of an edge", {"0", ".5", "1", "2", "4", "8"}, 3},
          {"decay", "decay: the weight fades", {"0", ".5", "1", "2", "4"}, 3},
          {"w_ssp", "w_ssp: weight of paths", {"0", ".1", ".3", "1", "3"}, 3},
          {"bonus", "bonus: for the seldom tried", {"0", ".03", ".1", ".3", "1"}, 2},
          {"eta", "eta: the bonus fades", {".5", "1", "1.5", "3"}, 2},
          {"noise", "noise: in choosing", {".001", ".003", ".01", ".03", ".1"}, 2}}},
        {"adaptive",
         "tune-adaptive.svg",
         4.0,
         {{"gamma", "gamma: discount", {".9", ".95", ".98", ".99", ".999"}, 3},
          {"bonus", "bonus: for the seldom tried", {"0", ".03", ".1", ".3", "1"}, 2},
          {"budget", "budget: touches a step", {"5", "13", "40", "120"}, 2},
          {"cap", "cap: tries that count", {"5", "20", "50", "200"}, 2},
          {"kappa_noise", "kappa_noise: hope in noise", {"0", ".2", ".4", ".8", "1.6"}, 2},
          {"tau", "tau: doubt comes back", {"0", "1000", "100", "10"}, 0},
          {"retrace", "retrace: the way back waits", {"0", ".1", ".3", "1"}, 1},
          {"alarm", "alarm: change is noticed", {".5", "1", "2", "4", "1e9"}, 2}}}};
    return all;
}

const std::vector<std::string> task_names{"open64", "soft54, after open64", "walls30, a map a seed",
                                          "robot, approach (kinematic)"};

RunPlan plan_of(std::size_t most_steps) {
    RunPlan plan;
    plan.episodes = 30;
    plan.steps_per_episode = most_steps;
    return plan;
}

double steps_of(const report::SeedRun& run) { return static_cast<double>(run.steps); }

/// The steps of 30 episodes on each task, as grid_experiment and pusher_experiment count them with this seed.
std::vector<double> measure(const LearnerRecipe& recipe, std::uint64_t seed) {
    std::vector<double> steps;
    const auto grid = [&](AnyLearner& learner, const std::string& map, std::size_t first_episode, std::size_t most) {
        GridWorld world = grid_task(map).world();
        TimedAgent agent(EnumState<StateId>(world.size()), EnumActions<Move>(GridWorld::actions), learner);
        steps.push_back(steps_of(run_seed(world, agent, seed, first_episode, plan_of(most))));
    };
    const std::size_t cells = grid_task("open64").map.size();
    const auto mover = recipe.make(cells, GridWorld::actions, seed);
    grid(*mover, "open64", 0, 5000);
    grid(*mover, "soft54", 1000000, 5000);
    const std::string walls = "walls30:" + std::to_string(seed);
    const auto explorer = recipe.make(grid_task(walls).map.size(), GridWorld::actions, seed);
    grid(*explorer, walls, 0, 20000);

    const sim::ApproachState states;
    const sim::ApproachActions actions;
    sim::ApproachTask<sim::KinematicBackend> robot{sim::PusherParams{}};
    const auto driver = recipe.make(states.size(), actions.size(), seed);
    TimedAgent agent(states, actions, *driver);
    steps.push_back(steps_of(run_seed(robot, agent, seed, 0, plan_of(2000))));
    return steps;
}

/// The mean of x over that of y, and its standard error; the samples are pairs of the same seed.
report::Sensitivity ratio_of(const std::vector<double>& x, const std::vector<double>& y) {
    const double ratio = summarize(x).mean / summarize(y).mean;
    std::vector<double> rest(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) rest[i] = x[i] - ratio * y[i];
    return {ratio, summarize(rest).error / summarize(y).mean};
}

void draw(const Study& study, std::size_t seeds, std::size_t threads, const std::string& out) {
    std::vector<LearnerRecipe> recipes;                     // the default, then every other value of every parameter
    std::vector<std::vector<std::size_t>> recipe_of_value;  // by parameter and value
    recipes.push_back(learner_recipes(study.learner, {}).front());
    for (const Parameter& parameter : study.parameters) {
        recipe_of_value.emplace_back();
        for (std::size_t v = 0; v < parameter.values.size(); ++v) {
            const std::string set = std::string(study.learner) + "." + parameter.key + "=" + parameter.values[v];
            recipe_of_value.back().push_back(v == parameter.standard ? 0 : recipes.size());
            if (v != parameter.standard) recipes.push_back(learner_recipes(study.learner, {set}).front());
        }
    }
    std::vector<std::vector<std::vector<double>>> steps(  // by recipe, task and seed
        recipes.size(), std::vector<std::vector<double>>(task_names.size(), std::vector<double>(seeds)));
    {
        report::Progress progress(study.learner, recipes.size() * seeds);
        parallel_for(recipes.size() * seeds, threads, [&](std::size_t i) {
            const std::vector<double> measured = measure(recipes[i / seeds], i % seeds + 1);
            for (std::size_t t = 0; t < measured.size(); ++t) steps[i / seeds][t][i % seeds] = measured[t];
            progress.advance();
        });
    }

    std::vector<report::SensitivityPanel> panels;
    for (std::size_t p = 0; p < study.parameters.size(); ++p) {
        const Parameter& parameter = study.parameters[p];
        report::SensitivityPanel panel{
            parameter.says, {parameter.values.begin(), parameter.values.end()}, parameter.standard, {}};
        for (std::size_t t = 0; t < task_names.size(); ++t) {
            panel.tasks.emplace_back();
            for (std::size_t v = 0; v < parameter.values.size(); ++v) {
                const auto& sample = steps[recipe_of_value[p][v]][t];
                panel.tasks.back().push_back(ratio_of(sample, steps[0][t]));
                const Summary mean = summarize(sample);
                std::cout << study.learner << "." << parameter.key << "=" << parameter.values[v] << " on "
                          << task_names[t] << ": " << report::fixed_text(mean.mean, 0) << " +- "
                          << report::fixed_text(mean.error, 0) << " steps, "
                          << report::fixed_text(panel.tasks.back().back().ratio, 2) << " +- "
                          << report::fixed_text(panel.tasks.back().back().error, 2)
                          << (v == parameter.standard ? ", the default\n" : "\n");
            }
        }
        panels.push_back(std::move(panel));
    }
    const std::string label =
        "Eight small charts, one for each parameter: steps of 30 episodes as a multiple of those "
        "with the defaults, on four tasks";
    report::write_file(out + "/" + study.file,
                       report::sensitivity_picture(panels, task_names, study.most, label).document());
}

int body(int argc, char** argv) {
    std::string out;
    std::int64_t seeds = 40;
    std::int64_t threads = 0;
    Options parser("tuning_pictures", "The pictures of docs/tune.md, as SVG files, and their numbers.");
    parser.text("--out", out, "The folder to write them to");
    parser.whole("--seeds", seeds, 2, 100000, "Runs of each kind");
    parser.whole("--threads", threads, 0, 1024, "Threads, 0: all; the numbers do not depend on it");
    if (!parser.parse(argc, argv)) return 0;
    if (out.empty()) throw std::invalid_argument("give --out (--help lists the options)");
    for (const Study& study : studies()) report::require_writable(out + "/" + study.file);
    for (const Study& study : studies()) {
        draw(study, static_cast<std::size_t>(seeds), static_cast<std::size_t>(threads), out);
    }
    return std::cout.flush().good() ? 0 : 2;
}

}  // namespace

int main(int argc, char** argv) { return run_program("tuning_pictures", body, argc, argv); }
