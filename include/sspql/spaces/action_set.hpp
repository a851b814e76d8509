// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>

#include <sspql/core/errors.hpp>
#include <sspql/core/ids.hpp>
#include <sspql/spaces/action_policy.hpp>

namespace sspql {

/// A set of actions out of 0 .. size - 1, by value and without allocation: the mask of what a robot may do now.
/// Up to `most` actions. All operations O(1) except is_empty and count, O(size / 64).
///
/// \throws std::invalid_argument for a size of 0 or above `most`, or an action outside.
class ActionSet {
public:
    /// The largest size a set can have.
    static constexpr std::size_t most = 256;

    /// No actions out of 0 .. size - 1.
    [[nodiscard]] static ActionSet none(std::size_t size) { return ActionSet(size); }

    /// All actions 0 .. size - 1.
    [[nodiscard]] static ActionSet all(std::size_t size) {
        ActionSet set(size);
        for (std::size_t a = 0; a < size; ++a) set.words_[a / 64] |= std::uint64_t{1} << (a % 64);
        return set;
    }

    /// These actions out of 0 .. size - 1.
    [[nodiscard]] static ActionSet of(std::size_t size, std::initializer_list<ActionId> actions) {
        ActionSet set(size);
        for (const ActionId a : actions) set.insert(a);
        return set;
    }

    /// Adds an action.
    void insert(ActionId a) { words_[index(require(a)) / 64] |= std::uint64_t{1} << (index(a) % 64); }
    /// Removes an action.
    void erase(ActionId a) { words_[index(require(a)) / 64] &= ~(std::uint64_t{1} << (index(a) % 64)); }

    /// False also for actions outside the size.
    [[nodiscard]] bool contains(ActionId a) const noexcept {
        return index(a) < size_ && ((words_[index(a) / 64] >> (index(a) % 64)) & 1u) != 0;
    }

    /// How many actions there are to choose from, in the set or not.
    [[nodiscard]] std::size_t size() const noexcept { return size_; }

    /// How many actions are in the set.
    [[nodiscard]] std::size_t count() const noexcept {
        std::size_t n = 0;
        for (std::size_t a = 0; a < size_; ++a) n += contains(action_id(a)) ? 1u : 0u;
        return n;
    }

    /// Whether no action is in the set.
    [[nodiscard]] bool is_empty() const noexcept { return (words_[0] | words_[1] | words_[2] | words_[3]) == 0; }

    /// Actions 64 i to 64 i + 63 as bits, the least first; i < 4.
    [[nodiscard]] std::uint64_t word(std::size_t i) const noexcept { return words_[i]; }

    /// The same size and the same actions.
    friend bool operator==(const ActionSet& a, const ActionSet& b) noexcept {
        return a.size_ == b.size_ && a.words_ == b.words_;
    }
    /// Another size or other actions.
    friend bool operator!=(const ActionSet& a, const ActionSet& b) noexcept { return !(a == b); }

private:
    explicit ActionSet(std::size_t size) : size_(size) {
        if (size == 0 || size > most) throw_invalid("size of an action set", "lie between 1 and 256", size);
    }

    [[nodiscard]] ActionId require(ActionId a) const { return detail::require_action_of(a, size_); }

    std::array<std::uint64_t, 4> words_{};
    std::size_t size_;
};

}  // namespace sspql
