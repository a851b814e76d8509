// expect: sspql: integer counts cannot fade; use TransitionCounts<FadingCell>
// SPDX-License-Identifier: MIT
#include <sspql/sspql.hpp>

int main() {
    sspql::TransitionCounts<sspql::CountCell> counts(4, 2);
    counts.fade(sspql::state_id(0), sspql::action_id(0), 0.5, 0.01);
}
