// SPDX-License-Identifier: MIT
#include <sspql/env/environment.hpp>

#include <cstdint>
#include <string>

#include <gtest/gtest.h>

namespace {

struct Corridor {
    int reset(std::uint64_t) { return at = 0; }
    sspql::Step<int> step(const int& move) { return {at += move, 0.0, at == 3, false}; }
    int at = 0;
};

/// A user's own step type, with another order of members and more of them.
struct OwnStep {
    bool truncated = false;
    bool terminated = false;
    float reward = 0.0f;
    std::string observation;
    int battery = 0;
};
struct OwnTypes {
    std::string reset(std::uint64_t) { return "start"; }
    OwnStep step(const std::string&) { return {}; }
};

struct NoReset {
    sspql::Step<int> step(const int&) { return {}; }
};
struct NoStep {
    int reset(std::uint64_t) { return 0; }
};
struct GymStep {
    int observation = 0;
    double reward = 0.0;
    bool done = false;
};
struct OldGym {
    int reset(std::uint64_t) { return 0; }
    GymStep step(const int&) { return {}; }
};

}  // namespace

static_assert(sspql::is_environment_v<Corridor, int>);
static_assert(sspql::is_environment_v<OwnTypes, std::string>);
static_assert(!sspql::is_environment_v<Corridor, std::string>, "another command");
static_assert(!sspql::is_environment_v<NoReset, int>);
static_assert(!sspql::is_environment_v<NoStep, int>);
static_assert(!sspql::is_environment_v<OldGym, int>);
static_assert(std::is_same_v<sspql::ObservationOf<OwnTypes>, std::string>);

TEST(Environment, StepIsNeitherTerminatedNorTruncatedUnlessSaid) {
    const sspql::Step<int> step{};
    EXPECT_FALSE(step.terminated);
    EXPECT_FALSE(step.truncated);
    EXPECT_EQ(step.reward, 0.0);
}
