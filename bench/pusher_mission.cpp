// SPDX-License-Identifier: MIT
//
// A robot searches a box, gets behind it, faces it and pushes it to the goal: section 4 of Kwon, Suh and Lee (2011),
// the whole task, in a simulated world with sensors that err: pusher_mission --help

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <sspql/core/version.hpp>
#include <sspql/sim/mission/mission_start.hpp>

#include "experiment/learner_catalog.hpp"
#include "experiment/mission_run.hpp"
#include "experiment/options.hpp"
#include "experiment/parts.hpp"
#include "report/findings.hpp"
#include "report/numbers.hpp"
#include "report/progress.hpp"

namespace {

using namespace sspql;
using namespace sspql::experiment;

struct MissionOptions {
    std::int64_t missions = 300;
    std::int64_t seed = 1;
    std::int64_t robots = 30;
    std::int64_t train_episodes = 150;
    std::int64_t threads = 0;
    std::int64_t replays = 20;
    std::int64_t curve_seeds = 40;
    std::string learner = "adaptive";
    std::string sensing = "sensors";
    std::string box;
    std::string goal;
    report::OutputFiles files;
    ShardOptions shards;
    double noise = 1.0;
    double box_mass = 2.0;
    double friction = 0.5;
};

/// "x,y" in metres.
std::optional<sim::Point> point_of(const char* option, const std::string& text) {
    if (text.empty()) return std::nullopt;
    const std::vector<std::string> parts = split(text, ',');
    double values[2] = {0.0, 0.0};
    bool good = parts.size() == 2;
    for (std::size_t i = 0; good && i < 2; ++i) {
        const char* end = parts[i].data() + parts[i].size();
        const auto result = std::from_chars(parts[i].data(), end, values[i]);
        good = result.ec == std::errc{} && result.ptr == end;
    }
    if (!good) throw std::invalid_argument(std::string(option) + " must be x,y in metres, got '" + text + "'");
    return sim::Point{values[0], values[1]};
}

std::vector<report::Setting> settings_of(const MissionOptions& options, const MissionPlan& plan) {
    std::vector<report::Setting> settings{{"learner", options.learner},
                                          {"sensing", options.sensing},
                                          {"seed", std::to_string(plan.seed), false},
                                          {"missions", std::to_string(plan.missions), false},
                                          {"robots", std::to_string(plan.robots), false},
                                          {"train_episodes", std::to_string(plan.approach_episodes), false},
                                          {"noise", report::exact_text(options.noise), false},
                                          {"box_mass", report::exact_text(options.box_mass), false},
                                          {"friction", report::exact_text(options.friction), false}};
    if (!options.box.empty()) settings.push_back({"box", options.box});
    if (!options.goal.empty()) settings.push_back({"goal", options.goal});
    return settings;
}

/// `drawn`: pictures may be wanted.
MissionPlan plan_of(const MissionOptions& options, bool drawn) {
    MissionPlan plan;
    plan.world = mission_world();
    plan.world.noise = options.noise;
    plan.world.box_mass_kg = options.box_mass;
    plan.world.box_ground_friction = options.friction;
    plan.world.validate();
    plan.sensors.noise = options.noise;
    plan.rules.sensing = options.sensing == "truth" ? sim::Sensing::truth : sim::Sensing::sensors;
    plan.seed = static_cast<std::uint64_t>(options.seed);
    plan.missions = static_cast<std::size_t>(options.missions);
    plan.robots = std::min(static_cast<std::size_t>(options.robots), plan.missions);
    plan.approach_episodes = static_cast<std::size_t>(options.train_episodes);
    if (drawn) {
        plan.replays = std::min(static_cast<std::size_t>(options.replays), plan.missions);
        plan.curve_seeds = static_cast<std::size_t>(options.curve_seeds);
    }
    plan.box = point_of("--box", options.box);
    plan.goal = point_of("--goal", options.goal);
    // Refuses places that no mission could succeed with, before anything is computed.
    Random random(plan.seed);
    static_cast<void>(sim::random_mission_start(plan.world, random, plan.box ? &*plan.box : nullptr,
                                                plan.goal ? &*plan.goal : nullptr));
    return plan;
}

/// False if --help or --version was all that was asked for.
bool parse(MissionOptions& options, int argc, char** argv) {
    Options parser(
        "pusher_mission",
        "A simulated robot searches a box, gets behind it, turns and pushes it to the goal. It learns the two "
        "middle parts without physics, then does missions with physics and sensors that err.");
    parser.whole("--missions", options.missions, 1, 1000000, "Missions with random places of robot, box and goal");
    parser.whole("--seed", options.seed, 1, 1000000000000, "Seed of everything");
    parser.text("--learner", options.learner, "Learner of 'approach' and 'turn' (default adaptive)");
    parser.whole("--robots", options.robots, 1, 1000000, "Robots, each trained by itself, that share the missions");
    parser.whole("--train-episodes", options.train_episodes, 0, 1000000, "Training episodes of 'approach' a robot");
    parser.number("--noise", options.noise, 0.0, 10.0, "Noise of actuators and sensors, as a multiple of the usual");
    parser.choice("--sensing", options.sensing, {"sensors", "truth"}, "What the robot goes by");
    parser.number("--box-mass", options.box_mass, 0.01, 100.0, "Mass of the box in kg");
    parser.number("--friction", options.friction, 0.0, 2.0, "Friction of the box with the floor");
    parser.text("--box", options.box, "Place of the box, x,y in metres, the arena's middle is 0,0 (default random)");
    parser.text("--goal", options.goal, "Place of the goal, likewise");
    parser.whole("--threads", options.threads, 0, 1024,
                 "Threads; 0 = as many as the machine has; results do not depend on it");
    parser.text("--json", options.files.json, "Write the results as JSON");
    parser.text("--html", options.files.html, "Write a report with replays to play, one self-contained file");
    parser.whole("--replay", options.replays, 0, 1000, "The first N missions are in the report");
    parser.whole("--curve-seeds", options.curve_seeds, 0, 100000, "Runs of the report's learning curves");
    parser.shards(options.shards);
    std::string names;
    for (const std::string& name : learner_names()) names += " " + name;
    parser.footer("Learners:" + names + "; dyna-q:20 and the like set k");
    return parser.parse(argc, argv);
}

struct Missions {
    MissionOptions options;
    std::vector<LearnerRecipe> recipes;  ///< one
    MissionPlan plan;
    Parts parts;

