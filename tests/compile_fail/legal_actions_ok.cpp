// SPDX-License-Identifier: MIT
#include <sspql/sspql.hpp>

struct Walls {
    struct Allowed {
        bool contains(sspql::ActionId) const { return true; }
    };
    Allowed allowed(sspql::StateId) const { return {}; }
};

struct MyPolicies : sspql::SspqlPolicies {
    using LegalActions = Walls;
};

int main() {
    sspql::Sspql<MyPolicies> learner(4, 2);
    sspql::ActionId a = learner.begin(sspql::state_id(0));
    a = learner.step(0.0, sspql::state_id(1));
    learner.end(1.0, sspql::state_id(2), true);
    a = learner.best(sspql::state_id(0));
    return static_cast<int>(sspql::index(a));
}
