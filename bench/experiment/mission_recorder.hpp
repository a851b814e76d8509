// SPDX-License-Identifier: MIT
#pragma once

#include <sspql/sim/mission/mission.hpp>

#include "experiment/any_learner.hpp"
#include "report/mission_replay.hpp"

namespace sspql::experiment {

/// Writes down a mission as it goes: an observer of sim::Mission.
class MissionRecorder {
public:
    MissionRecorder(const sim::PusherParams& world, const AnyLearner& approach, const AnyLearner& turn,
                    report::MissionReplay& replay)
        : world_(world), approach_(approach), turn_(turn), replay_(replay) {}

    void operator()(const sim::MissionMoment& moment);

private:
    void add_command(const sim::MissionMoment& moment, report::ReplayMoment& record) const;
    void add_choice(const sim::MissionMoment& moment, report::ReplayMoment& record) const;
    void add_reasons(const AnyLearner& learner, StateId s, report::ReplayMoment& record) const;

    const sim::PusherParams& world_;
    const AnyLearner& approach_;
    const AnyLearner& turn_;
    report::MissionReplay& replay_;
};

}  // namespace sspql::experiment
