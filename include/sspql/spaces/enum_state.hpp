// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <type_traits>

#include <sspql/core/errors.hpp>
#include <sspql/core/ids.hpp>

namespace sspql {

/// StatePolicy for observations that already are a number: an enum or integer with values 0 to size - 1.
/// `encode` is O(1) and throws std::invalid_argument for a value outside.
///
/// \throws std::invalid_argument if size is 0 or above 2^32 - 2.
template <class T>
class EnumState {
    static_assert(std::is_enum_v<T> || std::is_integral_v<T>, "sspql: EnumState needs an enum or an integer type");

public:
    /// Values 0 to size - 1.
    explicit EnumState(std::size_t size) : size_(detail::require_id_count("number of states", size)) {}

    /// The number of states.
    [[nodiscard]] std::size_t size() const noexcept { return size_; }

    /// The state of a value: the one with its number.
    [[nodiscard]] StateId encode(T value) const {
        const auto number = static_cast<long long>(value);
        if (number < 0 || static_cast<unsigned long long>(number) >= size_) {
            throw_invalid("observation", "lie between 0 and " + std::to_string(size_ - 1), number);
        }
        return state_id(static_cast<std::size_t>(number));
    }

private:
    std::size_t size_;
};

}  // namespace sspql
