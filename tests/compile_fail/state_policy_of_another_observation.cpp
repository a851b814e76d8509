// expect: sspql: this StatePolicy lacks `sspql::StateId encode(const Observation&)` for the observation it was given
// SPDX-License-Identifier: MIT
#include <sspql/sspql.hpp>

struct Scan {
    double x_m;
    double y_m;
};

int main() {
    // A grid wants numbers; wrap it in a ProjectedState.
    sspql::Agent robot(sspql::UniformGrid<2>({{{0, 8, 8}, {0, 8, 8}}}), sspql::ActionTable<int>{-1, 1});
    int move = robot.begin(Scan{1.0, 2.0});
    move = robot.step(0.0, Scan{1.0 + move, 2.0});
    robot.end(1.0, Scan{1.0 + move, 2.0}, true);
}
