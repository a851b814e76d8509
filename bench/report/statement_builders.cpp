// SPDX-License-Identifier: MIT
#include "report/statement_builders.hpp"

#include "report/numbers.hpp"

namespace sspql::report {

std::string with_error(const Summary& summary, int digits) {
    std::string text = fixed_text(summary.mean, digits);
    if (summary.count > 1) text += " \u00b1 " + fixed_text(summary.error, digits);
    return text;
}

std::string named(const std::string& name, const Summary& summary, int digits) {
    return "`" + name + "` " + with_error(summary, digits);
}

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

Finding fewer_steps(const Place& place, const LearnerStatistics& a, const LearnerStatistics& b) {
    return {place.name, named(a.name, a.first30_steps, 0) + ", " + named(b.name, b.first30_steps, 0),
            is_less(a.first30_steps, b.first30_steps)};
}

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

Statement fewest_steps(const std::string& claim, const std::vector<Place>& places, const std::string& a,
                       bool (*is_rival)(const std::string&)) {
    Statement statement{claim, {}};
    for (const Place& place : places) {
        const LearnerStatistics* first = place.phase->find(a);
        const LearnerStatistics* best = nullptr;
        for (const LearnerStatistics& learner : place.phase->learners) {
            if (!is_rival(learner.name) || &learner == first) continue;
            if (best == nullptr || learner.first30_steps.mean < best->first30_steps.mean) best = &learner;
        }
        if (first == nullptr || best == nullptr) {
            statement.findings.push_back(missing(place, first == nullptr ? "`" + a + "`" : "another learner"));
        } else {
            statement.findings.push_back(fewer_steps(place, *first, *best));
        }
    }
    return statement;
}

}  // namespace sspql::report
