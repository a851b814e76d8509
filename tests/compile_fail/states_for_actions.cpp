// expect: StateId
// SPDX-License-Identifier: MIT
#include <sspql/sspql.hpp>

int main() {
    sspql::Sspql<> learner(4, 2);
    learner.replace_action(learner.state());  // a state does not pass for an action
}
