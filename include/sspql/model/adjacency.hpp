// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <unordered_map>
#include <utility>
#include <vector>

#include <sspql/core/assert.hpp>
#include <sspql/core/ids.hpp>
#include <sspql/model/prefetch.hpp>
#include <sspql/model/record_slab.hpp>

namespace sspql::detail {

/// Which states follow which: the skeleton under TransitionCounts.
///
/// Per state one contiguous block of out-records {s', slot of the in-record, payload} and one of in-records
/// {s, label}. The slot links the two, so that a cost can be written where searches read it, without looking for it.
/// Besides: one mean weight per (s, s') (an array that exists only once a weight differs from 1), and the list of dirty
/// states, those whose out-records changed since somebody cleared them.
///
/// find is O(out-degree) up to 32 successors and O(1) expected beyond (hash index for those states only), insert O(1)
/// amortised, erase O(out-degrees involved).
class Adjacency {
public:
    static constexpr std::uint32_t none = 0xFFFFFFFFu;
    static constexpr std::uint32_t hub_degree = 32;

    /// \param payload bytes of an out-record that belong to the owner.
    explicit Adjacency(std::size_t payload, std::size_t alignment)
        : out_((head_bytes + payload + alignment - 1) / alignment * alignment), in_(in_bytes) {}

    [[nodiscard]] std::size_t states() const noexcept { return nodes_.size(); }
    void grow(std::size_t states) { nodes_.resize(states); }

    /// Room for `states` states and `pairs` distinct (s, s') without allocating.
    void reserve(std::size_t states, std::size_t pairs) {
        nodes_.reserve(states);
        dirty_.reserve(states);
        // With blocks that were outgrown and found no other taker, d records of a state take up at most 4 + 4 d places up
        // to hub_degree, and 4 + 5 d beyond. What is not used stays untouched address space.
        out_.reserve(4 * states + 4 * pairs);
        in_.reserve(4 * states + 5 * pairs);
        if (!weights_.empty()) weights_.reserve(4 * states + 4 * pairs);
    }

    // --- out-records: absolute indices, valid until the next insert or erase ---

    [[nodiscard]] std::uint32_t out_begin(StateId s) const noexcept { return nodes_[index(s)].out_begin; }
    [[nodiscard]] std::uint32_t out_size(StateId s) const noexcept { return nodes_[index(s)].out_size; }

    [[nodiscard]] StateId target(std::uint32_t record) const noexcept { return StateId{head(record).state}; }

    /// The same by address, for scans: the record's bytes, the target and payload in them, the bytes of the next one.
    [[nodiscard]] const std::byte* record(std::uint32_t record) const noexcept { return out_.record(record); }
    [[nodiscard]] static StateId target(const std::byte* record) noexcept {
        std::uint32_t state;
        std::memcpy(&state, record, sizeof state);
        return StateId{state};
    }
    [[nodiscard]] static const std::byte* payload(const std::byte* record) noexcept { return record + head_bytes; }
    [[nodiscard]] std::size_t stride() const noexcept { return out_.stride(); }

    [[nodiscard]] std::byte* payload(std::uint32_t record) noexcept { return out_.record(record) + head_bytes; }
    [[nodiscard]] const std::byte* payload(std::uint32_t record) const noexcept {
        return out_.record(record) + head_bytes;
    }

    /// The out-record of (s, next), or `none`.
    [[nodiscard]] std::uint32_t find(StateId s, StateId next) const noexcept {
        const Node& node = nodes_[index(s)];
        if (node.out_size > hub_degree) {
            const auto found = hubs_.find(key(s, next));
            return found == hubs_.end() ? none : node.out_begin + found->second;
        }
        const std::byte* record = out_.record(node.out_begin);
        for (std::uint32_t i = 0; i < node.out_size; ++i, record += out_.stride()) {
            std::uint32_t state;
            std::memcpy(&state, record, sizeof state);
            if (state == static_cast<std::uint32_t>(next)) return node.out_begin + i;
        }
        return none;
    }

