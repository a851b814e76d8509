// SPDX-License-Identifier: MIT
#include "report/verdict.hpp"

#include <cmath>
#include <limits>

namespace sspql::report {

namespace {

/// The statement "`gain` > 0", where the gain has a standard error.
Contest judged(const Summary& a, const Summary& b, double gain, double error) {
    Contest contest;
    contest.ratio = a.mean / b.mean;
    contest.ratio_error = std::fabs(contest.ratio) * std::hypot(a.error / a.mean, b.error / b.mean);
    contest.verdict = Verdict::open;
    if (a.count < 2 || b.count < 2 || !std::isfinite(gain)) return contest;
    if (error > 0.0) {
        contest.z = gain / error;
    } else if (gain != 0.0) {
        contest.z = std::copysign(std::numeric_limits<double>::infinity(), gain);
    }
    if (contest.z >= decisive_z) contest.verdict = Verdict::holds;
    if (contest.z <= -decisive_z) contest.verdict = Verdict::fails;
    return contest;
}

}  // namespace

std::string verdict_text(Verdict verdict) {
    switch (verdict) {
        case Verdict::holds: return "holds";
        case Verdict::fails: return "does not hold";
        case Verdict::open: return "not decided";
        case Verdict::missing: return "not in the recorded run";
    }
    return {};
}

Contest is_less(const Summary& a, const Summary& b) {
    return judged(a, b, b.mean - a.mean, std::hypot(a.error, b.error));
}

Contest is_greater(const Summary& a, const Summary& b) {
    return judged(a, b, a.mean - b.mean, std::hypot(a.error, b.error));
}

Contest is_multiple(const Summary& a, const Summary& b, double factor) {
    return judged(a, b, a.mean - factor * b.mean, std::hypot(a.error, factor * b.error));
}

void Tally::add(Verdict verdict) {
    switch (verdict) {
        case Verdict::holds: ++holds; return;
        case Verdict::fails: ++fails; return;
        case Verdict::open: ++open; return;
        case Verdict::missing: ++missing; return;
    }
}

std::string Tally::text() const {
    const std::size_t all = holds + fails + open;
    if (all == 0) return verdict_text(Verdict::missing);
    struct Part {
        std::size_t n;
        Verdict verdict;
    };
    std::string text;
    for (const Part& part : {Part{holds, Verdict::holds}, Part{fails, Verdict::fails}, Part{open, Verdict::open}}) {
        if (part.n == 0) continue;
        text += (text.empty() ? "" : ", ") + verdict_text(part.verdict);
        if (all > 1) text += " in " + std::to_string(part.n) + " of " + std::to_string(all);
    }
    return text;
}

}  // namespace sspql::report
