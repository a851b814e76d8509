// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <exception>
#include <fstream>
#include <istream>
#include <stdexcept>
#include <streambuf>
#include <string>
#include <string_view>
#include <utility>

#include <sspql/core/errors.hpp>

namespace sspql {

/// Throws std::runtime_error("NAME:LINE:COLUMN: MESSAGE"), which editors and terminals turn into a link.
[[noreturn]] inline void throw_at(const std::string& name, std::size_t line, std::size_t column,
                                  const std::string& message) {
    throw std::runtime_error(name + ":" + std::to_string(line) + ":" + std::to_string(column) + ": " + message);
}

/// Reads text line by line and says where something is wrong. Lines and columns count from 1, columns in bytes.
///
///     LineReader lines(stream, "maze.txt");
///     while (lines.next()) use(lines.line());
///
/// Lines end with LF or CRLF, which are not part of them; the last one needs no end. A UTF-8 byte order mark before the
/// first line is skipped. What is no text never fills the memory: a line of more than `max_line` bytes is refused when
/// that byte arrives, and so is a NUL byte. The stream must outlive the reader, and nobody else may read it meanwhile.
///
/// \throws std::runtime_error "NAME:LINE:COLUMN: ..." for a line too long, a NUL byte or a stream that cannot be read;
/// std::invalid_argument if max_line is 0.
class LineReader {
public:
    /// The longest line that is read unless told otherwise, in bytes: 1 MiB.
    static constexpr std::size_t default_max_line = std::size_t{1} << 20;

    /// Reads from `in`; `name` is what errors call it. See above for what is thrown when.
    LineReader(std::istream& in, std::string name, std::size_t max_line = default_max_line)
        : in_(&in), name_(std::move(name)), max_line_(max_line) {
        if (max_line == 0) throw_invalid("max_line", "be at least 1", max_line);
    }

    /// Goes to the next line. False at the end of the input; `number()` then stays that of the last line.
    [[nodiscard]] bool next() {
        line_.clear();
        int c = read();
        if (c == end_of_input) return false;
        ++number_;
        for (; c != end_of_input && c != '\n'; c = read()) {
            if (c == '\0') fail(line_.size() + 1, "NUL byte in what should be text");
            // One byte more may be the CR of a CRLF.
            if (line_.size() > max_line_ || (line_.size() == max_line_ && c != '\r')) fail_too_long();
            line_.push_back(static_cast<char>(c));
        }
        ended_ = c == '\n';
        if (ended_ && !line_.empty() && line_.back() == '\r') line_.pop_back();
        if (line_.size() > max_line_) fail_too_long();
        if (number_ == 1 && line_.compare(0, 3, "\xEF\xBB\xBF") == 0) line_.erase(0, 3);
        return true;
    }

    /// The current line without its end. Valid until next().
    [[nodiscard]] std::string_view line() const noexcept { return line_; }

    /// The current line's number; 0 before the first next(), and for an empty input.
    [[nodiscard]] std::size_t number() const noexcept { return number_; }

    /// Whether the current line has an end. The input's last line may have none, as where it was cut off.
    [[nodiscard]] bool ended() const noexcept { return ended_; }

    /// What errors call the input.
    [[nodiscard]] const std::string& name() const noexcept { return name_; }

    /// Throws std::runtime_error("NAME:LINE:COLUMN: MESSAGE") for the current line (line 1 if there is none).
    [[noreturn]] void fail(std::size_t column, const std::string& message) const {
        throw_at(name_, number_ == 0 ? 1 : number_, column, message);
    }

private:
    static constexpr int end_of_input = -1;

    [[noreturn]] void fail_too_long() const {
        fail(max_line_ + 1, "line is longer than " + std::to_string(max_line_) + " bytes");
    }

    /// The next byte, 0 to 255, or end_of_input. The stream's buffer is asked itself: one virtual call per block.
    int read() {
        using Traits = std::istream::traits_type;
        std::streambuf* buffer = in_->rdbuf();
        if (buffer == nullptr || in_->bad()) fail_to_read();
        try {
            const Traits::int_type c = buffer->sbumpc();
            return Traits::eq_int_type(c, Traits::eof()) ? end_of_input : static_cast<unsigned char>(c);
        } catch (const std::exception&) {  // a directory, a disk that fails
            fail_to_read();
        }
    }

    [[noreturn]] void fail_to_read() const { throw std::runtime_error(name_ + ": cannot be read"); }

    std::istream* in_;
    std::string name_;
    std::string line_;
    std::size_t max_line_;
    std::size_t number_ = 0;
    bool ended_ = false;
};

/// The file, opened for reading. \throws std::runtime_error "PATH: cannot be opened".
[[nodiscard]] inline std::ifstream open_text(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file.is_open()) throw std::runtime_error(path + ": cannot be opened");
    return file;
}

namespace detail {

/// A byte as it can be printed in a message: 'x', or '\xHH' for what is not printable ASCII.
inline std::string quoted(char c) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && byte < 0x7F) return std::string("'") + c + "'";
    const char* digits = "0123456789ABCDEF";
    return std::string("'\\x") + digits[byte >> 4] + digits[byte & 15] + "'";
}

/// A field as it can be printed in a message: quoted, cut after 40 bytes, unprintable bytes as '?'.
inline std::string quoted(std::string_view text) {
    std::string out = "'";
    for (const char c : text.substr(0, 40)) out += c >= 0x20 && c < 0x7F ? c : '?';
    return out + (text.size() > 40 ? "...'" : "'");
}

}  // namespace detail

}  // namespace sspql
