// SPDX-License-Identifier: MIT
#include "experiment/live_session.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace sspql::experiment {

namespace {

constexpr std::array<int, 11> rates{1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 0};  // 0: unlimited
constexpr double fastest_motion = 20.0;  // actions/s up to which the robot is seen moving
constexpr double longest_frame_s = 0.25;

std::string name_of(int rate) { return rate == 0 ? "max" : std::to_string(rate); }

}  // namespace

std::optional<LiveCommand> command_of(char32_t character) noexcept {
    if (character >= U'1' && character <= U'9') {
        return LiveCommand{LiveKey::learner, static_cast<std::size_t>(character - U'1')};
    }
    switch (character) {
        case U' ': return LiveCommand{LiveKey::pause};
        case U'+':
        case U'=': return LiveCommand{LiveKey::faster};  // '+' without the shift key on many keyboards
        case U'-': return LiveCommand{LiveKey::slower};
        case U'n':
        case U'N': return LiveCommand{LiveKey::single_step};
        case U'l':
        case U'L': return LiveCommand{LiveKey::next_learner};
        case U'r':
        case U'R': return LiveCommand{LiveKey::restart};
        case U'h':
        case U'H':
        case U'?': return LiveCommand{LiveKey::help};
        case U'q':
        case U'Q': return LiveCommand{LiveKey::quit};
        default: return std::nullopt;
    }
}

std::vector<std::string> Pace::names() {
    std::vector<std::string> names;
    names.reserve(rates.size());
    for (const int rate : rates) names.push_back(name_of(rate));
    return names;
}

Pace::Pace(const std::string& name) {
    while (level_ < rates.size() && name_of(rates[level_]) != name) ++level_;
    if (level_ == rates.size()) throw std::invalid_argument("no such pace: '" + name + "'");
}

bool Pace::is_unlimited() const noexcept { return rates[level_] == 0; }
double Pace::per_second() const noexcept { return rates[level_]; }

std::string Pace::text() const {
    if (is_unlimited()) return "as fast as it can";
    return std::to_string(rates[level_]) + (rates[level_] == 1 ? " action/s" : " actions/s");
}

void Pace::faster() noexcept { level_ = std::min(level_ + 1, rates.size() - 1); }

void Pace::slower() noexcept {
    if (level_ > 0) --level_;
}

std::size_t Pace::due(double seconds) noexcept {
    constexpr double rounding = 1e-9;  // sixty times 1/60 is one
    carry_ += seconds * per_second();
    const auto whole = static_cast<std::size_t>(carry_ + rounding);
    carry_ = std::max(0.0, carry_ - static_cast<double>(whole));
    return whole;
}

void LiveSession::handle(const LiveCommand& command) {
    switch (command.key) {
        case LiveKey::pause: paused_ = !paused_; break;
        case LiveKey::faster: pace_.faster(); break;
        case LiveKey::slower: pace_.slower(); break;
        case LiveKey::single_step:
            paused_ = true;
            run_.tick();
            break;
        case LiveKey::next_learner: switch_to((run_.learner() + 1) % run_.recipes().size()); break;
        case LiveKey::learner:
            if (command.number < run_.recipes().size()) switch_to(command.number);
            break;
        case LiveKey::restart:
            past_.clear();  // of another seed: another world
            run_.restart(run_.seed() + 1);
            break;
        case LiveKey::help: help_ = !help_; break;
        case LiveKey::quit: quitting_ = true; break;
    }
    if (run_.total_steps() == 0) pace_.begin_interval();
}

void LiveSession::switch_to(std::size_t learner) {
    const auto forget = [this](std::size_t of) {
        past_.erase(std::remove_if(past_.begin(), past_.end(), [of](const PastRun& run) { return run.learner == of; }),
                    past_.end());
    };
    if (!run_.episodes().empty()) {
        forget(run_.learner());
        past_.push_back({run_.learner(), run_.episodes()});
    }
    forget(learner);
    run_.choose_learner(learner);
}

void LiveSession::pass(double seconds, const std::function<bool()>& go_on) {
    if (paused_ || quitting_) return;
    if (pace_.is_unlimited()) {
        do {
            run_.tick();
        } while (!run_.is_over() && go_on());
        return;
    }
    for (std::size_t left = pace_.due(std::clamp(seconds, 0.0, longest_frame_s)); left > 0; --left) {
        run_.tick();
        if (!go_on()) break;
    }
}

bool LiveSession::is_followable() const noexcept {
    return paused_ || (!pace_.is_unlimited() && pace_.per_second() <= fastest_motion);
}

bool LiveSession::is_under_way() const { return !run_.next() || (run_.last() && !paused_ && is_followable()); }

sim::Pose LiveSession::shown_robot() const {
    const std::vector<sim::Pose>& trail = run_.trail();
    const sim::Pose& there = trail.back();
    const bool moving = !paused_ && !run_.is_over() && is_followable();
    if (!moving || trail.size() < 2) return there;
    const sim::Pose& from = trail[trail.size() - 2];
    const double part = std::min(1.0, pace_.phase());
    return {from.x_m + part * (there.x_m - from.x_m), from.y_m + part * (there.y_m - from.y_m),
            sim::wrap_angle(from.heading_rad + part * sim::wrap_angle(there.heading_rad - from.heading_rad))};
}

const Decision& LiveSession::shown_decision() const { return is_under_way() ? *run_.last() : *run_.next(); }

std::string LiveSession::status() const {
    return run_.learner_name() + ", seed " + std::to_string(run_.seed()) + ", episode " +
           std::to_string(run_.episode()) + ", step " + std::to_string(run_.episode_steps()) + ", " +
           std::to_string(run_.total_steps()) + " in all";
}

}  // namespace sspql::experiment
