// SPDX-License-Identifier: MIT
//
// How many steps does each learner need until the robot knows its way behind the box? Table 1 and Figs. 8 to 12 of Kwon,
// Suh and Lee (2011), on a simulated robot: pusher_experiment --help

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include <sspql/core/version.hpp>
#include <sspql/run/parallel.hpp>
#include <sspql/sim/box2d_backend.hpp>
#include <sspql/sim/kinematic_backend.hpp>
#include <sspql/sim/pusher_tasks.hpp>

#include "experiment/learner_catalog.hpp"
#include "experiment/options.hpp"
#include "experiment/runner.hpp"
#include "report/csv_report.hpp"
#include "report/json_report.hpp"
#include "report/numbers.hpp"
#include "report/output_file.hpp"
#include "report/progress.hpp"
#include "report/pusher_report.hpp"
#include "report/table_text.hpp"

namespace {

using namespace sspql;
using namespace sspql::experiment;

struct PusherOptions : CommonOptions {
    std::string backend = "box2d";
    std::string task = "approach";
    std::string starts = "two";
    std::string arena_svg;
    std::string curves_svg;
    double noise = 1.0;

    PusherOptions() {
        learners = "q,ssp,sspql,sspql-bonus";
        seeds = 20;
        episodes = 30;
        steps_per_episode = 2000;
    }
};

/// The robot's way in some episodes of one run, to be drawn.
struct Trace {
    std::vector<report::ArenaPath> episodes;

    void add(std::size_t episode, const sim::Pose& robot) {
        if (episodes.size() <= episode) episodes.resize(episode + 1);
        episodes[episode].poses.push_back({robot.x_m, robot.y_m, robot.heading_rad});
    }
};

/// Remembers where an episode began: what a TimeLimit passes on from reset is not seen by a step callback.
template <class Task>
class TracedTask {
public:
    TracedTask(const sim::PusherParams& params, Trace* trace) : task_(params), trace_(trace) {}

    auto reset(std::uint64_t seed) {
        const auto observation = task_.reset(seed);
        if (trace_ != nullptr) trace_->add(episode_, observation.robot);
        ++episode_;
        return observation;
    }