    /// Adds (s, next), which must be absent, with a payload of zeros, weight 1 and a label that no search may read yet.
    std::uint32_t insert(StateId s, StateId next) {
        SSPQL_ASSERT(find(s, next) == none, "one record for each pair");
        make_room(out_, nodes_[index(s)].out_begin, nodes_[index(s)].out_size, nodes_[index(s)].out_class, true);
        make_room(in_, nodes_[index(next)].in_begin, nodes_[index(next)].in_size, nodes_[index(next)].in_class, false);
        Node& node = nodes_[index(s)];
        Node& other = nodes_[index(next)];
        if (node.out_size >= hub_degree) index_hub(s, next);
        const std::uint32_t record = node.out_begin + node.out_size++;
        std::memset(out_.record(record), 0, out_.stride());
        set_head(record, {static_cast<std::uint32_t>(next), other.in_size});
        if (!weights_.empty()) weights_[record] = 1.0;
        const std::uint32_t slot = other.in_begin + other.in_size++;
        const auto from = static_cast<std::uint32_t>(s);
        std::memcpy(in_.record(slot), &from, sizeof from);
        write_label(slot, std::numeric_limits<double>::quiet_NaN());
        ++pairs_;
        return record;
    }

    /// Removes an out-record of s and its in-record. The last out-record of s takes its place.
    void erase(StateId s, std::uint32_t record) {
        const Head gone = head(record);
        erase_in(StateId{gone.state}, gone.slot);
        Node& node = nodes_[index(s)];
        const std::uint32_t last = node.out_begin + node.out_size - 1;
        const bool hub = node.out_size > hub_degree;
        if (hub) hubs_.erase(key(s, StateId{gone.state}));
        if (record != last) {
            std::memcpy(out_.record(record), out_.record(last), out_.stride());
            if (!weights_.empty()) weights_[record] = weights_[last];
            if (hub) hubs_[key(s, StateId{head(record).state})] = record - node.out_begin;
        }
        --node.out_size;
        if (hub && node.out_size == hub_degree) {
            for (std::uint32_t i = 0; i < node.out_size; ++i) hubs_.erase(key(s, target(node.out_begin + i)));
        }
        --pairs_;
    }

    void prefetch(StateId s) const noexcept { detail::prefetch(&nodes_[index(s)]); }

    // --- in-records ---

    [[nodiscard]] std::uint32_t in_size(StateId s) const noexcept { return nodes_[index(s)].in_size; }

    /// Calls f(StateId predecessor, double label) for every in-record of s.
    template <class F>
    void for_each_predecessor(StateId s, F&& f) const {
        const Node& node = nodes_[index(s)];
        const std::byte* record = in_.record(node.in_begin);
        for (std::uint32_t i = 0; i < node.in_size; ++i, record += in_bytes) {
            std::uint32_t from;
            double label;
            std::memcpy(&from, record, sizeof from);
            std::memcpy(&label, record + sizeof from, sizeof label);
            f(StateId{from}, label);
        }
    }

    [[nodiscard]] double label(std::uint32_t out_record) const noexcept {
        double value;
        std::memcpy(&value, in_.record(in_record(out_record)) + sizeof(std::uint32_t), sizeof value);
        return value;
    }

    void set_label(std::uint32_t out_record, double value) noexcept { write_label(in_record(out_record), value); }

    // --- weights ---

    [[nodiscard]] double weight(std::uint32_t record) const noexcept { return weights_.empty() ? 1.0 : weights_[record]; }

    void set_weight(std::uint32_t record, double value) {
        if (weights_.empty()) {
            weights_.reserve(out_.bytes() / out_.stride());  // what was reserved holds for weights, too
            weights_.resize(out_.extent(), 1.0);
        }
        weights_[record] = value;
    }

    [[nodiscard]] bool has_weights() const noexcept { return !weights_.empty(); }

    // --- dirty states ---

    void mark_dirty(StateId s) {
        Node& node = nodes_[index(s)];
        if (node.dirty) return;
        dirty_.push_back(s);
        node.dirty = true;
    }

    [[nodiscard]] const std::vector<StateId>& dirty() const noexcept { return dirty_; }

    void clear_dirty() noexcept {
        for (const StateId s : dirty_) nodes_[index(s)].dirty = false;
        dirty_.clear();
    }

