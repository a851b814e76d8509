// SPDX-License-Identifier: MIT
#include "experiment/mission_recorder.hpp"

#include <cmath>
#include <cstddef>
#include <optional>

#include <sspql/sim/pusher_spaces.hpp>

namespace sspql::experiment {

namespace {

report::ArenaPose arena_pose(const sim::Pose& pose) { return {pose.x_m, pose.y_m, pose.heading_rad}; }

/// A place of the belief's frame, in the arena's.
std::optional<report::ReplayBelief> arena_belief(const sim::Pose& frame, const std::optional<sim::Landmark>& thing) {
    if (!thing) return std::nullopt;
    const sim::Pose place = sim::from_frame(frame, {thing->place.x_m, thing->place.y_m, 0.0});
    return report::ReplayBelief{place.x_m, place.y_m, std::sqrt(thing->variance_m2)};
}

/// Which action a command is; a translation that was cut short is still the one it was meant to be.
template <class Actions>
int action_of(const sim::PusherCommand& command) {
    for (std::size_t a = 0; a < Actions::size(); ++a) {
        const sim::PusherCommand known = Actions::decode(action_id(a));
        if (known.motion == command.motion && std::signbit(known.amount) == std::signbit(command.amount)) {
            return static_cast<int>(a);
        }
    }
    return -1;
}

double known(double distance) { return std::isfinite(distance) ? distance : -1.0; }

}  // namespace

void MissionRecorder::operator()(const sim::MissionMoment& moment) {
    report::ReplayMoment record;
    record.task = static_cast<int>(moment.task);
    record.attempt = moment.attempt;
    record.robot = arena_pose(moment.scene.robot);
    record.box = {moment.scene.box.centre.x_m, moment.scene.box.centre.y_m, moment.scene.box_heading_rad};
    record.odometry = arena_pose(sim::from_frame(moment.frame, moment.belief.robot()));
    record.box_belief = arena_belief(moment.frame, moment.belief.box());
    record.goal_belief = arena_belief(moment.frame, moment.belief.goal());
    record.box_seen = moment.readings.view.box.has_value();
    record.goal_seen = moment.readings.view.goal.has_value();
    record.sonars_m = moment.readings.sonars;
    if (moment.command != nullptr) add_command(moment, record);
    replay_.goal = {moment.scene.goal.x_m, moment.scene.goal.y_m, 0.0};
    replay_.moments.push_back(std::move(record));
}

void MissionRecorder::add_command(const sim::MissionMoment& moment, report::ReplayMoment& record) const {
    const bool turns = moment.command->motion == sim::Motion::rotate;
    record.command = turns ? 1 : 0;
    record.amount = moment.command->amount;
    const double full = turns ? world_.max_turn_rad_per_s : world_.max_speed_m_per_s;
    record.seconds = std::fabs(record.amount) / full + 0.1;  // to start and to stop
    add_choice(moment, record);
}

void MissionRecorder::add_choice(const sim::MissionMoment& moment, report::ReplayMoment& record) const {
    if (!moment.belief.is_complete()) return;
    const sim::PusherObservation seen = moment.belief.observation();
    if (moment.task == sim::SubTask::approach) {
        const StateId s = sim::ApproachState::encode(seen);
        record.state = static_cast<int>(index(s));
        record.action = action_of<sim::ApproachActions>(*moment.command);
        add_reasons(approach_, s, record);
    } else if (moment.task == sim::SubTask::turn) {
        const StateId s = sim::TurnState::encode(seen);
        record.state = static_cast<int>(index(s));
        record.action = action_of<sim::TurnActions>(*moment.command);
        add_reasons(turn_, s, record);
    }
}

void MissionRecorder::add_reasons(const AnyLearner& learner, StateId s, report::ReplayMoment& record) const {
    const Explanation why = learner.explain(s);
    record.to_go = known(why.distance);
    replay_.to_go_in_steps = why.distance_in_steps;
    for (const ActionExplanation& a : why.actions) {
        report::ReplayTerms terms{a.terms.q, a.terms.ssp, a.terms.exploration + a.terms.hint, a.terms.n};
        if (a.likely != no_state) terms.next = static_cast<int>(index(a.likely));
        terms.to_go = known(a.distance);
        record.terms.push_back(terms);
    }
}

}  // namespace sspql::experiment
