// expect: sspql: a growing StatePolicy (HashedState) cannot be a factor of a ProductState; hash the whole observation instead
// SPDX-License-Identifier: MIT
#include <sspql/sspql.hpp>

int main() {
    sspql::ProductState states(sspql::EnumState<int>(4), sspql::HashedState<int>{});
    sspql::Agent robot(states, sspql::ActionTable<int>{-1, 1});
    return robot.begin(3);
}
