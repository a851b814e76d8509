// SPDX-License-Identifier: MIT
#pragma once

#include <string>

/// \file
/// Report files that are either written whole or not at all.

namespace sspql::report {

/// Checks that `write_file(path, ...)` can be expected to work: call it before a run of minutes. It creates and removes
/// a file in the target's directory; it neither leaves a file behind nor touches an existing one.
///
/// \throws std::runtime_error "cannot write PATH: REASON".
void require_writable(const std::string& path);

/// Makes `text` the content of `path`, whole or not at all: see AtomicFile.
///
/// \throws std::runtime_error "cannot write PATH: REASON"; the old content is then untouched and no new file is left.
void write_file(const std::string& path, const std::string& text);

}  // namespace sspql::report
