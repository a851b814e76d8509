// SPDX-License-Identifier: MIT
#include <sspql/sim/mission/mission.hpp>

#include <array>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include <sspql/core/random.hpp>
#include <sspql/learn/adaptive_sspql.hpp>
#include <sspql/sim/box2d_backend.hpp>
#include <sspql/sim/kinematic_backend.hpp>

namespace sim = sspql::sim;
using sim::MissionResult;
using sim::Outcome;
using sim::PusherCommand;
using sim::PusherObservation;
using sim::SubTask;

namespace {

/// A learner over states of the pusher, as an agent.
template <class States, class Actions>
class Learning {
public:
    explicit Learning(std::uint64_t seed) : learner_(States::size(), Actions::size(), {}, seed) {}

    PusherCommand begin(const PusherObservation& seen) { return Actions::decode(learner_.begin(States::encode(seen))); }
    PusherCommand step(double reward, const PusherObservation& seen) {
        return Actions::decode(learner_.step(reward, States::encode(seen)));
    }
    void end(double reward, const PusherObservation& seen, bool terminated) {
        learner_.end(reward, States::encode(seen), terminated);
        ++episodes;
        arrivals += terminated ? 1 : 0;
    }
    void abort() noexcept { learner_.abort(); }

    int episodes = 0;
    int arrivals = 0;

private:
    sspql::AdaptiveSspql<> learner_;
};

using Approach = Learning<sim::ApproachState, sim::ApproachActions>;
using Turn = Learning<sim::TurnState, sim::TurnActions>;

/// Does the same for ever.
struct Stubborn {
    PusherCommand command{sim::Motion::rotate, 0.5};
    int aborts = 0;
    PusherCommand begin(const PusherObservation&) const { return command; }
    PusherCommand step(double, const PusherObservation&) const { return command; }
    void end(double, const PusherObservation&, bool) const {}
    void abort() noexcept { ++aborts; }
};

sim::PusherParams world() {
    sim::PusherParams params;
    params.body.shape = sim::BodyShape::rectangle;
    return params;
}

/// Ready to push: behind the box, looking along its way.
sim::MissionStart ready() { return {{-1.0, 0.0, 0.0}, {0.0, 0.0, 0.3}, {1.5, 0.0}}; }

sim::MissionParams truth() {
    sim::MissionParams rules;
    rules.sensing = sim::Sensing::truth;
    return rules;
}

}  // namespace

TEST(Mission, PushesStraightAwayWhenItStandsRight) {
    sim::Mission<sim::Box2dBackend> mission(world(), {}, truth());
    Stubborn nobody;
    const MissionResult result = mission.run(ready(), 1, nobody, nobody);
    EXPECT_TRUE(result.in_goal && result.first_push && result.believed);
    EXPECT_EQ(result.of(SubTask::search).actions, 0);
    EXPECT_EQ(result.of(SubTask::approach).attempts, 0);
    EXPECT_EQ(result.of(SubTask::turn).attempts, 0);
    EXPECT_EQ(result.of(SubTask::push).successes, 1);
    EXPECT_GT(result.driven_s, 3.0);  // a metre and a half and back at 0.4 m/s
}

TEST(Mission, TimesOutWithAReason) {
    sim::MissionParams rules = truth();
    rules.pushes = 2;
    rules.approach_actions = 7;
    sim::Mission<sim::Box2dBackend> mission(world(), {}, rules);
    Stubborn nobody;
    sim::MissionStart start = ready();
    start.robot = {1.0, 1.0, 0.0};
    MissionResult result = mission.run(start, 1, nobody, nobody);
    EXPECT_FALSE(result.in_goal || result.believed);
    EXPECT_EQ(result.end, Outcome::approach_timeout);
    EXPECT_EQ(result.ends[static_cast<std::size_t>(Outcome::approach_timeout)], 2);
    EXPECT_EQ(result.of(SubTask::approach).attempts, 2);
    EXPECT_EQ(result.of(SubTask::approach).successes, 0);
    EXPECT_EQ(result.of(SubTask::approach).actions, 14);
    // On the kinematic backend the box cannot be pushed: the push says so.
    sim::Mission<sim::KinematicBackend> immovable(world(), {}, rules);
    result = immovable.run(ready(), 1, nobody, nobody);
    EXPECT_EQ(result.end, Outcome::push_stuck);
    EXPECT_FALSE(result.in_goal);
}

TEST(Mission, SaysWhenTheBoxIsWhereNothingGetsBehindIt) {
    sim::MissionParams rules = truth();
    rules.pushes = 1;
    rules.approach_actions = 3;
    sim::Mission<sim::KinematicBackend> mission(world(), {}, rules);
    Stubborn nobody;
    const MissionResult cornered = mission.run({{1.2, 1.0, 0.0}, {2.3, 0.0, 0.0}, {0.0, 0.0}}, 1, nobody, nobody);
    EXPECT_EQ(cornered.end, Outcome::approach_timeout);
    EXPECT_TRUE(cornered.cornered);
    const MissionResult free = mission.run({{1.2, 1.0, 0.0}, {1.5, 0.0, 0.0}, {0.0, 0.0}}, 1, nobody, nobody);
    EXPECT_EQ(free.end, Outcome::approach_timeout);
    EXPECT_FALSE(free.cornered);
}

