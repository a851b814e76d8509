// SPDX-License-Identifier: MIT
//
// A robot searches a box, gets behind it, faces it and pushes it to the goal: section 4 of Kwon, Suh and Lee (2011),
// the whole task, in a simulated world with sensors that err: pusher_mission --help

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <sspql/core/version.hpp>
#include <sspql/sim/mission/mission_start.hpp>

#include "experiment/learner_catalog.hpp"
#include "experiment/mission_run.hpp"
#include "experiment/options.hpp"
#include "report/mission_page.hpp"
#include "report/mission_results.hpp"
#include "report/numbers.hpp"
#include "report/output_file.hpp"
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
    std::string json;
    std::string html;
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

MissionPlan plan_of(const MissionOptions& options) {
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
    if (!options.html.empty()) {
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

int body(int argc, char** argv) {
    MissionOptions options;
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
    parser.text("--json", options.json, "Write the results as JSON");
    parser.text("--html", options.html, "Write a report with replays to play, one self-contained file");
    parser.whole("--replay", options.replays, 0, 1000, "The first N missions are in the report");
    parser.whole("--curve-seeds", options.curve_seeds, 0, 100000, "Runs of the report's learning curves");
    std::string names;
    for (const std::string& name : learner_names()) names += " " + name;
    parser.footer("Learners:" + names + "; dyna-q:20 and the like set k");
    if (!parser.parse(argc, argv)) return 0;

    const std::vector<LearnerRecipe> recipes = learner_recipes(options.learner, {});
    if (recipes.size() != 1)
        throw std::invalid_argument("--learner must be one learner, got '" + options.learner + "'");
    const MissionPlan plan = plan_of(options);
    for (const std::string* path : {&options.json, &options.html}) {
        if (!path->empty()) report::require_writable(*path);
    }

    report::MissionResults results;
    {
        report::Progress progress("pusher_mission", work_of(plan), "robots");
        results =
            run_missions(plan, recipes.front(), static_cast<std::size_t>(options.threads), [&] { progress.advance(); });
    }
    results.settings = settings_of(options, plan);
    results.manifest = {command_line(argc, argv), SSPQL_VERSION, compiler_name()};

    std::cout << report::mission_text(results) << std::flush;
    if (!options.json.empty()) report::write_file(options.json, report::mission_json(results));
    if (!options.html.empty()) report::write_file(options.html, report::mission_page(results, stage_of(plan)));
    return std::cout.good() ? 0 : 2;
}

}  // namespace

int main(int argc, char** argv) { return sspql::experiment::run_program("pusher_mission", body, argc, argv); }
