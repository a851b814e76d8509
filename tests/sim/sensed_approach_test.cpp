// SPDX-License-Identifier: MIT
#include <sspql/sim/mission/sensed_approach.hpp>

#include <cmath>
#include <cstdint>

#include <gtest/gtest.h>

#include <sspql/core/random.hpp>
#include <sspql/env/environment.hpp>
#include <sspql/sim/box2d_backend.hpp>
#include <sspql/sim/kinematic_backend.hpp>

namespace sim = sspql::sim;

namespace {

template <class Task>
double walk(Task& task, std::uint64_t seed, int steps) {
    task.reset(seed);
    sspql::Random random(seed);
    double sum = 0.0;
    for (int i = 0; i < steps; ++i) {
        const auto step = task.step(sim::ApproachActions::decode(sspql::action_id(random.below(4))));
        sum += step.observation.robot.x_m + 3.0 * step.observation.box.y_m;
        if (step.terminated) break;
    }
    return sum;
}

}  // namespace

TEST(SensedApproach, IsAnEnvironmentAndReproducible) {
    using Task = sim::SensedApproachTask<sim::KinematicBackend>;
    static_assert(sspql::is_environment_v<Task, sim::PusherCommand>);
    Task used;
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
        Task fresh;
        EXPECT_EQ(walk(used, seed, 100), walk(fresh, seed, 100)) << seed;
    }
}

TEST(SensedApproach, WithoutNoiseItSeesWhatIs) {
    sim::PusherParams params;
    params.noise = 0.0;
    sim::SensorParams sensors;
    sensors.noise = 0.0;
    sim::SensedApproachTask<sim::KinematicBackend> task(params, sensors);
    task.reset(1);
    sspql::Random random(1);
    for (int i = 0; i < 60; ++i) {
        const auto step = task.step(sim::ApproachActions::decode(sspql::action_id(random.below(4))));
        const sim::Pose truth = task.task().backend().robot();
        EXPECT_NEAR(step.observation.robot.x_m, truth.x_m, 1e-9) << i;
        EXPECT_NEAR(step.observation.robot.y_m, truth.y_m, 1e-9) << i;
        // The box's middle is guessed from what the range finder meets: 2 cm.
        EXPECT_LT(sim::distance_m(sim::position(step.observation.box), {}), 0.045) << i;
        if (step.terminated) break;
    }
}

TEST(SensedApproach, OdometryDriftsAndSightKeepsTheBox) {
    sim::SensorParams sensors;
    sensors.noise = 2.0;
    sim::SensedApproachTask<sim::Box2dBackend> task(sim::PusherParams{}, sensors);
    double drift = 0.0;
    double error = 0.0;
    int walks = 0;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        walk(task, seed, 150);
        const sim::Pose truth = task.task().backend().robot();
        const sim::Pose believed = task.belief().robot();
        drift += sim::distance_m(sim::position(truth), sim::position(believed));
        if (!task.belief().box()) continue;
        // Relative to the robot: what its decisions rest on.
        const sim::Point box = sim::position(task.task().backend().box());
        const double range = sim::distance_m(sim::position(truth), box);
        const double believed_range = sim::distance_m(sim::position(believed), task.belief().box()->place);
        error += std::fabs(range - believed_range);
        ++walks;
    }
    EXPECT_GT(drift / 20.0, 0.03);
    ASSERT_GT(walks, 15);
    EXPECT_LT(error / walks, 0.2);
}
