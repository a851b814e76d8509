// SPDX-License-Identifier: MIT
#include <sspql/env/random_mdp.hpp>

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include <sspql/learn/exact_steps.hpp>

using sspql::action_id;
using sspql::random_mdp;
using sspql::RandomMdpParams;
using sspql::state_id;

namespace {

std::string error_of(const RandomMdpParams& params) {
    try {
        (void)random_mdp(params, 1);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "no error";
}

}  // namespace

TEST(RandomMdp, HasWhatWasAskedFor) {
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        const sspql::TransitionTable table = random_mdp({12, 3, 4, -1.0, 0.25, 2.0}, seed);
        EXPECT_EQ(table.states(), 12u);
        EXPECT_EQ(table.actions(), 3u);
        EXPECT_EQ(table.size(), 11u * 3u * 4u);
        EXPECT_EQ(table.starts().size(), 11u);
        for (std::size_t s = 0; s < 11; ++s) {
            for (std::size_t a = 0; a < 3; ++a) {
                const auto outcomes = table.outcomes(state_id(s), action_id(a));
                ASSERT_EQ(outcomes.size(), 4u);
                for (std::size_t i = 0; i < 4; ++i) {
                    EXPECT_TRUE(i == 0 || outcomes[i - 1].next < outcomes[i].next);
                    EXPECT_GE(outcomes[i].probability, 1.0 / 80.0);
                    EXPECT_EQ(outcomes[i].terminal, outcomes[i].next == state_id(11));
                    if (outcomes[i].terminal) {
                        EXPECT_EQ(outcomes[i].reward, 2.0);
                    } else {
                        EXPECT_GE(outcomes[i].reward, -1.0);
                        EXPECT_LT(outcomes[i].reward, 0.25);
                    }
                }
            }
        }
    }
}

TEST(RandomMdp, ReachesItsGoalFromEverywhere) {
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        EXPECT_TRUE(sspql::optimal_steps(random_mdp({40, 2, 1}, seed)).has_value()) << seed;  // deterministic
        EXPECT_TRUE(sspql::optimal_steps(random_mdp({40, 1, 2}, seed)).has_value()) << seed;
        EXPECT_TRUE(sspql::optimal_steps(random_mdp({2, 1, 2}, seed)).has_value()) << seed;
    }
}

TEST(RandomMdp, IsDecidedByItsSeed) {
    const auto a = random_mdp({}, 3);
    const auto b = random_mdp({}, 3);
    const auto c = random_mdp({}, 4);
    ASSERT_EQ(a.size(), b.size());
    bool differs = false;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto of_a = a.outcomes(state_id(0), action_id(0));
        const auto of_b = b.outcomes(state_id(0), action_id(0));
        const auto of_c = c.outcomes(state_id(0), action_id(0));
        EXPECT_EQ(of_a[i].next, of_b[i].next);
        EXPECT_EQ(of_a[i].probability, of_b[i].probability);
        differs = differs || of_a[i].probability < of_c[i].probability || of_a[i].probability > of_c[i].probability;
    }
    EXPECT_TRUE(differs);
}

TEST(RandomMdp, RefusesWhatCannotBe) {
    EXPECT_EQ(error_of({1, 1, 1}), "number of states must be at least 2, got 1");
    EXPECT_EQ(error_of({2, 0, 1}), "number of actions must lie between 1 and 4294967294, got 0");
    EXPECT_EQ(error_of({2, 1, 0}), "branching must lie between 1 and 2, got 0");
    EXPECT_EQ(error_of({2, 1, 3}), "branching must lie between 1 and 2, got 3");
    EXPECT_EQ(error_of({2, 1, 1, 0.5, 0.0}), "greatest_reward must be at least the least reward, got 0");
}
