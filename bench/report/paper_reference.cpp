// SPDX-License-Identifier: MIT
#include "report/paper_reference.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "report/numbers.hpp"

namespace sspql::report {

namespace {

constexpr std::array<PaperRow, 4> table{{{"q", "Q-learning", 2849.0, "Fig. 8"},
                                         {"ssp", "SSP", 920.0, "Fig. 9"},
                                         {"sspql", "SSPQL", 822.0, "Fig. 10"},
                                         {"sspql-bonus", "SSPQL with exploration bonus", 638.0, "Fig. 11"}}};

/// A learner of this run with its row of the paper.
struct Pair {
    const LearnerStatistics* learner;
    const PaperRow* paper;

    [[nodiscard]] double steps() const { return learner->first30_steps.mean; }
};

bool is_close(double value, double reference) { return std::fabs(value - reference) <= claim_tolerance * reference; }

/// Mean of elements first to last, counted from 1.
double mean_of(const std::vector<double>& values, std::size_t first, std::size_t last) {
    double sum = 0.0;
    for (std::size_t i = first; i <= last; ++i) sum += values[i - 1];
    return sum / static_cast<double>(last - first + 1);
}

std::string joined(const std::vector<std::string>& parts) {
    std::string out;
    for (const std::string& part : parts) out += (out.empty() ? "" : ", ") + part;
    return out;
}

Claim order_claim(const std::vector<Pair>& pairs) {
    Claim claim;
    claim.agrees = true;
    double least_z = std::numeric_limits<double>::infinity();
    std::vector<std::string> totals;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        claim.statement += (i == 0 ? "Table 1, order of the totals: " : " > ") + std::string(pairs[i].paper->method);
        totals.push_back(fixed_text(pairs[i].steps(), 0));
        if (i == 0) continue;
        claim.agrees = claim.agrees && pairs[i - 1].steps() > pairs[i].steps();
        least_z = std::min(least_z, z_score(pairs[i - 1].learner->first30_steps, pairs[i].learner->first30_steps));
    }
    claim.measured = joined(totals);
    if (pairs.front().learner->seeds > 1) {
        claim.measured += "; the smallest step down is " + fixed_text(least_z, 1) + " standard errors";
        if (claim.agrees && least_z < 2.0) claim.measured += ", which chance can explain";
    }
    return claim;
}

Claim totals_claim(const std::vector<Pair>& pairs) {
    Claim claim;
    claim.agrees = true;
    std::vector<std::string> theirs;
    std::vector<std::string> factors;
    for (const Pair& pair : pairs) {
        theirs.push_back(fixed_text(pair.paper->steps, 0));
        factors.push_back(fixed_text(pair.steps() / pair.paper->steps, 2));
        claim.agrees = claim.agrees && is_close(pair.steps(), pair.paper->steps);
    }
    claim.statement = "Table 1, totals: " + joined(theirs) + " steps";
    claim.measured = joined(factors) + " times as many";
    return claim;
}

Claim ratios_claim(const std::vector<Pair>& pairs) {
    Claim claim;
    claim.agrees = true;
    std::vector<std::string> theirs;
    std::vector<std::string> ours;
    for (std::size_t i = 1; i < pairs.size(); ++i) {
        const double paper = pairs[i].paper->steps / pairs.front().paper->steps;
        const double here = pairs[i].steps() / pairs.front().steps();
        theirs.push_back(fixed_text(paper, 2));
        ours.push_back(fixed_text(here, 2));
        claim.agrees = claim.agrees && is_close(here, paper);
    }
    claim.statement = "Table 1, totals relative to Q-learning: " + joined(theirs);
    claim.measured = joined(ours);
    return claim;
}

/// "Converged after episode n": the five episodes after it need no more than the last five of the 30.
Claim convergence_claim(const LearnerStatistics& learner, std::size_t episode) {
    const double after = mean_of(learner.curve.mean, episode + 1, episode + 5);
    const double last = mean_of(learner.curve.mean, 26, 30);
    Claim claim;
    claim.statement = method_name(learner.name) + " has converged after episode " + std::to_string(episode);
    claim.measured = fixed_text(after, 1) + " steps an episode in episodes " + std::to_string(episode + 1) + " to " +
                     std::to_string(episode + 5) + ", " + fixed_text(last, 1) + " in episodes 26 to 30";
    claim.agrees = after <= last * (1.0 + claim_tolerance);
    return claim;
}

Claim first_episode_claim(const LearnerStatistics& plain, const LearnerStatistics& bonus) {
    const double ratio = bonus.first_episode.mean / plain.first_episode.mean;
    Claim claim;
    claim.statement = "The exploration bonus makes the first episode nearly half as long";
    claim.measured = fixed_text(ratio, 2) + " times as long (" + fixed_text(bonus.first_episode.mean, 1) +
                     " steps against " + fixed_text(plain.first_episode.mean, 1) + ")";
    claim.agrees = is_close(ratio, 0.5);
    return claim;
}

Claim spread_claim(const LearnerStatistics& ssp, const LearnerStatistics& both) {
    const double alone = mean_of(ssp.curve.deviation, 1, 30);
    const double together = mean_of(both.curve.deviation, 1, 30);
    Claim claim;
    claim.statement = "The steps of an episode spread more with SSP alone than with SSPQL";
    claim.measured = "standard deviation over seeds, mean of episodes 1 to 30: " + fixed_text(alone, 1) + " against " +
                     fixed_text(together, 1);
    claim.agrees = alone > together;
    return claim;
}

}  // namespace

const PaperRow* paper_row(std::string_view learner) noexcept {
    const auto found =
        std::find_if(table.begin(), table.end(), [&](const PaperRow& r) { return r.learner == learner; });
    return found == table.end() ? nullptr : &*found;
}

std::string method_name(std::string_view learner) {
    const PaperRow* row = paper_row(learner);
    return std::string(row == nullptr ? learner : row->method);
}

const LearnerStatistics* find_learner(const std::vector<LearnerStatistics>& learners, std::string_view name) noexcept {
    const auto found = std::find_if(learners.begin(), learners.end(), [&](const auto& l) { return l.name == name; });
    return found == learners.end() ? nullptr : &*found;
}

std::vector<Claim> compare_with_paper(const std::vector<LearnerStatistics>& learners) {
    std::vector<Pair> pairs;  // in the paper's order
    for (const PaperRow& row : table) {
        const LearnerStatistics* learner = find_learner(learners, row.learner);
        if (learner != nullptr && learner->episodes >= 30) pairs.push_back({learner, &row});
    }
    if (pairs.size() < 2) return {};
    const auto measured = [&](std::string_view name) -> const LearnerStatistics* {
        for (const Pair& pair : pairs) {
            if (pair.paper->learner == name) return pair.learner;
        }
        return nullptr;
    };
    const LearnerStatistics* q = measured("q");
    const LearnerStatistics* ssp = measured("ssp");
    const LearnerStatistics* sspql = measured("sspql");
    const LearnerStatistics* bonus = measured("sspql-bonus");

    std::vector<Claim> claims{order_claim(pairs)};
    if (q != nullptr) claims.push_back(ratios_claim(pairs));
    claims.push_back(totals_claim(pairs));
    if (q != nullptr) claims.push_back(convergence_claim(*q, 15));
    if (ssp != nullptr) claims.push_back(convergence_claim(*ssp, 5));
    if (sspql != nullptr && bonus != nullptr) claims.push_back(first_episode_claim(*sspql, *bonus));
    if (ssp != nullptr && sspql != nullptr && ssp->seeds > 1) claims.push_back(spread_claim(*ssp, *sspql));
    return claims;
}

}  // namespace sspql::report