    auto step(const sim::PusherCommand& command) {
        const auto step = task_.step(command);
        if (trace_ != nullptr) trace_->add(episode_ - 1, step.observation.robot);
        return step;
    }

private:
    Task task_;
    Trace* trace_;
    std::size_t episode_ = 0;
};

template <class Task, class States, class Actions>
report::SeedRun run_one(const PusherOptions& options, const sim::PusherParams& params, const LearnerRecipe& recipe,
                        std::uint64_t seed, Trace* trace) {
    const States states;
    const Actions actions;
    TracedTask<Task> environment(params, trace);
    const auto learner = recipe.make(states.size(), actions.size(), seed);
    TimedAgent agent(states, actions, *learner);
    RunPlan plan;
    plan.episodes = static_cast<std::size_t>(options.episodes);
    plan.steps_per_episode = static_cast<std::size_t>(options.steps_per_episode);
    return run_seed(environment, agent, seed, 0, plan);
}

template <class Backend>
report::SeedRun run_one(const PusherOptions& options, const sim::PusherParams& params, const LearnerRecipe& recipe,
                        std::uint64_t seed, Trace* trace) {
    using namespace sim;
    if (options.task == "turn") {
        return run_one<TurnTask<Backend>, TurnState, TurnActions>(options, params, recipe, seed, trace);
    }
    return run_one<ApproachTask<Backend>, ApproachState, ApproachActions>(options, params, recipe, seed, trace);
}

std::vector<report::Setting> settings_of(const PusherOptions& options, const std::vector<LearnerRecipe>& recipes) {
    std::vector<std::string> names;
    for (const LearnerRecipe& recipe : recipes) names.push_back(recipe.name());
    return {{"backend", options.backend},
            {"task", options.task},
            {"starts", options.starts},
            {"noise", report::exact_text(options.noise), false},
            {"learners", json_list(names), false},
            {"set", json_list(options.set), false},
            {"seeds", std::to_string(options.seeds), false},
            {"episodes", std::to_string(options.episodes), false},
            {"steps_per_episode", std::to_string(options.steps_per_episode), false}};
}

/// Which starting place an episode began at: the nearest.
std::size_t start_of(const report::ArenaPath& episode, const sim::PusherParams& params) {
    const report::ArenaPose& pose = episode.poses.front();
    const auto distance = [&](std::size_t p) {
        return std::hypot(pose.x_m - params.start_places[p].x_m, pose.y_m - params.start_places[p].y_m);
    };
    std::size_t nearest = 0;
    for (std::size_t p = 1; p < params.start_places.size(); ++p) {
        if (distance(p) < distance(nearest)) nearest = p;
    }
    return nearest;
}

/// For the learner that needed the fewest steps, from each starting place: of the last ten episodes of the first seed the
/// one of median length.
report::Arena learnt_paths(const PusherOptions& options, const sim::PusherParams& params,
                           const report::PhaseRuns& phase, const std::vector<Trace>& traces) {
    report::Arena arena;
    if (options.task == "turn") return arena;
    std::size_t best = 0;
    std::uint64_t best_steps = 0;
    for (std::size_t i = 0; i < phase.learners.size(); ++i) {
        std::uint64_t steps = 0;
        for (const report::SeedRun& run : phase.learners[i].runs) steps += run.steps;
        if (i == 0 || steps < best_steps) {
            best = i;
            best_steps = steps;
        }
    }
    const std::vector<report::ArenaPath>& episodes = traces[best].episodes;
    for (std::size_t p = 0; p < params.start_places.size(); ++p) {
        std::vector<std::size_t> from_here;
        for (std::size_t e = episodes.size(); e-- > 0 && from_here.size() < 10;) {
            if (start_of(episodes[e], params) == p) from_here.push_back(e);
        }
        if (from_here.empty()) continue;
        std::sort(from_here.begin(), from_here.end(), [&](std::size_t a, std::size_t b) {
            return episodes[a].poses.size() != episodes[b].poses.size() ? episodes[a].poses.size() < episodes[b].poses.size()
                                                                        : a < b;
        });
        const std::size_t typical = from_here[(from_here.size() - 1) / 2];
        arena.paths.push_back(episodes[typical]);
        arena.paths.back().name = phase.learners[best].name + ", episode " + std::to_string(typical + 1);
    }
    return arena;
}

int body(int argc, char** argv) {
    PusherOptions options;
    Options parser("pusher_experiment",
                   "A simulated robot learns to approach (or to turn towards) a box: steps per episode of several "
                   "learners, as in Table 1 and Figs. 8 to 12 of Kwon, Suh and Lee (2011).");
    parser.choice("--backend", options.backend, {"kinematic", "box2d"}, "The world: plain geometry, or physics");
    parser.choice("--task", options.task, {"approach", "turn"}, "Get behind the box, or face it once there");
    parser.number("--noise", options.noise, 0.0, 10.0, "Actuator noise, as a multiple of the study's");
    parser.choice("--starts", options.starts, {"one", "two"}, "Starting places of 'approach'");
    parser.common(options);
    parser.text("--arena-svg", options.arena_svg, "Write the picture of the arena and the learnt paths");
    parser.text("--curves-svg", options.curves_svg, "Write the picture of the learning curves");
    std::string names;
    for (const std::string& name : learner_names()) names += " " + name;
    parser.footer("Learners:" + names +
                  "; dyna-q:20 and the like set k"
                  "\nKeys of --set: an unknown one is answered with those the learner has");
    if (!parser.parse(argc, argv)) return 0;

    const std::vector<LearnerRecipe> recipes = learner_recipes(options.learners, options.set);
    sim::PusherParams params;
    params.noise = options.noise;
    params.starts = options.starts == "one" ? sim::Starts::one : sim::Starts::two;
    params.validate();
    for (const std::string* path : {&options.json, &options.html, &options.csv, &options.arena_svg, &options.curves_svg}) {
        if (!path->empty()) report::require_writable(*path);
    }

    report::ExperimentResults results;
    results.experiment = "pusher_experiment";
    results.settings = settings_of(options, recipes);
    results.manifest = {command_line(argc, argv), SSPQL_VERSION, compiler_name()};
    results.phases.emplace_back();
    report::PhaseRuns& phase = results.phases.back();
    phase.name = options.task;

    const auto seeds = static_cast<std::size_t>(options.seeds);
    for (const LearnerRecipe& recipe : recipes) {
        phase.learners.push_back({recipe.name(), std::vector<report::SeedRun>(seeds)});
    }
    const bool drawn = !options.html.empty() || !options.arena_svg.empty() || !options.curves_svg.empty();
    std::vector<Trace> traces(recipes.size());
    {
        report::Progress progress("pusher_experiment", recipes.size() * seeds);
        // Learners take turns, so that the time left can be told from the runs done.
        parallel_for(recipes.size() * seeds, static_cast<std::size_t>(options.threads), [&](std::size_t i) {
            const std::size_t learner = i % recipes.size();
            const std::size_t k = i / recipes.size();
            Trace* trace = k == 0 && drawn ? &traces[learner] : nullptr;
            phase.learners[learner].runs[k] =
                options.backend == "box2d"
                    ? run_one<sim::Box2dBackend>(options, params, recipes[learner], k + 1, trace)
                    : run_one<sim::KinematicBackend>(options, params, recipes[learner], k + 1, trace);
            progress.advance();
        });
    }

    std::cout << report::table_text(results) << std::flush;
    if (!options.json.empty()) report::write_file(options.json, report::json_report(results));
    if (!options.csv.empty()) report::write_file(options.csv, report::csv_report(results));
    if (drawn) {
        const report::Arena arena = learnt_paths(options, params, phase, traces);
        const report::PusherPictures pictures = report::pusher_pictures(results, arena);
        if (!options.html.empty()) report::write_file(options.html, report::pusher_report(results, arena));
        if (!options.arena_svg.empty()) report::write_file(options.arena_svg, pictures.arena.document());
        if (!options.curves_svg.empty()) report::write_file(options.curves_svg, pictures.curves.document());
    }
    return std::cout.good() ? 0 : 2;
}

}  // namespace

int main(int argc, char** argv) { return sspql::experiment::run_program("pusher_experiment", body, argc, argv); }
