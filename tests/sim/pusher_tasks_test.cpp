// SPDX-License-Identifier: MIT
#include <sspql/sim/pusher_tasks.hpp>

#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include <sspql/core/random.hpp>
#include <sspql/env/environment.hpp>
#include <sspql/sim/box2d_backend.hpp>
#include <sspql/sim/kinematic_backend.hpp>

namespace sim = sspql::sim;
using sim::PusherCommand;
using sim::PusherObservation;
using sim::PusherParams;

namespace {

constexpr PusherCommand forward{sim::Motion::translate, 0.3};
constexpr PusherCommand left{sim::Motion::rotate, sim::from_degrees(30.0)};

PusherParams noiseless() {
    PusherParams params;
    params.noise = 0.0;
    return params;
}

bool same(const PusherObservation& a, const PusherObservation& b) {
    return a.robot == b.robot && a.box == b.box && a.goal == b.goal;
}

template <class Backend>
class PusherTasks : public testing::Test {};

using Backends = testing::Types<sim::KinematicBackend, sim::Box2dBackend>;
TYPED_TEST_SUITE(PusherTasks, Backends, );

}  // namespace

TYPED_TEST(PusherTasks, AreEnvironments) {
    static_assert(sspql::is_environment_v<sim::ApproachTask<TypeParam>, PusherCommand>);
    static_assert(sspql::is_environment_v<sim::TurnTask<TypeParam>, PusherCommand>);
    SUCCEED();
}

TYPED_TEST(PusherTasks, SameSeedSameEpisodeInAUsedAndInANewTask) {
    sim::ApproachTask<TypeParam> used;
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
        sim::ApproachTask<TypeParam> fresh;
        ASSERT_TRUE(same(used.reset(seed), fresh.reset(seed)));
        sspql::Random random(seed);
        for (int i = 0; i < 40; ++i) {
            const PusherCommand command =
                sim::ApproachActions::decode(sspql::action_id(random.below(sim::ApproachActions::size())));
            const auto a = used.step(command);
            const auto b = fresh.step(command);
            ASSERT_TRUE(same(a.observation, b.observation)) << seed << " " << i;
            ASSERT_EQ(a.terminated, b.terminated);
            if (a.terminated) break;
        }
    }
}

TYPED_TEST(PusherTasks, ApproachStartsAtTwoPlacesWithinTheJitter) {
    sim::ApproachTask<TypeParam> task;
    const PusherParams& p = task.params();
    int at[2] = {0, 0};
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        const PusherObservation start = task.reset(seed);
        const int place = start.robot.y_m > 0.0 ? 0 : 1;
        ++at[place];
        const sim::Pose& wanted = p.start_places[static_cast<std::size_t>(place)];
        EXPECT_LE(std::fabs(start.robot.x_m - wanted.x_m), 0.03 + 1e-6);
        EXPECT_LE(std::fabs(start.robot.y_m - wanted.y_m), 0.03 + 1e-6);
        EXPECT_LE(std::fabs(sim::wrap_angle(start.robot.heading_rad - wanted.heading_rad)), 0.03 + 1e-6);
        EXPECT_TRUE(start.box == sim::Pose{});
        EXPECT_TRUE(start.goal == (sim::Point{1.3, 0.0}));
    }
    EXPECT_GT(at[0], 15);
    EXPECT_GT(at[1], 15);
    PusherParams one;
    one.starts = sim::Starts::one;
    sim::ApproachTask<TypeParam> fixed(one);
    for (std::uint64_t seed = 0; seed < 20; ++seed) EXPECT_GT(fixed.reset(seed).robot.y_m, 0.4);
}

TYPED_TEST(PusherTasks, ApproachEndsInSectorAWithRewardOne) {
    PusherParams params = noiseless();
    params.starts = sim::Starts::one;
    params.start_jitter_m = 0.0;
    params.start_jitter_rad = 0.0;
    params.start_places[0] = {-0.8, 0.4, -sim::pi / 2.0};  // 153.4 deg: sector 150, the edge of A is 165
    sim::ApproachTask<TypeParam> task(params);
    task.reset(1);
    const auto turned = task.step(left);
    EXPECT_FALSE(turned.terminated);
    EXPECT_EQ(turned.reward, 0.0);
    const auto back = task.step({sim::Motion::rotate, -left.amount});
    EXPECT_FALSE(back.terminated);
    const auto arrived = task.step(forward);  // (-0.8, 0.1): 172.9 deg
    EXPECT_TRUE(arrived.terminated);
    EXPECT_FALSE(arrived.truncated);
    EXPECT_EQ(arrived.reward, 1.0);
    EXPECT_NEAR(arrived.observation.robot.y_m, 0.1, 0.005);
}

TYPED_TEST(PusherTasks, ApproachRedrawsStartsInTheGoal) {
    PusherParams params;
    params.start_places[0] = {-0.9, 0.0, 0.0};  // in the middle of A: never a start
    sim::ApproachTask<TypeParam> task(params);
    for (std::uint64_t seed = 0; seed < 30; ++seed) EXPECT_LT(task.reset(seed).robot.y_m, -1.0);
    params.starts = sim::Starts::one;  // nothing else left: an error, no endless loop
    sim::ApproachTask<TypeParam> impossible(params);
    EXPECT_THROW(impossible.reset(1), std::invalid_argument);
}

