// SPDX-License-Identifier: MIT
#pragma once

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>

#include <sspql/core/line_reader.hpp>
#include <sspql/io/posix_file.hpp>
#include <sspql/io/step_log_line.hpp>

namespace sspql::detail {

/// Where an existing step log can be continued.
struct StepLogTail {
    std::uint64_t size = 0;          ///< of its whole lines; 0: not even the header is whole
    std::uint64_t next_episode = 0;  ///< after the last one in it
};

/// The bytes [from, to) of a file, fewer where it ends earlier.
inline std::string read_bytes(int descriptor, const std::string& path, std::uint64_t from, std::uint64_t to) {
    std::string bytes(static_cast<std::size_t>(to - from), '\0');
    std::size_t size = 0;
    while (size < bytes.size()) {
        const ssize_t n =
            ::pread(descriptor, bytes.data() + size, bytes.size() - size, static_cast<off_t>(from + size));
        if (n == 0) break;
        if (n > 0) {
            size += static_cast<std::size_t>(n);
        } else if (errno != EINTR) {
            throw std::runtime_error(path + ": cannot be read: " + std::generic_category().message(errno));
        }
    }
    bytes.resize(size);
    return bytes;
}

/// The episode after that of a log's last line.
inline std::uint64_t episode_after(const std::string& line, bool weights, const std::string& path) {
    std::istringstream in(line);
    LineReader lines(in, path + " (last line)", step_log_max_line);
    static_cast<void>(lines.next());
    const std::uint64_t episode = StepLogLine(weights).parse(lines).episode;
    if (episode == step_log_max_episode) lines.fail(1, "no log has an episode after " + std::to_string(episode));
    return episode + 1;
}

/// Looks at the first and the last whole line of a step log. Reads a few hundred bytes, and what has no line end.
/// \throws std::runtime_error "PATH:1:1: ..." if it begins with another header than a log with or without `weights`;
/// "PATH (last line):1:COLUMN: ..." if the last whole line is none of a step log.
inline StepLogTail read_step_log_tail(int descriptor, const std::string& path, bool weights) {
    const std::string_view header = weights ? weighted_step_log_header : step_log_header;
    const std::string first = read_bytes(descriptor, path, 0, weighted_step_log_header.size() + 2);
    const std::size_t line_end = first.find('\n');
    if (line_end == std::string::npos && begins_step_log(first)) return {};
    std::string_view line = std::string_view(first).substr(0, line_end);
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    if (line_end == std::string::npos || line != header) {
        throw_at(path, 1, 1, "header must be " + std::string(header) + " to continue this log, got " + quoted(line));
    }
    const std::uint64_t header_size = line_end + 1;

    // Backwards to the last line end but one: between the two is the last whole line.
    constexpr std::uint64_t block_size = 4096;
    const off_t file_size = ::lseek(descriptor, 0, SEEK_END);
    if (file_size < 0) throw_cannot_write(path, errno);
    std::uint64_t end = 0;  // behind the last line end
    std::uint64_t to = static_cast<std::uint64_t>(file_size);
    std::string text;  // of [to, end)
    for (;;) {
        const std::uint64_t from = to - std::min(to, block_size);
        const std::string block = read_bytes(descriptor, path, from, to);
        if (block.size() != to - from) throw_cannot_write(path, EIO);  // it shrank meanwhile
        if (end == 0) {
            const std::size_t last = block.rfind('\n');
            if (last != std::string::npos) end = from + last + 1;
            if (last != std::string::npos) text = block.substr(0, last + 1);
        } else {
            text.insert(0, block);
        }
        to = from;
        if (end == 0 && to > 0) continue;  // the header has one, at the latest
        if (end == header_size) return {end, 0};
        const std::size_t begin = text.size() < 2 ? std::string::npos : text.rfind('\n', text.size() - 2);
        if (begin == std::string::npos && text.size() <= step_log_max_line && to > 0) continue;
        return {end, episode_after(begin == std::string::npos ? text : text.substr(begin + 1), weights, path)};
    }
}

}  // namespace sspql::detail
