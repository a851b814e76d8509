// SPDX-License-Identifier: MIT
#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>

/// \file
/// What writing files needs of POSIX, with the interruptions dealt with and the errors in words.

namespace sspql {

namespace detail {

/// Calls write_some(data, size), which answers like ::write, until everything is written, whatever signals and short
/// writes come between. \returns 0 or an errno.
template <class WriteSome>
[[nodiscard]] int write_with(const char* data, std::size_t size, WriteSome&& write_some) {
    while (size > 0) {
        const ssize_t n = write_some(data, size);
        if (n > 0) {
            data += n;
            size -= static_cast<std::size_t>(n);
        } else if (n == 0) {
            return EIO;
        } else if (errno != EINTR) {
            return errno;
        }
    }
    return 0;
}

/// Writes all of it. \returns 0 or an errno.
[[nodiscard]] inline int write_all(int descriptor, const char* data, std::size_t size) {
    return write_with(data, size,
                      [descriptor](const char* from, std::size_t n) { return ::write(descriptor, from, n); });
}

/// Writes all of it, from this place in the file on. \returns 0 or an errno.
[[nodiscard]] inline int write_all_at(int descriptor, const char* data, std::size_t size, std::uint64_t place) {
    return write_with(data, size, [descriptor, &place](const char* from, std::size_t n) {
        const ssize_t written = ::pwrite(descriptor, from, n, static_cast<off_t>(place));
        if (written > 0) place += static_cast<std::uint64_t>(written);
        return written;
    });
}

/// Waits until the disk has it. \returns 0 or an errno.
[[nodiscard]] inline int synchronise(int descriptor) noexcept {
    for (;;) {
        if (::fsync(descriptor) == 0) return 0;
        if (errno != EINTR) return errno;
    }
}

/// Makes what was created or renamed in a directory last. Some file systems cannot, and some directories may not be
/// read: that is no error. \returns 0 or an errno.
[[nodiscard]] inline int synchronise_directory(const std::string& directory) {
    const int descriptor = ::open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0) return 0;
    const int error = synchronise(descriptor);
    ::close(descriptor);
    return error == EINVAL || error == EBADF || error == ENOTSUP || error == EROFS ? 0 : error;
}

/// An open file, closed at the end of its life.
class FileDescriptor {
public:
    FileDescriptor() = default;
    explicit FileDescriptor(int number) noexcept : number_(number) {}
    FileDescriptor(FileDescriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
    FileDescriptor& operator=(FileDescriptor&& other) noexcept {
        std::swap(number_, other.number_);
        return *this;
    }
    ~FileDescriptor() {
        if (number_ >= 0) ::close(number_);
    }

    /// -1 where none is open.
    [[nodiscard]] int number() const noexcept { return number_; }

    /// \returns 0, or the errno of a late write error that only closing reports.
    [[nodiscard]] int close() noexcept { return ::close(std::exchange(number_, -1)) == 0 ? 0 : errno; }

private:
    int number_ = -1;
};

[[noreturn]] inline void throw_cannot_write(const std::string& path, int error) {
    throw std::runtime_error("cannot write " + (path.empty() ? "''" : path) + ": " +
                             std::generic_category().message(error));
}

/// The absolute path without links; empty and errno if there is none.
inline std::string real_path(const std::string& path) {
    const std::unique_ptr<char, decltype(&std::free)> real(::realpath(path.c_str(), nullptr), &std::free);
    return real == nullptr ? std::string() : real.get();
}

}  // namespace detail

}  // namespace sspql
