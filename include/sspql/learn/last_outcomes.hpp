// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <sspql/core/ids.hpp>
#include <sspql/core/serialization.hpp>
#include <sspql/learn/transition.hpp>
#include <sspql/model/prefetch.hpp>

namespace sspql {

/// The (s,a) that were tried, each once, in the order of the first try, with what happened last: what Dyna-Q draws from.
/// observe is O(1) amortised; memory 4 bytes an (s,a) and 48 a tried one.
class LastOutcomes {
public:
    /// Nothing tried.
    explicit LastOutcomes(std::size_t actions) : actions_(actions) {}

    /// Room for all (s,a) of that many states.
    void reserve(std::size_t states) {
        place_.reserve(states * actions_);
        tried_.reserve(states * actions_);
    }

    /// Takes in a step: the last outcome of its (s,a) from now on.
    void observe(const Transition& t) {
        const std::size_t at = index(t.state) * actions_ + index(t.action);
        if (place_.size() <= at) place_.resize((index(t.state) + 1) * actions_, none);
        if (place_[at] == none) {
            place_[at] = static_cast<std::uint32_t>(tried_.size());
            tried_.push_back(t);
        } else {
            tried_[place_[at]] = t;
        }
    }

    /// How many (s,a) were tried.
    [[nodiscard]] std::size_t size() const noexcept { return tried_.size(); }

    /// The i-th of them with its last outcome.
    [[nodiscard]] const Transition& tried(std::size_t i) const noexcept { return tried_[i]; }

    /// For somebody who soon looks at tried(i): has it fetched into the cache.
    void prefetch(std::size_t i) const noexcept { detail::prefetch(&tried_[i]); }

    /// The last outcome of (s,a), or nullptr.
    [[nodiscard]] const Transition* find(StateId s, ActionId a) const noexcept {
        const std::size_t at = index(s) * actions_ + index(a);
        return at < place_.size() && place_[at] != none ? &tried_[place_[at]] : nullptr;
    }

private:
    friend SerializationAccess;

    template <class Archive>
    void serialize(Archive& archive, std::size_t states) {
        archive(tried_);
        if constexpr (Archive::loading) {
            place_.clear();
            for (std::size_t i = 0; i < tried_.size(); ++i) {
                const Transition& t = tried_[i];
                archive.require(index(t.state) < states && index(t.next) < states && index(t.action) < actions_ &&
                                    find(t.state, t.action) == nullptr,
                                "the list of outcomes is wrong");
                const std::size_t at = index(t.state) * actions_ + index(t.action);
                if (place_.size() <= at) place_.resize((index(t.state) + 1) * actions_, none);
                place_[at] = static_cast<std::uint32_t>(i);
            }
        }
    }

    static constexpr std::uint32_t none = 0xFFFFFFFFu;

    std::size_t actions_;
    std::vector<std::uint32_t> place_;
    std::vector<Transition> tried_;
};

}  // namespace sspql
