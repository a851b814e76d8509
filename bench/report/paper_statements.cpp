// SPDX-License-Identifier: MIT
#include "report/paper_statements.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>

#include <nlohmann/json.hpp>

#include "report/numbers.hpp"
#include "report/paper_reference.hpp"

namespace sspql::report {

namespace {

constexpr double constant_factor = 3.0;  // "many times"
constexpr double least_pace = 0.5;       // after a wall moved, of the pace before

std::string with_error(const Summary& summary, int digits) {
    std::string text = fixed_text(summary.mean, digits);
    if (summary.count > 1) text += " \u00b1 " + fixed_text(summary.error, digits);
    return text;
}

/// "dyna-q:20 1033 ± 9"
std::string named(const std::string& name, const Summary& summary, int digits) {
    return "`" + name + "` " + with_error(summary, digits);
}

/// Every learner of a family (dyna-q with whatever k).
std::vector<const LearnerStatistics*> members(const RecordedPhase& phase, std::string_view family) {
    std::vector<const LearnerStatistics*> found;
    for (const LearnerStatistics& learner : phase.learners) {
        if (learner.name == family || family_of(learner.name) == family) found.push_back(&learner);
    }
    return found;
}

Finding missing(const Place& place, const std::string& what) {
    return {place.name, what + " is not in the recorded run", {}};
}

/// Sums over fewer than 30 episodes, or over as many as fitted into a number of steps, mean something else.
const Summary& first_steps(const LearnerStatistics& learner) { return learner.first30_steps; }

Finding fewer_steps(const Place& place, const LearnerStatistics& a, const LearnerStatistics& b) {
    return {place.name, named(a.name, first_steps(a), 0) + ", " + named(b.name, first_steps(b), 0),
            is_less(first_steps(a), first_steps(b))};
}

/// At every place: a needs fewer steps than each member of b's family.
Statement fewer_steps(const std::string& claim, const std::vector<Place>& places, const std::string& a,
                      const std::string& b) {
    Statement statement{claim, {}};
    for (const Place& place : places) {
        const LearnerStatistics* first = place.phase->find(a);
        const auto rivals = members(*place.phase, b);
        if (first == nullptr || rivals.empty()) {
            statement.findings.push_back(missing(place, "`" + (first == nullptr ? a : b) + "`"));
            continue;
        }
        for (const LearnerStatistics* rival : rivals) {
            if (rival != first) statement.findings.push_back(fewer_steps(place, *first, *rival));
        }
    }
    return statement;
}

bool is_ssp_family(const std::string& name) {
    const std::string_view family = family_of(name);
    return family.substr(0, 3) == "ssp";
}

/// Against whoever of the others needed the fewest steps.
Statement fewest_steps(const std::string& claim, const std::vector<Place>& places, const std::string& a,
                       bool (*is_rival)(const std::string&)) {
    Statement statement{claim, {}};
    for (const Place& place : places) {
        const LearnerStatistics* first = place.phase->find(a);
        const LearnerStatistics* best = nullptr;
        for (const LearnerStatistics& learner : place.phase->learners) {
            if (!is_rival(learner.name) || &learner == first) continue;
            if (best == nullptr || first_steps(learner).mean < first_steps(*best).mean) best = &learner;
        }
        if (first == nullptr || best == nullptr) {
            statement.findings.push_back(missing(place, first == nullptr ? "`" + a + "`" : "another learner"));
        } else {
            statement.findings.push_back(fewer_steps(place, *first, *best));
        }
    }
    return statement;
}

std::vector<Place> filtered(const std::vector<Place>& places, bool after_change) {
    std::vector<Place> some;
    for (const Place& place : places) {
        if (place.after_change == after_change) some.push_back(place);
    }
    return some;
}

double slip_of(const RecordedRun& run) {
    const std::string text = run.setting("slip");
    double slip = 0.1;  // the chain's, if none is given
    std::from_chars(text.data(), text.data() + text.size(), slip);
    return slip;
}

/// The steps in units of the fewest possible.
std::optional<Summary> relative_steps(const RecordedPhase& phase, const LearnerStatistics& learner) {
    if (!phase.optimal_steps || learner.episodes == 0) return std::nullopt;
    const double least = *phase.optimal_steps * static_cast<double>(std::min<std::size_t>(30, learner.episodes));
    Summary scaled = learner.first30_steps;
    scaled.mean /= least;
    scaled.error /= least;
    scaled.deviation /= least;
    return scaled;
}

/// More steps, relative to the fewest possible, on each chain with cycles than on the first one without.
Statement slowed_by_cycles(const std::string& claim, const std::vector<Place>& chains, const std::string& family) {
    Statement statement{claim, {}};
    const auto sure = std::find_if(chains.begin(), chains.end(), [](const Place& p) { return slip_of(*p.run) == 0.0; });
    for (const Place& place : chains) {
        if (slip_of(*place.run) == 0.0) continue;
        const auto learners = members(*place.phase, family);
        if (learners.empty()) statement.findings.push_back(missing(place, "`" + family + "`"));
        for (const LearnerStatistics* learner : learners) {
            const LearnerStatistics* other = sure == chains.end() ? nullptr : sure->phase->find(learner->name);
            const auto with = relative_steps(*place.phase, *learner);
            const auto without = other == nullptr ? std::nullopt : relative_steps(*sure->phase, *other);
            if (!with || !without) {
                statement.findings.push_back(missing(place, "`" + learner->name + "` on the chain without cycles"));
                continue;
            }
            statement.findings.push_back({place.name,
                                          "`" + learner->name + "`, steps / fewest possible: " + with_error(*with, 2) +
                                              " with cycles, " + with_error(*without, 2) + " without",
                                          is_greater(*with, *without)});
        }
    }
    return statement;
}

Statement more_reward(const std::string& claim, const std::vector<Place>& mazes, const std::string& a,
                      const std::string& b) {
    Statement statement{claim, {}};
    for (const Place& place : mazes) {
        const LearnerStatistics* first = place.phase->find(a);
        const auto rivals = members(*place.phase, b);
        if (first == nullptr || rivals.empty()) {
            statement.findings.push_back(missing(place, "`" + (first == nullptr ? a : b) + "`"));
            continue;
        }
        for (const LearnerStatistics* rival : rivals) {
            if (first->cumulative_reward.empty() || rival->cumulative_reward.empty()) {
                statement.findings.push_back(fewer_steps(place, *first, *rival));
                continue;
            }
            const Summary mine = first->cumulative_reward.back().reward;
            const Summary theirs = rival->cumulative_reward.back().reward;
            statement.findings.push_back({place.name,
                                          "reward by step " + std::to_string(first->cumulative_reward.back().step) +
                                              ": " + named(a, mine, 1) + ", " + named(rival->name, theirs, 1),
                                          is_greater(mine, theirs)});
        }
    }
    return statement;
}

/// When the wall of a built-in maze moves; 0 for none.
std::uint64_t change_step(const std::string& maze) {
    return maze == "blocking-maze" ? 1000 : maze == "shortcut-maze" ? 3000 : 0;
}

/// Reward per 1000 steps from one report point to another; their errors are taken as independent.
Summary pace(const RewardPoint& from, const RewardPoint& to) {
    const double thousands = static_cast<double>(to.step - from.step) / 1000.0;
    Summary summary;
    summary.count = std::max(from.reward.count, to.reward.count);
    summary.mean = (to.reward.mean - from.reward.mean) / thousands;
    summary.error = std::hypot(to.reward.error, from.reward.error) / thousands;
    return summary;
}

Statement keeps_pace(const std::string& claim, const std::vector<Place>& mazes, const std::string& name) {
    Statement statement{claim, {}};
    for (const Place& place : mazes) {
        const std::uint64_t change = change_step(place.phase->name);
        if (change == 0) continue;
        const LearnerStatistics* learner = place.phase->find(name);
        const RewardPoint* before = nullptr;
        if (learner != nullptr) {
            for (const RewardPoint& point : learner->cumulative_reward) {
                if (point.step == change) before = &point;
            }
        }
        if (before == nullptr || before == &learner->cumulative_reward.back()) {
            statement.findings.push_back(
                missing(place, learner == nullptr ? "`" + name + "`" : "the reward before and after the change"));
            continue;
        }
        const Summary first = pace({}, *before);
        const Summary then = pace(*before, learner->cumulative_reward.back());
        statement.findings.push_back({place.name,
                                      "`" + name + "`, reward per 1000 steps: " + with_error(first, 1) + " before, " +
                                          with_error(then, 1) + " after",
                                      is_multiple(then, first, least_pace)});
    }
    return statement;
}

// ---- cost ---------------------------------------------------------------------------------------------------------

struct Effort {
    double episodes = 0.0;
    double steps = 0.0;
    double operations = 0.0;
    double ns_per_step = std::numeric_limits<double>::quiet_NaN();
};

/// A learner's, mean over seeds, summed over the run's phases.
Effort effort_of(const RecordedRun& run, const std::string& name) {
    Effort effort;
    for (const RecordedPhase& phase : run.phases) {
        const LearnerStatistics* learner = phase.find(name);
        if (learner == nullptr) continue;
        effort.episodes += static_cast<double>(learner->episodes);
        effort.steps += learner->total_steps.mean;
        effort.operations += learner->total_steps.mean * learner->model_ops_per_step;
        effort.ns_per_step = learner->learn_ns_per_step;
    }
    return effort;
}

/// "`dyna-q:20` (k = 20): 17.2 steps per episode, 21.0 operations and 300 ns per step"
std::string effort_text(const RecordedRun& run, const std::string& name, bool plans) {
    const Effort effort = effort_of(run, name);
    return "`" + name + "`" + (plans ? " (k = " + planning_steps(run, name) + ")" : "") + ": " +
           fixed_text(effort.steps / effort.episodes, 1) + " steps per episode, " +
           fixed_text(effort.operations / effort.steps, 1) + " operations and " + fixed_text(effort.ns_per_step, 0) +
           " ns per step";
}

/// Sums over the same seeds: there is no error to judge by.
Contest plainly_less(double a, double b) {
    Contest contest;
    contest.ratio = a / b;
    contest.ratio_error = std::numeric_limits<double>::quiet_NaN();
    contest.z = std::numeric_limits<double>::quiet_NaN();
    contest.verdict = !std::isfinite(contest.ratio) ? Verdict::missing
                      : a < b                       ? Verdict::holds
                      : a > b                       ? Verdict::fails
                                                    : Verdict::open;
    return contest;
}

bool has_bonus(const std::string& name) {
    const std::string_view family = family_of(name);
    return family.size() > 6 && family.substr(family.size() - 6) == "-bonus";
}

/// SSPQL with a bonus for rivals with one, without for those without; else the other.
const LearnerStatistics* sspql_like(const RecordedPhase& phase, const std::string& rival) {
    const LearnerStatistics* plain = phase.find("sspql");
    const LearnerStatistics* bonus = phase.find("sspql-bonus");
    if (has_bonus(rival)) return bonus != nullptr ? bonus : plain;
    return plain != nullptr ? plain : bonus;
}

bool is_planner(const std::string& name) {
    const std::string_view family = family_of(name);
    return family.substr(0, 6) == "dyna-q" || family == "ps" || family.substr(0, 3) == "ps-";
}

bool is_not_ours(const std::string& name) { return !is_ssp_family(name) && family_of(name) != "adaptive"; }
bool is_anyone(const std::string&) { return true; }

std::string label_of(const std::vector<RecordedRun>& runs, std::size_t i) {
    return runs.size() > 1 ? " (run " + std::to_string(i + 1) + ")" : "";
}

std::vector<std::string> assignments_of(const RecordedRun& run) {
    const auto json = nlohmann::ordered_json::parse(run.setting("set"), nullptr, false);
    std::vector<std::string> assignments;
    if (!json.is_array()) return assignments;
    for (const auto& entry : json) {
        if (entry.is_string()) assignments.push_back(entry.get<std::string>());
    }
    return assignments;
}

}  // namespace

std::string planning_steps(const RecordedRun& run, const std::string& learner) {
    std::string k = "10";
    const std::size_t colon = learner.find(':');
    if (colon != std::string::npos) k = learner.substr(colon + 1);
    for (const std::string& assignment : assignments_of(run)) {
        const std::size_t equals = assignment.find('=');
        const std::string target = assignment.substr(0, equals);
        if (equals != std::string::npos && (target == learner + ".k" || target == "*.k")) {
            k = assignment.substr(equals + 1);
        }
    }
    return k;
}

double steps_per_episode(const RecordedRun& run, const std::string& learner) {
    const Effort effort = effort_of(run, learner);
    return effort.steps / effort.episodes;
}

TaskKind kind_of(const RecordedRun& run, const RecordedPhase& phase) {
    if (run.experiment == "pusher_experiment") {
        return run.setting("task") == "turn" ? TaskKind::turn : TaskKind::approach;
    }
    if (!run.setting("table").empty()) return TaskKind::other;
    if (phase.name == "chain") return TaskKind::chain;
    for (const char* maze : {"dyna-maze", "blocking-maze", "shortcut-maze"}) {
        if (phase.name == maze) return TaskKind::maze;
    }
    if (phase.name == "cliff") return TaskKind::other;
    // Counted in steps, sums of first episodes say nothing.
    for (const LearnerStatistics& learner : phase.learners) {
        if (!learner.cumulative_reward.empty()) return TaskKind::other;
    }
    return TaskKind::grid;
}

std::vector<Place> places_of(const std::vector<RecordedRun>& runs, TaskKind kind) {
    std::vector<Place> places;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        for (std::size_t p = 0; p < runs[i].phases.size(); ++p) {
            const RecordedPhase& phase = runs[i].phases[p];
            if (kind_of(runs[i], phase) != kind) continue;
            std::string name = phase.name;
            if (kind == TaskKind::chain) name += ", p = " + short_text(1.0 - slip_of(runs[i]), 3);
            places.push_back({&runs[i], &phase, name + label_of(runs, i), p > 0});
        }
    }
    return places;
}

