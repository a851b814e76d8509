// SPDX-License-Identifier: MIT
#include "report/paper_statements.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include "report/numbers.hpp"
#include "report/paper_reference.hpp"
#include "report/statement_builders.hpp"

namespace sspql::report {

namespace {

constexpr double constant_factor = 3.0;  // "many times"

std::vector<Place> filtered(const std::vector<Place>& places, bool after_change) {
    std::vector<Place> some;
    for (const Place& place : places) {
        if (place.after_change == after_change) some.push_back(place);
    }
    return some;
}

bool is_ssp_family(const std::string& name) {
    const std::string_view family = family_of(name);
    return family.substr(0, 3) == "ssp";
}

bool is_not_ours(const std::string& name) { return !is_ssp_family(name) && family_of(name) != "adaptive"; }
bool is_anyone(const std::string&) { return true; }

}  // namespace

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
                                          named(constant->name, constant->first30_steps, 0) + " (" +
                                              std::to_string(constant->capped_episodes) + " episodes cut), " +
                                              named(other->name, other->first30_steps, 0),
                                          is_multiple(constant->first30_steps, other->first30_steps, constant_factor)});
        }
        return statement;
    };
    return {"A constant weight (eq. 8 without eq. 9)",
            "Ours, not the paper's: unless the weight of SSP decays with the visits (we read eq. 9 as a fixed "
            "exponent), the learner keeps to the old path after a change. Cut episodes count the steps made, so the "
            "true ratios are greater.",
            {many_times("With a constant weight SSPQL needs at least " + factor + " times the steps of `q-bonus`",
                        "q-bonus"),
             many_times("With a constant weight SSPQL needs at least " + factor + " times the steps of `q`", "q")}};
}

ComparisonSection table1_section(const std::vector<Place>& approaches) {
    ComparisonSection section{"Table 1: the robot approaches the box",
                              "The paper: 2849, 920, 822 and 638 steps over 30 episodes for Q-learning, SSP, SSPQL and "
                              "SSPQL with bonus. Numbers agree when they lie within " +
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

ComparisonSection adaptive_section(const std::vector<Place>& grids) {
    return {"The library's answer: `adaptive`",
            "Not in the paper: the planner that forgets, for worlds that change.",
            {fewer_steps("`adaptive` needs fewer steps than SSPQL with the bonus", grids, "adaptive", "sspql-bonus"),
             fewer_steps("`adaptive` needs fewer steps than optimistic prioritized sweeping that forgets", grids,
                         "adaptive", "ps-optimistic"),
             fewest_steps("`adaptive` needs fewer steps than every other learner", grids, "adaptive", is_anyone)}};
}

}  // namespace sspql::report
