// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <sspql/core/errors.hpp>
#include <sspql/core/ids.hpp>
#include <sspql/io/atomic_file.hpp>
#include <sspql/io/label_text.hpp>
#include <sspql/io/learnt_paths.hpp>
#include <sspql/model/probability.hpp>
#include <sspql/model/transition_counts.hpp>
#include <sspql/paths/shortest_paths.hpp>

namespace sspql {

/// How a learnt graph is drawn.
struct DotOptions {
    /// Above the picture; nothing if empty.
    std::string title{};

    /// At most so many states are drawn, those nearest to a goal; a note tells how many are left out.
    std::size_t most_states = 1000;

    /// The state in words; its number if empty.
    std::function<std::string(StateId)> label{};

    /// Where the state stands, x to the right and y up, one unit apart; GraphViz arranges the states if empty.
    std::function<std::array<double, 2>(StateId)> position{};

    /// In each state the length of its path.
    bool distances = true;

    /// At each edge of a path its probability, where that is below 1; the edge is the thicker the greater it is.
    bool probabilities = true;

    /// Edges from a state to itself.
    bool loops = false;
};

namespace detail {

/// Writes one graph; see save_dot.
template <class Cell>
class DotWriter {
public:
    DotWriter(const std::string& path, const TransitionCounts<Cell>& counts, const ShortestPathTree& tree,
              const std::vector<Goal>& goals, const DotOptions& options)
        : file_(path), counts_(counts), tree_(tree), options_(options), role_(counts.states(), Role::hidden) {
        for (const Goal& goal : goals) {
            if (index(goal.state) >= counts.states()) {
                throw_invalid("goal", "be below the number of states " + std::to_string(counts.states()),
                              index(goal.state));
            }
        }
        choose_states(goals);
    }

    void write() {
        write_head();
        for (const StateId s : shown_) write_state(s);
        if (left_out_ > 0) {
            file_.write("  note [label=" + dot_quoted("and " + std::to_string(left_out_) + " more states") +
                        ", shape=plaintext, style=\"\"];\n");
        }
        for (const StateId s : shown_) write_edges(s);
        file_.write("}\n");
        file_.commit();
    }

private:
    enum class Role : unsigned char { hidden, shown, goal };

    [[nodiscard]] double distance(StateId s) const {
        return index(s) < tree_.size() ? tree_.distance[index(s)] : std::numeric_limits<double>::infinity();
    }

    /// States that nobody has met are not part of the graph.
    void choose_states(const std::vector<Goal>& goals) {
        for (const Goal& goal : goals) role_[index(goal.state)] = Role::goal;
        for (std::size_t i = 0; i < role_.size(); ++i) {
            const StateId s = state_id(i);
            const bool met = counts_.out_degree(s) > 0 || counts_.in_degree(s) > 0 || role_[i] == Role::goal;
            if (met) shown_.push_back(s);
        }
        std::sort(shown_.begin(), shown_.end(), [this](StateId x, StateId y) {
            return std::make_tuple(distance(x), x) < std::make_tuple(distance(y), y);
        });
        left_out_ = shown_.size() - std::min(shown_.size(), options_.most_states);
        shown_.resize(shown_.size() - left_out_);
        std::sort(shown_.begin(), shown_.end());
        std::vector<Role> role(role_.size(), Role::hidden);
        for (const StateId s : shown_) {
            role[index(s)] = role_[index(s)] == Role::goal ? Role::goal : Role::shown;
            if (tree_.reaches_goal(s)) farthest_ = std::max(farthest_, distance(s));
        }
        role_ = std::move(role);
    }

    void write_head() {
        file_.write("digraph learnt {\n  graph [bgcolor=white, outputorder=edgesfirst, fontname=\"Helvetica\"");
        file_.write(options_.position ? ", layout=neato, overlap=true, splines=true" : ", rankdir=LR");
        if (!options_.title.empty()) file_.write(", labelloc=t, fontsize=20, label=" + dot_quoted(options_.title));
        file_.write("];\n  node [fontname=\"Helvetica\", fontsize=11, color=\"#5f6b7a\", ");
        file_.write(options_.label ? "shape=box, style=\"filled,rounded\", margin=\"0.08,0.04\"];\n"
                                   : "shape=circle, style=filled, fixedsize=true, width=0.62];\n");
        file_.write(
            "  edge [color=\"#c3c9d1\", penwidth=0.6, arrowsize=0.45, fontname=\"Helvetica\", fontsize=9, "
            "fontcolor=\"#8a3324\", constraint=false];\n");
    }