ComparisonSection scratch_section(const std::vector<Place>& grids) {
    const std::vector<Place> places = filtered(grids, false);
    return {
        "From scratch (Fig. 5a)",
        "The paper: SSPQL shows a faster convergence rate than Q-learning and prioritized sweeping. It does not say "
        "whether the others had its exploration bonus; equal chances mean that both have it or neither.",
        {fewer_steps("SSPQL needs fewer steps than Q-learning, neither with a bonus", places, "sspql", "q"),
         fewer_steps("SSPQL needs fewer steps than Q-learning, both with the bonus", places, "sspql-bonus", "q-bonus"),
         fewer_steps("SSPQL needs fewer steps than prioritized sweeping, neither with a bonus", places, "sspql", "ps"),
         fewer_steps("SSPQL needs fewer steps than prioritized sweeping, both with the bonus", places, "sspql-bonus",
                     "ps-bonus"),
         fewer_steps("SSPQL with the bonus needs fewer steps than Q-learning without (unequal chances)", places,
                     "sspql-bonus", "q"),
         fewer_steps("SSPQL with the bonus needs fewer steps than prioritized sweeping without (unequal chances)",
                     places, "sspql-bonus", "ps")}};
}

ComparisonSection change_section(const std::vector<Place>& grids) {
    const std::vector<Place> places = filtered(grids, true);
    const auto slower = [&](const std::string& claim, const std::string& a, const std::string& b) {
        // "a is slower than b" is "b needs fewer steps than a".
        return fewer_steps(claim, places, b, a);
    };
    ComparisonSection section{
        "After the map changed (Fig. 5b, c)",
        "The paper: with what was learnt on another map, prioritized sweeping is slower than SSPQL and Q-learning, "
        "because the model it has learnt hinders it; SSPQL is best. Its own maps are lost: ours have their sizes.",
        {slower("Prioritized sweeping is slower than Q-learning, neither with a bonus", "ps", "q"),
         slower("Prioritized sweeping is slower than Q-learning, both with the bonus", "ps-bonus", "q-bonus"),
         fewer_steps("SSPQL needs fewer steps than Q-learning, neither with a bonus", places, "sspql", "q"),
         fewer_steps("SSPQL needs fewer steps than Q-learning, both with the bonus", places, "sspql-bonus", "q-bonus"),
         fewer_steps("SSPQL needs fewer steps than prioritized sweeping, neither with a bonus", places, "sspql", "ps"),
         fewer_steps("SSPQL needs fewer steps than prioritized sweeping, both with the bonus", places, "sspql-bonus",
                     "ps-bonus"),
         fewer_steps("SSPQL needs fewer steps than Dyna-Q, both with the bonus", places, "sspql-bonus", "dyna-q-bonus"),
         fewer_steps("SSPQL with the bonus needs fewer steps than optimistic Q-learning", places, "sspql-bonus",
                     "q-optimistic"),
         fewer_steps("SSPQL with the bonus needs fewer steps than optimistic prioritized sweeping that forgets", places,
                     "sspql-bonus", "ps-optimistic"),
         fewest_steps("SSPQL with the bonus is best: fewer steps than the best learner that is not ours", places,
                      "sspql-bonus", is_not_ours)}};
    return section;
}

