// SPDX-License-Identifier: MIT
#include <sspql/sspql.hpp>

int main() {
    sspql::ProductState states(sspql::EnumState<int>(4), sspql::EnumState<int>(4));
    sspql::Agent robot(states, sspql::ActionTable<int>{-1, 1});
    return robot.begin(3);
}
