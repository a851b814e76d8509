// SPDX-License-Identifier: MIT
#include <sspql/core/errors.hpp>

#include <clocale>
#include <cmath>
#include <limits>
#include <locale>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

template <class F>
std::string refusal(F&& f) {
    try {
        f();
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "accepted";
}

/// Writes 1.5 as "1,5" and 1000 as "1.000".
struct GermanNumbers : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
};

}  // namespace

TEST(Errors, NameTheParameterTheRequirementAndTheValue) {
    EXPECT_EQ(refusal([] { sspql::require_in("gamma", 1.5, 0.0, 1.0); }), "gamma must lie in [0, 1], got 1.5");
    EXPECT_EQ(refusal([] { sspql::require_finite("reward", not_a_number); }), "reward must be finite, got nan");
    EXPECT_EQ(refusal([] { sspql::require_finite("reward", -infinity); }), "reward must be finite, got -inf");
    EXPECT_EQ(refusal([] { sspql::require_positive("noise", 0.0); }), "noise must be finite and > 0, got 0");
    EXPECT_EQ(refusal([] { sspql::require_not_negative("w_q", -1e-9); }), "w_q must be finite and >= 0, got -1e-09");
    EXPECT_EQ(refusal([] { sspql::throw_invalid("states", "be even", 3); }), "states must be even, got 3");
    EXPECT_EQ(refusal([] { sspql::throw_invalid("name", "be short", std::string("long")); }),
              "name must be short, got long");
}

TEST(Errors, ShowTheDigitsThatAreWrong) {
    EXPECT_EQ(refusal([] { sspql::require_in("alpha", std::nextafter(1.0, 2.0), 0.0, 1.0); }),
              "alpha must lie in [0, 1], got 1.0000000000000002");
    EXPECT_EQ(refusal([] { sspql::require_in("alpha", 1.1, 0.0, 1.0); }), "alpha must lie in [0, 1], got 1.1");
    EXPECT_EQ(refusal([] { sspql::throw_invalid("n", "stay small", 4294967295u); }),
              "n must stay small, got 4294967295");
}

TEST(Errors, TextDoesNotDependOnTheLocale) {
    const std::locale before = std::locale::global(std::locale(std::locale::classic(), new GermanNumbers));
    const std::string real = refusal([] { sspql::require_in("gamma", 1.5, 0.0, 1.0); });
    const std::string whole = refusal([] { sspql::throw_invalid("n", "stay small", 4294967295u); });
    std::locale::global(before);
    EXPECT_EQ(real, "gamma must lie in [0, 1], got 1.5");
    EXPECT_EQ(whole, "n must stay small, got 4294967295");
}

TEST(Errors, AcceptedValuesPassThrough) {
    EXPECT_EQ(sspql::require_finite("x", -3.5), -3.5);
    EXPECT_EQ(sspql::require_in("x", 0.0, 0.0, 1.0), 0.0);
    EXPECT_EQ(sspql::require_in("x", 1.0, 0.0, 1.0), 1.0);
    EXPECT_EQ(sspql::require_positive("x", 1e-300), 1e-300);
    EXPECT_EQ(sspql::require_not_negative("x", 0.0), 0.0);
}

TEST(Errors, NaNAndInfinityPassNoCheck) {
    for (const double bad : {not_a_number, infinity, -infinity}) {
        EXPECT_THROW(sspql::require_finite("x", bad), std::invalid_argument);
        EXPECT_THROW(sspql::require_in("x", bad, 0.0, 1.0), std::invalid_argument);
        EXPECT_THROW(sspql::require_positive("x", bad), std::invalid_argument);
        EXPECT_THROW(sspql::require_not_negative("x", bad), std::invalid_argument);
    }
}
