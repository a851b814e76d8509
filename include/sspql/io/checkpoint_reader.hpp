// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <sspql/io/archive.hpp>
#include <sspql/io/checkpoint_format.hpp>
#include <sspql/io/crc32.hpp>

namespace sspql {

/// The archive that reads a checkpoint from anything with
///
///     std::uint64_t size() const                          bytes in all
///     void rewind()                                       back to the first
///     std::size_t read(void* to, std::size_t most)        fewer than `most` only at the end
///
/// The constructor passes over everything and checks the header, every section's checksum and the end, so that nothing
/// damaged is ever interpreted; then values are read, and checksums checked again. Memory is one chunk of 64 KiB.
/// \throws std::runtime_error "checkpoint NAME: ..." with the section and what is wrong with it.
template <class Source>
class CheckpointReader : public Archive<CheckpointReader<Source>, true> {
    using Base = Archive<CheckpointReader, true>;
    friend Base;

public:
    /// Checks all of it. \param name what messages call it, the path of the file.
    CheckpointReader(Source& source, std::string name)
        : source_(source), name_(std::move(name)), chunk_(detail::largest_chunk) {
        open_header();
        do {
            open_section();
            while (next_chunk()) {
            }
            check_sum();
        } while (section_ != detail::last_section);
        if (position_ != source_.size()) {
            fail("has " + std::to_string(source_.size() - position_) + " bytes after its end");
        }
        open_header();
    }

    /// Version of the library that wrote it, as 1000000 major + 1000 minor + patch.
    [[nodiscard]] std::uint32_t written_by() const noexcept { return written_by_; }

    /// Opens the next section, which must have this name, and calls read() for what is in it, which must be all.
    template <class F>
    void section(const char* name, const F& read) {
        open_section();
        if (section_ != name) fail("has section '" + section_ + "' where this learner expects '" + name + "'");
        try {
            read();
        } catch (const std::invalid_argument& error) {  // what constructors say of numbers out of range
            refuse(error.what());
        } catch (const std::length_error& error) {
            refuse(error.what());
        } catch (const std::bad_alloc&) {
            refuse("there is not enough memory for it");
        }
        if (used_ != filled_ || next_chunk()) refuse("it holds more than this learner does");
        check_sum();
    }

    /// Expects the end: no section must follow.
    void finish() {
        section(detail::last_section, [] {});
    }

    /// Reads a name, which must be this one.
    void tag(const char* what, const std::string& name) {
        std::string found;
        (*this)(found);
        if (found == name) return;
        for (char& c : found) c = c >= ' ' && c <= '~' ? c : '?';
        refuse(std::string("the file has the ") + what + " '" + found.substr(0, 60) + "', this learner '" + name + "'");
    }

    /// Refuses the file unless `ok`; `text` says what is wrong with it.
    void require(bool ok, const char* text) {
        if (!ok) refuse(text);
    }

    /// Bytes that may still come.
    [[nodiscard]] std::size_t left() const noexcept {
        const std::uint64_t left = source_.size() - position_ + (filled_ - used_);
        return static_cast<std::size_t>(std::min<std::uint64_t>(left, std::numeric_limits<std::size_t>::max()));
    }

    /// Refuses the section being read. \throws std::runtime_error
    [[noreturn]] void refuse(const std::string& text) const { fail("section '" + section_ + "': " + text); }

private:
    [[noreturn]] void fail(const std::string& text) const {
        throw std::runtime_error("checkpoint " + name_ + ": " + text);
    }

    void open_header() {
        source_.rewind();
        position_ = 0;
        section_ = "header";
        crc_ = detail::Crc32{};
        std::array<unsigned char, 8> magic{};
        if (source_.size() < magic.size()) fail("is no checkpoint of sspql: section 'header' is cut short");
        get(magic.data(), magic.size());
        if (magic != detail::checkpoint_magic) fail("is no checkpoint of sspql: section 'header' begins otherwise");
        const std::uint32_t format = get();
        written_by_ = get();
        check_sum();
        if (format > detail::checkpoint_format) {
            fail("section 'header': written by sspql " + detail::version_text(written_by_) + " in format " +
                 std::to_string(format) + "; this version reads formats up to " +
                 std::to_string(detail::checkpoint_format));
        }
        if (format == 0) fail("section 'header': there is no format 0");
    }

    void open_section() {
        if (section_.rfind("after ", 0) != 0) section_ = "after " + section_;  // until its name is known
        crc_ = detail::Crc32{};
        detail::SectionName padded{};
        get(padded.data(), padded.size());
        const auto end = std::find(padded.begin(), padded.end(), '\0');
        const bool sound = std::all_of(padded.begin(), end, [](char c) { return c >= ' ' && c <= '~'; }) &&
                           end != padded.begin() && std::all_of(end, padded.end(), [](char c) { return c == '\0'; });
        if (!sound) damaged();
        section_.assign(padded.begin(), end);
        used_ = filled_ = 0;
    }

    /// \returns false at the end of the section.
    bool next_chunk() {
        const std::uint32_t size = get();
        if (size > chunk_.size()) damaged();
        get(chunk_.data(), size);
        used_ = 0;
        filled_ = size;
        return size != 0;
    }

    void check_sum() {
        const std::uint32_t computed = crc_.value();
        if (get() != computed) damaged();
    }

    [[noreturn]] void damaged() const { fail("section '" + section_ + "' is damaged"); }

    void get(void* to, std::size_t size) {
        if (source_.read(to, size) != size) fail("is cut short in section '" + section_ + "'");
        position_ += size;
        crc_.add(to, size);
    }
    std::uint32_t get() {
        std::array<unsigned char, 4> four{};
        get(four.data(), four.size());
        return detail::from_little_endian(four.data());
    }

    [[gnu::always_inline]] void bytes(void* data, std::size_t size) {
        if (size > filled_ - used_) return join(data, size);
        std::memcpy(data, chunk_.data() + used_, size);
        used_ += size;
    }

    [[gnu::noinline]] void join(void* data, std::size_t size) {
        auto* to = static_cast<unsigned char*>(data);
        while (size > 0) {
            if (used_ == filled_ && !next_chunk()) refuse("it holds less than this learner does");
            const std::size_t n = std::min(size, filled_ - used_);
            std::memcpy(to, chunk_.data() + used_, n);
            used_ += n;
            to += n;
            size -= n;
        }
    }

    Source& source_;
    std::string name_;
    std::string section_;
    std::vector<unsigned char> chunk_;
    std::size_t used_ = 0;
    std::size_t filled_ = 0;
    std::uint64_t position_ = 0;
    std::uint32_t written_by_ = 0;
    detail::Crc32 crc_;
};

}  // namespace sspql