    void write_state(StateId s) {
        std::string text = options_.label ? options_.label(s) : std::to_string(index(s));
        const bool reaches = tree_.reaches_goal(s);
        if (options_.distances && reaches && role_[index(s)] != Role::goal) {
            text += "\n" + fixed_text(distance(s), distance(s) < 99.5 ? 1 : 0);
        }
        std::string line = "  s" + std::to_string(index(s)) + " [label=" + dot_quoted(text);
        if (role_[index(s)] == Role::goal) {
            line += ", shape=doublecircle, style=filled, width=0.55, fillcolor=\"#ffd75e\"";
        } else {
            line += ", fillcolor=\"" + colour(s) + "\"";
        }
        if (options_.position) {
            const std::array<double, 2> at = options_.position(s);
            line += ", pos=\"" + fixed_text(require_finite("position", at[0]), 3) + "," +
                    fixed_text(require_finite("position", at[1]), 3) + "!\"";
        }
        file_.write(line + "];\n");
    }

    /// The nearer to a goal, the greener; grey where no path is known.
    [[nodiscard]] std::string colour(StateId s) const {
        if (!tree_.reaches_goal(s)) return "#eceff3";
        const double share = farthest_ > 0.0 ? distance(s) / farthest_ : 0.0;
        return "0.36 " + fixed_text(0.45 - 0.40 * share, 3) + " " + fixed_text(0.86 + 0.12 * share, 3);
    }

    void write_edges(StateId s) {
        std::vector<std::pair<StateId, double>> edges;
        counts_.for_each_successor(s, [&](const auto& successor) {
            edges.emplace_back(successor.state(), BestAction{}(counts_, s, successor));
        });
        std::sort(edges.begin(), edges.end());
        const StateId next = index(s) < tree_.size() ? tree_.next[index(s)] : no_state;
        for (const auto& [to, probability] : edges) {
            if (role_[index(to)] == Role::hidden || (to == s && !options_.loops)) continue;
            std::string line = "  s" + std::to_string(index(s)) + " -> s" + std::to_string(index(to));
            if (to == next) {
                line += " [color=\"#c8452b\", penwidth=" + fixed_text(1.0 + 2.0 * probability, 2) +
                        ", arrowsize=0.7, constraint=true";
                if (options_.probabilities && probability < 0.995) {
                    line += ", label=\"" + fixed_text(probability, 2) + "\"";
                }
                line += "]";
            }
            file_.write(line + ";\n");
        }
    }

    AtomicFile file_;
    const TransitionCounts<Cell>& counts_;
    const ShortestPathTree& tree_;
    const DotOptions& options_;
    std::vector<Role> role_;
    std::vector<StateId> shown_;
    std::size_t left_out_ = 0;
    double farthest_ = 0.0;
};

}  // namespace detail

/// Draws the learnt graph for GraphViz: `dot -Tsvg graph.dot -o graph.svg`. A node for each state met, goals with a
/// double circle, greener the nearer to a goal; an edge for each (s,s') observed, those of the shortest-path tree thick
/// and red. Labels may hold any text. Written whole or not at all (AtomicFile). O(m log m) for m distinct (s,s').
/// \throws std::runtime_error "cannot write PATH: REASON"; std::invalid_argument for a goal that is no state, or a
/// position that is not finite.
template <class Cell>
void save_dot(const std::string& path, const TransitionCounts<Cell>& counts, const ShortestPathTree& tree,
              const std::vector<Goal>& goals, const DotOptions& options = {}) {
    detail::DotWriter<Cell>(path, counts, tree, goals, options).write();
}

/// The same with the shortest paths by expected steps (learnt_paths), for learners that keep counts but no tree.
template <class Cell>
void save_dot(const std::string& path, const TransitionCounts<Cell>& counts, const std::vector<Goal>& goals,
              const DotOptions& options = {}) {
    save_dot(path, counts, learnt_paths(counts, goals), goals, options);
}

/// The same for a learner that has counts(), tree() and goals(), as Sspql.
template <class Learner>
auto save_dot(const std::string& path, const Learner& learner, const DotOptions& options = {})
    -> decltype(learner.tree(), void()) {
    save_dot(path, learner.counts(), learner.tree(), learner.goals(), options);
}

}  // namespace sspql