ComparisonSection constant_section(const std::vector<Place>& grids) {
    const std::vector<Place> places = filtered(grids, true);
    const std::string factor = fixed_text(constant_factor, 0);
    const auto many_times = [&](const std::string& claim, const std::string& rival) {
        Statement statement{claim, {}};
        for (const Place& place : places) {
            const LearnerStatistics* constant = place.phase->find("sspql-constant");
            const LearnerStatistics* other = place.phase->find(rival);
            if (constant == nullptr || other == nullptr) {
                statement.findings.push_back(
                    missing(place, "`" + (constant == nullptr ? std::string("sspql-constant") : rival) + "`"));
                continue;
            }
            statement.findings.push_back({place.name,
                                          named(constant->name, first_steps(*constant), 0) + " (" +
                                              std::to_string(constant->capped_episodes) + " episodes cut), " +
                                              named(other->name, first_steps(*other), 0),
                                          is_multiple(first_steps(*constant), first_steps(*other), constant_factor)});
        }
        return statement;
    };
    return {
        "A constant weight (eq. 8 without eq. 9)",
        "Ours, not the paper's: unless the weight of SSP decays with the visits (we read eq. 9 as a fixed exponent), "
        "the learner keeps to the old path after a change. Cut episodes count the steps made, so the true ratios "
        "are greater.",
        {many_times("With a constant weight SSPQL needs at least " + factor + " times the steps of `q-bonus`",
                    "q-bonus"),
         many_times("With a constant weight SSPQL needs at least " + factor + " times the steps of `q`", "q")}};
}

