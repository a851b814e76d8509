// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

#include <sspql/core/errors.hpp>
#include <sspql/env/environment.hpp>

namespace sspql {

/// An Environment that cuts another one's episodes after `max_steps` steps by setting `truncated` (also when the last
/// allowed step terminated: then both are set). The inner environment stays ignorant of time, so a cut never looks like
/// a failure to the learner. Holds the inner environment by value; `environment()` reaches it.
///
/// \throws std::invalid_argument if max_steps is 0.
template <class Environment>
class TimeLimit {
public:
    /// `environment`, whose episodes end after `max_steps` steps at the latest.
    TimeLimit(Environment environment, std::size_t max_steps)
        : environment_(std::move(environment)), max_steps_(max_steps) {
        if (max_steps == 0) throw_invalid("max_steps", "be at least 1", max_steps);
    }

    /// Starts an episode of the inner environment, at step 0.
    template <class E = Environment>
    auto reset(std::uint64_t seed) -> std::decay_t<decltype(std::declval<E&>().reset(seed))> {
        steps_ = 0;
        return environment_.reset(seed);
    }

    /// A step of the inner environment, `truncated` at the limit. What throws is no step.
    template <class Command, class E = Environment>
    auto step(const Command& command) -> std::decay_t<decltype(std::declval<E&>().step(command))> {
        auto result = environment_.step(command);
        ++steps_;
        if (steps_ >= max_steps_) result.truncated = true;
        return result;
    }

    /// Steps made in this episode.
    [[nodiscard]] std::size_t steps() const noexcept { return steps_; }
    /// The number of steps after which an episode is cut.
    [[nodiscard]] std::size_t max_steps() const noexcept { return max_steps_; }
    /// The inner environment.
    [[nodiscard]] Environment& environment() noexcept { return environment_; }
    /// The same for reading.
    [[nodiscard]] const Environment& environment() const noexcept { return environment_; }

private:
    Environment environment_;
    std::size_t max_steps_;
    std::size_t steps_ = 0;
};

template <class Environment>
TimeLimit(Environment, std::size_t) -> TimeLimit<Environment>;

}  // namespace sspql
