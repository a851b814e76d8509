// expect: sspql: this StatePolicy grows, so a checkpoint must hold what it has discovered; it lacks `template <class Archive> void serialize(Archive&)`
// SPDX-License-Identifier: MIT
#include <sspql/sspql.hpp>

struct Rooms {
    static constexpr bool grows = true;
    std::size_t size() const { return 0; }
    sspql::StateId encode(int) { return sspql::state_id(0); }
};
struct Commands {
    std::size_t size() const { return 2; }
    int decode(sspql::ActionId) const { return 0; }
};

void write(const sspql::Agent<Rooms, Commands>& agent) { sspql::save(agent, "robot"); }
