// SPDX-License-Identifier: MIT
#include <sspql/learn/schedule.hpp>

#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <variant>

#include <gtest/gtest.h>

namespace sspql_schedule_test {

using sspql::Constant;
using sspql::ExponentialDecay;
using sspql::Schedule;
using sspql::VisitDecay;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::uint64_t counts[] = {0, 1, 2, 3, 10, 1022, 1023, 1024, 1025, 100000, std::uint64_t{1} << 40};

}  // namespace

TEST(Schedule, ConstantStays) {
    const Schedule number = 0.8;
    const Schedule rule = Constant{0.8};
    for (const std::uint64_t n : counts) {
        EXPECT_EQ(number(n), 0.8);
        EXPECT_EQ(rule(n), 0.8);
    }
    EXPECT_EQ(number.greatest(), 0.8);
    EXPECT_EQ(Schedule(Constant{})(5), 1.0);
}

TEST(Schedule, VisitDecayIsEq9) {
    for (const double p : {0.0, 0.5, 1.0, 2.0, 7.0}) {
        const Schedule decay = VisitDecay{p};
        for (const std::uint64_t n : counts) {
            EXPECT_EQ(decay(n), n <= 1 ? 1.0 : std::pow(static_cast<double>(n), -p)) << p << ", " << n;
        }
        EXPECT_EQ(decay.greatest(), 1.0);
    }
    EXPECT_EQ(Schedule(VisitDecay{})(2), 0.25) << "p is 2 unless told otherwise";
}

TEST(Schedule, ExponentialDecayFallsToItsFloor) {
    const Schedule decay = ExponentialDecay{0.9, 0.01, 0.1};
    EXPECT_EQ(decay(0), 0.9);
    EXPECT_EQ(decay.greatest(), 0.9);
    for (const std::uint64_t n : counts)
        EXPECT_EQ(decay(n), 0.1 + (0.9 - 0.1) * std::exp(-0.01 * static_cast<double>(n)));
    EXPECT_EQ(decay(std::uint64_t{1} << 40), 0.1);
    EXPECT_EQ(Schedule(ExponentialDecay{0.5, 0.0, 0.5})(77), 0.5);
}

TEST(Schedule, NoRuleGrows) {
    for (const Schedule& schedule :
         {Schedule(0.3), Schedule(VisitDecay{0.7}), Schedule(ExponentialDecay{1.0, 0.002, 0.0})}) {
        double before = schedule.greatest();
        for (std::uint64_t n = 0; n < 3000; ++n) {
            EXPECT_LE(schedule(n), before) << n;
            before = schedule(n);
        }
    }
}

TEST(Schedule, RefusesParametersOutside) {
    for (const double bad : {-0.1, not_a_number, infinity}) {
        EXPECT_THROW(Schedule{bad}, std::invalid_argument);
        EXPECT_THROW(Schedule{Constant{bad}}, std::invalid_argument);
        EXPECT_THROW(Schedule{VisitDecay{bad}}, std::invalid_argument);
        EXPECT_THROW(Schedule(ExponentialDecay{1.0, bad, 0.0}), std::invalid_argument);
        EXPECT_THROW(Schedule(ExponentialDecay{1.0, 0.1, bad}), std::invalid_argument);
        EXPECT_THROW(Schedule(ExponentialDecay{bad, 0.1, 0.0}), std::invalid_argument);
    }
    EXPECT_THROW(Schedule(ExponentialDecay{0.1, 0.1, 0.2}), std::invalid_argument) << "start below floor";
}

TEST(Schedule, KeepsItsRuleAndCopies) {
    const Schedule decay = VisitDecay{3.0};
    Schedule copy = 1.0;
    copy = decay;
    EXPECT_EQ(std::get<VisitDecay>(copy.rule()).p, 3.0);
    EXPECT_EQ(copy(2), decay(2));
    {
        const Schedule gone = copy;
        copy = gone;
    }
    EXPECT_EQ(copy(10), decay(10)) << "the table outlives the object it was copied from";
}

}  // namespace sspql_schedule_test
