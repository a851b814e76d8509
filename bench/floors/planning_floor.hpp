// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <sspql/core/random.hpp>

/// \file
/// Learners written by hand for one task, a grid with four actions: what bench_learners holds the library against.
///
/// They know what a library cannot: the number of actions and the most outcomes an action can have are constants, ids
/// are not checked, everything is allowed everywhere, nothing fades, grows or is taught, and alpha is a number. What
/// planning needs they keep as the library does: counts, reward sums, terminal flags, predecessors. Fed the same steps
/// and the same random numbers they reach the same values.

namespace sspql::floors {

inline constexpr std::uint32_t actions = 4;
inline constexpr std::size_t most_outcomes = 4;  // four neighbours; at the edge the cell itself instead of some

struct Step {
    std::uint32_t state;
    std::uint32_t action;
    double reward;
    std::uint32_t next;
    bool terminated;
};

/// What was seen of one (s,a,s'), 16 bytes.
struct Outcome {
    std::uint32_t next;
    std::uint32_t terminal : 1;
    std::uint32_t count : 31;
    double reward_sum;
};

/// What was seen of one (s,a): a header and its outcomes in place, 72 bytes.
struct Outcomes {
    std::uint32_t count = 0;
    std::uint32_t size = 0;
    std::array<Outcome, most_outcomes> seen{};

    /// \returns the place of the outcome.
    std::uint32_t add(const Step& t) {
        std::uint32_t i = 0;
        while (i < size && seen[i].next != t.next) ++i;
        if (i == size) seen[size++] = {t.next, 0, 0, 0.0};
        ++count;
        seen[i].count = seen[i].count + 1u;
        seen[i].terminal = t.terminated;
        seen[i].reward_sum += t.reward;
        return i;
    }
};

/// Q values as one array, a row of four a state.
class Values {
public:
    explicit Values(std::size_t states) : q_(states * actions, 0.0) {}

    [[nodiscard]] double max(std::size_t s) const {
        const double* q = &q_[s * actions];
        return std::max(std::max(q[0], q[1]), std::max(q[2], q[3]));
    }
    double& operator[](std::size_t pair) { return q_[pair]; }
    double operator[](std::size_t pair) const { return q_[pair]; }

private:
    std::vector<double> q_;
};

/// Q-learning: the update, then the best action by Q plus uniform noise.
class QLearning {
public:
    QLearning(std::size_t states, double alpha, double gamma, double noise, std::uint64_t seed)
        : q_(states), alpha_(alpha), gamma_(gamma), noise_(noise), random_(seed, RandomStream::learner) {}

    std::uint32_t begin(std::uint32_t s) {
        state_ = s;
        return action_ = choose();
    }

    std::uint32_t step(double reward, std::uint32_t next) {
        double& q = q_[state_ * actions + action_];
        q += alpha_ * (reward + gamma_ * q_.max(next) - q);
        state_ = next;
        return action_ = choose();
    }

    [[nodiscard]] const Values& q() const { return q_; }

private:
    std::uint32_t choose() {
        std::uint32_t best = 0;
        double best_score = q_[state_ * actions] + noise_ * random_.uniform();
        for (std::uint32_t a = 1; a < actions; ++a) {
            const double score = q_[state_ * actions + a] + noise_ * random_.uniform();
            if (score > best_score) {
                best = a;
                best_score = score;
            }
        }
        return best;
    }

    Values q_;
    double alpha_;
    double gamma_;
    double noise_;
    Random random_;
    std::uint32_t state_ = 0;
    std::uint32_t action_ = 0;
};

/// Dyna-Q: the update, then planning steps, each an outcome of a tried (s,a) drawn from the counts and the update with
/// it.
class DynaQ {
public:
    DynaQ(std::size_t states, double alpha, double gamma, std::uint64_t seed)
        : q_(states), model_(states * actions), alpha_(alpha), gamma_(gamma), random_(seed, RandomStream::learner) {}

    void observe(const Step& t, std::size_t planning_steps) {
        const std::uint32_t pair = t.state * actions + t.action;
        if (model_[pair].count == 0) tried_.push_back(pair);
        model_[pair].add(t);
        update(pair, t.reward, t.next, t.terminated);
        for (std::size_t k = 0; k < planning_steps; ++k) plan();
    }

    [[nodiscard]] const Values& q() const { return q_; }

private:
    void plan() {
        const std::uint32_t pair = tried_[random_.below(tried_.size())];
        const Outcomes& outcomes = model_[pair];
        double left = random_.uniform() * outcomes.count;
        const Outcome* drawn = outcomes.seen.data();
        const Outcome* last = drawn + outcomes.size - 1;
        while ((left -= drawn->count) >= 0.0 && drawn != last) ++drawn;
        update(pair, drawn->reward_sum / drawn->count, drawn->next, drawn->terminal);
    }

