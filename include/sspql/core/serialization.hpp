// SPDX-License-Identifier: MIT
#pragma once

#include <type_traits>
#include <utility>

/// \file
/// Serializable (concept): a type whose state an archive can write and read. One member for both directions:
///
///     template <class Archive>
///     void serialize(Archive& archive) {
///         archive(first_, second_);                                          // in a fixed order
///         archive.require(first_ <= second_, "the first is the smaller");    // reading only: refuses the file
///     }
///
/// What an archive offers is described in io/archive.hpp. serialize may be private if the type declares
/// `friend sspql::SerializationAccess;`. While writing it must not change anything; while reading it may rely on
/// nothing it has read, since the file may be a forgery: whatever later code takes for granted has to be required.

namespace sspql {

/// Calls serialize where it is private.
struct SerializationAccess {
    /// `context`: what some private members want besides, to check what they read.
    template <class T, class Archive, class... Context>
    static void serialize(T& object, Archive& archive, const Context&... context) {
        object.serialize(archive, context...);
    }

    /// Whether T has a member serialize(Archive&).
    template <class T, class Archive>
    [[nodiscard]] static constexpr bool possible() {
        return decltype(test<T, Archive>(0))::value;
    }

private:
    template <class T, class Archive>
    static auto test(int)
        -> decltype(std::declval<T&>().serialize(std::declval<Archive&>()), std::true_type{});
    template <class, class>
    static std::false_type test(...);
};

}  // namespace sspql
