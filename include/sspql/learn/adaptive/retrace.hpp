// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <sspql/core/ids.hpp>
#include <sspql/core/serialization.hpp>
#include <sspql/learn/transition.hpp>

namespace sspql {

/// Which actions undo which, learnt from what was done right after what; and so, which untried actions would probably lead
/// back to where the agent has been. While no goal is known these can wait.
///
/// rate(s, b) = max over the actions a by which s was entered of hits(a,b) / (trials(a,b) + 2), where a trial is b taken
/// right after a led from one state to another, and a hit is one that led back. In a world where nothing can be undone all
/// rates stay near 0. For up to 64 actions; beyond, all rates are 0. O(|A|) a call; memory 8 bytes a state and 16 |A|^2.
class Retrace {
public:
    /// Nothing is known to undo anything.
    Retrace(std::size_t states, std::size_t actions)
        : actions_(actions), entered_by_(states, 0), hits_(small() ? actions * actions : 0), trials_(hits_.size()) {}

    /// More states, never entered.
    void grow(std::size_t states) {
        if (states > entered_by_.size()) entered_by_.resize(states, 0);
    }
    /// Room for that many states.
    void reserve(std::size_t states) { entered_by_.reserve(states); }

    /// What was done last is not what the next action follows.
    void begin_episode() noexcept { last_action_ = no_action; }

    /// Takes in a step, right after the last one unless an episode began since.
    void observe(const Transition& t) {
        if (last_action_ != no_action && last_arrival_ == t.state && small()) {
            const std::size_t at = index(last_action_) * actions_ + index(t.action);
            trials_[at] += 1.0;
            if (t.next == last_from_) hits_[at] += 1.0;
        }
        if (t.next == t.state) {
            last_action_ = no_action;
            return;
        }
        if (small()) entered_by_[index(t.next)] |= std::uint64_t{1} << index(t.action);
        last_action_ = t.action;
        last_from_ = t.state;
        last_arrival_ = t.next;
    }

    /// The action that has just led from another state to s; no_action if none did.
    [[nodiscard]] ActionId heading(StateId s) const noexcept {
        return last_action_ != no_action && last_arrival_ == s ? last_action_ : no_action;
    }

    /// How likely b leads from s back to where s was entered from, in [0, 1).
    [[nodiscard]] double rate(StateId s, ActionId b) const noexcept {
        double greatest = 0.0;
        for (std::uint64_t left = entered_by_[index(s)], a = 0; left != 0; left >>= 1, ++a) {
            if ((left & 1u) == 0) continue;
            const std::size_t at = a * actions_ + index(b);
            const double rate = hits_[at] / (trials_[at] + 2.0);
            if (rate > greatest) greatest = rate;
        }
        return greatest;
    }

private:
    friend SerializationAccess;

    template <class Archive>
    void serialize(Archive& archive) {
        archive.fixed(entered_by_);
        archive.fixed(hits_);
        archive.fixed(trials_);
        archive(last_action_, last_from_, last_arrival_);
        archive.require(last_action_ == no_action || index(last_action_) < actions_, "the last action is none");
        for (const std::uint64_t actions : entered_by_) {
            archive.require(actions == 0 || (small() && (actions_ == 64 || actions >> actions_ == 0)),
                            "a state was entered by no action");
        }
    }

    [[nodiscard]] bool small() const noexcept { return actions_ <= 64; }

    std::size_t actions_;
    std::vector<std::uint64_t> entered_by_;  // a set of actions, by state
    std::vector<double> hits_;
    std::vector<double> trials_;
    ActionId last_action_ = no_action;
    StateId last_from_ = no_state;
    StateId last_arrival_ = no_state;
};

}  // namespace sspql
