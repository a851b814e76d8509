// SPDX-License-Identifier: MIT
#include <sspql/sspql.hpp>

struct Energy {
    double operator()(double weight, double probability) const { return weight / probability; }
};

struct MyPolicies : sspql::SspqlPolicies {
    using Cost = Energy;
};

int main() {
    sspql::Sspql<MyPolicies> learner(4, 2);
    sspql::ActionId a = learner.begin(sspql::state_id(0));
    a = learner.step(0.0, sspql::state_id(1));
    learner.end(1.0, sspql::state_id(2), true);
    a = learner.best(sspql::state_id(0));
    return static_cast<int>(sspql::index(a));
}
