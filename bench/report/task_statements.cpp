// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <optional>

#include "report/paper_statements.hpp"
#include "report/statement_builders.hpp"

namespace sspql::report {

namespace {

constexpr double least_pace = 0.5;  // after a wall moved, of the pace before

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

}  // namespace

ComparisonSection chain_section(const std::vector<Place>& chains) {
    std::vector<Place> cyclic;
    for (const Place& place : chains) {
        if (slip_of(*place.run) > 0.0) cyclic.push_back(place);
    }
    ComparisonSection section{
        "Cycles (Fig. 3)",
        "The paper: where an action often leaves the state unchanged, Dyna-Q's and prioritized sweeping's values "
        "hardly reach their optima, while SSPQL has no such difficulty.",
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
        "8.2 and 8.3). The Dyna maze counts steps, the others the reward collected while a wall moves.",
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

}  // namespace sspql::report
