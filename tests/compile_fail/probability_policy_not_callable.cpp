// expect: sspql: this ProbabilityPolicy lacks `double operator()(const TransitionCounts&, StateId, const Successor&) const`
// SPDX-License-Identifier: MIT
#include <sspql/sspql.hpp>

struct Certain {
    double operator()(double) const { return 1.0; }
};

struct MyPolicies : sspql::SspqlPolicies {
    using Probability = Certain;
};

int main() {
    sspql::Sspql<MyPolicies> learner(4, 2);
    sspql::ActionId a = learner.begin(sspql::state_id(0));
    a = learner.step(0.0, sspql::state_id(1));
    learner.end(1.0, sspql::state_id(2), true);
    a = learner.best(sspql::state_id(0));
    return static_cast<int>(sspql::index(a));
}
