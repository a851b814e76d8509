// SPDX-License-Identifier: MIT
#include <sspql/io/checkpoint.hpp>

#include "io/checkpoint_testing.hpp"
#include "io/file_testing.hpp"

#include <sspql/learn/dyna_q.hpp>
#include <sspql/learn/q_learning.hpp>
#include <sspql/spaces/action_policy.hpp>
#include <sspql/spaces/hashed_state.hpp>

using namespace sspql;
using namespace sspql::testing;

namespace {

/// What loading these bytes into the learner says; the learner is checked to be as before.
template <class L>
std::string refusal(const std::string& bytes, L learner) {
    const std::string before = save_to_bytes(learner);
    const std::string error = error_of<std::runtime_error>([&] { load_from_bytes(bytes, learner, "robot"); });
    EXPECT_EQ(save_to_bytes(learner), before) << error;
    return error;
}

struct Epsilon : ValuePolicies {
    using Selector = EpsilonGreedy;
};
struct Fading : SspqlPolicies {
    using Cell = FadingCell;
};

}  // namespace

TEST(CheckpointErrors, AnotherLearner) {
    const std::string q = save_to_bytes(QLearning<>(4, 2));
    EXPECT_EQ(refusal(q, Sspql<>(4, 2)),
              "checkpoint robot: section 'type': the file has the learner 'Q-learning', this learner 'SSPQL'");
    EXPECT_EQ(refusal(save_to_bytes(QLearning<Epsilon>(4, 2)), QLearning<>(4, 2)),
              "checkpoint robot: section 'parameters': the file has the selector 'epsilon greedy', this learner 'uniform "
              "noise'");
    EXPECT_EQ(refusal(save_to_bytes(Sspql<Fading>(4, 2)), Sspql<>(4, 2)),
              "checkpoint robot: section 'model': the file has the cell 'fading', this learner 'count'");
}

TEST(CheckpointErrors, OtherDimensions) {
    const std::string q = save_to_bytes(QLearning<>(4, 2));
    EXPECT_EQ(refusal(q, QLearning<>(5, 2)),
              "checkpoint robot: section 'type': the file has 4 states, this learner 5");
    EXPECT_EQ(refusal(q, QLearning<>(4, 3)),
              "checkpoint robot: section 'type': the file has 2 actions, this learner 3");
    EXPECT_EQ(refusal(q, QLearning<>(StateCount::growing(), 2)),
              "checkpoint robot: section 'type': the file is of a learner with a fixed number of states, this one's grow "
              "in number");
    EXPECT_EQ(refusal(save_to_bytes(QLearning<>(StateCount::growing(), 2)), QLearning<>(4, 2)),
              "checkpoint robot: section 'type': the file is of a learner whose states grow in number, this one's do not");
}

TEST(CheckpointErrors, OlderAndNewerFormats) {
    std::string bytes = save_to_bytes(QLearning<>(4, 2));
    bytes[8] = 2;
    EXPECT_EQ(refusal(with_checksums(bytes), QLearning<>(4, 2)),
              "checkpoint robot: section 'header': written by sspql " SSPQL_VERSION
              " in format 2; this version reads formats up to 1");
    bytes[8] = 0;
    EXPECT_EQ(refusal(with_checksums(bytes), QLearning<>(4, 2)),
              "checkpoint robot: section 'header': there is no format 0");
}

TEST(CheckpointErrors, NoCheckpointAtAll) {
    EXPECT_EQ(refusal("", QLearning<>(4, 2)),
              "checkpoint robot: is no checkpoint of sspql: section 'header' is cut short");
    EXPECT_EQ(refusal("episode,step,state,action\n", QLearning<>(4, 2)),
              "checkpoint robot: is no checkpoint of sspql: section 'header' begins otherwise");
    const std::string bytes = save_to_bytes(QLearning<>(4, 2));
    EXPECT_EQ(refusal(bytes + "x", QLearning<>(4, 2)), "checkpoint robot: has 1 bytes after its end");
}

TEST(CheckpointErrors, AnAgentsFileForItsLearnerAlone) {
    const Agent agent(HashedState<int>{}, sspql::testing::TwoCommands{}, QLearningParams<>{});
    EXPECT_EQ(refusal(save_to_bytes(agent), QLearning<>(StateCount::growing(), 2)),
              "checkpoint robot: has section 'states' where this learner expects 'end'");
}

/// Numbers that are out of range though the checksums are right.
TEST(CheckpointErrors, ForgedNumbers) {
    const QLearning<> learner(4, 2);
    const std::string bytes = save_to_bytes(learner);
    const std::string gamma(reinterpret_cast<const char*>(&learner.params().gamma), sizeof(double));
    const std::size_t at = bytes.find(gamma);
    ASSERT_NE(at, std::string::npos);
    std::string forged = bytes;
    forged.replace(at, 7, 7, '\xFF');
    forged[at + 7] = '\x7F';  // NaN
    EXPECT_EQ(refusal(with_checksums(forged), learner),
              "checkpoint robot: section 'parameters': gamma must lie in [0, 1], got nan");
    forged = bytes;
    const std::size_t random = forged.find("random");
    forged.replace(random + 16 + 4, 32, 32, '\0');
    EXPECT_EQ(refusal(with_checksums(forged), learner),
              "checkpoint robot: section 'random': the random generator is all zeros");
}

class CheckpointFiles : public FileTest {};

TEST_F(CheckpointFiles, SaysWhatIsWrongWithAPath) {
    QLearning<> learner(4, 2);
    EXPECT_EQ(error_of<std::runtime_error>([&] { load(path("none"), learner); }),
              "cannot read " + path("none") + ": No such file or directory");
    EXPECT_EQ(error_of<std::runtime_error>([&] { load(directory_.string(), learner); }),
              "cannot read " + directory_.string() + ": Is a directory");
    EXPECT_EQ(error_of<std::runtime_error>([&] { save(learner, path("none/robot")); }),
              "cannot write " + path("none/robot") + ": No such file or directory");
}

TEST_F(CheckpointFiles, AFullDiskLeavesTheOldOne) {
    QLearning<> learner(4, 2);
    save(learner, path("robot"));
    const std::string old = content(path("robot"));
    EXPECT_TRUE(in_child([&] {
        QLearning<> larger(5000, 2);
        return limit_files_to(10000) && error_of<std::runtime_error>([&] { save(larger, path("robot")); }) ==
                                            "cannot write " + path("robot") + ": File too large";
    }));
    EXPECT_EQ(content(path("robot")), old);
    EXPECT_EQ(files(), 1u);
}
