// SPDX-License-Identifier: MIT
#pragma once

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include <sspql/io/posix_file.hpp>

namespace sspql {

/// A file that is replaced whole or not at all: what is written goes to a new file in the same directory, and commit()
/// puts that in the old one's place. Whoever opens `path`, even after a power cut, finds the old content or the new
/// one.
///
///     AtomicFile file("robot.sspql");
///     file.write(data, size);   ...
///     file.commit();
///
/// Without commit() nothing has happened. An existing file keeps its permission bits, a symbolic link stays one (what
/// it leads to is replaced), a device or pipe (/dev/stdout) is written to directly. A process killed while it writes
/// leaves nothing behind where the file system has nameless files (O_TMPFILE); elsewhere, and in the instant before the
/// rename, the new file stays, whose name begins with ".sspql-". Writes are gathered in a buffer of 64 KiB, the only
/// allocation of any size. Objects in several threads do not disturb one another.
///
/// \throws std::runtime_error "cannot write PATH: REASON", from every member: no such directory, no permission, a full
/// disk, a limit to the size of files (with SIGXFSZ ignored; else that ends the process). The old content is untouched
/// then and the new file gone, and all later calls throw the same. The one exception: if nothing but synchronising the
/// directory fails, the new content is in place. std::logic_error for calls after commit().
class AtomicFile {
public:
    /// Begins a new file beside the one at `path`.
    explicit AtomicFile(std::string path) : path_(std::move(path)) {
        resolve();
        buffer_.reserve(buffer_size);
        if (direct_) return;
        open_nameless();
        while (descriptor_ < 0) {
            temporary_ = next_name();
            descriptor_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
            if (descriptor_ >= 0 || errno == EEXIST) continue;
            temporary_.clear();
            fail(errno);
        }
    }

    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;
    ~AtomicFile() { discard(); }

    /// Adds bytes.
    void write(const void* data, std::size_t size) {
        require_open();
        if (size == 0) return;
        if (buffer_.size() + size <= buffer_size) {
            buffer_.append(static_cast<const char*>(data), size);
            return;
        }
        flush();
        if (size < buffer_size) {
            buffer_.append(static_cast<const char*>(data), size);
        } else if (const int error = detail::write_all(descriptor_, static_cast<const char*>(data), size)) {
            fail(error);
        }
    }

    /// Adds a text.
    void write(std::string_view text) { write(text.data(), text.size()); }

    /// Everything is on the disk and under its name when this returns.
    void commit() {
        require_open();
        flush();
        if (!direct_) {
            if (mode_known_ && ::fchmod(descriptor_, mode_) != 0) fail(errno);
            if (const int error = detail::synchronise(descriptor_)) fail(error);
            give_name();
        }
        if (::close(std::exchange(descriptor_, -1)) != 0) fail(errno);  // late write errors of some file systems
        committed_ = true;
        if (direct_) return;
        if (::rename(temporary_.c_str(), file_.c_str()) != 0) fail(errno);
        temporary_.clear();
        if (const int error = detail::synchronise_directory(directory_)) fail(error);
    }

private:
    static constexpr std::size_t buffer_size = std::size_t{1} << 16;

    /// Where a write to path_ would land, and whether it may.
    void resolve() {
        struct stat status {};
        file_ = path_;
        if (::stat(path_.c_str(), &status) == 0) {
            if (S_ISDIR(status.st_mode)) fail(EISDIR);
            if (::faccessat(AT_FDCWD, path_.c_str(), W_OK, AT_EACCESS) != 0) fail(errno);
            direct_ = !S_ISREG(status.st_mode);
            if (direct_) return;
            mode_ = status.st_mode & 07777u;
            mode_known_ = true;
            file_ = detail::real_path(path_);
            if (file_.empty()) fail(errno);
        } else if (errno != ENOENT || ::lstat(path_.c_str(), &status) == 0) {
            fail(errno);  // a name that cannot be, or a link that leads nowhere
        } else if (path_.empty() || path_.back() == '/') {
            fail(path_.empty() ? ENOENT : EISDIR);
        }
        // Absolute, so that a change of the working directory until commit() does no harm.
        const std::size_t slash = file_.rfind('/');
        directory_ = detail::real_path(slash == std::string::npos ? "." : file_.substr(0, slash + 1));
        if (directory_.empty()) fail(errno);
        if (directory_.back() != '/') directory_ += '/';
        file_ = directory_ + file_.substr(slash == std::string::npos ? 0 : slash + 1);
    }

    /// A file that disappears with the process. Leaves -1 where there is no such thing.
    void open_nameless() {
#ifdef O_TMPFILE
        descriptor_ = ::open(directory_.c_str(), O_WRONLY | O_TMPFILE | O_CLOEXEC, 0666);
        if (descriptor_ >= 0 && ::access(link_of_descriptor().c_str(), F_OK) != 0) {  // no /proc: it could get no name
            ::close(std::exchange(descriptor_, -1));
        }
#endif
    }

    [[nodiscard]] std::string link_of_descriptor() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

    /// An existing file cannot be linked over, only renamed over: the new one needs a name of its own first.
    void give_name() {
        if (!temporary_.empty()) return;
        const std::string link = link_of_descriptor();
        for (;;) {
            std::string name = next_name();
            if (::linkat(AT_FDCWD, link.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0) {
                temporary_ = std::move(name);
                return;
            }
            if (errno != EEXIST) fail(errno);
        }
    }

    [[nodiscard]] std::string next_name() const {
        static std::atomic<unsigned> counter{0};
        return directory_ + ".sspql-" + std::to_string(::getpid()) + "-" + std::to_string(counter++);
    }

    void flush() {
        if (direct_ && descriptor_ < 0) descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CLOEXEC);
        if (descriptor_ < 0) fail(errno);
        if (const int error = detail::write_all(descriptor_, buffer_.data(), buffer_.size())) fail(error);
        buffer_.clear();
    }

    void require_open() const {
        if (error_ != 0) detail::throw_cannot_write(path_, error_);
        if (committed_) throw std::logic_error("AtomicFile: " + path_ + " was committed before");
    }

    [[noreturn]] void fail(int error) {
        error_ = error == 0 ? EIO : error;
        discard();
        detail::throw_cannot_write(path_, error_);
    }

    void discard() noexcept {
        if (descriptor_ >= 0) ::close(std::exchange(descriptor_, -1));
        if (!temporary_.empty()) ::unlink(temporary_.c_str());
        temporary_.clear();
    }

    std::string path_;       // as given
    std::string file_;       // where links lead
    std::string directory_;  // of file_, ending in a slash
    std::string temporary_;  // the new file's name, while it has one
    std::string buffer_;
    int descriptor_ = -1;
    int error_ = 0;
    mode_t mode_ = 0;  // of the existing file
    bool mode_known_ = false;
    bool direct_ = false;  // a device or pipe: nothing to rename over
    bool committed_ = false;
};

}  // namespace sspql
