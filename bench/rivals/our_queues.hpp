// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <sspql/paths/reverse_graph.hpp>
#include <sspql/paths/shortest_paths.hpp>

#include "rivals/contender.hpp"

namespace sspql::rivals {

/// shortest_paths_to with one of our queues: distances and the tree, with its rule for ties. Buffers are reused.
template <class Queue>
class Ours : public Contender {
public:
    Ours(std::string name, const ReverseGraph& graph, StateId goal)
        : Contender(std::move(name)), graph_(graph), goals_{{goal}} {}

    void run() override { shortest_paths_to(graph_, goals_, queue_, tree_); }
    [[nodiscard]] double distance(std::size_t state) const override { return tree_.distance[state]; }
    [[nodiscard]] const ShortestPathTree& tree() const noexcept { return tree_; }

private:
    const ReverseGraph& graph_;
    std::vector<Goal> goals_;
    Queue queue_;
    ShortestPathTree tree_;
};

}  // namespace sspql::rivals
