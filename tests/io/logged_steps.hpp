// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

#include <sspql/core/ids.hpp>
#include <sspql/learn/transition.hpp>

/// \file
/// What tests of step logs write and expect.

namespace sspql::testing {

/// The first line of a log without weights.
inline const std::string header = "episode,step,state,action,reward,next,terminated,truncated\n";

inline Transition step(std::size_t s, std::size_t a, double reward, std::size_t next, bool terminated = false) {
    return {state_id(s), action_id(a), reward, state_id(next), terminated};
}

}  // namespace sspql::testing
