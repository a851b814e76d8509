// SPDX-License-Identifier: MIT
#include "report/output_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <climits>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <optional>
#include <stdexcept>
#include <system_error>

namespace sspql::report {

namespace {

[[noreturn]] void fail(const std::string& path, int error) {
    throw std::runtime_error("cannot write " + (path.empty() ? "''" : path) + ": " +
                             std::generic_category().message(error));
}

/// A descriptor that is closed at the end of the scope unless `close` was called before.
class Descriptor {
public:
    explicit Descriptor(int number) noexcept : number_(number) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() {
        if (number_ >= 0) ::close(number_);
    }

    [[nodiscard]] int number() const noexcept { return number_; }

    /// 0, or the errno of a late write error that only close reports.
    [[nodiscard]] int close() noexcept {
        const int result = ::close(number_);
        const int error = errno;
        number_ = -1;
        return result == 0 ? 0 : error;
    }

private:
    int number_;
};

/// Removes the new file unless it was renamed into place.
class TemporaryName {
public:
    explicit TemporaryName(std::string name) : name_(std::move(name)) {}
    TemporaryName(const TemporaryName&) = delete;
    TemporaryName& operator=(const TemporaryName&) = delete;
    ~TemporaryName() {
        if (!name_.empty()) ::unlink(name_.c_str());
    }

    [[nodiscard]] const char* text() const noexcept { return name_.c_str(); }
    void renamed() noexcept { name_.clear(); }

private:
    std::string name_;
};

struct Target {
    std::string file;                   ///< where links lead
    std::string directory;              ///< of `file`, ending in a slash
    std::optional<mode_t> permissions;  ///< of the existing file
    bool direct = false;                ///< a device or pipe: nothing to rename over
};

/// Where a write to `path` would land. Throws if it is a directory or an existing file that may not be written.
Target resolve(const std::string& path) {
    Target target;
    target.file = path;
    struct stat status {};
    if (::stat(path.c_str(), &status) == 0) {
        if (S_ISDIR(status.st_mode)) fail(path, EISDIR);
        if (::faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) != 0) fail(path, errno);
        target.direct = !S_ISREG(status.st_mode);
        target.permissions = status.st_mode & 07777u;
        const std::unique_ptr<char, decltype(&std::free)> real(::realpath(path.c_str(), nullptr), &std::free);
        if (real) target.file = real.get();
    } else if (errno != ENOENT || ::lstat(path.c_str(), &status) == 0) {
        fail(path, errno != 0 ? errno : ENOENT);  // a name that cannot be, or a link that leads nowhere
    } else if (path.empty() || path.back() == '/') {
        fail(path, path.empty() ? ENOENT : EISDIR);
    }
    const std::size_t slash = target.file.rfind('/');
    target.directory = slash == std::string::npos ? "./" : target.file.substr(0, slash + 1);
    return target;
}

/// A new empty file in `directory`, opened for writing; its name goes to `name`. -1 and errno on failure.
int create_beside(const std::string& directory, std::string& name) {
    static std::atomic<unsigned> counter{0};
    for (;;) {
        name = directory + ".sspql-" + std::to_string(::getpid()) + "-" + std::to_string(counter++);
        const int number = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (number >= 0 || errno != EEXIST) return number;
    }
}

/// 0 or an errno.
int write_all(int number, const std::string& text) {
    std::size_t written = 0;
    while (written < text.size()) {
        const ssize_t n = ::write(number, text.data() + written, text.size() - written);
        if (n > 0) {
            written += static_cast<std::size_t>(n);
        } else if (n == 0) {
            return EIO;
        } else if (errno != EINTR) {
            return errno;
        }
    }
    return 0;
}

void write_directly(const std::string& path, const std::string& text) {
    Descriptor file(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
    if (file.number() < 0) fail(path, errno);
    if (const int error = write_all(file.number(), text)) fail(path, error);
    if (const int error = file.close()) fail(path, error);
}

/// Makes the rename itself durable. Best effort: some file systems cannot synchronise a directory.
void synchronise_directory(const std::string& directory) {
    const Descriptor descriptor(::open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (descriptor.number() >= 0) static_cast<void>(::fsync(descriptor.number()));
}

}  // namespace

void require_writable(const std::string& path) {
    const Target target = resolve(path);
    if (target.direct) return;
    std::string name;
    const Descriptor probe(create_beside(target.directory, name));
    if (probe.number() < 0) fail(path, errno);
    const TemporaryName temporary(std::move(name));
}

void write_file(const std::string& path, const std::string& text) {
    const Target target = resolve(path);
    if (target.direct) return write_directly(path, text);
    std::string name;
    Descriptor file(create_beside(target.directory, name));
    if (file.number() < 0) fail(path, errno);
    TemporaryName temporary(std::move(name));
    if (const int error = write_all(file.number(), text)) fail(path, error);
    if (target.permissions && ::fchmod(file.number(), *target.permissions) != 0) fail(path, errno);
    if (::fsync(file.number()) != 0) fail(path, errno);
    if (const int error = file.close()) fail(path, error);
    if (::rename(temporary.text(), target.file.c_str()) != 0) fail(path, errno);
    temporary.renamed();
    synchronise_directory(target.directory);
}

}  // namespace sspql::report
