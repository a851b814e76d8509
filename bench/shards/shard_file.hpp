// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "shards/fields.hpp"
#include "shards/shard.hpp"

/// \file
/// What a shard is written to: one JSON document of two lines and a brace. The first line says what the file is, and
/// the length and checksum of the second, which holds all else, so that a file that was cut or changed is noticed.
///
///     {"format":"sspql shard","format_version":1,"bytes":1234,"crc32":"00c0ffee","content":
///     {"run":{...},"shard":2,"command":"...","compiler":"...","part":{...}}
///     }

namespace sspql::shards {

inline constexpr int format_version = 1;

struct ShardContent {
    Json run;  ///< the same in all shards of a run: program, version, number of shards, and the findings' head
    Shard shard;
    std::string command;  ///< that repeats the whole run in one process
    std::string compiler;
    Json part;  ///< what this shard measured

    [[nodiscard]] std::string program() const;
};

[[nodiscard]] std::string shard_text(ShardContent content);

/// Reads what shard_text wrote. \throws std::runtime_error "NAME: ..." for text that is no shard, is damaged, or of
/// another version of the format.
[[nodiscard]] ShardContent parse_shard_text(const std::string& text, const std::string& name);

/// The same from a file. \throws std::runtime_error also "PATH: cannot be opened".
[[nodiscard]] ShardContent load_shard(const std::string& path);

}  // namespace sspql::shards
