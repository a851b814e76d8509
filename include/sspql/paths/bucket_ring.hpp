// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include <sspql/core/assert.hpp>

namespace sspql::detail {

/// A ring of buckets over the keys just ahead of a search: bucket number floor((key - base) / width), which is monotone
/// in the key whatever the rounding. The current bucket is number c; the ring holds numbers c to c + size - 1, a bit
/// each telling whether there are entries; keys beyond wait in a binary heap and come in as the ring turns.
///
/// An entry is not removed when its vertex moves to another bucket: it is stale as soon as place_of(vertex) differs.
/// Entry: what a bucket holds, at least the vertex.
template <class Entry>
class BucketRing {
public:
    static constexpr std::uint16_t nowhere = 0xFFFFu;    ///< not queued
    static constexpr std::uint16_t far = 0xFFFEu;        ///< beyond the ring
    static constexpr std::uint16_t elsewhere = 0xFFFDu;  ///< for the owner's use

    /// Empty; `dirty`: some vertices may still have a place. At least `size` buckets; width 0: one bucket for all keys.
    void prepare(std::size_t n, bool dirty, std::size_t size, double width) {
        if (dirty) std::fill(place_.begin(), place_.end(), nowhere);
        if (place_.size() < n) place_.resize(n, nowhere);
        for (std::size_t word = 0; word < bits_.size(); ++word) {
            for (; bits_[word] != 0; bits_[word] &= bits_[word] - 1) {
                buckets_[word * 64 + lowest_bit(bits_[word])].clear();
            }
        }
        std::size_t buckets = 64;
        while (buckets < size) buckets *= 2;
        if (buckets_.size() < buckets) buckets_.resize(buckets);
        bits_.assign(buckets / 64, 0);
        mask_ = buckets - 1;
        far_.clear();
        inverse_ = width > 0.0 ? std::min(1.0 / width, std::numeric_limits<double>::max()) : 0.0;
        loading_ = true;
        horizon_ = -1.0;
        base_ = 0.0;
        number_ = 0;
    }

    [[nodiscard]] std::uint16_t place_of(std::uint32_t vertex) const noexcept { return place_[vertex]; }
    [[nodiscard]] std::uint16_t current_place() const noexcept { return static_cast<std::uint16_t>(number_ & mask_); }
    [[nodiscard]] std::vector<Entry>& current() noexcept { return buckets_[number_ & mask_]; }
    [[nodiscard]] const std::vector<Entry>& current() const noexcept { return buckets_[number_ & mask_]; }

    void forget(std::uint32_t vertex) noexcept { place_[vertex] = nowhere; }
    void set_place(std::uint32_t vertex, std::uint16_t place) noexcept { place_[vertex] = place; }

    /// Where a key belongs now; everything is `far` before the first advance.
    [[nodiscard]] std::uint16_t place_for(double key) const noexcept {
        const double x = (key - base_) * inverse_;
        if (!(x < horizon_)) return far;
        SSPQL_ASSERT(x >= static_cast<double>(number_), "keys do not fall below the last popped one");
        return static_cast<std::uint16_t>(static_cast<std::uint64_t>(static_cast<std::int64_t>(x)) & mask_);
    }

    /// Adds an entry; place = place_for(key).
    void insert(std::uint32_t vertex, double key, std::uint16_t place, const Entry& entry) {
        place_[vertex] = place;
        if (place == far) {
            far_.push_back({key, vertex});
            if (!loading_) std::push_heap(far_.begin(), far_.end(), Later());
            return;
        }
        buckets_[place].push_back(entry);
        bits_[place / 64u] |= std::uint64_t{1} << (place % 64u);
    }

    /// Turns to the next bucket with entries; the current one is cleared. make(vertex, key) builds the entries of the
    /// keys that come in. Precondition: some vertex is queued.
    template <class Make>
    void advance(const Make& make) {
        const std::uint16_t here = current_place();
        buckets_[here].clear();
        bits_[here / 64u] &= ~(std::uint64_t{1} << (here % 64u));
        if (loading_) {
            loading_ = false;
            std::make_heap(far_.begin(), far_.end(), Later());
        }
        const std::size_t next = next_place(here);
        if (next == none) {
            drop_stale();
            SSPQL_ASSERT(!far_.empty(), "advance of an empty ring");
            base_ = far_.front().key;
            number_ = 0;
        } else {
            number_ += (next - here) & mask_;
        }
        horizon_ = static_cast<double>(number_ + mask_ + 1);
        while (!far_.empty() && (far_.front().key - base_) * inverse_ < horizon_) {
            const Far item = far_.front();
            pop_far();
            if (place_[item.vertex] == far)
                insert(item.vertex, item.key, place_for(item.key), make(item.vertex, item.key));
        }
    }

private:
    static constexpr std::size_t none = ~std::size_t{0};

    struct Far {
        double key;
        std::uint32_t vertex;
    };

    struct Later {
        bool operator()(const Far& a, const Far& b) const noexcept { return a.key > b.key; }
    };

    static std::size_t lowest_bit(std::uint64_t word) noexcept {
#if defined(__GNUC__)
        return static_cast<std::size_t>(__builtin_ctzll(word));
#else
        std::size_t bit = 0;
        for (; (word & 1u) == 0; word >>= 1) ++bit;
        return bit;
#endif
    }

    /// The first place with entries from `here` on around the ring, or none.
    [[nodiscard]] std::size_t next_place(std::size_t here) const noexcept {
        std::size_t word = here / 64u;
        std::uint64_t bits = bits_[word] & (~std::uint64_t{0} << (here % 64u));
        for (std::size_t i = 0; i <= bits_.size(); ++i) {
            if (bits != 0) return word * 64u + lowest_bit(bits);
            word = word + 1 == bits_.size() ? 0 : word + 1;
            bits = bits_[word];
        }
        return none;
    }

    void pop_far() {
        std::pop_heap(far_.begin(), far_.end(), Later());
        far_.pop_back();
    }

    void drop_stale() {
        while (!far_.empty() && place_[far_.front().vertex] != far) pop_far();
    }

    std::vector<std::vector<Entry>> buckets_;
    std::vector<std::uint64_t> bits_;
    std::vector<std::uint16_t> place_;
    std::vector<Far> far_;
    std::size_t mask_ = 0;
    std::uint64_t number_ = 0;
    double base_ = 0.0;
    double inverse_ = 0.0;
    double horizon_ = -1.0;
    bool loading_ = true;
};

/// How many vertices a queue over a BucketRing holds: the ring itself cannot tell, as it holds stale entries too.
class QueuedVertices {
public:
    [[nodiscard]] bool empty() const noexcept { return size_ == 0; }
    [[nodiscard]] std::size_t size() const noexcept { return size_; }

protected:
    std::size_t size_ = 0;
};

}  // namespace sspql::detail
