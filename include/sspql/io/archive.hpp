// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include <sspql/core/serialization.hpp>

namespace sspql {

/// What is common to writing and reading: which bytes a value has. Little-endian whatever the machine; numbers and enums
/// at their size, bool one byte; strings and vectors a length of 8 bytes, then the elements; arrays, pairs and tuples
/// their elements; other types what their member serialize (core/serialization.hpp) makes of them.
///
///     archive(a, b, ...)          these values
///     archive.size(n)             a std::size_t, 8 bytes on every machine (never give one to archive(...) directly)
///     archive.fixed(vector)       a vector that already has the right length; a file with another one is refused
///     archive.tag(what, name)     a name that must be the same when read: "the file has WHAT x, this is y"
///     archive.policy(what, p)     a policy object: its `static constexpr const char* type_name`, if it has one, as a
///                                 tag, and its state, if it is not an empty type
///     archive.require(ok, text)   reading: refuses the file unless ok
///     archive.section(name, f)    f() within a section of its own (at most 15 characters), with a checksum
///     Archive::loading            whether values are read
///
/// For implementers (CRTP): Derived supplies bytes(void*, size_t), left() = the most bytes that may still come, and
/// require, tag, section.
template <class Derived, bool reads>
class Archive {
public:
    /// Whether values are read.
    static constexpr bool loading = reads;

    /// Reads or writes these values, in this order.
    template <class... T>
    [[gnu::always_inline]] void operator()(T&... values) {
        (item(values), ...);
    }

    /// Reads or writes a std::size_t as 8 bytes.
    void size(std::size_t& n) {
        std::uint64_t wide = n;
        item(wide);
        if constexpr (reads) {
            self().require(wide <= std::numeric_limits<std::size_t>::max(), "a number is too large for this machine");
            n = static_cast<std::size_t>(wide);
        }
    }

    /// Reads or writes a vector whose length is known; a file with another one is refused.
    template <class T>
    void fixed(std::vector<T>& values) {
        std::size_t n = values.size();
        size(n);
        self().require(n == values.size(), "a table has another size than the learner's");
        elements(values);
    }

    /// Reads or writes a policy object: its name as a tag, and its state.
    template <class T>
    void policy(const char* what, T& object) {
        if constexpr (has_name<T>(0)) {
            self().tag(what, T::type_name);
        } else {
            self().tag(what, "");
        }
        if constexpr (!std::is_empty_v<T>) item(object);
    }

protected:
    Archive() = default;
    ~Archive() = default;

private:
    Derived& self() noexcept { return static_cast<Derived&>(*this); }

    template <class T>
    static constexpr auto has_name(int) -> decltype(T::type_name, true) {
        return true;
    }
    template <class T>
    static constexpr bool has_name(...) {
        return false;
    }

    static bool little_endian() noexcept {
        const std::uint16_t one = 1;
        unsigned char first = 0;
        std::memcpy(&first, &one, 1);
        return first == 1;
    }

    /// Numbers whose bytes in memory are those in the file, on a little-endian machine.
    template <class T>
    static constexpr bool plain = (std::is_arithmetic_v<T> || std::is_enum_v<T>) && !std::is_same_v<T, bool>;

    template <class T>
    [[gnu::always_inline]] void item(T& value) {
        static_assert(!std::is_const_v<T>, "sspql: serialize is not a const member");
        if constexpr (std::is_same_v<T, bool>) {
            auto byte = static_cast<std::uint8_t>(value ? 1 : 0);
            self().bytes(&byte, 1);
            if constexpr (reads) {
                self().require(byte <= 1, "a truth value is neither 0 nor 1");
                value = byte == 1;
            }
        } else if constexpr (plain<T>) {
            static_assert(!std::is_floating_point_v<T> || (std::numeric_limits<T>::is_iec559 && sizeof(T) <= 8),
                          "sspql: only IEEE floats and doubles can be saved");
            number(value);
        } else if constexpr (SerializationAccess::possible<T, Derived>()) {
            SerializationAccess::serialize(value, self());
        } else {
            compound(value);
        }
    }

    template <class T>
    [[gnu::always_inline]] void number(T& value) {
        if (little_endian()) {
            self().bytes(&value, sizeof(T));
            return;
        }
        std::array<unsigned char, sizeof(T)> reversed{};
        if constexpr (!reads) {
            std::memcpy(reversed.data(), &value, sizeof(T));
            for (std::size_t i = 0; i < sizeof(T) / 2; ++i) std::swap(reversed[i], reversed[sizeof(T) - 1 - i]);
        }
        self().bytes(reversed.data(), sizeof(T));
        if constexpr (reads) {
            for (std::size_t i = 0; i < sizeof(T) / 2; ++i) std::swap(reversed[i], reversed[sizeof(T) - 1 - i]);
            std::memcpy(&value, reversed.data(), sizeof(T));
        }
    }

    template <class T>
    struct unsupported : std::false_type {};

    template <class T>
    void compound(T& /*value*/) {
        static_assert(unsupported<T>::value,
                      "sspql: this type cannot be saved; it lacks `template <class Archive> void serialize(Archive&)`");
    }
    template <class A, class B>
    void compound(std::pair<A, B>& value) {
        (*this)(value.first, value.second);
    }
    template <class... T>
    void compound(std::tuple<T...>& value) {
        std::apply([this](T&... elements) { (*this)(elements...); }, value);
    }
    template <class T, std::size_t n>
    void compound(std::array<T, n>& values) {
        for (T& value : values) item(value);
    }
    void compound(std::string& text) { list(text); }
    template <class T>
    void compound(std::vector<T>& values) {
        list(values);
    }

    template <class List>
    void list(List& values) {
        std::size_t n = values.size();
        size(n);
        if constexpr (reads) {
            // An element takes a byte at least, a number all of its bytes: no more memory than there is file.
            using T = typename List::value_type;
            self().require(n <= self().left() / (plain<T> ? sizeof(T) : 1), "a list is longer than the section");
            values.clear();
            if constexpr (plain<T>) {
                values.resize(n);
            } else {
                return grow(values, n);
            }
        }
        elements(values);
    }

    /// Reads n elements, asking for memory in step with what the file really holds.
    template <class List>
    void grow(List& values, std::size_t n) {
        const std::size_t before = self().left();
        for (std::size_t i = 0; i < n; ++i) {
            values.emplace_back();
            item(values.back());
            if (i != 0) continue;
            const std::size_t taken = before - self().left();
            const std::size_t most = self().left() / (taken == 0 ? 1 : taken) + 1;
            values.reserve(n < most ? n : most);
        }
    }

    template <class List>
    void elements(List& values) {
        using T = typename List::value_type;
        if (values.empty()) return;  // data() may be null
        if constexpr (plain<T>) {
            if (little_endian()) return self().bytes(values.data(), values.size() * sizeof(T));
        }
        for (T& value : values) item(value);
    }
};

}  // namespace sspql
