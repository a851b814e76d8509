// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <sspql/core/version.hpp>

#include "shards/experiment_shard.hpp"
#include "shards/mission_shard.hpp"
#include "shards/shard_file.hpp"

/// \file
/// From findings to shards and back. `Findings` is one of report/findings.hpp.

namespace sspql::shards {

/// Keeps account of the shards of one run.
class ShardSet {
public:
    /// Takes a shard's name down. \throws std::runtime_error "NAME: ..." if it is of another run than the first, or was
    /// there before.
    void add(const ShardContent& content, const std::string& name);

    /// \throws std::runtime_error naming the shards that are missing.
    void require_complete() const;

    /// Which compilers the shards' programs were made with.
    [[nodiscard]] std::string compilers() const;

private:
    Json run_;  // the first shard's, as is the next
    std::string first_name_;
    std::vector<std::string> names_;  // by shard; empty: not there yet
    std::vector<std::string> compilers_;
};

/// A shard of a run. `command` repeats the whole run.
template <class Findings>
[[nodiscard]] ShardContent content_of(const std::string& program, const Findings& findings, const Shard& shard,
                                      const std::string& command) {
    Json run = {{"program", program}, {"version", SSPQL_VERSION}, {"shards", shard.count}};
    run.update(head_of(findings));
    return {std::move(run), shard, command, findings.results.manifest.compiler, part_of(findings, shard)};
}

/// Puts shards together, in any order: the findings of one process, digit for digit. Memory: the findings, and one
/// shard at a time.
template <class Findings>
class Merge {
public:
    /// \throws std::runtime_error "NAME: ..." as ShardSet does, and for a part that does not fit.
    void add(const ShardContent& content, const std::string& name) {
        const bool first = empty_;
        empty_ = false;
        set_.add(content, name);
        try {
            if (first) {
                set_head(content.run, findings_);
                command_ = content.command;
            }
            add_part(content.part, content.shard, findings_);
        } catch (const FieldError& error) {
            throw std::runtime_error(name + ": damaged shard file: " + error.what());
        }
    }

    /// The whole. \throws std::runtime_error if shards are missing.
    [[nodiscard]] Findings take() {
        set_.require_complete();
        findings_.results.manifest = {command_, SSPQL_VERSION, set_.compilers()};
        return std::move(findings_);
    }

private:
    ShardSet set_;
    Findings findings_;
    std::string command_;  // the first shard's
    bool empty_ = true;
};

}  // namespace sspql::shards
