// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <utility>

#include <sspql/core/errors.hpp>
#include <sspql/io/checkpoint.hpp>
#include <sspql/run/episode.hpp>

namespace sspql {

/// Saves the agent after every so many episodes of a run:
///
///     run_episodes(environment, agent, 1000, seed, sspql::CheckpointEvery(10, "robot.sspql"));
///
/// A run that is killed loses 9 episodes at most. Errors: save()'s end the run; the agent stays as it is.
class CheckpointEvery {
public:
    /// Saves to `path`, for the first time after so many episodes. \throws std::invalid_argument for 0 episodes.
    CheckpointEvery(std::size_t episodes, std::string path) : episodes_(episodes), path_(std::move(path)) {
        if (episodes_ == 0) throw_invalid("episodes between checkpoints", "be at least 1", episodes_);
    }

    /// For run_episodes to call after each episode.
    template <class Agent>
    void operator()(const EpisodeResult& /*result*/, const Agent& agent) {
        if (++since_ < episodes_) return;
        save(agent, path_);
        since_ = 0;
    }

private:
    std::size_t episodes_;
    std::string path_;
    std::size_t since_ = 0;  // episodes since the last checkpoint
};

}  // namespace sspql
