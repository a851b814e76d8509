// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include <sspql/io/archive.hpp>
#include <sspql/io/checkpoint_format.hpp>
#include <sspql/io/crc32.hpp>

namespace sspql {

/// The archive that writes a checkpoint, to anything with `write(const void*, std::size_t)`: a header, sections one after
/// the other, an end. The length of a section need not be known beforehand; memory is one chunk of 64 KiB.
template <class Sink>
class CheckpointWriter : public Archive<CheckpointWriter<Sink>, false> {
    using Base = Archive<CheckpointWriter, false>;
    friend Base;

public:
    /// Writes the header. The sink must outlive the writer; it throws what it throws.
    explicit CheckpointWriter(Sink& sink) : sink_(sink), chunk_(detail::largest_chunk) {
        detail::Crc32 crc;
        put(detail::checkpoint_magic.data(), detail::checkpoint_magic.size(), crc);
        put(detail::checkpoint_format, crc);
        put(detail::library_version, crc);
        put_checksum(crc);
    }

    /// A section of this name (at most 15 characters) with what write() writes.
    template <class F>
    void section(const char* name, const F& write) {
        crc_ = detail::Crc32{};
        const detail::SectionName padded = detail::section_name(name);
        put(padded.data(), padded.size(), crc_);
        used_ = 0;
        write();
        flush();
        put(std::uint32_t{0}, crc_);
        put_checksum(crc_);
    }

    /// Nothing may follow.
    void finish() {
        section(detail::last_section, [] {});
    }

    /// Writes a name, which a reader compares with its own.
    void tag(const char* /*what*/, const std::string& name) {
        std::string copy = name;
        (*this)(copy);
    }

    /// Nothing: what is written is right.
    void require(bool /*ok*/, const char* /*text*/) const noexcept {}

private:
    /// Inlined, a number costs a store.
    [[gnu::always_inline]] void bytes(const void* data, std::size_t size) {
        if (size > detail::largest_chunk - used_) return split(data, size);
        std::memcpy(chunk_.data() + used_, data, size);
        used_ += size;
    }

    [[gnu::noinline]] void split(const void* data, std::size_t size) {
        const auto* from = static_cast<const unsigned char*>(data);
        while (size > 0) {
            if (used_ == detail::largest_chunk) flush();
            const std::size_t n = std::min(size, detail::largest_chunk - used_);
            std::memcpy(chunk_.data() + used_, from, n);
            used_ += n;
            from += n;
            size -= n;
        }
    }

    void flush() {
        if (used_ == 0) return;
        put(static_cast<std::uint32_t>(used_), crc_);
        put(chunk_.data(), used_, crc_);
        used_ = 0;
    }

    void put(const void* data, std::size_t size, detail::Crc32& crc) {
        crc.add(data, size);
        sink_.write(data, size);
    }
    void put(std::uint32_t value, detail::Crc32& crc) {
        const auto four = detail::little_endian(value);
        put(four.data(), four.size(), crc);
    }
    void put_checksum(const detail::Crc32& crc) {
        const auto four = detail::little_endian(crc.value());
        sink_.write(four.data(), four.size());
    }

    Sink& sink_;
    std::vector<unsigned char> chunk_;
    std::size_t used_ = 0;
    detail::Crc32 crc_;
};

/// A sink in memory.
class MemorySink {
public:
    /// Adds bytes.
    void write(const void* data, std::size_t size) { bytes_.append(static_cast<const char*>(data), size); }
    /// All bytes so far.
    [[nodiscard]] std::string& bytes() noexcept { return bytes_; }

private:
    std::string bytes_;
};

}  // namespace sspql
