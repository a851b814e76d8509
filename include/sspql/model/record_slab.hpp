// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <vector>

#include <sspql/core/assert.hpp>

namespace sspql::detail {

/// One arena of equally long records, handed out in contiguous blocks by size class (4, 6, 8, 12, 16, 24, 32, ...
/// records: a grown block is at most a third empty) and taken back on a LIFO free list per class, linked through the
/// free blocks themselves. allocate and release are O(1) amortised; nothing is allocated while the extent stays within
/// what was reserved. Record addresses move when the arena grows.
class RecordSlab {
public:
    static constexpr std::uint8_t classes = 59;  // the largest holds 2^31 records
    static constexpr std::uint8_t no_block = 255;

    /// \param stride bytes of a record, at least 4.
    explicit RecordSlab(std::size_t stride) : stride_(stride) {
        SSPQL_ASSERT(stride >= sizeof(std::uint32_t), "a free block keeps its link in its first record");
        free_.fill(none);
    }

    /// Records in a block of class c.
    [[nodiscard]] static constexpr std::uint32_t capacity(std::uint8_t c) noexcept {
        return c == no_block ? 0u : (c % 2 == 0 ? 4u : 6u) << (c / 2);
    }

    /// First record of a free block, contents undefined. \throws std::length_error past 2^32 - 1 records.
    [[nodiscard]] std::uint32_t allocate(std::uint8_t c) {
        SSPQL_ASSERT(c < classes, "no block is that large");
        if (free_[c] != none) {
            const std::uint32_t begin = free_[c];
            std::memcpy(&free_[c], record(begin), sizeof(std::uint32_t));
            return begin;
        }
        if (extent_ > 0xFFFFFFFEu - capacity(c)) throw std::length_error("sspql: 2^32 transition records are in use");
        bytes_.resize((extent_ + capacity(c)) * stride_);
        const auto begin = static_cast<std::uint32_t>(extent_);
        extent_ += capacity(c);
        return begin;
    }

    void release(std::uint32_t begin, std::uint8_t c) noexcept {
        std::memcpy(record(begin), &free_[c], sizeof(std::uint32_t));
        free_[c] = begin;
    }

    [[nodiscard]] std::byte* record(std::size_t i) noexcept { return bytes_.data() + i * stride_; }
    [[nodiscard]] const std::byte* record(std::size_t i) const noexcept { return bytes_.data() + i * stride_; }

    [[nodiscard]] std::size_t stride() const noexcept { return stride_; }

    /// One more than the largest record handed out.
    [[nodiscard]] std::size_t extent() const noexcept { return extent_; }

    void reserve(std::size_t records) { bytes_.reserve(records * stride_); }

    [[nodiscard]] std::size_t bytes() const noexcept { return bytes_.capacity(); }

private:
    static constexpr std::uint32_t none = 0xFFFFFFFFu;

    std::size_t stride_;
    std::size_t extent_ = 0;
    std::array<std::uint32_t, classes> free_{};
    std::vector<std::byte> bytes_;
};

}  // namespace sspql::detail
