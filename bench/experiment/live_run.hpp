// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <sspql/core/ids.hpp>
#include <sspql/learn/transition.hpp>
#include <sspql/sim/backend.hpp>
#include <sspql/sim/pose.hpp>

#include "experiment/any_learner.hpp"
#include "experiment/learner_catalog.hpp"
#include "experiment/live_world.hpp"

namespace sspql::experiment {

/// What the learner chose in a state, and what each action was worth to it then.
struct Decision {
    StateId state{};
    ActionId action{};
    std::vector<ActionTerms> terms;  ///< by action
};

/// An episode that is over.
struct LiveEpisode {
    std::size_t steps = 0;
    bool success = false;  ///< else it was cut
};

/// What the learner thinks of a state.
struct StateView {
    bool tried = false;  ///< any of its actions
    double value = 0.0;  ///< the most an action tried there is worth, exploration bonus aside
    ActionId best{};     ///< what it would do if it had to learn nothing
};

/// A run that somebody watches: a learner in a world, one action at a time. The learner can be exchanged and the run
/// begun anew at any moment.
///
/// Seed s, learner for learner, is the run that pusher_experiment makes of seed s: the same steps in each episode,
/// however it is watched. No clock, no window; one object per thread.
class LiveRun {
public:
    /// Begins the first episode of the first learner.
    /// \throws std::invalid_argument without learners, for parameters out of range, or a start that is impossible.
    LiveRun(std::unique_ptr<LiveWorld> world, std::vector<LearnerRecipe> recipes, std::uint64_t seed);

    /// One action; or, where the episode is over, the next episode's beginning. Nothing once the run is over.
    void tick();

    /// The run is over after so many episodes; 0: never. Holds for the runs to come too.
    void stop_after(std::size_t episodes) noexcept { episode_limit_ = episodes; }
    [[nodiscard]] bool is_over() const noexcept {
        return episode_limit_ > 0 && episode_over_ && episodes_.size() >= episode_limit_;
    }

    /// Forgets all and begins anew with this learner. \throws std::invalid_argument for a number not below learners().
    void choose_learner(std::size_t learner);

    /// Forgets all and begins anew with this seed.
    void restart(std::uint64_t seed);

    [[nodiscard]] const std::vector<LearnerRecipe>& recipes() const noexcept { return recipes_; }
    [[nodiscard]] std::size_t learner() const noexcept { return learner_index_; }
    [[nodiscard]] const std::string& learner_name() const noexcept { return recipes_[learner_index_].name(); }
    [[nodiscard]] std::uint64_t seed() const noexcept { return seed_; }
    [[nodiscard]] const LiveWorld& world() const noexcept { return *world_; }

    /// The running episode, from 1; its steps so far; all steps of the run.
    [[nodiscard]] std::size_t episode() const noexcept { return episodes_.size() + (episode_over_ ? 0 : 1); }
    [[nodiscard]] std::size_t episode_steps() const noexcept { return trail_.size() - 1; }
    [[nodiscard]] std::size_t total_steps() const noexcept { return total_steps_; }
    [[nodiscard]] bool is_episode_over() const noexcept { return episode_over_; }
    [[nodiscard]] const std::vector<LiveEpisode>& episodes() const noexcept { return episodes_; }

    [[nodiscard]] const sim::PusherObservation& observation() const noexcept { return observation_; }

    /// The robot's poses in the running episode, from its start on, and in the one before (empty in the first).
    [[nodiscard]] const std::vector<sim::Pose>& trail() const noexcept { return trail_; }
    [[nodiscard]] const std::vector<sim::Pose>& last_trail() const noexcept { return last_trail_; }

    /// What is done next, none if the episode is over, and what was done last in this episode.
    [[nodiscard]] const std::optional<Decision>& next() const noexcept { return next_; }
    [[nodiscard]] const std::optional<Decision>& last() const noexcept { return last_; }
    [[nodiscard]] sim::Move last_move() const { return world_->last_move(); }

    /// O(actions). \throws std::invalid_argument for an id outside.
    [[nodiscard]] StateView view(StateId s) const;

private:
    void begin_run();
    void begin_episode();
    void act();
    void decide(ActionId action);

    std::unique_ptr<LiveWorld> world_;
    std::vector<LearnerRecipe> recipes_;
    std::size_t learner_index_ = 0;
    std::uint64_t seed_;
    std::size_t episode_limit_ = 0;

    std::unique_ptr<AnyLearner> learner_;
    sim::PusherObservation observation_{};
    std::vector<LiveEpisode> episodes_;
    std::vector<sim::Pose> trail_;
    std::vector<sim::Pose> last_trail_;
    std::optional<Decision> next_;
    std::optional<Decision> last_;
    std::size_t total_steps_ = 0;
    bool episode_over_ = false;
};

}  // namespace sspql::experiment
