// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <istream>
#include <string>
#include <string_view>
#include <utility>

#include <sspql/core/ids.hpp>
#include <sspql/core/line_reader.hpp>
#include <sspql/io/step_log_line.hpp>

namespace sspql {

/// What a step log holds.
struct StepLogContent {
    std::uint64_t episodes = 0;    ///< begun
    std::uint64_t unfinished = 0;  ///< of them: neither terminated nor truncated, as after abort() or a power cut
    std::uint64_t steps = 0;       ///< in all episodes
    std::size_t cut_line = 0;      ///< number of the last line if it has no end, and was therefore left out; else 0
};

/// Reads what StepLog wrote, line by line in constant memory:
///
///     StepLogReader log(stream, "run.csv");
///     while (log.next()) use(log.step());
///
/// The header must be StepLog's, with or without weights; lines end with LF or CRLF. A last line without an end was cut
/// off while it was written: it is left out, and content() tells its number. An empty file is a log cut off at its
/// first byte.
///
/// \throws std::runtime_error "NAME:LINE:COLUMN: ..." with the offending value for anything else: another header, a
/// missing or additional field, ids that are none, a reward that is not finite, a weight outside [1e-30, 1e30], a flag
/// other than 0 and 1; a step that does not begin in the state where the last one of its episode led, whose number is
/// not the next one, or that follows the episode's end; an episode that does not begin with step 0 or is not greater
/// than the last one; and what LineReader refuses.
class StepLogReader {
public:
    /// The stream must outlive the reader.
    StepLogReader(std::istream& in, std::string name) : lines_(in, std::move(name), detail::step_log_max_line) {}

    /// Goes to the next step. False at the end of the log.
    [[nodiscard]] bool next() {
        if (lines_.number() == 0 && !(next_line() && read_header())) return false;
        if (!next_line()) {
            if (running()) ++content_.unfinished;
            step_ended_ = true;
            return false;
        }
        const LoggedStep step = line_.parse(lines_);
        require_continuity(step);
        if (step.step == 0) {
            if (running()) ++content_.unfinished;
            ++content_.episodes;
        }
        ++content_.steps;
        step_ = step;
        step_ended_ = step.transition.terminated || step.truncated;
        return true;
    }

    /// The current step. Valid after next() returned true.
    [[nodiscard]] const LoggedStep& step() const noexcept { return step_; }

    /// What was read so far; of the whole log once next() returned false.
    [[nodiscard]] const StepLogContent& content() const noexcept { return content_; }

    /// Whether the log has weights.
    [[nodiscard]] bool has_weights() const noexcept { return line_.has_weights(); }

    /// Throws std::runtime_error("NAME:LINE:COLUMN: MESSAGE") for field `i` of the current step, as counted in the
    /// header from 0.
    [[noreturn]] void fail(std::size_t i, const std::string& message) const { line_.fail(lines_, i, message); }

private:
    /// False at the end, and at a line that has none.
    bool next_line() {
        if (!lines_.next()) return false;
        if (lines_.ended()) return true;
        if (lines_.number() == 1 && !detail::begins_step_log(lines_.line())) fail_header();
        content_.cut_line = lines_.number();
        return false;
    }

    bool read_header() {
        const std::string_view line = lines_.line();
        if (line != detail::step_log_header && line != detail::weighted_step_log_header) fail_header();
        line_ = detail::StepLogLine(line == detail::weighted_step_log_header);
        return true;
    }

    [[noreturn]] void fail_header() const {
        lines_.fail(1, "header must be " + std::string(detail::step_log_header) + "[,weight], got " +
                           detail::quoted(lines_.line()));
    }

    [[nodiscard]] bool running() const noexcept { return content_.steps != 0 && !step_ended_; }

    void require_continuity(const LoggedStep& step) const {
        const std::string episode = "episode " + std::to_string(step.episode);
        if (content_.steps == 0 || step.episode > step_.episode) {
            if (step.step != 0) fail(1, episode + " begins with step " + std::to_string(step.step) + ", not 0");
            return;
        }
        if (step.episode < step_.episode) fail(0, episode + " comes after episode " + std::to_string(step_.episode));
        if (step_ended_) fail(0, episode + " goes on after its end");
        if (step.step != step_.step + 1) {
            fail(1, "step " + std::to_string(step.step) + " comes after step " + std::to_string(step_.step));
        }
        if (step.transition.state != step_.transition.next) {
            fail(2, "state " + std::to_string(index(step.transition.state)) + " is not where the last step led, " +
                        std::to_string(index(step_.transition.next)));
        }
    }

    LineReader lines_;
    detail::StepLogLine line_;
    LoggedStep step_;
    StepLogContent content_;
    bool step_ended_ = false;  // the last step ended its episode
};

/// Calls f(const LoggedStep&) for every step of a log. \throws what StepLogReader and f throw.
template <class F>
StepLogContent for_each_step(std::istream& in, const std::string& name, F&& f) {
    StepLogReader log(in, name);
    while (log.next()) f(log.step());
    return log.content();
}

/// The same for a file. \throws std::runtime_error also "PATH: cannot be opened".
template <class F>
StepLogContent for_each_step(const std::string& path, F&& f) {
    std::ifstream file = open_text(path);
    return for_each_step(file, path, f);
}

}  // namespace sspql
