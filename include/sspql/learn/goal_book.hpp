// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <sspql/core/ids.hpp>
#include <sspql/core/serialization.hpp>
#include <sspql/learn/transition.hpp>
#include <sspql/paths/shortest_paths.hpp>

namespace sspql {

/// Which states are goals. Given ones (set) hold alone; without them goals are discovered: a state where an episode
/// terminated with reward > 0, and, once a non-terminal reward other than 0 was seen (steps have costs), every state
/// where one terminated. Other terminal states are hazards. A discovered goal that is later passed through without
/// terminating is one no longer. observe is O(1), O(states where episodes ended) when it forgets one; memory 1 byte a
/// state.
class GoalBook {
public:
    /// No goals among this many states.
    explicit GoalBook(std::size_t states = 0) : kind_(states, Kind::plain) {}

    /// More states, none a goal.
    void grow(std::size_t states) {
        if (states > kind_.size()) kind_.resize(states, Kind::plain);
    }

    /// Room for that many states.
    void reserve(std::size_t states) { kind_.reserve(states); }

    /// Takes in a step: its next state may be a goal, or none any longer.
    void observe(const Transition& t) {
        if (!t.terminated && t.reward != 0.0) costs_seen_ = true;
        Kind& kind = kind_[index(t.next)];
        if (!t.terminated) {
            if (kind != Kind::plain) forget(t.next, kind);
            return;
        }
        const Kind now = t.reward > 0.0 || kind == Kind::rewarding ? Kind::rewarding : Kind::terminal;
        if (kind == Kind::plain) ends_.push_back(t.next);
        kind = now;
    }

    /// These hold from now on; none: discovered ones again.
    void set(const std::vector<Goal>& goals) { given_ = goals; }

    /// The goals that hold now, each with its offset (0 for discovered ones), in the order they were found. O(number of
    /// states where episodes ended).
    [[nodiscard]] std::vector<Goal> goals() const {
        if (!given_.empty()) return given_;
        std::vector<Goal> goals;
        for (const StateId s : ends_) {
            if (costs_seen_ || kind_[index(s)] == Kind::rewarding) goals.push_back({s, 0.0});
        }
        return goals;
    }

private:
    friend SerializationAccess;

    template <class Archive>
    void serialize(Archive& archive) {
        archive.fixed(kind_);
        archive(ends_, given_, costs_seen_);
        if constexpr (Archive::loading) {
            std::size_t ends = 0;
            for (const Kind kind : kind_) {
                archive.require(kind <= Kind::rewarding, "there is no such kind of state");
                ends += kind != Kind::plain ? 1u : 0u;
            }
            archive.require(ends == ends_.size(), "the list of goals is incomplete");
            std::vector<bool> listed(kind_.size(), false);
            for (const StateId s : ends_) {
                archive.require(index(s) < kind_.size() && kind_[index(s)] != Kind::plain && !listed[index(s)],
                                "the list of goals is wrong");
                listed[index(s)] = true;
            }
            detail::require_goals(given_, kind_.size());
        }
    }

    enum class Kind : std::uint8_t { plain, terminal, rewarding };

    void forget(StateId s, Kind& kind) {
        kind = Kind::plain;
        ends_.erase(std::find(ends_.begin(), ends_.end(), s));
    }

    std::vector<Kind> kind_;
    std::vector<StateId> ends_;
    std::vector<Goal> given_;
    bool costs_seen_ = false;
};

}  // namespace sspql
