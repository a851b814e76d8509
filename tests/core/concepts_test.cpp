// SPDX-License-Identifier: MIT
#include <sspql/core/concepts.hpp>

#include <string>
#include <type_traits>

#include <gtest/gtest.h>

namespace {

template <class T>
using SizeOf = decltype(std::declval<const T&>().size());

struct Sized {
    int size() const { return 3; }
};

using sspql::detail::detected_t;
using sspql::detail::is_detected_convertible_v;
using sspql::detail::is_detected_v;

static_assert(is_detected_v<SizeOf, Sized>);
static_assert(!is_detected_v<SizeOf, int>);
static_assert(std::is_same_v<detected_t<SizeOf, Sized>, int>);
static_assert(std::is_default_constructible_v<detected_t<SizeOf, int>>, "a placeholder, not an error");
static_assert(is_detected_convertible_v<double, SizeOf, Sized>);
static_assert(!is_detected_convertible_v<std::string, SizeOf, Sized>);
static_assert(!is_detected_convertible_v<double, SizeOf, int>);

}  // namespace

TEST(Concepts, DetectAnExpression) { EXPECT_EQ(Sized{}.size(), 3); }
