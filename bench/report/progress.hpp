// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstddef>
#include <mutex>
#include <string>

namespace sspql::report {

/// What a progress line shows.
struct ProgressState {
    std::string label;
    std::string unit;  ///< of what is counted: "runs"
    std::size_t done = 0;
    std::size_t total = 0;
    double elapsed_s = 0.0;
};

/// "pusher_experiment  [#####.....]  132/400 runs  33 %  ETA 0:41", at most `columns` long: the bar shrinks first, then
/// the text is cut. The time left extrapolates the pace so far; "-:--" until something is done.
[[nodiscard]] std::string progress_line(const ProgressState& state, std::size_t columns);

/// A progress line on stderr that rewrites itself, at most ten times a second, and is wiped when the object goes.
/// Writes nothing at all where stderr is no terminal, or a dumb one.
class Progress {
public:
    /// `total` is what `advance` will add up to. `descriptor`: for tests.
    Progress(std::string label, std::size_t total, std::string unit = "runs", int descriptor = 2);
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    ~Progress();

    /// Counts n more as done. Any thread may call it at any time.
    void advance(std::size_t n = 1);

    /// Wipes the line, before something else is printed; the next update shows it again. Any thread.
    void clear();

private:
    using Clock = std::chrono::steady_clock;

    void draw();
    void wipe();

    std::mutex mutex_;
    ProgressState state_;
    int descriptor_;
    bool active_;
    bool shown_ = false;
    Clock::time_point begun_;
    Clock::time_point drawn_;
};

}  // namespace sspql::report