ComparisonSection table1_section(const std::vector<Place>& approaches) {
    ComparisonSection section{"Table 1: the robot approaches the box",
                              "The paper: 2849, 920, 822 and 638 steps over 30 episodes for Q-learning, SSP, SSPQL and "
                              "SSPQL with bonus. Numbers "
                              "agree when they lie within " +
                                  fixed_text(100.0 * claim_tolerance, 0) +
                                  " % of the paper's; such statements have no z.",
                              {}};
    const std::array<std::pair<const char*, const char*>, 3> order{
        {{"ssp", "q"}, {"sspql", "ssp"}, {"sspql-bonus", "sspql"}}};
    for (const auto& [less, more] : order) {
        section.statements.push_back(
            fewer_steps(method_name(less) + " needs fewer steps than " + method_name(more), approaches, less, more));
    }
    for (const Place& place : approaches) {
        const std::vector<Claim> claims = compare_with_paper(place.phase->learners);
        for (std::size_t i = 1; i < claims.size(); ++i) {  // the first is the order
            const Claim& claim = claims[i];
            auto at = std::find_if(section.statements.begin(), section.statements.end(),
                                   [&](const Statement& s) { return s.claim == claim.statement; });
            if (at == section.statements.end()) {
                at = section.statements.insert(at, Statement{claim.statement, {}});
            }
            Contest contest;
            contest.verdict = claim.agrees ? Verdict::holds : Verdict::fails;
            contest.ratio = contest.ratio_error = contest.z = std::numeric_limits<double>::quiet_NaN();
            at->findings.push_back({place.name, claim.measured, contest});
        }
    }
    return section;
}