    [[nodiscard]] std::size_t pairs() const noexcept { return pairs_; }

    [[nodiscard]] std::size_t bytes() const noexcept {
        return nodes_.capacity() * sizeof(Node) + out_.bytes() + in_.bytes() + weights_.capacity() * sizeof(double) +
               dirty_.capacity() * sizeof(StateId) + hubs_.size() * 3 * sizeof(std::uint64_t) +
               hubs_.bucket_count() * sizeof(void*);
    }

private:
    struct Node {
        std::uint32_t out_begin = 0;
        std::uint32_t in_begin = 0;
        std::uint32_t out_size = 0;
        std::uint32_t in_size = 0;
        std::uint8_t out_class = RecordSlab::no_block;
        std::uint8_t in_class = RecordSlab::no_block;
        bool dirty = false;
    };
    struct Head {
        std::uint32_t state;
        std::uint32_t slot;
    };
    static constexpr std::size_t head_bytes = sizeof(Head);
    static constexpr std::size_t in_bytes = sizeof(std::uint32_t) + sizeof(double);  // unpadded: read by memcpy

    static std::uint64_t key(StateId s, StateId next) noexcept {
        return (static_cast<std::uint64_t>(s) << 32) | static_cast<std::uint64_t>(next);
    }

    [[nodiscard]] Head head(std::uint32_t record) const noexcept {
        Head value;
        std::memcpy(&value, out_.record(record), sizeof value);
        return value;
    }
    void set_head(std::uint32_t record, Head value) noexcept { std::memcpy(out_.record(record), &value, sizeof value); }

    [[nodiscard]] std::size_t in_record(std::uint32_t out_record) const noexcept {
        const Head h = head(out_record);
        return std::size_t{nodes_[h.state].in_begin} + h.slot;
    }

    void write_label(std::size_t in_record, double value) noexcept {
        std::memcpy(in_.record(in_record) + sizeof(std::uint32_t), &value, sizeof value);
    }

    /// Moves a full block into one of the next class.
    void make_room(RecordSlab& slab, std::uint32_t& begin, std::uint32_t size, std::uint8_t& block, bool out) {
        if (size < RecordSlab::capacity(block)) return;
        const auto next = static_cast<std::uint8_t>(block == RecordSlab::no_block ? 0 : block + 1);
        const std::uint32_t to = slab.allocate(next);
        if (out && !weights_.empty() && weights_.size() < slab.extent()) weights_.resize(slab.extent(), 1.0);
        if (size != 0) {
            std::memcpy(slab.record(to), slab.record(begin), size * slab.stride());
            if (out && !weights_.empty()) {
                for (std::uint32_t i = 0; i < size; ++i) weights_[to + i] = weights_[begin + i];
            }
        }
        if (block != RecordSlab::no_block) slab.release(begin, block);
        begin = to;
        block = next;
    }

    /// (s, next) is about to become the out-record number out_size, at or past the degree from which a hash finds it.
    void index_hub(StateId s, StateId next) {
        const Node& node = nodes_[index(s)];
        if (node.out_size == hub_degree) {
            for (std::uint32_t i = 0; i < node.out_size; ++i) hubs_[key(s, target(node.out_begin + i))] = i;
        }
        hubs_[key(s, next)] = node.out_size;
    }

    void erase_in(StateId s, std::uint32_t slot) {
        Node& node = nodes_[index(s)];
        const std::uint32_t last = node.in_size - 1;
        if (slot != last) {
            std::byte* to = in_.record(std::size_t{node.in_begin} + slot);
            std::memcpy(to, in_.record(std::size_t{node.in_begin} + last), in_bytes);
            std::uint32_t from;
            std::memcpy(&from, to, sizeof from);
            const std::uint32_t moved = find(StateId{from}, s);
            set_head(moved, {static_cast<std::uint32_t>(s), slot});
        }
        --node.in_size;
    }

    std::vector<Node> nodes_;
    RecordSlab out_;
    RecordSlab in_;
    std::vector<double> weights_;
    std::vector<StateId> dirty_;
    std::unordered_map<std::uint64_t, std::uint32_t> hubs_;
    std::size_t pairs_ = 0;
};

}  // namespace sspql::detail
