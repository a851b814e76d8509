// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

/// \file
/// What all duels are fought over.

namespace sspql::duels {

inline constexpr std::uint32_t tries = 10;  // of every (s,a), from which models are learnt
inline constexpr std::uint64_t seed = 1;

inline constexpr double alpha = 0.8;
inline constexpr double discount = 0.95;
inline constexpr double noise = 0.01;  // of the selectors

}  // namespace sspql::duels
