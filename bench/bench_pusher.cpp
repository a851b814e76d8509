// SPDX-License-Identifier: MIT
//
// How fast the box pusher's worlds are: time steps and actions a second with physics, actions a second without, what
// sensors cost, whole missions. CPU time of one thread; targets on a free core: 0.4 M Box2D steps, 15 k Box2D actions
// and 0.8 M kinematic actions a second.

#include <cstddef>
#include <cstdint>

#include <benchmark/benchmark.h>

#include <sspql/core/random.hpp>
#include <sspql/sim/box2d_backend.hpp>
#include <sspql/sim/kinematic_backend.hpp>
#include <sspql/sim/pusher_spaces.hpp>
#include <sspql/sim/pusher_tasks.hpp>
#include <sspql/sim/sensors/sensor_suite.hpp>

namespace {

using namespace sspql;

constexpr int actions_a_world = 200;

sim::PusherParams world(sim::BodyShape shape) {
    sim::PusherParams params;
    params.body.shape = shape;
    return params;
}

/// Random actions of 'approach' near the box; `after(backend)` follows each.
template <class Backend, class After>
void act(Backend& backend, sim::NoisyActuator& actuator, Random& random, After&& after) {
    backend.reset({-1.0, 0.2, 0.0}, {}, {1.3, 0.0});
    for (int i = 0; i < actions_a_world; ++i) {
        const std::size_t action = random.below(sim::ApproachActions::size());
        actuator.execute(backend, sim::ApproachActions::decode(action_id(action)));
        after(backend);
    }
}

template <class Backend, sim::BodyShape shape>
void actions(benchmark::State& state) {
    const sim::PusherParams params = world(shape);
    Backend backend(params);
    sim::NoisyActuator actuator(params);
    Random random(1);
    double done = 0.0;
    for (auto _ : state) {
        act(backend, actuator, random, [](const Backend&) {});
        done += actions_a_world;
    }
    state.counters["actions"] = benchmark::Counter(done, benchmark::Counter::kIsRate);
}

/// The path has a pose for every time step.
void box2d_steps(benchmark::State& state) {
    const sim::PusherParams params = world(sim::BodyShape::circle);
    sim::Box2dBackend backend(params);
    backend.set_path_recording(true);
    sim::NoisyActuator actuator(params);
    Random random(1);
    double steps = 0.0;
    double done = 0.0;
    for (auto _ : state) {
        act(backend, actuator, random, [](const sim::Box2dBackend&) {});
        steps += static_cast<double>(backend.path().size() - 1);
        done += actions_a_world;
    }
    state.counters["steps"] = benchmark::Counter(steps, benchmark::Counter::kIsRate);
    state.counters["steps_an_action"] = steps / done;
}

/// With a look of all sensors (16 sonars, 91 beams, camera) after each action.
template <class Backend>
void sensed_actions(benchmark::State& state) {
    const sim::PusherParams params = world(sim::BodyShape::rectangle);
    Backend backend(params);
    sim::NoisyActuator actuator(params);
    sim::SensorSuite sensors;
    Random random(1);
    double done = 0.0;
    for (auto _ : state) {
        act(backend, actuator, random,
            [&](const Backend& b) { benchmark::DoNotOptimize(sensors.look(sim::scene_of(b))); });
        done += actions_a_world;
    }
    state.counters["actions"] = benchmark::Counter(done, benchmark::Counter::kIsRate);
}

void looks(benchmark::State& state) {
    const sim::KinematicBackend backend(world(sim::BodyShape::rectangle));
    const sim::Scene scene = sim::scene_of(backend);
    sim::SensorSuite sensors;
    for (auto _ : state) benchmark::DoNotOptimize(sensors.look(scene));
    state.counters["rays"] =
        benchmark::Counter(static_cast<double>(state.iterations()) * (sim::SonarRing::count + sim::RangeFinder::count),
                           benchmark::Counter::kIsRate);
}

BENCHMARK(box2d_steps)->Unit(benchmark::kMillisecond);
BENCHMARK(actions<sim::Box2dBackend, sim::BodyShape::circle>)->Unit(benchmark::kMillisecond);
BENCHMARK(actions<sim::Box2dBackend, sim::BodyShape::rectangle>)->Unit(benchmark::kMillisecond);
BENCHMARK(actions<sim::KinematicBackend, sim::BodyShape::circle>);
BENCHMARK(actions<sim::KinematicBackend, sim::BodyShape::rectangle>);
BENCHMARK(sensed_actions<sim::Box2dBackend>)->Unit(benchmark::kMillisecond);
BENCHMARK(sensed_actions<sim::KinematicBackend>);
BENCHMARK(looks);

}  // namespace

BENCHMARK_MAIN();