    void update(std::uint32_t pair, double reward, std::uint32_t next, bool terminal) {
        const double future = terminal ? 0.0 : gamma_ * q_.max(next);
        q_[pair] += alpha_ * (reward + future - q_[pair]);
    }

    Values q_;
    std::vector<Outcomes> model_;
    std::vector<std::uint32_t> tried_;
    double alpha_;
    double gamma_;
    Random random_;
};

/// A heap of (s,a) by priority, the largest first, with four children a node and an index that tells where each is.
class PairHeap {
public:
    explicit PairHeap(std::size_t pairs) : place_(pairs, absent) {}

    [[nodiscard]] bool empty() const { return heap_.empty(); }

    void raise(std::uint32_t pair, double priority) {
        std::uint32_t at = place_[pair];
        if (at == absent) {
            at = static_cast<std::uint32_t>(heap_.size());
            heap_.push_back({priority, pair});
        } else if (!(priority > heap_[at].priority)) {
            return;
        }
        while (at > 0) {
            const std::uint32_t parent = (at - 1) / 4;
            if (!(priority > heap_[parent].priority)) break;
            put(at, heap_[parent]);
            at = parent;
        }
        put(at, {priority, pair});
    }

    std::uint32_t pop() {
        const std::uint32_t top = heap_[0].pair;
        const Item item = heap_.back();
        place_[top] = absent;
        heap_.pop_back();
        if (heap_.empty()) return top;
        const auto size = static_cast<std::uint32_t>(heap_.size());
        std::uint32_t at = 0;
        for (std::uint32_t child = 1; child < size; child = 4 * at + 1) {
            std::uint32_t largest = child;
            const std::uint32_t end = std::min(child + 4, size);
            for (std::uint32_t i = child + 1; i < end; ++i) {
                if (heap_[i].priority > heap_[largest].priority) largest = i;
            }
            if (!(heap_[largest].priority > item.priority)) break;
            put(at, heap_[largest]);
            at = largest;
        }
        put(at, item);
        return top;
    }

private:
    struct Item {
        double priority;
        std::uint32_t pair;
    };
    static constexpr std::uint32_t absent = 0xFFFFFFFFu;

    void put(std::uint32_t at, const Item& item) {
        heap_[at] = item;
        place_[item.pair] = at;
    }

    std::vector<Item> heap_;
    std::vector<std::uint32_t> place_;
};

/// Prioritized sweeping: full backups of the most urgent (s,a), which raise the (u,b) that lead there.
class PrioritizedSweeping {
public:
    PrioritizedSweeping(std::size_t states, double gamma, double threshold)
        : q_(states),
          model_(states * actions),
          predecessors_(states),
          queue_(states * actions),
          gamma_(gamma),
          threshold_(threshold) {}

    void observe(const Step& t, std::size_t most_backups) {
        const std::uint32_t pair = t.state * actions + t.action;
        Outcomes& outcomes = model_[pair];
        const std::uint32_t known = outcomes.size;
        const std::uint32_t place = outcomes.add(t);
        if (place == known) predecessors_[t.next].push_back({pair, place});
        const double change = std::fabs(expected(outcomes) - q_[pair]);
        if (change > threshold_) queue_.raise(pair, change);
        for (std::size_t k = 0; k < most_backups && !queue_.empty(); ++k) sweep_one();
    }

    [[nodiscard]] std::uint64_t backups() const { return backups_; }
    [[nodiscard]] const Values& q() const { return q_; }

private:
    struct Predecessor {
        std::uint32_t pair;
        std::uint32_t place;  // among the pair's outcomes
    };

    [[nodiscard]] double expected(const Outcomes& outcomes) const {
        double sum = 0.0;
        for (std::uint32_t i = 0; i < outcomes.size; ++i) {
            const Outcome& outcome = outcomes.seen[i];
            sum += outcome.reward_sum;
            if (!outcome.terminal) sum += outcome.count * gamma_ * q_.max(outcome.next);
        }
        return sum / outcomes.count;
    }

    void sweep_one() {
        const std::uint32_t pair = queue_.pop();
        const std::uint32_t s = pair / actions;
        ++backups_;
        const double before = q_.max(s);
        q_[pair] = expected(model_[pair]);
        const double moved = gamma_ * std::fabs(q_.max(s) - before);
        if (!(moved > threshold_)) return;
        for (const Predecessor& p : predecessors_[s]) {
            const Outcomes& outcomes = model_[p.pair];
            const Outcome& outcome = outcomes.seen[p.place];
            if (outcome.terminal) continue;
            const double priority = moved * outcome.count / outcomes.count;
            if (priority > threshold_) queue_.raise(p.pair, priority);
        }
    }

    Values q_;
    std::vector<Outcomes> model_;
    std::vector<std::vector<Predecessor>> predecessors_;
    PairHeap queue_;
    double gamma_;
    double threshold_;
    std::uint64_t backups_ = 0;
};

}  // namespace sspql::floors