ComparisonSection robot_section(const std::vector<Place>& tasks) {
    return {
        "Other model-based learners on the robot",
        "The paper's Section 3.2 says that SSPQL converges faster than Dyna-Q and prioritized sweeping, but its robot "
        "met neither.",
        {fewer_steps("SSPQL needs fewer steps than Dyna-Q, neither with a bonus", tasks, "sspql", "dyna-q"),
         fewer_steps("SSPQL needs fewer steps than Dyna-Q, both with the bonus", tasks, "sspql-bonus", "dyna-q-bonus"),
         fewer_steps("SSPQL needs fewer steps than prioritized sweeping, neither with a bonus", tasks, "sspql", "ps"),
         fewer_steps("SSPQL needs fewer steps than prioritized sweeping, both with the bonus", tasks, "sspql-bonus",
                     "ps-bonus"),
         fewer_steps("SSPQL needs fewer steps than Q-learning, both with the bonus", tasks, "sspql-bonus", "q-bonus")}};
}

ComparisonSection cost_section(const std::vector<RecordedRun>& runs) {
    Statement operations{"SSPQL touches fewer records and edges per step", {}};
    Statement time{"SSPQL takes less time per step", {}};
    Statement altogether{"SSPQL touches fewer records and edges in the whole run, its number of steps included", {}};
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const RecordedRun& run = runs[i];
        if (run.phases.empty()) continue;
        const RecordedPhase& phase = run.phases.front();
        const std::string where = phase.name + (run.phases.size() > 1 ? " and so on" : "") + label_of(runs, i);
        for (const LearnerStatistics& rival : phase.learners) {
            const LearnerStatistics* ours = sspql_like(phase, rival.name);
            if (ours == nullptr || !is_planner(rival.name)) continue;
            const Effort mine = effort_of(run, ours->name);
            const Effort theirs = effort_of(run, rival.name);
            const std::string numbers = effort_text(run, ours->name, false) + "; " + effort_text(run, rival.name, true);
            operations.findings.push_back(
                {where, numbers, plainly_less(mine.operations / mine.steps, theirs.operations / theirs.steps)});
            time.findings.push_back({where, numbers, plainly_less(mine.ns_per_step, theirs.ns_per_step)});
            altogether.findings.push_back({where,
                                           numbers + "; operations per run " + fixed_text(mine.operations, 0) +
                                               " and " + fixed_text(theirs.operations, 0),
                                           plainly_less(mine.operations, theirs.operations)});
        }
    }
    return {
        "What Dyna-Q and prioritized sweeping cost (Section 3.1)",
        "The paper: SSPQL solves once an episode, the others plan k times a step, so SSPQL is cheaper. That depends on "
        "k "
        "and on how long episodes are (a solve is paid by all steps of its episode), so both stand with every number. "
        "Totals of the same run are compared as they are: no z. Times are those of the machine that recorded the run.",
        {operations, time, altogether}};
}

