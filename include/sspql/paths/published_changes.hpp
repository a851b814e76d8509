// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include <sspql/core/ids.hpp>
#include <sspql/core/serialization.hpp>

namespace sspql {

/// An edge label that a CostPublisher rewrote.
struct CostChange {
    StateId from{};         ///< the edge leads from here
    StateId to{};           ///< to here
    double old_cost = 0.0;  ///< infinite for an edge that had none: seen for the first time, or erased and seen again
    double new_cost = 0.0;  ///< finite, > 0

    /// Whether the edge became dearer.
    [[nodiscard]] bool worsened() const noexcept { return new_cost > old_cost; }
    /// Whether the edge became cheaper, or is new.
    [[nodiscard]] bool improved() const noexcept { return new_cost < old_cost; }
};

/// What one refresh of the labels did: which states were refreshed and which edges changed. Lists are kept up to a
/// length given beforehand and dropped beyond it, since after that many changes nobody looks at them one by one; the
/// counts go on. Buffers are kept, so that a reused report allocates only when it grows.
class PublishedChanges {
public:
    /// Keeps everything.
    static constexpr std::size_t no_limit = std::numeric_limits<std::size_t>::max();

    /// Empties the report. \param most entries of either list.
    void begin(std::size_t most = no_limit) noexcept {
        edges_.clear();
        states_.clear();
        most_ = most;
        touched_ = changed_ = added_ = 0;
        least_ = std::numeric_limits<double>::infinity();
        greatest_ = 0.0;
        complete_ = true;
    }

    /// Whether the lists hold everything.
    [[nodiscard]] bool complete() const noexcept { return complete_; }

    /// The edges whose label was rewritten; empty if the lists were dropped.
    [[nodiscard]] const std::vector<CostChange>& edges() const noexcept { return edges_; }

    /// The states whose edges were refreshed, changed or not; empty if the lists were dropped.
    [[nodiscard]] const std::vector<StateId>& states() const noexcept { return states_; }

    [[nodiscard]] std::size_t touched() const noexcept { return touched_; }  ///< edges whose cost was computed
    [[nodiscard]] std::size_t changed() const noexcept { return changed_; }  ///< edges whose label was rewritten
    [[nodiscard]] std::size_t added() const noexcept { return added_; }      ///< of those, edges that had no label

    /// The least rewritten label; infinity if there is none.
    [[nodiscard]] double least() const noexcept { return least_; }
    /// The greatest rewritten label; 0 if there is none.
    [[nodiscard]] double greatest() const noexcept { return greatest_; }

    /// The edges of s were refreshed.
    void add_state(StateId s) {
        if (states_.size() >= most_) drop();
        if (complete_) states_.push_back(s);
    }

    /// The costs of this many edges were computed.
    void add_touched(std::size_t edges) noexcept { touched_ += edges; }

    /// The label of an edge was rewritten. `old_cost` is NaN where there was no label.
    void add_edge(StateId from, StateId to, double old_cost, double new_cost) {
        ++changed_;
        least_ = std::min(least_, new_cost);
        greatest_ = std::max(greatest_, new_cost);
        if (old_cost != old_cost) {
            ++added_;
            old_cost = std::numeric_limits<double>::infinity();
        }
        if (edges_.size() >= most_) drop();
        if (complete_) edges_.push_back({from, to, old_cost, new_cost});
    }

private:
    friend SerializationAccess;

    /// Counts only: of a report whose lists are empty or were dropped.
    template <class Archive>
    void serialize(Archive& archive) {
        if constexpr (Archive::loading) begin(0);
        archive.size(touched_);
        archive.size(changed_);
        archive.size(added_);
        archive(least_, greatest_, complete_);
    }

    void drop() noexcept {
        complete_ = false;
        edges_.clear();
        states_.clear();
    }

    std::vector<CostChange> edges_;
    std::vector<StateId> states_;
    std::size_t most_ = no_limit;
    std::size_t touched_ = 0;
    std::size_t changed_ = 0;
    std::size_t added_ = 0;
    double least_ = std::numeric_limits<double>::infinity();
    double greatest_ = 0.0;
    bool complete_ = true;
};

}  // namespace sspql
