// expect: sspql: these LegalActions keep no masks; LegalActionTable does
// SPDX-License-Identifier: MIT
#include <sspql/sspql.hpp>

struct Unmasked : sspql::SspqlPolicies {
    using LegalActions = sspql::AllActions;
};

int main() {
    sspql::Sspql<Unmasked> learner(4, 2);
    learner.set_legal_actions(sspql::state_id(0), sspql::ActionSet::all(2));
}