ComparisonSection chain_section(const std::vector<Place>& chains) {
    std::vector<Place> cyclic;
    for (const Place& place : chains) {
        if (slip_of(*place.run) > 0.0) cyclic.push_back(place);
    }
    ComparisonSection section{
        "Cycles (Fig. 3)",
        "The paper: where an action often leaves the state unchanged, Dyna-Q's and prioritized sweeping's values "
        "hardly "
        "reach their optima, while SSPQL has no such difficulty.",
        {fewer_steps("SSPQL needs fewer steps than Dyna-Q on the chain with cycles", cyclic, "sspql", "dyna-q"),
         fewer_steps("SSPQL needs fewer steps than Dyna-Q that replays the last outcome", cyclic, "sspql",
                     "dyna-q-last"),
         fewer_steps("SSPQL needs fewer steps than prioritized sweeping on the chain with cycles", cyclic, "sspql",
                     "ps"),
         slowed_by_cycles("Cycles slow Dyna-Q down", chains, "dyna-q"),
         slowed_by_cycles("Cycles slow prioritized sweeping down", chains, "ps"),
         slowed_by_cycles("Cycles slow SSPQL down (the paper: they do not)", chains, "sspql")}};
    return section;
}

ComparisonSection maze_section(const std::vector<Place>& mazes) {
    ComparisonSection section{
        "Sutton and Barto's mazes",
        "Not in the paper: the field's own tasks for learners with a model (Sutton and Barto 2018, Fig. 8.2, examples "
        "8.2 "
        "and 8.3). The Dyna maze counts steps, the others the reward collected while a wall moves.",
        {}};
    for (const char* name : {"sspql", "sspql-bonus"}) {
        for (const char* rival : {"dyna-q", "dyna-q-plus", "ps"}) {
            section.statements.push_back(
                more_reward("`" + std::string(name) + "` does better than `" + rival + "`", mazes, name, rival));
        }
    }
    for (const char* name : {"sspql", "sspql-bonus", "sspql-constant", "ps", "adaptive"}) {
        section.statements.push_back(keeps_pace(
            "After the wall moved, `" + std::string(name) + "` collects reward at half its former pace or more", mazes,
            name));
    }
    return section;
}

ComparisonSection adaptive_section(const std::vector<Place>& grids) {
    return {"The library's answer: `adaptive`",
            "Not in the paper: the planner that forgets, for worlds that change.",
            {fewer_steps("`adaptive` needs fewer steps than SSPQL with the bonus", grids, "adaptive", "sspql-bonus"),
             fewer_steps("`adaptive` needs fewer steps than optimistic prioritized sweeping that forgets", grids,
                         "adaptive", "ps-optimistic"),
             fewest_steps("`adaptive` needs fewer steps than every other learner", grids, "adaptive", is_anyone)}};
}

}  // namespace sspql::report