    /// \throws std::exception for anything wrong with the options, as prepare does.
    [[nodiscard]] bool read(int argc, char** argv) { return parse(options, argc, argv); }

    void prepare(const Ranks& ranks, int argc, char** argv) {
        recipes = learner_recipes(options.learner, {});
        if (recipes.size() != 1)
            throw std::invalid_argument("--learner must be one learner, got '" + options.learner + "'");
        // What is wrong with the plan comes before what is wrong with the files.
        static_cast<void>(plan_of(options, false));
        parts = parts_of("pusher_mission", options.shards, options.files, ranks, argc, argv);
        plan = plan_of(options, parts.drawn());
    }

    [[nodiscard]] report::MissionFindings blank(int argc, char** argv) const {
        report::MissionFindings findings{blank_missions(plan, recipes.front()), stage_of(plan)};
        findings.results.settings = settings_of(options, plan);
        findings.results.manifest = {command_line(argc, argv), SSPQL_VERSION, compiler_name()};
        return findings;
    }

    void run(const shards::Shard& shard, const Ranks& ranks, report::MissionFindings& findings) const {
        report::Progress progress("pusher_mission", work_of(plan, shard), "robots", ranks.progress_descriptor());
        run_missions(
            plan, recipes.front(), shard, ranks.threads(static_cast<std::size_t>(options.threads)),
            [&] { progress.advance(); }, findings.results);
    }
};

}  // namespace

int main(int argc, char** argv) {
    return sspql::experiment::run_on_ranks("pusher_mission", run_experiment<Missions>, argc, argv);
}
