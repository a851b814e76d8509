// SPDX-License-Identifier: MIT
//
// Watch a robot learn: a window on a run of pusher_experiment, with keys for pause, speed and learner.
// pusher_viewer --help

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <SFML/System/Clock.hpp>

#include <sspql/sim/pusher_params.hpp>

#include "experiment/learner_catalog.hpp"
#include "experiment/live_session.hpp"
#include "experiment/options.hpp"
#include "report/numbers.hpp"
#include "report/output_file.hpp"
#include "viewer/display.hpp"
#include "viewer/viewer_window.hpp"

namespace {

using namespace sspql;
using namespace sspql::experiment;

struct ViewerOptions {
    std::string backend = "box2d";
    std::string task = "approach";
    std::string starts = "two";
    double noise = 1.0;
    std::string learner;
    std::string learners = "adaptive,sspql-bonus,sspql,ssp,q,q-bonus,ps-bonus,dyna-q-bonus:20,rmax";
    std::int64_t seed = 1;
    std::string speed = "10";
    std::int64_t episodes = 500;
    std::int64_t steps_per_episode = 2000;
    std::int64_t skip = 0;
    std::int64_t frames = 0;
    std::string screenshot;
    std::string font;
};

bool parse(ViewerOptions& options, int argc, char** argv) {
    Options parser("pusher_viewer",
                   "Watch a simulated robot learn to approach (or to turn towards) a box, with keys for "
                   "pause, speed and learner (h shows them).");
    parser.choice("--backend", options.backend, {"kinematic", "box2d"}, "The world: plain geometry, or physics");
    parser.choice("--task", options.task, {"approach", "turn"}, "Get behind the box, or face it once there");
    parser.number("--noise", options.noise, 0.0, 10.0, "Actuator noise, as a multiple of the study's");
    parser.choice("--starts", options.starts, {"one", "two"}, "Starting places of 'approach'");
    parser.text("--learner", options.learner, "The learner that begins (default: the first of --learners)");
    parser.text("--learners", options.learners,
                "Those to choose from with l and 1 to 9 (default " + options.learners + ")");
    parser.whole("--seed", options.seed, 0, 1000000000, "The run: as seed N of pusher_experiment");
    parser.choice("--speed", options.speed, Pace::names(), "Actions a second at first");
    parser.whole("--episodes", options.episodes, 1, 1000000, "The run is over after N episodes");
    parser.whole("--steps-per-episode", options.steps_per_episode, 1, 1000000000, "An episode is cut after N steps");
    parser.whole("--skip", options.skip, 0, 1000000, "Learn N episodes before the window opens");
    parser.whole("--frames", options.frames, 0, 1000000000,
                 "Close after N frames, each a sixtieth of a second of the run however long it takes; 0 = stay open");
    parser.text("--screenshot", options.screenshot, "Write the last frame as a PNG");
    parser.text("--font", options.font, "A TrueType font (default: DejaVu Sans of the system)");
    std::string names;
    for (const std::string& name : learner_names()) names += " " + name;
    parser.footer("Learners:" + names + "; dyna-q:20 and the like set k");
    return parser.parse(argc, argv);
}

LiveRun run_of(const ViewerOptions& options) {
    std::vector<std::string> names = split(options.learners, ',');
    if (!options.learner.empty() && std::find(names.begin(), names.end(), options.learner) == names.end()) {
        names.insert(names.begin(), options.learner);
    }
    std::string list;
    for (const std::string& name : names) list += (list.empty() ? "" : ",") + name;

    sim::PusherParams params;
    params.noise = options.noise;
    params.starts = options.starts == "one" ? sim::Starts::one : sim::Starts::two;
    LiveRun run(
        make_live_world(options.backend, options.task, params, static_cast<std::size_t>(options.steps_per_episode)),
        learner_recipes(list, {}), static_cast<std::uint64_t>(options.seed));
    if (!options.learner.empty()) {
        const auto place = std::find(names.begin(), names.end(), options.learner);
        run.choose_learner(static_cast<std::size_t>(place - names.begin()));
    }
    run.stop_after(static_cast<std::size_t>(options.episodes));
    return run;
}

/// Shows the session until somebody quits it, or the frames are over.
void show(LiveSession& session, viewer::ViewerWindow& window, std::int64_t frames, const std::string& screenshot) {
    constexpr int frames_per_second = 60;
    constexpr float computing_s = 0.010F;          // of a frame, unless its length is imagined
    constexpr int imagined_actions = 500;          // "as fast as it can" then
    constexpr std::int64_t frames_per_title = 12;  // window managers are slow to change titles
    const bool is_imagined = frames > 0;
    window.limit_frames(is_imagined ? 0 : frames_per_second);
    sf::Clock clock;
    for (std::int64_t frame = 0; !session.is_quitting() && (!is_imagined || frame < frames); ++frame) {
        const double seconds = is_imagined ? 1.0 / frames_per_second : static_cast<double>(clock.restart().asSeconds());
        const bool was_paused = session.is_paused();
        window.handle_events(session);
        int left = imagined_actions;
        const sf::Clock computing;
        session.pass(seconds,
                     [&] { return is_imagined ? --left > 0 : computing.getElapsedTime().asSeconds() < computing_s; });
        if (frame % frames_per_title == 0 || was_paused || session.is_paused()) {
            window.set_title("pusher_viewer: " + session.status() + (session.is_paused() ? ", paused" : ""));
        }
        window.draw(session);
        const bool is_last = session.is_quitting() || (is_imagined && frame + 1 == frames);
        if (is_last && !screenshot.empty()) window.write_png(screenshot);
        window.show();
    }
}

int body(int argc, char** argv) {
    ViewerOptions options;
    if (!parse(options, argc, argv)) return 0;
    LiveRun run = run_of(options);
    const std::string& png = options.screenshot;
    if (!png.empty()) {
        if (png.size() < 5 || png.substr(png.size() - 4) != ".png") {
            throw std::invalid_argument("--screenshot must end in .png, got '" + png + "'");
        }
        report::require_writable(png);
    }
    const std::string font = viewer::font_file(options.font);
    const viewer::DisplayConnection display;
    while (run.episodes().size() < static_cast<std::size_t>(options.skip) && !run.is_over()) run.tick();

    LiveSession session(std::move(run), Pace(options.speed));
    viewer::ViewerWindow window(
        font, {options.task + ", " + options.backend + ", noise " + report::short_text(options.noise, 3)});
    show(session, window, options.frames, png);
    std::cout << session.status() << std::endl;
    return std::cout.good() ? 0 : 2;
}

}  // namespace

int main(int argc, char** argv) { return sspql::experiment::run_program("pusher_viewer", body, argc, argv); }
