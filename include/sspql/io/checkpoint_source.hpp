// SPDX-License-Identifier: MIT
#pragma once

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace sspql {

/// Bytes of a regular file, for a CheckpointReader. Its size is what it was when it was opened.
/// \throws std::runtime_error "cannot read PATH: REASON".
class FileSource {
public:
    /// Opens the file.
    explicit FileSource(const std::string& path) : path_(path), buffer_(std::size_t{1} << 16) {
        descriptor_.value = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);  // a pipe without a writer: no waiting
        struct stat status {};
        if (descriptor_.value < 0 || ::fstat(descriptor_.value, &status) != 0) fail(errno);
        if (S_ISDIR(status.st_mode)) fail(EISDIR);
        if (!S_ISREG(status.st_mode)) refuse("it is no file");
        size_ = static_cast<std::uint64_t>(status.st_size);
    }
    FileSource(const FileSource&) = delete;
    FileSource& operator=(const FileSource&) = delete;
    ~FileSource() = default;

    /// Bytes in all.
    [[nodiscard]] std::uint64_t size() const noexcept { return size_; }

    /// Back to the first byte.
    void rewind() {
        if (::lseek(descriptor_.value, 0, SEEK_SET) != 0) fail(errno);
        used_ = filled_ = 0;
    }

    /// Reads the next `most` bytes. \returns how many there were; fewer only at the end.
    std::size_t read(void* to, std::size_t most) {
        std::size_t done = 0;
        while (done < most) {
            if (used_ == filled_ && !fill()) break;
            const std::size_t n = std::min(most - done, filled_ - used_);
            std::memcpy(static_cast<char*>(to) + done, buffer_.data() + used_, n);
            used_ += n;
            done += n;
        }
        return done;
    }

private:
    bool fill() {
        ssize_t n = 0;
        do {
            n = ::read(descriptor_.value, buffer_.data(), buffer_.size());
        } while (n < 0 && errno == EINTR);
        if (n < 0) fail(errno);
        used_ = 0;
        filled_ = static_cast<std::size_t>(n);
        return n > 0;
    }

    [[noreturn]] void fail(int error) const { refuse(std::generic_category().message(error)); }
    [[noreturn]] void refuse(const std::string& reason) const {
        throw std::runtime_error("cannot read " + (path_.empty() ? "''" : path_) + ": " + reason);
    }

    /// Closed also where the constructor throws.
    struct Descriptor {
        int value = -1;
        ~Descriptor() {
            if (value >= 0) ::close(value);
        }
    };

    std::string path_;
    std::vector<char> buffer_;
    std::size_t used_ = 0;
    std::size_t filled_ = 0;
    std::uint64_t size_ = 0;
    Descriptor descriptor_;
};

/// Bytes in memory; the view must stay valid.
class MemorySource {
public:
    /// Before the first byte.
    explicit MemorySource(std::string_view bytes) noexcept : bytes_(bytes) {}

    /// Bytes in all.
    [[nodiscard]] std::uint64_t size() const noexcept { return bytes_.size(); }
    /// Back to the first byte.
    void rewind() noexcept { used_ = 0; }
    /// Reads the next `most` bytes. \returns how many there were; fewer only at the end.
    std::size_t read(void* to, std::size_t most) noexcept {
        const std::size_t n = std::min(most, bytes_.size() - used_);
        if (n != 0) std::memcpy(to, bytes_.data() + used_, n);
        used_ += n;
        return n;
    }

private:
    std::string_view bytes_;
    std::size_t used_ = 0;
};

}  // namespace sspql
