// SPDX-License-Identifier: MIT
#include <sspql/sspql.hpp>

struct First {
    template <class Allowed, class Score>
    sspql::ActionId operator()(std::size_t actions, const Allowed& allowed, const Score&, sspql::Random&) const {
        std::size_t a = 0;
        while (a + 1 < actions && !allowed.contains(sspql::action_id(a))) ++a;
        return sspql::action_id(a);
    }
};

struct MyPolicies : sspql::SspqlPolicies {
    using Selector = First;
};

int main() {
    sspql::Sspql<MyPolicies> learner(4, 2);
    sspql::ActionId a = learner.begin(sspql::state_id(0));
    a = learner.step(0.0, sspql::state_id(1));
    learner.end(1.0, sspql::state_id(2), true);
    a = learner.best(sspql::state_id(0));
    return static_cast<int>(sspql::index(a));
}
