// SPDX-License-Identifier: MIT
#include <sspql/io/checkpoint.hpp>

#include <array>
#include <string>
#include <tuple>
#include <utility>

#include "io/file_testing.hpp"

#include <sspql/learn/q_learning.hpp>
#include <sspql/spaces/hashed_state.hpp>
#include <sspql/spaces/uniform_grid.hpp>

using namespace sspql;
using namespace sspql::testing;

namespace {

struct Commands {
    [[nodiscard]] std::size_t size() const { return 3; }
    [[nodiscard]] int decode(ActionId a) const { return static_cast<int>(a) - 1; }
};

struct PairHash {
    std::size_t operator()(const std::pair<std::string, std::array<int, 2>>& key) const {
        return std::hash<std::string>()(key.first) ^ static_cast<std::size_t>(key.second[0] * 31 + key.second[1]);
    }
};

/// A user's own StatePolicy: rooms by name, in the order they were entered.
class Rooms {
public:
    static constexpr bool grows = true;
    [[nodiscard]] std::size_t size() const { return names_.size(); }
    StateId encode(const std::string& name) {
        for (std::size_t i = 0; i < names_.size(); ++i) {
            if (names_[i] == name) return state_id(i);
        }
        names_.push_back(name);
        return state_id(names_.size() - 1);
    }

    template <class Archive>
    void serialize(Archive& archive) {
        archive(names_);
    }

private:
    std::vector<std::string> names_;
};

}  // namespace

class CheckpointAgent : public FileTest {};

TEST_F(CheckpointAgent, KeepsTheKeysOfHashedStates) {
    using Key = std::pair<std::string, std::array<int, 2>>;
    Agent agent(HashedState<Key, PairHash>{}, Commands{}, QLearningParams<>{}, 3);
    static_cast<void>(agent.begin(Key{"kitchen", {1, 2}}));
    static_cast<void>(agent.step(0.5, Key{"hall", {0, 0}}));
    static_cast<void>(agent.step(0.5, Key{"", {-1, 7}}));
    save(agent, path("robot"));
    Agent loaded(HashedState<Key, PairHash>{}, Commands{}, QLearningParams<>{}, 4);
    static_cast<void>(loaded.begin(Key{"elsewhere", {9, 9}}));
    load(path("robot"), loaded);
    EXPECT_EQ(loaded.states().size(), 3u);
    EXPECT_EQ(loaded.states().key(state_id(2)), (Key{"", {-1, 7}}));
    EXPECT_EQ(loaded.states().find(Key{"hall", {0, 0}}), state_id(1));
    EXPECT_EQ(loaded.states().find(Key{"elsewhere", {9, 9}}), std::nullopt);
    EXPECT_TRUE(loaded.learner().running());
    EXPECT_EQ(loaded.step(1.0, Key{"kitchen", {1, 2}}), agent.step(1.0, Key{"kitchen", {1, 2}}));
    EXPECT_EQ(save_to_bytes(loaded), save_to_bytes(agent));
}

TEST_F(CheckpointAgent, KeepsWhatAUsersPolicyDiscovered) {
    Agent agent(Rooms{}, Commands{});  // the adaptive planner
    for (int episode = 0; episode < 10; ++episode) {
        static_cast<void>(agent.begin(std::string("start")));
        for (const char* name : {"hall", "kitchen", "hall", "stairs"}) static_cast<void>(agent.step(0.0, std::string(name)));
        agent.end(1.0, std::string("goal"), true);
    }
    save(agent, path("robot"));
    Agent loaded(Rooms{}, Commands{});
    load(path("robot"), loaded);
    EXPECT_EQ(loaded.states().size(), 5u);
    EXPECT_EQ(loaded.learner().states(), 5u);
    EXPECT_EQ(loaded.begin(std::string("start")), agent.begin(std::string("start")));
    EXPECT_EQ(save_to_bytes(loaded), save_to_bytes(agent));
}

TEST_F(CheckpointAgent, AStatePolicyWithoutDiscoveriesNeedsNothing) {
    const UniformGrid<1> grid({GridAxis{0.0, 1.0, 10}});
    Agent agent(grid, Commands{});
    static_cast<void>(agent.begin(std::array<double, 1>{0.35}));
    agent.end(1.0, std::array<double, 1>{0.95}, true);
    save(agent, path("robot"));
    Agent loaded(grid, Commands{});
    load(path("robot"), loaded);
    EXPECT_EQ(save_to_bytes(loaded), save_to_bytes(agent));
}

TEST_F(CheckpointAgent, TwoStatesWithOneKeyAreRefused) {
    HashedState<int> states;
    Agent agent(states, Commands{}, QLearningParams<>{});
    static_cast<void>(agent.begin(11111));
    static_cast<void>(agent.step(0.0, 22222));
    std::string bytes = save_to_bytes(agent);
    const int first = 11111;
    const int second = 22222;
    const std::size_t at = bytes.find(std::string(reinterpret_cast<const char*>(&second), sizeof second));
    ASSERT_NE(at, std::string::npos);
    bytes.replace(at, sizeof first, std::string(reinterpret_cast<const char*>(&first), sizeof first));
    EXPECT_THROW(load_from_bytes(bytes, agent), std::runtime_error);
}
