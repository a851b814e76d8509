// SPDX-License-Identifier: MIT
//
// How many steps does each learner need until the robot knows its way behind the box? Table 1 and Figs. 8 to 12 of Kwon,
// Suh and Lee (2011), on a simulated robot: pusher_experiment --help

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
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
#include "experiment/parts.hpp"
#include "experiment/runner.hpp"
#include "report/findings.hpp"
#include "report/numbers.hpp"
#include "report/progress.hpp"

namespace {

using namespace sspql;
using namespace sspql::experiment;

struct PusherOptions : CommonOptions {
    std::string backend = "box2d";
    std::string task = "approach";
    std::string starts = "two";
    ShardOptions shards;
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

/// From each starting place, of the last ten episodes the one of median length.
std::vector<report::ArenaPath> typical_paths(const std::vector<report::ArenaPath>& episodes,
                                             const sim::PusherParams& params, const std::string& learner) {
    std::vector<report::ArenaPath> typical_ones;
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
        typical_ones.push_back(episodes[typical]);
        typical_ones.back().name = learner + ", episode " + std::to_string(typical + 1);
    }
    return typical_ones;
}

/// False if --help or --version was all that was asked for.
bool parse(PusherOptions& options, int argc, char** argv) {
    Options parser("pusher_experiment",
                   "A simulated robot learns to approach (or to turn towards) a box: steps per episode of several "
                   "learners, as in Table 1 and Figs. 8 to 12 of Kwon, Suh and Lee (2011).");
    parser.choice("--backend", options.backend, {"kinematic", "box2d"}, "The world: plain geometry, or physics");
    parser.choice("--task", options.task, {"approach", "turn"}, "Get behind the box, or face it once there");
    parser.number("--noise", options.noise, 0.0, 10.0, "Actuator noise, as a multiple of the study's");
    parser.choice("--starts", options.starts, {"one", "two"}, "Starting places of 'approach'");
    parser.common(options);
    parser.text("--arena-svg", options.files.arena_svg, "Write the picture of the arena and the learnt paths");
    parser.text("--curves-svg", options.files.curves_svg, "Write the picture of the learning curves");
    parser.shards(options.shards);
    std::string names;
    for (const std::string& name : learner_names()) names += " " + name;
    parser.footer("Learners:" + names +
                  "; dyna-q:20 and the like set k"
                  "\nKeys of --set: an unknown one is answered with those the learner has");
    return parser.parse(argc, argv);
}

/// A run of every learner with every seed.
struct Experiment {
    PusherOptions options;
    std::vector<LearnerRecipe> recipes;
    sim::PusherParams params;
    Parts parts;

    /// \throws std::exception for anything wrong with the options, as prepare does.
    [[nodiscard]] bool read(int argc, char** argv) { return parse(options, argc, argv); }

    void prepare(const Ranks& ranks, int argc, char** argv) {
        recipes = learner_recipes(options.learners, options.set);
        params.noise = options.noise;
        params.starts = options.starts == "one" ? sim::Starts::one : sim::Starts::two;
        params.validate();
        parts = parts_of("pusher_experiment", options.shards, options.files, ranks, argc, argv);
    }

    [[nodiscard]] report::PusherFindings blank(int argc, char** argv) const {
        report::PusherFindings findings;
        report::ExperimentResults& results = findings.results;
        results.experiment = "pusher_experiment";
        results.settings = settings_of(options, recipes);
        results.manifest = {command_line(argc, argv), SSPQL_VERSION, compiler_name()};
        results.phases.emplace_back();
        results.phases.front().name = options.task;
        for (const LearnerRecipe& recipe : recipes) {
            results.phases.front().learners.push_back(
                {recipe.name(), std::vector<report::SeedRun>(static_cast<std::size_t>(options.seeds))});
        }
        return findings;
    }

    void run(const shards::Shard& shard, const Ranks& ranks, report::PusherFindings& findings) const {
        std::vector<report::LearnerRuns>& learners = findings.results.phases.front().learners;
        const std::size_t count = recipes.size() * shard.share(static_cast<std::size_t>(options.seeds));
        const bool drawn = shard.has(0) && parts.drawn() && options.task != "turn";
        std::vector<Trace> traces(recipes.size());
        {
            report::Progress progress("pusher_experiment", count, "runs", ranks.progress_descriptor());
            // Learners take turns, so that the time left can be told from the runs done.
            parallel_for(count, ranks.threads(static_cast<std::size_t>(options.threads)), [&](std::size_t i) {
                const std::size_t learner = i % recipes.size();
                const std::size_t k = shard.unit(i / recipes.size());
                Trace* trace = k == 0 && drawn ? &traces[learner] : nullptr;
                learners[learner].runs[k] =
                    options.backend == "box2d"
                        ? run_one<sim::Box2dBackend>(options, params, recipes[learner], k + 1, trace)
                        : run_one<sim::KinematicBackend>(options, params, recipes[learner], k + 1, trace);
                progress.advance();
            });
        }
        if (!drawn) return;
        for (std::size_t i = 0; i < recipes.size(); ++i) {
            findings.typical_paths.push_back(typical_paths(traces[i].episodes, params, recipes[i].name()));
        }
    }
};

}  // namespace

int main(int argc, char** argv) {
    return sspql::experiment::run_on_ranks("pusher_experiment", run_experiment<Experiment>, argc, argv);
}
