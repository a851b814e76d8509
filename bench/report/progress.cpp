// SPDX-License-Identifier: MIT
#include "report/progress.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace sspql::report {

namespace {

constexpr std::size_t widest_bar = 24;
constexpr std::chrono::milliseconds least_pause{100};

bool is_capable_terminal(int descriptor) {
    if (::isatty(descriptor) == 0) return false;
    const char* terminal = std::getenv("TERM");
    return terminal == nullptr || std::string(terminal) != "dumb";
}

std::size_t columns_of(int descriptor) {
    winsize size{};
    if (::ioctl(descriptor, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return 80;
    return size.ws_col;
}

/// 41 -> "0:41", 3600 -> "1:00:00".
std::string clock_text(double seconds) {
    if (!(seconds >= 0.0 && seconds < 3.6e8)) return "-:--";
    const auto whole = static_cast<unsigned long>(std::lround(seconds));
    const auto two_digits = [](unsigned long value) { return (value < 10 ? ":0" : ":") + std::to_string(value); };
    if (whole < 3600) return std::to_string(whole / 60) + two_digits(whole % 60);
    return std::to_string(whole / 3600) + two_digits(whole / 60 % 60) + two_digits(whole % 60);
}

/// A progress line is a courtesy: a terminal that went away must not end the experiment.
void write_ignoring_errors(int descriptor, const std::string& text) {
    const ssize_t written = ::write(descriptor, text.data(), text.size());
    static_cast<void>(written);
}

}  // namespace

std::string progress_line(const ProgressState& state, std::size_t columns) {
    const double share =
        state.total == 0 ? 1.0 : std::min(1.0, static_cast<double>(state.done) / static_cast<double>(state.total));
    const double left_s = share > 0.0 ? state.elapsed_s * (1.0 - share) / share : -1.0;
    const std::string total = std::to_string(state.total);
    std::string done = std::to_string(state.done);
    done.insert(0, total.size() - std::min(total.size(), done.size()), ' ');  // so that the line does not wobble
    const std::size_t percent = state.total == 0 ? 100 : std::min<std::size_t>(100, state.done * 100 / state.total);
    const std::string counts =
        done + "/" + total + " " + state.unit + "  " + std::to_string(percent) + " %  ETA " + clock_text(left_s);

    const std::size_t around = state.label.size() + counts.size() + 6;  // two gaps and the brackets
    const std::size_t bar = columns > around ? std::min(widest_bar, columns - around) : 0;
    const auto filled = static_cast<std::size_t>(share * static_cast<double>(bar));
    std::string line = state.label + "  ";
    if (bar >= 4) line += "[" + std::string(filled, '#') + std::string(bar - filled, '.') + "]  ";
    return (line + counts).substr(0, columns);
}

Progress::Progress(std::string label, std::size_t total, std::string unit, int descriptor)
    : state_{std::move(label), std::move(unit), 0, total, 0.0},
      descriptor_(descriptor),
      active_(is_capable_terminal(descriptor)),
      begun_(Clock::now()),
      drawn_(begun_) {
    if (active_) draw();
}

Progress::~Progress() { wipe(); }

void Progress::advance(std::size_t n) {
    if (!active_) return;
    const std::lock_guard<std::mutex> lock(mutex_);
    state_.done += n;
    if (Clock::now() - drawn_ >= least_pause) draw();
}

void Progress::clear() {
    const std::lock_guard<std::mutex> lock(mutex_);
    wipe();
}

void Progress::draw() {
    drawn_ = Clock::now();
    state_.elapsed_s = std::chrono::duration<double>(drawn_ - begun_).count();
    const std::size_t columns = columns_of(descriptor_);
    const std::string line = progress_line(state_, columns - std::min<std::size_t>(columns, 1));
    write_ignoring_errors(descriptor_, "\r" + line + "\x1b[K");
    shown_ = true;
}

void Progress::wipe() {
    if (shown_) write_ignoring_errors(descriptor_, "\r\x1b[K");
    shown_ = false;
}

}  // namespace sspql::report
