// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <sspql/core/errors.hpp>
#include <sspql/core/ids.hpp>
#include <sspql/model/transition_table.hpp>
#include <sspql/spaces/action_policy.hpp>
#include <sspql/spaces/state_policy.hpp>

namespace sspql {

/// What makes a table impossible, and which `add` brought it (the first is 0): a reader of files can name the line.
class TransitionTableError : public std::invalid_argument {
public:
    /// What the error is about.
    enum class Field { probability, next };

    /// What is wrong, which row is to blame, counted from 0, and which of its fields.
    TransitionTableError(const std::string& message, std::size_t row, Field field)
        : std::invalid_argument(message), row_(row), field_(field) {}
    /// Which `add` brought it; the first is 0.
    [[nodiscard]] std::size_t row() const noexcept { return row_; }
    /// Which of its arguments is to blame.
    [[nodiscard]] Field field() const noexcept { return field_; }

private:
    std::size_t row_;
    Field field_;
};

/// Collects the outcomes of a TransitionTable, in any order:
///
///     TransitionTableBuilder builder(2, 1);
///     builder.add(state_id(0), action_id(0), state_id(1), 0.3, 1.0, true);   // with p = 0.3 to the end, reward 1
///     builder.add(state_id(0), action_id(0), state_id(0), 0.7);              // else nothing
///     const TransitionTable table = builder.build();
///
/// Outcomes added with the same s, a, next, reward and terminal become one, their probabilities added up.
class TransitionTableBuilder {
    struct Row {
        StateId s;
        ActionId a;
        Outcome outcome;
        std::size_t number;

        [[nodiscard]] auto key() const {
            return std::make_tuple(s, a, outcome.next, outcome.reward, outcome.terminal, number);
        }
        [[nodiscard]] bool same_pair(const Row& other) const { return s == other.s && a == other.a; }
        [[nodiscard]] bool merges_with(const Outcome& other) const {
            return outcome.next == other.next && !(outcome.reward < other.reward) && !(other.reward < outcome.reward) &&
                   outcome.terminal == other.terminal;
        }
    };

public:
    /// The probabilities of an (s,a) must sum to 1 up to this.
    static constexpr double tolerance = 1e-9;

    /// No outcomes yet. \throws std::invalid_argument for no states or actions, or more than 2^32 - 2.
    TransitionTableBuilder(std::size_t states, std::size_t actions)
        : states_(detail::require_id_count("number of states", states)),
          actions_(detail::require_id_count("number of actions", actions)) {}

    /// An outcome of a in s. Terminal outcomes end the episode.
    /// \throws std::invalid_argument for an id outside, a probability outside (0, 1] or a reward that is not finite;
    /// nothing has changed then.
    TransitionTableBuilder& add(StateId s, ActionId a, StateId next, double probability, double reward = 0.0,
                                bool terminal = false) {
        detail::require_state_of(s, states_);
        detail::require_action_of(a, actions_);
        detail::require_state_of(next, states_);
        if (!(probability > 0.0 && probability <= 1.0)) throw_invalid("probability", "lie in (0, 1]", probability);
        require_finite("reward", reward);
        rows_.push_back({s, a, {next, probability, reward, terminal}, rows_.size()});
        return *this;
    }

    /// The states in which episodes start; an empty list (the default) means every state that has actions.
    /// \throws std::invalid_argument for a state outside or given twice.
    TransitionTableBuilder& start_in(std::vector<StateId> starts) {
        for (const StateId s : starts) detail::require_state_of(s, states_);
        std::sort(starts.begin(), starts.end());
        const auto twice = std::adjacent_find(starts.begin(), starts.end());
        if (twice != starts.end()) throw_invalid("start state", "be given once", index(*twice));
        starts_ = std::move(starts);
        return *this;
    }

    /// The table. O(n log n) in the number of outcomes.
    /// \throws TransitionTableError for probabilities of an (s,a) that do not sum to 1, or a non-terminal outcome into
    /// a state without actions; std::invalid_argument for no outcomes at all, 2^32 or more of them, or a start state
    /// without actions.
    [[nodiscard]] TransitionTable build() const {
        if (rows_.empty()) throw std::invalid_argument("a transition table needs at least one outcome");
        if (rows_.size() > std::numeric_limits<std::uint32_t>::max()) {
            throw_invalid("number of outcomes", "stay below 4294967296", rows_.size());
        }
        std::vector<Row> rows = rows_;
        std::sort(rows.begin(), rows.end(), [](const Row& x, const Row& y) { return x.key() < y.key(); });
        TransitionTable table(states_, actions_);
        table.offsets_.assign(states_ * actions_ + 1, 0);
        for (std::size_t i = 0; i < rows.size();) i = append_pair(table, rows, i);
        for (std::size_t i = 1; i < table.offsets_.size(); ++i) table.offsets_[i] += table.offsets_[i - 1];
        require_ways_on(table, rows);
        set_starts(table);
        return table;
    }

private:
    static std::string name_of(StateId s, ActionId a) {
        return "state " + std::to_string(index(s)) + ", action " + std::to_string(index(a));
    }

    /// Appends the (s,a) that begins at row i; the row after its last one. Leaves its size in the offsets.
    std::size_t append_pair(TransitionTable& table, const std::vector<Row>& rows, std::size_t i) const {
        const Row& head = rows[i];
        const std::size_t before = table.outcomes_.size();
        double sum = 0.0;
        std::size_t first = head.number;
        for (; i < rows.size() && rows[i].same_pair(head); ++i) {
            const Outcome& outcome = rows[i].outcome;
            sum += outcome.probability;
            first = std::min(first, rows[i].number);
            if (table.outcomes_.size() > before && rows[i].merges_with(table.outcomes_.back())) {
                table.outcomes_.back().probability += outcome.probability;
            } else {
                table.outcomes_.push_back(outcome);
            }
            std::optional<double>& best = table.best_terminal_reward_;
            if (outcome.terminal) best = std::max(best.value_or(outcome.reward), outcome.reward);
        }
        if (!(std::fabs(sum - 1.0) <= tolerance)) {
            throw TransitionTableError("probabilities of " + name_of(head.s, head.a) +
                                           " must sum to 1 within 1e-9, got " + detail::to_text(sum),
                                       first, TransitionTableError::Field::probability);
        }
        table.offsets_[index(head.s) * actions_ + index(head.a) + 1] =
            static_cast<std::uint32_t>(table.outcomes_.size() - before);
        return i;
    }

    static void require_ways_on(const TransitionTable& table, const std::vector<Row>& rows) {
        for (const Row& row : rows) {
            if (row.outcome.terminal || table.has_actions(row.outcome.next)) continue;
            throw TransitionTableError(name_of(row.s, row.a) + " must be terminal where it enters state " +
                                           std::to_string(index(row.outcome.next)) + ", which has no actions",
                                       row.number, TransitionTableError::Field::next);
        }
    }

    void set_starts(TransitionTable& table) const {
        for (const StateId s : starts_) {
            if (!table.has_actions(s)) throw_invalid("start state", "have an action", index(s));
        }
        table.starts_ = starts_;
        if (!starts_.empty()) return;
        for (std::size_t s = 0; s < states_; ++s) {
            if (table.has_actions(state_id(s))) table.starts_.push_back(state_id(s));
        }
    }

    std::size_t states_;
    std::size_t actions_;
    std::vector<Row> rows_;
    std::vector<StateId> starts_;
};

}  // namespace sspql
