// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

/// \file
/// The task for which the floors are written by hand, a grid with four actions, and what they build on: what
/// bench_learners holds the library against.
///
/// They know what a library cannot: the number of actions and the most outcomes an action can have are constants, ids
/// are not checked, everything is allowed everywhere, nothing fades, grows or is taught, and alpha is a number. What
/// planning needs they keep as the library does: counts, reward sums, terminal flags, predecessors. Fed the same steps
/// and the same random numbers they reach the same values.

namespace sspql::floors {

inline constexpr std::uint32_t actions = 4;
inline constexpr std::size_t most_outcomes = 4;  // four neighbours; at the edge the cell itself instead of some

struct Step {
    std::uint32_t state;
    std::uint32_t action;
    double reward;
    std::uint32_t next;
    bool terminated;
};

/// What was seen of one (s,a,s'), 16 bytes.
struct Outcome {
    std::uint32_t next;
    std::uint32_t terminal : 1;
    std::uint32_t count : 31;
    double reward_sum;
};

/// What was seen of one (s,a): a header and its outcomes in place, 72 bytes.
struct Outcomes {
    std::uint32_t count = 0;
    std::uint32_t size = 0;
    std::array<Outcome, most_outcomes> seen{};

    /// \returns the place of the outcome.
    std::uint32_t add(const Step& t) {
        std::uint32_t i = 0;
        while (i < size && seen[i].next != t.next) ++i;
        if (i == size) seen[size++] = {t.next, 0, 0, 0.0};
        ++count;
        seen[i].count = seen[i].count + 1u;
        seen[i].terminal = t.terminated;
        seen[i].reward_sum += t.reward;
        return i;
    }
};

/// Q values as one array, a row of four a state.
class Values {
public:
    explicit Values(std::size_t states) : q_(states * actions, 0.0) {}

    [[nodiscard]] double max(std::size_t s) const {
        const double* q = &q_[s * actions];
        return std::max(std::max(q[0], q[1]), std::max(q[2], q[3]));
    }
    double& operator[](std::size_t pair) { return q_[pair]; }
    double operator[](std::size_t pair) const { return q_[pair]; }

private:
    std::vector<double> q_;
};

}  // namespace sspql::floors
