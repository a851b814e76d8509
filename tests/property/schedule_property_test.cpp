// SPDX-License-Identifier: MIT
// Eq. 9 asks of every weight: in [0, 1], and falling.
#ifdef SSPQL_HAS_RAPIDCHECK
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstdint>

#include <sspql/learn/exploration_bonus.hpp>
#include <sspql/learn/schedule.hpp>

namespace {

/// A number from 0 to `most` in steps of a thousandth.
double fraction(double most) { return most * *rc::gen::inRange(0, 1001) / 1000.0; }

/// A count; half of them about 1024, where the tables end.
std::uint64_t count() {
    return *rc::gen::oneOf(rc::gen::inRange<std::uint64_t>(0, 5000), rc::gen::inRange<std::uint64_t>(1000, 1050),
                           rc::gen::inRange<std::uint64_t>(0, std::uint64_t{1} << 40));
}

/// {value after n, value after n + k}, in [0, 1] and falling.
template <class Decaying>
void expect_falling(const Decaying& decaying) {
    const std::uint64_t n = count();
    const double before = decaying(n);
    const double after = decaying(n + count());
    RC_ASSERT(before <= 1.0);
    RC_ASSERT(after <= before);
    RC_ASSERT(after >= 0.0);
    RC_ASSERT(decaying(0) >= before);
}

}  // namespace

RC_GTEST_PROP(ScheduleProperty, VisitDecayFallsWithinZeroToOne, ()) {
    const sspql::Schedule schedule = sspql::VisitDecay{fraction(6.0)};
    RC_ASSERT(schedule(0) == 1.0);
    RC_ASSERT(schedule(1) == 1.0);
    RC_ASSERT(schedule.greatest() == 1.0);
    expect_falling(schedule);
}

RC_GTEST_PROP(ScheduleProperty, ExponentialDecayFallsFromItsStartToItsFloor, ()) {
    const double start = fraction(1.0);
    const double floor = start * fraction(1.0);
    const sspql::Schedule schedule = sspql::ExponentialDecay{start, fraction(2.0), floor};
    expect_falling(schedule);
    RC_ASSERT(schedule(count()) >= floor);
    RC_ASSERT(schedule.greatest() == schedule(0));
}

RC_GTEST_PROP(ScheduleProperty, ConstantStays, ()) {
    const double value = fraction(1.0);
    const sspql::Schedule schedule = value;
    RC_ASSERT(schedule(count()) == value);
    expect_falling(schedule);
}

RC_GTEST_PROP(ScheduleProperty, ExplorationBonusFallsWithinZeroToOne, ()) {
    const sspql::ExplorationBonus bonus(fraction(4.0));
    RC_ASSERT(bonus(0) == 1.0);
    expect_falling(bonus);
}
#endif
