// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <limits>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <sspql/core/ids.hpp>
#include <sspql/io/label_text.hpp>
#include <sspql/learn/transition.hpp>

namespace sspql {

/// What there is to say about one action of a state.
struct ActionExplanation {
    ActionId action{};    ///< which one
    std::string label{};  ///< the action in words; its number if nobody has any
    bool legal = true;    ///< whether it may be chosen now
    ActionTerms terms{};  ///< eq. 8's, and N(s,a)

    StateId likely = no_state;   ///< where it led most often, the least id on ties; no_state if unknown
    std::string likely_label{};  ///< in words
    double probability = 0.0;    ///< in this share of its tries
    bool ends = false;           ///< and the episode ended there, the last time
    double distance = std::numeric_limits<double>::infinity();  ///< from there to the goal; infinite if no way is known
};

/// A state on the way to the goal, and the action that leads on from it; no_action at the goal.
struct PathStep {
    StateId state{};              ///< where the way leads through
    std::string label{};          ///< the state in words; its number if nobody has any
    ActionId action = no_action;  ///< that leads on from it
    std::string action_label{};   ///< the action in words; empty at the goal
};

/// Why a learner does what it does in a state: explain() makes one, `<<` and to_text() put it into words. Distances are
/// those of the learner's shortest-path tree.
struct Explanation {
    StateId state{};              ///< which one
    std::string label{};          ///< the state in words; empty if nobody has any
    ActionId chosen = no_action;  ///< what the running episode does here now; no_action if it is elsewhere
    ActionId leading{};           ///< the legal action with the greatest sum of terms, the least id on ties
    ActionId best{};              ///< what best() answers: without curiosity, hints and chance

    bool has_model = false;         ///< whether the learner keeps counts; else the rest is unknown
    bool distance_in_steps = true;  ///< expected steps (weights, where steps had any); else the costs of eq. 2
    double distance = std::numeric_limits<double>::infinity();  ///< to the goal; infinite where no way is known
    StateId next = no_state;        ///< the tree's next state; no_state at a goal and where no way is known
    std::vector<PathStep> path{};   ///< the first states of the way, this one first, and the goal last; or empty
    std::size_t path_left_out = 0;  ///< states between the last but one of `path` and the goal

    std::vector<ActionExplanation> actions{};  ///< all, by id
};

namespace detail {

/// Rows of texts as columns of equal width. What a row that is shorter than the others ends with may be of any length.
class TextTable {
public:
    /// By column: whether its texts begin at the same place; else they end at the same place.
    explicit TextTable(std::vector<bool> left) : left_(std::move(left)) {}

    void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }

    [[nodiscard]] std::string text() const {
        std::vector<std::size_t> width(left_.size(), 0);
        for (const auto& row : rows_) {
            const std::size_t aligned = row.size() == left_.size() ? row.size() : row.size() - 1;
            for (std::size_t i = 0; i < aligned; ++i) width[i] = std::max(width[i], characters(row[i]));
        }
        std::string out;
        for (const auto& row : rows_) {
            std::string line;
            for (std::size_t i = 0; i < row.size(); ++i) {
                const std::size_t used = characters(row[i]);
                const std::string space(width[i] > used ? width[i] - used : 0, ' ');
                line += (i == 0 ? "" : "  ") + (left_[i] ? row[i] + space : space + row[i]);
            }
            out += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
        }
        return out;
    }

private:
    /// Of well-formed UTF-8.
    static std::size_t characters(std::string_view text) {
        return static_cast<std::size_t>(std::count_if(
            text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
    }

    std::vector<bool> left_;
    std::vector<std::vector<std::string>> rows_;
};

/// Numbers of one column: as many digits after the point as show four of the greatest.
class NumberColumn {
public:
    void see(double value) {
        if (std::isfinite(value)) greatest_ = std::max(greatest_, std::fabs(value));
    }

    [[nodiscard]] std::string text(double value) const {
        if (!std::isfinite(value)) return "-";
        if (greatest_ < 1e-6 || greatest_ >= 1e9) {
            std::array<char, 40> text;
            const auto end =
                std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 4);
            return {text.data(), end.ptr};
        }
        int digits = 3;
        for (double x = greatest_; x >= 10.0 && digits > 0; x /= 10.0) --digits;
        for (double x = greatest_; x < 1.0; x *= 10.0) ++digits;
        const std::string text = fixed_text(value, digits);
        return text.find_first_not_of("-0.") == std::string::npos && text.front() == '-' ? text.substr(1) : text;
    }

private:
    double greatest_ = 0.0;
};

/// Puts an Explanation into words.
class ExplanationText {
public:
    explicit ExplanationText(const Explanation& why) : why_(why) {
        for (const ActionExplanation& a : why.actions) {
            if (!a.legal) continue;
            for (const double term : {a.terms.q, a.terms.ssp, a.terms.exploration, a.terms.hint}) terms_.see(term);
            distances_.see(a.distance);
            has_path_ = has_path_ || a.terms.ssp != 0.0;
            has_curiosity_ = has_curiosity_ || a.terms.exploration != 0.0;
            has_hint_ = has_hint_ || a.terms.hint != 0.0;
        }
        distances_.see(why.distance);
    }

