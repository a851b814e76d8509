// g++ -std=c++17 -O2 -I include -I /usr/include/eigen3 examples/02_your_own_robot.cpp -o your_robot && ./your_robot
//
// A robot of your own: your observation and command types, states met one by one, actions that are not always legal, a
// safety layer that steps in, an emergency stop, a look inside, and another goal without starting over.
#include <functional>
#include <iostream>
#include <string>
#include <sspql/sspql.hpp>

enum class Drive { east, west, lift };  // the command
struct Scan {                           // the observation
    int floor = 0;
    int door = 0;
};

// States are discovered: HashedState needs == and a hash of what tells one state from another.
struct Key {
    int floor, door;
    bool operator==(const Key& other) const { return floor == other.floor && door == other.door; }
};
struct KeyHash {
    std::size_t operator()(const Key& key) const { return std::hash<int>{}(key.floor * 1000 + key.door); }
};

// A building of 4 floors with 10 doors each; the lift goes up one floor (and from the top down to the first), and only
// from door 0. The robot's own loop owns the time here: no environment class is needed.
struct Building {
    Scan at{};
    void drive(Drive command) {
        if (command == Drive::east && at.door < 9) ++at.door;
        if (command == Drive::west && at.door > 0) --at.door;
        if (command == Drive::lift && at.door == 0) at.floor = (at.floor + 1) % 4;
    }
    sspql::ActionSet legal() const {
        auto set = sspql::ActionSet::all(3);
        if (at.door != 0) set.erase(sspql::ActionId{2});
        return set;
    }
};

int main() {
    const sspql::ProjectedState states(sspql::HashedState<Key, KeyHash>{}, [](const Scan& s) { return Key{s.floor, s.door}; });
    sspql::Agent robot(states, sspql::EnumActions<Drive>(3), sspql::AdaptiveParams<>{}, 7);

    const auto trip = [&robot](Scan goal) {
        Building building;
        Drive command = robot.begin(building.at, building.legal());
        for (int steps = 1;; ++steps) {
            if (steps == 5 && command == Drive::west) {  // a safety layer has its own idea
                command = Drive::east;
                robot.replace_action(sspql::ActionId{0});
            }
            building.drive(command);
            const bool there = building.at.floor == goal.floor && building.at.door == goal.door;
            if (there || steps == 1000) {
                robot.end(there ? 1.0 : 0.0, building.at, there);
                return steps;
            }
            command = robot.step(0.0, building.at, building.legal());
        }
    };
    for (int episode = 0; episode < 8; ++episode) std::cout << trip({3, 7}) << ' ';
    std::cout << "steps to floor 3, door 7\n";

    static_cast<void>(robot.begin(Scan{0, 0}));
    robot.abort();  // an emergency stop: the episode is dropped, what was learnt stays

    const auto terms = robot.terms(Scan{1, 0}, sspql::ActionId{2});
    std::cout << "taking the lift up on floor 1: worth " << terms.q << ", curiosity " << terms.exploration << " after "
              << terms.n << " tries\n";

    robot.set_goals<Scan>({{2, 4}});
    for (int episode = 0; episode < 3; ++episode) std::cout << trip({2, 4}) << ' ';
    std::cout << "steps to another goal, floor 2, door 4\n";
}
