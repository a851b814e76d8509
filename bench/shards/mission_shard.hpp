// SPDX-License-Identifier: MIT
#pragma once

#include "report/findings.hpp"
#include "shards/fields.hpp"
#include "shards/shard.hpp"

/// \file
/// What shards of pusher_mission hold: see experiment_shard.hpp. A shard has some of the robots with all their
/// missions, and some of the curves' seeds.

namespace sspql::shards {

[[nodiscard]] Json head_of(const report::MissionFindings& findings);
void set_head(const Json& head, report::MissionFindings& findings);
[[nodiscard]] Json part_of(const report::MissionFindings& findings, const Shard& shard);
void add_part(const Json& part, const Shard& shard, report::MissionFindings& findings);

}  // namespace sspql::shards
