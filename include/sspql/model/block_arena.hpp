// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>
#include <stdexcept>
#include <utility>

#include <sspql/core/assert.hpp>

namespace sspql::detail {

/// Zeros whose first one lies on a cache line. Addresses change when they grow. Many at once come untouched from the
/// system: what is never written takes address space only, on systems that work like that. A const object's bytes can
/// be written, as those behind a pointer.
class ZeroedBytes {
public:
    static constexpr std::size_t alignment = 64;

    ZeroedBytes() = default;
    ZeroedBytes(const ZeroedBytes& other) {
        reserve(other.size_);
        size_ = other.size_;
        if (size_ != 0) std::memcpy(data_, other.data_, size_);
    }
    ZeroedBytes(ZeroedBytes&& other) noexcept { swap(other); }
    ZeroedBytes& operator=(ZeroedBytes other) noexcept {
        swap(other);
        return *this;
    }
    ~ZeroedBytes() = default;

    [[nodiscard]] std::byte* data() const noexcept { return data_; }
    [[nodiscard]] std::size_t size() const noexcept { return size_; }
    [[nodiscard]] std::size_t capacity() const noexcept { return capacity_; }

    void reserve(std::size_t bytes) {
        if (bytes <= capacity_) return;
        std::size_t space = bytes + alignment;
        std::unique_ptr<std::byte, Free> memory(static_cast<std::byte*>(std::calloc(space, 1)));
        if (!memory) throw std::bad_alloc();
        void* begin = memory.get();
        auto* data = static_cast<std::byte*>(std::align(alignment, bytes, begin, space));
        if (size_ != 0) std::memcpy(data, data_, size_);
        memory_ = std::move(memory);
        data_ = data;
        capacity_ = bytes;
    }

    /// O(1) amortised: what must grow again grows by a quarter at least.
    void resize(std::size_t bytes) {
        if (bytes > capacity_) reserve(std::max(bytes, capacity_ + capacity_ / 4));
        size_ = bytes;
    }

private:
    struct Free {
        void operator()(std::byte* memory) const noexcept { std::free(memory); }
    };

    void swap(ZeroedBytes& other) noexcept {
        std::swap(memory_, other.memory_);
        std::swap(data_, other.data_);
        std::swap(size_, other.size_);
        std::swap(capacity_, other.capacity_);
    }

    std::unique_ptr<std::byte, Free> memory_;
    std::byte* data_ = nullptr;
    std::size_t size_ = 0;
    std::size_t capacity_ = 0;
};

/// Blocks of a head and 4, 6, 8, 12, 16, 24, ... records each (a grown block is at most a third empty), in one arena. A
/// block is named by its first unit of 32 bytes. Blocks are taken back
/// on a LIFO free list per class, linked through the free blocks themselves. allocate and release are O(1) amortised;
/// nothing is allocated while the blocks stay within what was reserved. Addresses change when the arena grows.
///
/// Unit 0 belongs to nobody: zeros, which those who have no block may read as one without records.
class BlockArena {
public:
    static constexpr std::size_t unit = 32;
    static constexpr std::uint8_t classes = 57;  // the largest holds 2^30 records

    /// \param head bytes before the records of a block.
    /// \param record bytes of a record, at least 1.
    BlockArena(std::size_t head, std::size_t record) : head_(head), record_(record) {
        free_.fill(none);
        bytes_.resize(unit);
    }

    /// Records in a block of class c.
    [[nodiscard]] static constexpr std::uint32_t capacity(std::uint8_t c) noexcept {
        return (c % 2 == 0 ? 4u : 6u) << (c / 2);
    }

    /// The class of blocks of this capacity.
    [[nodiscard]] static constexpr std::uint8_t class_of(std::uint32_t capacity) noexcept {
        std::uint8_t c = 0;
        while (BlockArena::capacity(c) < capacity) ++c;
        return c;
    }

    /// The capacity of the next larger class; 0 has the first.
    [[nodiscard]] static std::uint32_t grown(std::uint32_t capacity) {
        if (capacity == 0) return BlockArena::capacity(0);
        const auto c = static_cast<std::uint8_t>(class_of(capacity) + 1);
        if (c >= classes) throw std::length_error("sspql: a state has 2^30 neighbours");
        return BlockArena::capacity(c);
    }

    /// A block of this capacity, which must be a class's; contents undefined.
    /// \throws std::length_error past 2^32 - 1 units.
    [[nodiscard]] std::uint32_t allocate(std::uint32_t capacity) {
        const std::uint8_t c = class_of(capacity);
        SSPQL_ASSERT(c < classes && BlockArena::capacity(c) == capacity, "a block has the capacity of a class");
        if (free_[c] != none) {
            const std::uint32_t begin = free_[c];
            std::memcpy(&free_[c], at(begin), sizeof(std::uint32_t));
            return begin;
        }
        const std::size_t begin = bytes_.size() / unit;
        const std::size_t end = begin + units(capacity);
        if (end > none) throw std::length_error("sspql: 128 GB of transitions are in use");
        bytes_.resize(end * unit);
        return static_cast<std::uint32_t>(begin);
    }

    void release(std::uint32_t begin, std::uint32_t capacity) noexcept {
        const std::uint8_t c = class_of(capacity);
        std::memcpy(at(begin), &free_[c], sizeof(std::uint32_t));
        free_[c] = begin;
    }

    [[nodiscard]] std::byte* at(std::uint32_t begin) const noexcept {
        return bytes_.data() + std::size_t{begin} * unit;
    }

    /// Units of a block.
    [[nodiscard]] std::size_t units(std::uint32_t capacity) const noexcept {
        return (head_ + capacity * record_ + unit - 1) / unit;
    }

    /// One more than the largest unit handed out.
    [[nodiscard]] std::size_t extent() const noexcept { return bytes_.size() / unit; }

    /// Room for blocks of this many records in all, however they are spread.
    void reserve(std::size_t records) {
        std::size_t most = 0;
        for (std::uint8_t c = 0; c < 8; ++c) {  // in larger blocks rounding up to units counts for less
            most = std::max(most, (records * units(capacity(c)) + capacity(c) - 1) / capacity(c));
        }
        bytes_.reserve(unit * (1 + most));
    }

    [[nodiscard]] std::size_t bytes() const noexcept { return bytes_.capacity(); }

private:
    static constexpr std::uint32_t none = 0xFFFFFFFFu;

    std::size_t head_;
    std::size_t record_;
    std::array<std::uint32_t, classes> free_{};
    ZeroedBytes bytes_;
};

}  // namespace sspql::detail
