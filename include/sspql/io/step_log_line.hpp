// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <system_error>

#include <sspql/core/ids.hpp>
#include <sspql/core/line_reader.hpp>
#include <sspql/learn/transition.hpp>
#include <sspql/model/transition_counts.hpp>

namespace sspql {

/// One line of a step log.
struct LoggedStep {
    Transition transition;      ///< what happened
    bool truncated = false;     ///< the episode was cut short here
    std::uint64_t episode = 0;  ///< ascending, not always by one
    std::uint64_t step = 0;     ///< within the episode, from 0
};

namespace detail {

inline constexpr std::string_view step_log_header = "episode,step,state,action,reward,next,terminated,truncated";
inline constexpr std::string_view weighted_step_log_header =
    "episode,step,state,action,reward,next,terminated,truncated,weight";

/// Whether a header begins so, CRLF included: what is left of a log that was cut off in its first line.
inline bool begins_step_log(std::string_view text) noexcept {
    const bool whole = !text.empty() && text.back() == '\r';
    if (whole) text.remove_suffix(1);
    return whole ? text == step_log_header || text == weighted_step_log_header
                 : weighted_step_log_header.substr(0, text.size()) == text;
}

/// Longer than any line of a step log: 20 + 20 + 10 + 10 + 24 + 10 + 1 + 1 + 24 characters and 8 commas.
inline constexpr std::size_t step_log_max_line = 256;

/// The last episode that a log can have.
inline constexpr std::uint64_t step_log_max_episode = ~std::uint64_t{0} - 1;

/// Turns the current line of a LineReader into a step, and remembers where its fields begin.
class StepLogLine {
public:
    explicit StepLogLine(bool weights = false) noexcept : fields_(weights ? most_fields : most_fields - 1) {}

    [[nodiscard]] bool has_weights() const noexcept { return fields_ == most_fields; }

    /// \throws std::runtime_error "NAME:LINE:COLUMN: ..." if it is none.
    [[nodiscard]] LoggedStep parse(const LineReader& lines) {
        split(lines);
        LoggedStep step;
        step.episode = whole(lines, 0, "episode", step_log_max_episode);
        step.step = whole(lines, 1, "step", ~std::uint64_t{0});
        step.transition.state = state_id(whole(lines, 2, "state", max_ids - 1));
        step.transition.action = action_id(whole(lines, 3, "action", max_ids - 1));
        step.transition.reward = number(lines, 4, "reward");
        step.transition.next = state_id(whole(lines, 5, "next", max_ids - 1));
        step.transition.terminated = whole(lines, 6, "terminated", 1) == 1;
        step.truncated = whole(lines, 7, "truncated", 1) == 1;
        if (has_weights()) {
            step.transition.weight = number(lines, 8, "weight");
            if (!(step.transition.weight >= min_weight && step.transition.weight <= max_weight)) {
                fail(lines, 8, "weight must lie in [1e-30, 1e+30], got " + quoted(field_[8]));
            }
        }
        return step;
    }

    /// Throws std::runtime_error("NAME:LINE:COLUMN: MESSAGE") for the i-th field, from 0, of the line parsed last.
    [[noreturn]] void fail(const LineReader& lines, std::size_t i, const std::string& message) const {
        lines.fail(column_[i], message);
    }

private:
    static constexpr std::size_t most_fields = 9;

    void split(const LineReader& lines) {
        const std::string_view line = lines.line();
        std::size_t count = 0;
        for (std::size_t begin = 0;;) {
            const std::size_t comma = line.find(',', begin);
            if (count == fields_) lines.fail(begin + 1, "line has more than " + std::to_string(fields_) + " fields");
            column_[count] = begin + 1;
            field_[count++] = line.substr(begin, comma - begin);
            if (comma == std::string_view::npos) break;
            begin = comma + 1;
        }
        if (count == fields_) return;
        lines.fail(line.size() + 1, "line has " + std::to_string(count) + " fields, not " + std::to_string(fields_));
    }

    [[nodiscard]] std::uint64_t whole(const LineReader& lines, std::size_t i, const char* name,
                                      std::uint64_t most) const {
        std::uint64_t value = 0;
        const char* end = field_[i].data() + field_[i].size();
        const auto [stop, error] = std::from_chars(field_[i].data(), end, value);
        if (error == std::errc::invalid_argument || stop != end) {
            fail(lines, i, std::string(name) + " must be a whole number from 0 on, got " + quoted(field_[i]));
        }
        if (error != std::errc{} || value > most) {
            fail(lines, i,
                 std::string(name) + " must be at most " + std::to_string(most) + ", got " + quoted(field_[i]));
        }
        return value;
    }

    [[nodiscard]] double number(const LineReader& lines, std::size_t i, const char* name) const {
        double value = 0.0;
        const char* end = field_[i].data() + field_[i].size();
        const auto [stop, error] = std::from_chars(field_[i].data(), end, value);
        if (error != std::errc{} || stop != end || !std::isfinite(value)) {
            fail(lines, i, std::string(name) + " must be a finite number, got " + quoted(field_[i]));
        }
        return value;
    }

    std::array<std::string_view, most_fields> field_;
    std::array<std::size_t, most_fields> column_{};
    std::size_t fields_;
};

}  // namespace detail

}  // namespace sspql
