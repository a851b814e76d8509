// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <sspql/core/random.hpp>

#include "duels/task.hpp"
#include "floors/grid_task.hpp"
#include "floors/match.hpp"
#include "floors/slippery_grid.hpp"
#include "rivals/counting.hpp"

/// \file
/// The duels of recording: everybody counts the same steps.

namespace sspql::duels {

/// Episodes of random steps, the endless source of the benchmark's work.
class Walk {
public:
    explicit Walk(const floors::SlipperyGrid& grid) : grid_(grid), random_(seed, RandomStream::environment) {}

    void fill(std::vector<floors::Step>& steps) {
        for (floors::Step& t : steps) {
            if (left_-- == 0) {
                state_ = static_cast<std::uint32_t>(random_.below(grid_.states()));
                left_ = 99;
            }
            const auto a = static_cast<std::uint32_t>(random_.below(floors::actions));
            const std::uint32_t next = grid_.moved(state_, floors::SlipperyGrid::direction(a, random_));
            t = {state_, a, 0.0, next, next + 1 == grid_.states()};
            state_ = next;
        }
    }

private:
    floors::SlipperyGrid grid_;
    Random random_;
    std::uint32_t state_ = 0;
    std::size_t left_ = 0;
};

/// One who records. Begins anew, between turns, after `life` steps (0: never).
template <class T>
class Recorder {
public:
    Recorder(const floors::SlipperyGrid& grid, bool explored, std::size_t life) : grid_(grid), life_(life) {
        renew();
        if (explored) grid.explore(tries, seed, [this](const floors::Step& t) { counts_->record(t); });
    }
    void start_turn() {
        if (life_ != 0 && recorded_ >= life_) renew();
        counts_->start_turn();
    }
    std::uint64_t record(const std::vector<floors::Step>& steps) {
        for (const floors::Step& t : steps) counts_->record(t);
        recorded_ += steps.size();
        return steps.size();
    }
    [[nodiscard]] const T& counts() const { return *counts_; }

private:
    void renew() {
        counts_.reset();
        counts_ = std::make_unique<T>(grid_.states());
        recorded_ = 0;
    }
    floors::SlipperyGrid grid_;
    std::size_t life_;
    std::size_t recorded_ = 0;
    std::unique_ptr<T> counts_;
};

/// Library, floor and others record the same steps.
template <class... Others>
floors::Match recording(const floors::SlipperyGrid& grid, bool explored, std::size_t turn, std::size_t life,
                        const std::vector<std::string>& names) {
    auto steps = std::make_shared<std::vector<floors::Step>>(turn);
    auto walk = std::make_shared<Walk>(grid);
    auto library = std::make_shared<Recorder<rivals::Library>>(grid, explored, life);
    auto prepares = std::make_shared<std::vector<std::function<void()>>>();
    auto differences = std::make_shared<std::vector<std::function<double(const floors::Step&)>>>();
    floors::Match match;
    const auto enter = [&](auto recorder) {
        match.rivals.push_back({names[match.rivals.size()], [=] { return recorder->record(*steps); }});
        prepares->push_back([=] { recorder->start_turn(); });
        differences->push_back(
            [=](const floors::Step& t) { return std::fabs(recorder->counts().n(t) - library->counts().n(t)); });
    };
    enter(library);
    (enter(std::make_shared<Recorder<Others>>(grid, explored, life)), ...);
    match.prepare = [=] {
        walk->fill(*steps);
        for (const auto& prepare : *prepares) prepare();
    };
    // A step's own count, and N(s,a) of the floor, stand for all.
    match.disagreement = [=] {
        double largest = 0.0;
        for (const floors::Step& t : *steps) {
            for (const auto& difference : *differences) largest = std::max(largest, difference(t));
        }
        return largest;
    };
    return match;
}

}  // namespace sspql::duels
