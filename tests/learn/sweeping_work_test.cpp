// SPDX-License-Identifier: MIT
// A backup of prioritized sweeping costs the same in a world of 64 states and in one of a million: operations on the
// model are counted, no clock is read.
#include <sspql/learn/prioritized_sweeping.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>

#include <gtest/gtest.h>

#include <sspql/core/assert.hpp>
#include <sspql/core/ids.hpp>
#include <sspql/core/random.hpp>

namespace sspql_sweeping_work_test {

using namespace sspql;

namespace {

constexpr std::size_t actions = 4;

class Planner : public PrioritizedSweeping<> {
public:
    using PrioritizedSweeping<>::PrioritizedSweeping;
    void set_planning_steps(std::size_t steps) { params_.planning_steps = steps; }
};

/// Open floor; one step in ten goes in a random direction.
struct Floor {
    std::size_t columns;
    std::size_t rows;

    [[nodiscard]] std::size_t states() const { return columns * rows; }

    [[nodiscard]] StateId step(std::size_t s, std::size_t direction, Random& random) const {
        if (random.chance(0.1)) direction = random.below(actions);
        const std::size_t x = s % columns;
        const std::size_t y = s / columns;
        switch (direction) {
            case 0: return state_id(x + 1 < columns ? s + 1 : s);
            case 1: return state_id(x > 0 ? s - 1 : s);
            case 2: return state_id(y + 1 < rows ? s + columns : s);
            default: return state_id(y > 0 ? s - columns : s);
        }
    }
};

/// Operations on the model per backup, once every (s,a) was tried three times: rewards turn up in random places, for
/// one (s,a) in eight (at most 4000), and are planned from. Small worlds are learnt several times, so that all are averages
/// of about 4000 rewards.
double operations_per_backup(const Floor& floor) {
    constexpr std::size_t all = 4000;
    const std::size_t rewards = std::min(floor.states() * actions / 8, all);
    std::uint64_t operations = 0;
    std::uint64_t backups = 0;
    for (std::size_t k = 0; k < (all + rewards - 1) / rewards; ++k) {
        PrioritizedSweepingParams<> params;
        params.planning_steps = 0;
        params.threshold = 1e-3;
        params.gamma = 0.95;
        Planner learner(floor.states(), actions, params);
        Random random(k, RandomStream::environment);
        for (std::size_t s = 0; s < floor.states(); ++s) {
            for (std::size_t a = 0; a < actions; ++a) {
                for (int i = 0; i < 3; ++i) {
                    learner.observe(state_id(s), action_id(a), 0.0, floor.step(s, a, random), false);
                }
            }
        }
        learner.set_planning_steps(20);
        const std::uint64_t before = learner.model_operations();
        for (std::size_t i = 0; i < rewards; ++i) {
            const std::size_t s = random.below(floor.states());
            const std::size_t a = random.below(actions);
            const StateId next = floor.step(s, a, random);
            learner.observe(state_id(s), action_id(a), random.uniform(), next, false);
        }
        operations += learner.model_operations() - before;
        backups += learner.backups();
    }
    EXPECT_GT(backups, all);
    return static_cast<double>(operations) / static_cast<double>(backups);
}

void expect_no_growth(std::initializer_list<Floor> floors) {
    const double least = operations_per_backup({8, 8});
    ::testing::Test::RecordProperty("operations_64", std::to_string(least));
    for (const Floor& floor : floors) {
        const double work = operations_per_backup(floor);
        ::testing::Test::RecordProperty("operations_" + std::to_string(floor.states()), std::to_string(work));
        EXPECT_LE(work, 1.2 * least) << floor.states() << " states; " << least << " at 64";
    }
}

TEST(SweepingWork, ABackupCostsTheSameUpToAHundredThousandStates) {
    expect_no_growth({{25, 40}, {100, 100}, {250, 400}});
}

#if !SSPQL_ENABLE_ASSERTIONS  // takes too long with them
TEST(SweepingWork, ABackupCostsTheSameAtAMillionStates) { expect_no_growth({{1000, 1000}}); }
#endif

}  // namespace

}  // namespace sspql_sweeping_work_test