    [[nodiscard]] std::string text() const { return heading() + table() + decision() + way(); }

private:
    [[nodiscard]] std::string heading() const {
        std::string text = "state " + std::to_string(index(why_.state));
        if (!why_.label.empty()) text += ", " + one_line(why_.label);
        if (!why_.has_model) return text + "\n";
        if (!std::isfinite(why_.distance)) return text + ": no way to a goal is known\n";
        if (why_.next == no_state) return text + ": a goal\n";
        const std::string distance = distances_.text(why_.distance);
        return text + (why_.distance_in_steps ? ": " + distance + " steps to the goal\n"
                                              : ": cost " + distance + " to the goal\n");
    }

    [[nodiscard]] std::string table() const {
        const bool sum = has_path_ || has_curiosity_ || has_hint_;
        std::vector<bool> left{true, true, false};
        std::vector<std::string> head{"", "action", "value"};
        const auto column = [&](bool shown, const char* name, bool to_the_left = false) {
            if (!shown) return;
            left.push_back(to_the_left);
            head.emplace_back(name);
        };
        column(has_path_, "path");
        column(has_curiosity_, "curiosity");
        column(has_hint_, "hint");
        column(sum, "sum");
        column(true, "tries");
        column(why_.has_model, "leads to", true);
        column(why_.has_model, "share");
        column(why_.has_model, "to go");
        TextTable table(left);
        table.add(head);
        const ActionId taken = why_.chosen != no_action ? why_.chosen : why_.leading;
        for (const ActionExplanation& a : why_.actions) {
            std::vector<std::string> row{a.action == taken ? ">" : "", one_line(a.label)};
            if (a.legal) {
                row.push_back(terms_.text(a.terms.q));
                if (has_path_) row.push_back(terms_.text(a.terms.ssp));
                if (has_curiosity_) row.push_back(terms_.text(a.terms.exploration));
                if (has_hint_) row.push_back(terms_.text(a.terms.hint));
                if (sum) row.push_back(terms_.text(a.terms.sum()));
                row.push_back(tries(a.terms.n));
                if (why_.has_model) add_outcome(row, a);
            } else {
                row.emplace_back("not allowed");
            }
            table.add(std::move(row));
        }
        return table.text();
    }

    void add_outcome(std::vector<std::string>& row, const ActionExplanation& a) const {
        if (a.likely == no_state) return;
        row.push_back(one_line(a.likely_label) + (a.ends ? " (the end)" : ""));
        row.push_back(fixed_text(100.0 * a.probability, 0) + " %");
        row.push_back(distances_.text(a.distance));
    }

    [[nodiscard]] std::string decision() const {
        std::string text;
        if (why_.chosen == no_action) {
            text = "would choose " + name(why_.leading) + ", but for chance";
        } else if (why_.chosen == why_.leading) {
            text = "chose " + name(why_.chosen) + ", which has the greatest sum";
        } else {
            text = "chose " + name(why_.chosen) + ", though " + name(why_.leading) + " has the greatest sum";
        }
        return text + "; best as far as known: " + name(why_.best) + "\n";
    }

    [[nodiscard]] std::string way() const {
        if (why_.path.size() < 2) return {};
        std::string text = "way: ";
        for (std::size_t i = 0; i < why_.path.size(); ++i) {
            const PathStep& step = why_.path[i];
            if (i + 1 == why_.path.size() && why_.path_left_out > 0) {
                text += "... " + std::to_string(why_.path_left_out) + " more ... ";
            }
            text += one_line(step.label);
            if (step.action != no_action) text += " -" + one_line(step.action_label) + "-> ";
        }
        return text + "\n";
    }

    [[nodiscard]] std::string name(ActionId a) const { return one_line(why_.actions[index(a)].label); }

    /// Counts that fade are no whole numbers.
    static std::string tries(double n) { return fixed_text(n, n == std::floor(n) ? 0 : 1); }

    static std::string one_line(std::string_view label) {
        std::string text = printable(label);
        std::replace(text.begin(), text.end(), '\n', ' ');
        return text;
    }

    const Explanation& why_;
    NumberColumn terms_;
    NumberColumn distances_;
    bool has_path_ = false;
    bool has_curiosity_ = false;
    bool has_hint_ = false;
};

}  // namespace detail

/// The explanation as a table for people, an action a line, '>' where the one taken stands:
///
///     state 5: 3.000 steps to the goal
///        action  value  curiosity    sum  tries  leads to  share  to go
///     >  right   0.410      0.035  0.445      4  6          75 %  2.000
///        left    0.262      0.071  0.333      1  4         100 %  4.000
///     would choose right, but for chance; best as far as known: right
///     way: 5 -right-> 6 -right-> 7
///
/// `value` is w_Q Q, `path` w_SSP Q_SSP, `curiosity` w_EXP Q_EXP, `hint` what is left of a trainer's hint (eq. 8);
/// terms that are 0 for all actions are left out. `to go` counts from the state the action most often leads to.
[[nodiscard]] inline std::string to_text(const Explanation& why) { return detail::ExplanationText(why).text(); }

/// to_text(), to a stream.
inline std::ostream& operator<<(std::ostream& out, const Explanation& why) { return out << to_text(why); }

}  // namespace sspql
