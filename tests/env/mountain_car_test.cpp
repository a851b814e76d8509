// SPDX-License-Identifier: MIT
#include <sspql/env/mountain_car.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>

#include <gtest/gtest.h>

#include <sspql/env/time_limit.hpp>
#include <sspql/learn/agent.hpp>
#include <sspql/run/episode.hpp>
#include <sspql/spaces/action_policy.hpp>

namespace sspql {
namespace {

using Observation = MountainCar::Observation;

/// Steps to the hilltop, or `cap`.
template <class Driver>
std::size_t drive(MountainCar& car, const Driver& driver, std::size_t cap) {
    for (std::size_t steps = 1; steps < cap; ++steps) {
        if (car.step(driver(car.observation())).terminated) return steps;
    }
    return cap;
}

/// Always the way it goes: no tick takes energy out.
Throttle pumping(const Observation& at) { return at[1] < 0.0 ? Throttle::back : Throttle::forward; }

}  // namespace

static_assert(is_environment_v<MountainCar, Throttle>);

// velocity 0.001 - 0.0025 cos(-1.5) = 0.001 - 0.0025 x 0.0707372016677029 = 0.000823156995830743, from rest at -0.5;
// coasting and in reverse 0.001 and 0.002 less.
TEST(MountainCar, ATickFollowsTheEquations) {
    for (const int throttle : {0, 1, 2}) {
        MountainCar car;
        car.place({-0.5, 0.0});
        const auto step = car.step(static_cast<Throttle>(throttle));
        const double velocity = 0.000823156995830743 - 0.001 * (2 - throttle);
        EXPECT_NEAR(step.observation[1], velocity, 1e-15);
        EXPECT_NEAR(step.observation[0], -0.5 + velocity, 1e-15);
        EXPECT_EQ(step.reward, -1.0);
        EXPECT_FALSE(step.terminated || step.truncated);
    }
}

TEST(MountainCar, TheWallStopsItAndSpeedHasALimit) {
    MountainCar car;
    car.place({-1.19, -0.05});
    const auto hit = car.step(Throttle::back);
    EXPECT_EQ(hit.observation, (Observation{-1.2, 0.0}));
    car.place({-1.0, 0.07});
    EXPECT_EQ(car.step(Throttle::forward).observation[1], 0.07) << "-0.0025 cos(-3) is 0.0025 more";
    car.place({0.45, 0.07});
    const auto end = car.step(Throttle::none);
    EXPECT_TRUE(end.terminated);
    EXPECT_EQ(end.observation[0], 0.5);
    EXPECT_THROW((void)car.step(Throttle::none), std::logic_error);
}

// The slope is steeper than the engine is strong where 0.0025 cos(3 x) > 0.001: between -0.386 and 0.386.
TEST(MountainCar, GoingForwardAloneNeverGetsThere) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        MountainCar car;
        car.reset(seed);
        EXPECT_EQ(drive(
                      car, [](const Observation&) { return Throttle::forward; }, 10000),
                  10000u)
            << "seed " << seed;
        EXPECT_LT(car.observation()[0], 0.0);
        car.reset(seed);
        EXPECT_EQ(drive(
                      car, [](const Observation&) { return Throttle::none; }, 10000),
                  10000u)
            << "coasting";
    }
}

TEST(MountainCar, PumpingEnergyGetsThere) {
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
        MountainCar car;
        car.reset(seed);
        const std::size_t steps = drive(car, pumping, 10000);
        EXPECT_GE(steps, 80u) << "seed " << seed;
        EXPECT_LE(steps, 160u) << "seed " << seed;
    }
}

TEST(MountainCar, EpisodesStartAtRestNearTheBottom) {
    double least = 0.0;
    double greatest = -1.0;
    for (std::uint64_t seed = 0; seed < 1000; ++seed) {
        MountainCar car;
        const Observation at = car.reset(seed);
        EXPECT_EQ(at[1], 0.0);
        EXPECT_TRUE(at[0] >= -0.6 && at[0] < -0.4);
        EXPECT_EQ(MountainCar().reset(seed), at);
        least = std::min(least, at[0]);
        greatest = std::max(greatest, at[0]);
    }
    EXPECT_LT(least, -0.599);
    EXPECT_GT(greatest, -0.401);
}

TEST(MountainCar, AHeldCommandIsManyTicksInOneStep) {
    MountainCar one;
    MountainCar four({4, 0.0, 1.0});
    one.reset(3);
    four.reset(3);
    std::size_t ticks = 0;
    for (;;) {
        const Throttle throttle = pumping(four.observation());
        const auto step = four.step(throttle);
        for (int k = 0; k < 4; ++k) {
            ++ticks;
            if (one.step(throttle).terminated) break;
        }
        ASSERT_EQ(step.observation, one.observation());
        EXPECT_EQ(step.reward, step.terminated ? 1.0 : 0.0);
        if (step.terminated) break;
    }
    EXPECT_LT(ticks, 200u);
}

TEST(MountainCar, RefusesWhatItIsNot) {
    EXPECT_THROW(MountainCar({0, -1.0, -1.0}), std::invalid_argument);
    EXPECT_THROW(MountainCar({1, std::nan(""), -1.0}), std::invalid_argument);
    MountainCar car;
    EXPECT_THROW((void)car.step(Throttle::none), std::logic_error);
    EXPECT_THROW(car.place({0.5, 0.0}), std::invalid_argument);
    EXPECT_THROW(car.place({std::nan(""), 0.0}), std::invalid_argument);
    EXPECT_THROW(car.place({0.0, 0.08}), std::invalid_argument);
    car.reset(1);
    EXPECT_THROW((void)car.step(static_cast<Throttle>(3)), std::invalid_argument);
}

// Through a grid of 16 x 16 cells the adaptive planner learns to swing. Seeds 1 to 5. Measured over
// 100 seeds, ticks of episodes 81 to 100: 141 +- 1; Q-learning (gamma 1, alpha 0.3) 319 +- 3, SSPQL 251 +- 2,
// prioritized sweeping that starts optimistic (gamma 0.99) 145 +- 1; pumping energy, which is not the best, 119.
TEST(MountainCar, TheAdaptivePlannerLearnsToSwing) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        TimeLimit car(MountainCar({4, -1.0, -1.0}), 2000);
        Agent robot(MountainCar::grid(16), EnumActions<Throttle>(3), AdaptiveParams<>{}, seed);
        (void)run_episodes(car, robot, 80, 1000 * seed);
        double ticks = 0.0;
        for (const auto& episode : run_episodes(car, robot, 20, 1000 * seed + 80)) {
            EXPECT_TRUE(episode.terminated);
            ticks += 4.0 * static_cast<double>(episode.steps);
        }
        EXPECT_LT(ticks / 20.0, 200.0) << "seed " << seed;
    }
}

}  // namespace sspql
