// SPDX-License-Identifier: MIT
#include "report/mission_replay.hpp"

#include <cmath>

#include <nlohmann/json.hpp>

#include "report/numbers.hpp"

namespace sspql::report {

namespace {

/// Whole numbers between commas; no spaces.
class Row {
public:
    void add(double value, double unit) {
        const double scaled = std::isfinite(value) ? std::round(value / unit) : 0.0;
        text_ += (text_.empty() ? "" : ",") + fixed_text(scaled, 0);
    }

    void add(int value) { add(static_cast<double>(value), 1.0); }

    void add(const ArenaPose& pose) {
        add(pose.x_m, 1e-3);
        add(pose.y_m, 1e-3);
        add(pose.heading_rad, 1e-3);
    }

    void add(const std::optional<ReplayBelief>& belief) {
        add(belief ? belief->x_m : 0.0, 1e-3);
        add(belief ? belief->y_m : 0.0, 1e-3);
        add(belief ? belief->deviation_m : -1e-3, 1e-3);  // -1: nothing is believed
    }

    [[nodiscard]] std::string text() const { return "[" + text_ + "]"; }

private:
    std::string text_;
};

/// The order is the script's: see its function `moment`.
std::string moment_json(const ReplayMoment& moment) {
    Row row;
    row.add(moment.task);
    row.add(moment.attempt);
    row.add(moment.robot);
    row.add(moment.box);
    row.add(moment.odometry);
    row.add(moment.box_belief);
    row.add(moment.goal_belief);
    row.add((moment.box_seen ? 1 : 0) + (moment.goal_seen ? 2 : 0));
    row.add(moment.seconds, 1e-3);
    row.add(moment.command);
    row.add(moment.amount, 1e-3);
    row.add(moment.state);
    row.add(moment.action);
    row.add(moment.to_go, 1e-3);
    for (const double sonar : moment.sonars_m) row.add(sonar, 1e-2);
    for (const ReplayTerms& terms : moment.terms) {
        row.add(terms.q, 1e-3);
        row.add(terms.ssp, 1e-3);
        row.add(terms.exploration, 1e-3);
        row.add(std::fmin(terms.tries, 1e6), 1.0);
        row.add(terms.next);
        row.add(terms.to_go, 1e-3);
    }
    return row.text();
}

/// JSON text in which no "</script" can stand.
std::string dumped(const nlohmann::ordered_json& value) {
    std::string text = value.dump(-1, ' ', true, nlohmann::ordered_json::error_handler_t::replace);
    for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at)) {
        text.replace(at, 1, "\\u003c");
    }
    return text;
}

}  // namespace

std::string replay_json(const ReplayStage& stage, const std::vector<MissionReplay>& replays) {
    const nlohmann::ordered_json common = {
        {"half", stage.half_width_m},      {"length", stage.robot_length_m},     {"width", stage.robot_width_m},
        {"box", stage.box_side_m},         {"goal", stage.goal_radius_m},        {"field", stage.camera_field_rad},
        {"sonars", stage.sonar_offsets_m}, {"approach", stage.approach_actions}, {"turn", stage.turn_actions}};
    std::string out = "{\"stage\":" + dumped(common) + ",\"missions\":[";
    for (std::size_t i = 0; i < replays.size(); ++i) {
        const MissionReplay& replay = replays[i];
        const nlohmann::ordered_json head = {{"n", replay.number},
                                             {"outcome", replay.outcome},
                                             {"won", replay.in_goal},
                                             {"first", replay.first_push},
                                             {"unit", replay.to_go_in_steps ? "steps" : "of cost"},
                                             {"goal", {replay.goal.x_m, replay.goal.y_m}}};
        std::string text = dumped(head);
        text.pop_back();
        out += (i == 0 ? "\n" : ",\n") + text + ",\"moments\":[\n";
        for (std::size_t m = 0; m < replay.moments.size(); ++m) {
            out += (m == 0 ? "" : ",\n") + moment_json(replay.moments[m]);
        }
        out += "]}";
    }
    return out + "]}\n";
}

}  // namespace sspql::report
