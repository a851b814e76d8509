// expect: sspql: this Selector lacks `ActionId operator()(std::size_t actions, const Allowed&, const Score&, Random&) const`
// SPDX-License-Identifier: MIT
#include <sspql/sspql.hpp>

struct Greedy {
    sspql::ActionId operator()(const double* scores, std::size_t actions) const {
        return sspql::action_id(scores[0] > scores[actions - 1] ? 0 : actions - 1);
    }
};

struct MyPolicies : sspql::SspqlPolicies {
    using Selector = Greedy;
};

int main() {
    sspql::Sspql<MyPolicies> learner(4, 2);
    sspql::ActionId a = learner.begin(sspql::state_id(0));
    a = learner.step(0.0, sspql::state_id(1));
    learner.end(1.0, sspql::state_id(2), true);
    a = learner.best(sspql::state_id(0));
    return static_cast<int>(sspql::index(a));
}