TYPED_TEST(PusherTasks, TurnStartsInAOutsideBinZeroAndEndsInIt) {
    sim::TurnTask<TypeParam> task;
    bool seen[12] = {};
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        const PusherObservation start = task.reset(seed);
        EXPECT_TRUE(sim::in_push_sector(sim::to_box_frame(start)));
        const std::size_t bin = sspql::index(sim::TurnState::encode(start));
        ASSERT_NE(bin, 0u);
        seen[bin] = true;
    }
    for (std::size_t bin = 1; bin < 12; ++bin) EXPECT_TRUE(seen[bin]) << bin;
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
        std::size_t bin = sspql::index(sim::TurnState::encode(task.reset(seed)));
        for (int i = 0; i < 40 && bin != 0; ++i) {
            const auto step = task.step(left);
            bin = sspql::index(sim::TurnState::encode(step.observation));
            EXPECT_EQ(step.terminated, bin == 0);
            EXPECT_EQ(step.reward, bin == 0 ? 1.0 : 0.0);
        }
        EXPECT_EQ(bin, 0u);  // steps of at most 30 deg +-: none jumps over a bin of 30 deg for 40 times
    }
}

TEST(NoisyActuator, NoiseZeroIsExact) {
    sim::ApproachTask<sim::KinematicBackend> task(noiseless());
    const sim::Pose start = task.reset(3).robot;
    task.step(left);
    EXPECT_EQ(task.last_move().amount, left.amount);
    EXPECT_EQ(task.backend().robot().heading_rad, sim::wrap_angle(start.heading_rad + left.amount));
    task.step({sim::Motion::translate, 0.05});
    EXPECT_EQ(task.last_move().amount, 0.05);
    EXPECT_EQ(task.last_move().stop, sim::Stop::done);
    EXPECT_EQ(task.backend().robot().heading_rad, sim::wrap_angle(start.heading_rad + left.amount));
}

TEST(NoisyActuator, DeviationsAreThoseAskedFor) {
    PusherParams params;
    params.noise = 2.0;  // 10 % of an amount, 4 deg of drift
    params.fence = false;
    params.guard = false;
    sim::KinematicBackend backend(params);
    sim::NoisyActuator actuator(params);
    actuator.reset(1);
    double distance[2] = {0.0, 0.0};  // sums of values and squares
    double angle[2] = {0.0, 0.0};
    double drift[2] = {0.0, 0.0};
    const auto add = [](double(&sums)[2], double value) {
        sums[0] += value;
        sums[1] += value * value;
    };
    constexpr int n = 4000;
    for (int i = 0; i < n; ++i) {
        backend.reset({-1.0, 0.0, 0.0}, {}, {1.3, 0.0});
        add(distance, actuator.execute(backend, {sim::Motion::translate, -0.2}).amount);
        add(drift, backend.robot().heading_rad);
        add(angle, actuator.execute(backend, {sim::Motion::rotate, 0.5}).amount);
    }
    const auto mean = [](const double(&sums)[2]) { return sums[0] / n; };
    const auto deviation = [](const double(&sums)[2]) { return std::sqrt(sums[1] / n - sums[0] / n * (sums[0] / n)); };
    EXPECT_NEAR(mean(distance), -0.2, 0.0015);
    EXPECT_NEAR(deviation(distance), 0.02, 0.001);
    EXPECT_NEAR(mean(angle), 0.5, 0.004);
    EXPECT_NEAR(deviation(angle), 0.05, 0.0025);
    EXPECT_NEAR(mean(drift), 0.0, 0.005);
    EXPECT_NEAR(deviation(drift), sim::from_degrees(4.0), 0.0035);
}

TEST(NoisyActuator, DrawsDoNotDependOnTheOutcome) {
    // One robot stands before a guard, the other is free; then both turn: with the same error.
    PusherParams params;
    sim::KinematicBackend blocked(params);
    sim::KinematicBackend free(params);
    blocked.reset({-0.38, 0.0, 0.0}, {}, {1.3, 0.0});
    free.reset({-1.0, 0.0, sim::pi / 2.0}, {}, {1.3, 0.0});
    sim::NoisyActuator first(params);
    sim::NoisyActuator second(params);
    first.reset(9);
    second.reset(9);
    EXPECT_EQ(first.execute(blocked, forward).amount, 0.0);
    EXPECT_GT(second.execute(free, forward).amount, 0.2);
    EXPECT_EQ(first.execute(blocked, left).amount, second.execute(free, left).amount);
    EXPECT_NE(first.execute(blocked, left).amount, left.amount);
    second.execute(free, {sim::Motion::translate, -0.1});  // one command each: a turn there, a way here
    EXPECT_EQ(first.execute(blocked, left).amount, second.execute(free, left).amount);
}

TEST(PusherTask, RefusesImpossibleParametersAndCommands) {
    PusherParams negative;
    negative.noise = -0.1;
    EXPECT_THROW(sim::ApproachTask<sim::KinematicBackend>{negative}, std::invalid_argument);
    EXPECT_THROW(sim::TurnTask<sim::KinematicBackend>{negative}, std::invalid_argument);
    PusherParams on_box;
    on_box.start_places[0] = {0.1, 0.0, 0.0};
    on_box.starts = sim::Starts::one;
    sim::ApproachTask<sim::KinematicBackend> task(on_box);
    EXPECT_THROW(task.reset(1), std::invalid_argument);
    sim::ApproachTask<sim::KinematicBackend> good;
    good.reset(1);
    EXPECT_THROW(good.step({sim::Motion::translate, std::numeric_limits<double>::infinity()}), std::invalid_argument);
}
