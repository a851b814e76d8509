// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

#include <gtest/gtest.h>

#include <sspql/core/ids.hpp>
#include <sspql/core/random.hpp>
#include <sspql/learn/adaptive_sspql.hpp>
#include <sspql/learn/dyna_q.hpp>
#include <sspql/learn/dyna_q_plus.hpp>
#include <sspql/learn/prioritized_sweeping.hpp>
#include <sspql/learn/q_learning.hpp>
#include <sspql/learn/r_max.hpp>
#include <sspql/learn/rtdp.hpp>
#include <sspql/learn/sarsa.hpp>
#include <sspql/learn/sspql.hpp>

/// \file
/// What the tests of learners share: the learners themselves, a small room to walk in, and all that can be seen of a
/// learner as one list of numbers.

namespace sspql::testing {

/// The interface is one: what is said of Learner holds for all of these.
using AllLearners = ::testing::Types<QLearning<>, Sspql<>, Sarsa<>, DynaQ<>, DynaQPlus<>, PrioritizedSweeping<>, Rtdp<>,
                                     RMax<>, AdaptiveSspql<>>;

/// Those with the parameters of ValueParams, gamma 0.8 and initial_q 0 among them.
using ValueLearners =
    ::testing::Types<QLearning<>, Sspql<>, Sarsa<>, DynaQ<>, DynaQPlus<>, PrioritizedSweeping<>, Rtdp<>, RMax<>>;

/// Those that update Q by eq. 1 alone.
using LearnersByEq1 = ::testing::Types<QLearning<>, Sspql<>>;

struct LearnerNames {
    template <class L>
    static std::string GetName(int) {
        if (std::is_same_v<L, QLearning<>>) return "QLearning";
        if (std::is_same_v<L, Sspql<>>) return "Sspql";
        if (std::is_same_v<L, Sarsa<>>) return "Sarsa";
        if (std::is_same_v<L, DynaQ<>>) return "DynaQ";
        if (std::is_same_v<L, DynaQPlus<>>) return "DynaQPlus";
        if (std::is_same_v<L, PrioritizedSweeping<>>) return "PrioritizedSweeping";
        if (std::is_same_v<L, Rtdp<>>) return "Rtdp";
        if (std::is_same_v<L, RMax<>>) return "RMax";
        return "AdaptiveSspql";
    }
};

/// 5 x 5 cells, moves east, west, north, south; one in `slip` (0: none) goes somewhere else.
class Room {
public:
    static constexpr std::size_t width = 5;
    static constexpr std::size_t states = width * width;
    static constexpr std::size_t actions = 4;

    explicit Room(std::uint64_t seed, double slip = 0.0) : random_(seed, RandomStream::environment), slip_(slip) {}

    [[nodiscard]] static StateId at(std::size_t x, std::size_t y) { return state_id(y * width + x); }

    [[nodiscard]] static StateId moved(StateId s, ActionId a) {
        const std::size_t x = index(s) % width;
        const std::size_t y = index(s) / width;
        switch (index(a)) {
            case 0: return at(x + 1 < width ? x + 1 : x, y);
            case 1: return at(x > 0 ? x - 1 : x, y);
            case 2: return at(x, y + 1 < width ? y + 1 : y);
            default: return at(x, y > 0 ? y - 1 : y);
        }
    }

    [[nodiscard]] StateId step(StateId s, ActionId a) {
        if (!random_.chance(slip_)) return moved(s, a);
        return moved(s, action_id(random_.below(actions)));
    }

private:
    Random random_;
    double slip_;
};

/// One episode from `start` to `goal`, which pays 1: the actions chosen. Cut after `cap` steps.
template <class L>
std::vector<ActionId> walk(L& learner, Room& room, StateId start, StateId goal, std::size_t cap = 1000) {
    std::vector<ActionId> chosen{learner.begin(start)};
    StateId s = start;
    for (;;) {
        s = room.step(s, learner.action());
        if (s == goal || chosen.size() == cap) {
            learner.end(s == goal ? 1.0 : 0.0, s, s == goal);
            return chosen;
        }
        chosen.push_back(learner.step(0.0, s));
    }
}

/// The learner sees the outcome of every action in every cell of the room once.
template <class L>
void show_room(L& learner) {
    for (std::size_t s = 0; s < Room::states; ++s) {
        for (std::size_t a = 0; a < Room::actions; ++a) {
            learner.observe(state_id(s), action_id(a), 0.0, Room::moved(state_id(s), action_id(a)), false);
        }
    }
}

/// All that can be seen of a learner, in one order.
template <class L>
std::vector<double> fingerprint(const L& learner) {
    std::vector<double> seen{static_cast<double>(learner.states()), static_cast<double>(learner.running()),
                             static_cast<double>(index(learner.state())), static_cast<double>(index(learner.action()))};
    for (std::size_t s = 0; s < learner.states(); ++s) {
        for (std::size_t a = 0; a < learner.actions(); ++a) {
            const auto terms = learner.terms(state_id(s), action_id(a));
            const bool legal = learner.legal_actions().allowed(state_id(s)).contains(action_id(a));
            for (const double x :
                 {learner.q()(state_id(s), action_id(a)), terms.q, terms.ssp, terms.exploration, terms.n,
                  static_cast<double>(learner.visits()(state_id(s), action_id(a))), legal ? 1.0 : 0.0}) {
                seen.push_back(x);
            }
        }
    }
    seen.push_back(static_cast<double>(learner.model_operations()));
    if constexpr (std::is_same_v<L, Sspql<>>) {
        seen.push_back(static_cast<double>(learner.counts().pairs()));
        for (const double d : learner.tree().distance) seen.push_back(d);
        for (const Goal& goal : learner.goals()) seen.push_back(static_cast<double>(index(goal.state)));
    }
    return seen;
}

inline constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr std::array<double, 3> bad_rewards{not_a_number, infinity, -infinity};
inline constexpr std::array<double, 6> bad_weights{0.0, -1.0, 1e-31, 1e31, not_a_number, infinity};

}  // namespace sspql::testing
