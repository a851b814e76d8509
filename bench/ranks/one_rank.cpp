// SPDX-License-Identifier: MIT
#include "ranks/ranks.hpp"

namespace sspql::experiment {

Ranks::Ranks() = default;

Ranks::~Ranks() = default;

void Ranks::together(const std::function<void()>& task) const { task(); }

void Ranks::gather(std::string own, const std::function<void(std::size_t, const std::string&)>& take) const {
    take(rank_, own);
}

}  // namespace sspql::experiment
