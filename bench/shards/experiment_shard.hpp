// SPDX-License-Identifier: MIT
#pragma once

#include "report/findings.hpp"
#include "shards/fields.hpp"
#include "shards/shard.hpp"

/// \file
/// What shards of pusher_experiment and grid_experiment hold. Of every program's findings, in overloads:
///
/// - head_of: what all shards of a run have in common: settings, names, sizes. Shards whose heads differ are of
///   different runs.
/// - set_head: empty findings of that head, ready for parts.
/// - part_of: what one shard measured.
/// - add_part: puts that into the findings. \throws FieldError for a part that does not fit the head.
///
/// The manifest is neither. Measured times are carried as they are, like all numbers.

namespace sspql::shards {

[[nodiscard]] Json head_of(const report::PusherFindings& findings);
void set_head(const Json& head, report::PusherFindings& findings);
[[nodiscard]] Json part_of(const report::PusherFindings& findings, const Shard& shard);
void add_part(const Json& part, const Shard& shard, report::PusherFindings& findings);

[[nodiscard]] Json head_of(const report::GridFindings& findings);
void set_head(const Json& head, report::GridFindings& findings);
[[nodiscard]] Json part_of(const report::GridFindings& findings, const Shard& shard);
void add_part(const Json& part, const Shard& shard, report::GridFindings& findings);

}  // namespace sspql::shards
