// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <sspql/sim/pose.hpp>

#include "experiment/live_run.hpp"

namespace sspql::experiment {

/// What the keys do.
enum class LiveKey { pause, faster, slower, single_step, next_learner, learner, restart, help, quit };

struct LiveCommand {
    LiveKey key = LiveKey::pause;
    std::size_t number = 0;  ///< of the learner, from 0
};

/// The command of a typed character, either case; none for one that means nothing.
[[nodiscard]] std::optional<LiveCommand> command_of(char32_t character) noexcept;

/// How fast a run goes: some actions a second, or as many as can be done.
class Pace {
public:
    /// The names of all paces, the slowest first: "1", "2", "5", ... "1000", "max".
    [[nodiscard]] static std::vector<std::string> names();

    /// \throws std::invalid_argument for a name that is none.
    explicit Pace(const std::string& name = "10");

    [[nodiscard]] bool is_unlimited() const noexcept;
    [[nodiscard]] double per_second() const noexcept;  ///< unless unlimited
    [[nodiscard]] std::string text() const;            ///< "10 actions/s"

    void faster() noexcept;
    void slower() noexcept;

    /// How many actions are due after this much more time; what is left over counts towards the next.
    [[nodiscard]] std::size_t due(double seconds) noexcept;

    /// How much of the time until the next action has gone by, 0 to 1.
    [[nodiscard]] double phase() const noexcept { return carry_; }

    /// The next action is a whole interval away.
    void begin_interval() noexcept { carry_ = 0.0; }

private:
    std::size_t level_ = 0;
    double carry_ = 0.0;
};

/// A run that was left for another: what is worth comparing.
struct PastRun {
    std::size_t learner = 0;
    std::vector<LiveEpisode> episodes;
};

/// A watched run and what its watcher asked for: everything but the window. One object per thread; no clock of its own.
class LiveSession {
public:
    LiveSession(LiveRun run, Pace pace) : run_(std::move(run)), pace_(pace) {}

    /// Does what a key says. A number without a learner does nothing.
    void handle(const LiveCommand& command);

    /// Lets `seconds` pass (of more than a quarter of a second no more than that counts, as after the window was held).
    /// `go_on` is asked after each action whether there is time for another; what was due then is dropped. When
    /// unlimited it alone ends the frame, once the run is not over.
    void pass(double seconds, const std::function<bool()>& go_on);

    [[nodiscard]] const LiveRun& run() const noexcept { return run_; }
    [[nodiscard]] const Pace& pace() const noexcept { return pace_; }
    [[nodiscard]] bool is_paused() const noexcept { return paused_; }
    [[nodiscard]] bool is_help_shown() const noexcept { return help_; }
    [[nodiscard]] bool is_quitting() const noexcept { return quitting_; }

    /// The last run of each other learner with this seed, as far as it had an episode behind it; the latest is last.
    [[nodiscard]] const std::vector<PastRun>& past() const noexcept { return past_; }

    /// Whether an eye can follow each action: paused, or slow.
    [[nodiscard]] bool is_followable() const noexcept;

    /// Where the robot is seen: at slow paces on its way between the last two poses, else where it is.
    [[nodiscard]] sim::Pose shown_robot() const;

    /// The decision that belongs to that: the one carried out while it is on its way, else the next one; at an
    /// episode's end the last one.
    [[nodiscard]] const Decision& shown_decision() const;

    /// Whether shown_decision() is being carried out or has been, rather than to come.
    [[nodiscard]] bool is_under_way() const;

    /// "adaptive, seed 1, episode 3, step 12, 240 in all": for the title and for scripts; ", paused" may follow.
    [[nodiscard]] std::string status() const;

private:
    void switch_to(std::size_t learner);

    LiveRun run_;
    Pace pace_;
    std::vector<PastRun> past_;
    bool paused_ = false;
    bool help_ = false;
    bool quitting_ = false;
};

}  // namespace sspql::experiment
