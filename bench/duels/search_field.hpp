// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include <sspql/paths/auto_queue.hpp>
#include <sspql/paths/dary_heap.hpp>
#include <sspql/paths/fibonacci_heap.hpp>
#include <sspql/paths/ring_queue.hpp>

#include "duels/search_cases.hpp"
#include "duels/search_results.hpp"
#include "floors/clock.hpp"
#include "paths/search_families.hpp"
#include "rivals/boost_rivals.hpp"
#include "rivals/contender.hpp"
#include "rivals/graph_floors.hpp"
#include "rivals/our_queues.hpp"
#if SSPQL_HAS_LEMON
#include "rivals/lemon_rivals.hpp"
#endif

namespace sspql::duels {

/// Everybody, ready to run on one graph.
class Field {
public:
    explicit Field(sspql_test::SearchCase c) : case_(std::move(c)) {
        add<rivals::Ours<AutoQueue<>>>("auto", case_.graph, case_.goal);
        add<rivals::Ours<RingQueue<>>>("ring<Fibonacci>", case_.graph, case_.goal);
        add<rivals::Ours<FibonacciHeap<>>>("Fibonacci", case_.graph, case_.goal);
        add<rivals::Ours<DaryHeap<4>>>("4-ary", case_.graph, case_.goal);
        add<rivals::BoostListDijkstra>(case_.graph, case_.goal);
        add<rivals::BoostBothWaysDijkstra>(case_.graph, case_.goal);
        add<rivals::BoostRowsDijkstra>(case_.graph, case_.goal);
        add<rivals::BoostFibonacciDijkstra>(case_.graph, case_.goal);
#if SSPQL_HAS_LEMON
        lemon_ = std::make_unique<rivals::LemonInput>(case_.graph);
        add<rivals::LemonDijkstra<rivals::LemonBinary>>("LEMON binary", *lemon_, case_.goal);
        add<rivals::LemonDijkstra<rivals::LemonQuaternary>>("LEMON 4-ary", *lemon_, case_.goal);
        add<rivals::LemonDijkstra<rivals::LemonFibonacci>>("LEMON Fibonacci", *lemon_, case_.goal);
#endif
        add<rivals::BreadthFirst>(case_.graph, case_.goal);
        add<rivals::OnePass>(case_.graph);
        seconds_.resize(contenders_.size());
    }

    /// Everybody once, starting with another one each time. \returns the seconds of the first.
    double turn() {
        for (std::size_t i = 0; i < contenders_.size(); ++i) {
            const std::size_t which = (i + turns_) % contenders_.size();
            const double start = floors::cpu_seconds();
            contenders_[which]->run();
            seconds_[which].push_back(floors::cpu_seconds() - start);
        }
        ++turns_;
        return seconds_[0].back();
    }

    /// A turn that does not count, to fetch memory and to compare the answers.
    [[nodiscard]] bool warm_up() {
        for (const auto& contender : contenders_) contender->run();
        const rivals::Contender& first = *contenders_.front();
        for (const auto& contender : contenders_) {
            if (!contender->finds_distances()) continue;
            for (std::size_t s = 0; s < case_.graph.size(); ++s) {
                if (contender->distance(s) != first.distance(s)) return false;
            }
        }
        const auto& tree = static_cast<const rivals::Ours<AutoQueue<>>&>(first).tree();
        return static_cast<const rivals::Ours<RingQueue<>>&>(*contenders_[1]).tree().next == tree.next &&
               static_cast<const rivals::Ours<FibonacciHeap<>>&>(*contenders_[2]).tree().next == tree.next &&
               static_cast<const rivals::Ours<DaryHeap<4>>&>(*contenders_[3]).tree().next == tree.next;
    }

    [[nodiscard]] SearchResult result(const Family& family) const {
        const auto n = static_cast<double>(case_.graph.size());
        const double touched = n + static_cast<double>(case_.graph.edges());
        SearchResult result{family.name, case_.graph.size(), family.grid_or_random, touched / n, {}};
        for (std::size_t i = 0; i < contenders_.size(); ++i) {
            result.time.emplace_back(contenders_[i]->name(), 1e9 * floors::median(seconds_[i]) / touched);
        }
        return result;
    }

private:
    template <class T, class... Arguments>
    void add(Arguments&&... arguments) {
        contenders_.push_back(std::make_unique<T>(std::forward<Arguments>(arguments)...));
    }

    sspql_test::SearchCase case_;
#if SSPQL_HAS_LEMON
    std::unique_ptr<rivals::LemonInput> lemon_;
#endif
    std::vector<std::unique_ptr<rivals::Contender>> contenders_;
    std::vector<std::vector<double>> seconds_;
    std::size_t turns_ = 0;
};

}  // namespace sspql::duels