TEST(Mission, ABoxSeenInTheGoalNeedsNoPush) {
    sim::Mission<sim::Box2dBackend> mission(world());
    Stubborn nobody;
    const MissionResult result = mission.run({{-1.0, 0.0, 2.0}, {0.05, 0.0, 0.3}, {0.0, 0.0}}, 1, nobody, nobody);
    EXPECT_TRUE(result.in_goal && result.believed);
    EXPECT_FALSE(result.first_push);
    EXPECT_EQ(result.of(SubTask::push).attempts, 0);
    EXPECT_GT(result.of(SubTask::search).actions, 0);
}

TEST(Mission, ASearchThatFindsNothingTimesOut) {
    sim::SensorParams blind;
    blind.camera_field_rad = sim::from_degrees(1.0);
    sim::MissionParams rules;
    rules.search_actions = 5;
    rules.pushes = 1;
    sim::Mission<sim::Box2dBackend> mission(world(), blind, rules);
    Stubborn nobody;
    sim::MissionStart start = ready();
    start.robot.heading_rad = 2.0;
    const MissionResult result = mission.run(start, 1, nobody, nobody);
    EXPECT_EQ(result.end, Outcome::search_timeout);
    EXPECT_EQ(result.of(SubTask::search).actions, 5);
}

TEST(Mission, ObserverSeesEveryActionAndTheEnd) {
    sim::Mission<sim::Box2dBackend> mission(world());
    Approach approach(1);
    Turn turn(1);
    int actions = 0;
    int ends = 0;
    bool complete = false;
    sim::MissionStart start = ready();
    start.robot = {-1.5, 1.5, 2.0};
    const MissionResult result = mission.run(start, 3, approach, turn, [&](const sim::MissionMoment& moment) {
        (moment.command != nullptr ? actions : ends) += 1;
        if (actions == 1) {
            EXPECT_EQ(moment.task, SubTask::search);
            EXPECT_FALSE(moment.belief.is_complete());  // it starts knowing nothing
            EXPECT_TRUE(moment.belief.robot() == sim::Pose{});
            EXPECT_NEAR(moment.frame.x_m, -1.5, 1e-6);
        }
        complete = moment.belief.is_complete();
        if (moment.task == SubTask::push && moment.belief.is_complete()) {
            const sim::Point box = moment.belief.box()->place;
            const sim::Pose believed = sim::from_frame(moment.frame, {box.x_m, box.y_m, 0.0});
            EXPECT_LT(sim::distance_m(sim::position(believed), moment.scene.box.centre), 0.35);
        }
    });
    int total = 0;
    for (const sim::SubTaskTally& tally : result.tasks) total += tally.actions;
    EXPECT_EQ(actions, total);
    EXPECT_EQ(ends, 1);
    EXPECT_TRUE(complete);
    EXPECT_EQ(approach.episodes, result.of(SubTask::approach).attempts);
    EXPECT_EQ(approach.arrivals, result.of(SubTask::approach).successes);
}

TEST(Mission, SameSeedSameMissionInAUsedAndInANewObject) {
    sim::Mission<sim::Box2dBackend> used(world());
    const auto poses = [](sim::Mission<sim::Box2dBackend>& mission, std::uint64_t seed) {
        Approach approach(seed);
        Turn turn(seed);
        sspql::Random random(seed);
        const sim::MissionStart start = sim::random_mission_start(world(), random);
        std::vector<sim::Pose> seen;
        mission.run(start, seed, approach, turn,
                    [&](const sim::MissionMoment& moment) { seen.push_back(moment.scene.robot); });
        seen.push_back(mission.backend().box());
        return seen;
    };
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
        sim::Mission<sim::Box2dBackend> fresh(world());
        EXPECT_TRUE(poses(used, seed) == poses(fresh, seed)) << seed;
    }
    EXPECT_FALSE(poses(used, 1) == poses(used, 2));
}

TEST(Mission, AgentsThatThrowAreAborted) {
    struct Throwing : Stubborn {
        PusherCommand step(double, const PusherObservation&) const { throw std::runtime_error("no"); }
    };
    sim::Mission<sim::Box2dBackend> mission(world(), {}, truth());
    Throwing agent;
    sim::MissionStart start = ready();
    start.robot = {1.0, 1.0, 0.0};
    EXPECT_THROW(mission.run(start, 1, agent, agent), std::runtime_error);
    EXPECT_EQ(agent.aborts, 1);
}

TEST(Mission, RefusesImpossibleRules) {
    sim::MissionParams none;
    none.pushes = 0;
    EXPECT_THROW(sim::Mission<sim::Box2dBackend>(world(), {}, none), std::invalid_argument);
    sim::SensorParams negative;
    negative.noise = -1.0;
    EXPECT_THROW(sim::Mission<sim::Box2dBackend>(world(), negative), std::invalid_argument);
}

/// Untrained learners: even learning as they go they deliver most boxes.
TEST(MissionSlow, DeliversMostBoxesFromNothing) {
    sim::Mission<sim::Box2dBackend> mission(world());
    Approach approach(1);
    Turn turn(1);
    int delivered = 0;
    constexpr int missions = 40;
    for (std::uint64_t k = 0; k < missions; ++k) {
        sspql::Random random(1, 5000 + k);
        const sim::MissionStart start = sim::random_mission_start(world(), random);
        delivered += mission.run(start, k, approach, turn).in_goal ? 1 : 0;
    }
    EXPECT_GE(delivered, 34) << "of " << missions;
}
