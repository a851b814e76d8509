// g++ -std=c++17 -O2 -I include -I /usr/include/eigen3 examples/00_smallest.cpp -o smallest && ./smallest
// The smallest program: one header, one learner, states and actions are numbers. A corridor of 10 cells, home on the
// right.
#include <cstdio>
#include <sspql/learn/q_learning.hpp>

int main() {
    sspql::QLearning<> learner(10, 2);  // 10 cells; action 0 goes left, action 1 right
    for (int episode = 1; episode <= 12; ++episode) {
        std::size_t cell = 0;
        int steps = 0;
        sspql::ActionId action = learner.begin(sspql::state_id(cell));
        for (;;) {
            ++steps;
            cell = index(action) == 1 ? cell + 1 : cell == 0 ? 0 : cell - 1;
            if (cell == 9) break;
            action = learner.step(0.0, sspql::state_id(cell));  // reward 0 on the way; what next?
        }
        learner.end(1.0, sspql::state_id(cell), true);  // reward 1 at home, where the episode ends
        std::printf("%d ", steps);
    }
    std::printf("steps home; 9 are the fewest\n");
}
