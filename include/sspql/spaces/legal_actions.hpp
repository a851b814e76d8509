// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <sspql/core/concepts.hpp>
#include <sspql/core/errors.hpp>
#include <sspql/core/ids.hpp>
#include <sspql/core/serialization.hpp>
#include <sspql/spaces/action_set.hpp>

/// \file
/// LegalActions (concept): which actions a state has. Learners choose among these only, and back up the best of these.
///
///     legal.allowed(StateId)              something with `.contains(ActionId) -> bool`
///
/// Ours: LegalActionTable (the default: everything, until a mask is given), AllActions (no masks ever, no memory).

namespace sspql {

namespace detail {

template <class L>
using AllowedExpression =
    decltype(static_cast<bool>(std::declval<const L&>().allowed(StateId{}).contains(ActionId{})));

template <class L>
using SetMaskExpression = decltype(std::declval<L&>().set(StateId{}, std::declval<const ActionSet&>()));

}  // namespace detail

/// Whether L answers `legal.allowed(state).contains(action)`.
template <class L>
inline constexpr bool is_legal_actions_v = detail::is_detected_v<detail::AllowedExpression, L>;

/// Whether masks can be stored in it: `legal.set(state, mask)`.
template <class L>
inline constexpr bool stores_masks_v = detail::is_detected_v<detail::SetMaskExpression, L>;

/// LegalActions: every action in every state.
struct AllActions {
    static constexpr const char* type_name = "all";  ///< in checkpoints

    /// Contains every action.
    struct Everything {
        /// True.
        [[nodiscard]] constexpr bool contains(ActionId) const noexcept { return true; }
    };
    /// Every action.
    [[nodiscard]] constexpr Everything allowed(StateId) const noexcept { return {}; }
};

/// LegalActions: the last mask given for each state; every action where none was given. No memory is used until the
/// first mask; then ceil(|A| / 64) words a state, grown when a higher state gets a mask.
class LegalActionTable {
public:
    static constexpr const char* type_name = "masks";  ///< in checkpoints

    /// A view into the table, valid until the next `set`.
    class Allowed {
    public:
        /// A view of these words, a bit an action; nullptr means every action.
        explicit Allowed(const std::uint64_t* words) noexcept : words_(words) {}
        /// Whether the action is allowed. Precondition (unchecked): it is one of the learner's.
        [[nodiscard]] bool contains(ActionId a) const noexcept {
            return words_ == nullptr || ((words_[index(a) / 64] >> (index(a) % 64)) & 1u) != 0;
        }

    private:
        const std::uint64_t* words_;
    };

    /// The actions of s: its last mask, or every action. O(1).
    [[nodiscard]] Allowed allowed(StateId s) const noexcept {
        const std::size_t begin = index(s) * stride_;
        return Allowed(begin < words_.size() ? words_.data() + begin : nullptr);
    }

    /// The mask of s from now on. O(|A| / 64), and growing the table where s is above all that have one.
    /// \throws std::invalid_argument for a mask without actions, or of another size than those before.
    void set(StateId s, const ActionSet& mask) {
        if (mask.is_empty()) throw_invalid("mask of state " + std::to_string(index(s)), "allow an action, of", mask.size());
        if (actions_ != 0 && mask.size() != actions_) {
            throw_invalid("size of an action mask", "stay " + std::to_string(actions_), mask.size());
        }
        const std::size_t stride = (mask.size() + 63) / 64;
        const std::size_t end = (index(s) + 1) * stride;
        if (end > words_.size()) words_.resize(end, ~std::uint64_t{0});  // unset states allow everything
        stride_ = stride;
        actions_ = mask.size();
        for (std::size_t i = 0; i < stride; ++i) words_[index(s) * stride + i] = mask.word(i);
    }

    /// The size of its masks; 0 while it has none.
    [[nodiscard]] std::size_t actions() const noexcept { return actions_; }

    /// Room for the masks of this many states and actions.
    void reserve(std::size_t states, std::size_t actions) { words_.reserve(states * ((actions + 63) / 64)); }

    /// Forgets all masks: everything is allowed again.
    void clear() noexcept {
        words_.clear();
        actions_ = 0;
    }

private:
    friend SerializationAccess;

    template <class Archive>
    void serialize(Archive& archive) {
        archive(words_);
        archive.size(actions_);
        archive.require(actions_ <= ActionSet::most, "a mask has too many actions");
        if constexpr (Archive::loading) stride_ = actions_ == 0 ? 1 : (actions_ + 63) / 64;
        archive.require(words_.size() % stride_ == 0 && words_.empty() == (actions_ == 0), "masks are incomplete");
        for (std::size_t at = 0; at < words_.size(); at += stride_) archive.require(allows_some(at), "a mask allows nothing");
    }

    [[nodiscard]] bool allows_some(std::size_t at) const noexcept {
        for (std::size_t a = 0; a < actions_; ++a) {
            if (((words_[at + a / 64] >> (a % 64)) & 1u) != 0) return true;
        }
        return false;
    }

    std::vector<std::uint64_t> words_;
    std::size_t stride_ = 1;
    std::size_t actions_ = 0;
};

}  // namespace sspql
