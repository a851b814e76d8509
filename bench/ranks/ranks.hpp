// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <thread>

namespace sspql::experiment {

/// Thrown where another rank says what is wrong.
struct ErrorElsewhere : std::runtime_error {
    ErrorElsewhere() : std::runtime_error("another rank failed") {}
};

/// The processes that share a run: rank 0, 1, ... of `size`. One object in main, before anything is printed.
///
/// There are two implementations: one_rank.cpp knows of no other process; mpi_ranks.cpp (SSPQL_BUILD_MPI) talks to
/// those that an MPI launcher started beside this one. Without such a launcher MPI is not even initialised, and both
/// are the same. Only rank 0 prints: stdout of the others leads nowhere.
class Ranks {
public:
    Ranks();
    Ranks(const Ranks&) = delete;
    Ranks& operator=(const Ranks&) = delete;
    ~Ranks();

    [[nodiscard]] std::size_t rank() const noexcept { return rank_; }
    [[nodiscard]] std::size_t size() const noexcept { return size_; }

    /// Where this rank's progress line goes: only rank 0 shows one.
    [[nodiscard]] int progress_descriptor() const noexcept { return rank_ == 0 ? 2 : -1; }

    /// How many threads a rank should have if asked for `threads`: as many, but for 0 (as many as the machine has) its
    /// share of them, since the ranks of a host share it.
    [[nodiscard]] std::size_t threads(std::size_t threads) const {
        if (threads > 0 || on_host_ == 1) return threads;
        return std::max<std::size_t>(1, std::thread::hardware_concurrency() / on_host_);
    }

    /// Does something on every rank. If that throws on any, it ends with an exception on all: on the lowest of those
    /// ranks with the text of its own, on the others with ErrorElsewhere. All ranks must call it.
    void together(const std::function<void()>& task) const;

    /// Brings every rank's text to rank 0, which calls take(rank, text) for each, in order, its own first: one text at
    /// a time is in memory. All ranks must call it.
    void gather(std::string own, const std::function<void(std::size_t rank, const std::string& text)>& take) const;

private:
    std::size_t rank_ = 0;
    std::size_t size_ = 1;
    std::size_t on_host_ = 1;
};

}  // namespace sspql::experiment
