// SPDX-License-Identifier: MIT
#pragma once

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include <sspql/core/errors.hpp>
#include <sspql/core/ids.hpp>
#include <sspql/io/posix_file.hpp>
#include <sspql/io/step_log_line.hpp>
#include <sspql/io/step_log_tail.hpp>
#include <sspql/learn/transition.hpp>
#include <sspql/model/transition_counts.hpp>

namespace sspql {

/// When steps leave the program's memory.
enum class LogFlush {
    every_step,     ///< a power cut loses no step but the running one
    every_episode,  ///< a power cut loses the running episode at most; also at 64 KiB
};

/// How a StepLog writes.
struct StepLogOptions {
    LogFlush flush = LogFlush::every_episode;  ///< when steps leave the program's memory
    /// Wait for the disk (fsync) at each flush. Else a power cut also loses what the system holds back, some 30
    /// seconds; a crash of the program does not.
    bool synchronise = true;
    bool weights = false;  ///< a ninth column for Transition::weight, which must be 1 otherwise
};

/// A record of what happened, one line a step, that outlives power cuts and can be learnt from again (replay):
///
///     episode,step,state,action,reward,next,terminated,truncated
///     0,0,12,1,-0.1,13,0,0
///     0,1,13,1,1,14,1,0
///
/// Episodes and the steps in them count from 0; `terminated` and `truncated` are 0 or 1, as in Step. Rewards have the
/// digits that give the same double again, whatever the locale. Lines end with LF; one without was cut off.
///
///     StepLog log("run.csv");
///     log.write({s, a, reward, next, terminated}, truncated);     or let a Logged<Agent> do it
///
/// An existing log is continued with the episode after its last one; a line that a power cut left without its end is
/// removed. Whole lines are handed over in one write(). States are logged as ids: with a HashedState, whose ids come in
/// order of discovery, a log belongs to the policy's own saved keys. Legal actions and goals are not in a log.
///
/// A write costs less than half a microsecond besides the disk. Memory: 64 KiB. One process at a time; one object per
/// thread.
///
/// \throws std::runtime_error "cannot write PATH: REASON" from every member: a full disk, a log that another process
/// writes, a file that is no regular one. Steps that could not be written are kept and tried again with the next call,
/// up to 1 MiB of them; beyond that write() refuses. "PATH:LINE:COLUMN: ..." for a file that is no step log, which
/// stays untouched. The destructor flushes, but cannot tell: call close() to hear of errors.
class StepLog {
public:
    /// Opens the log at `path`, or begins it: a new file has its header at once.
    explicit StepLog(std::string path, StepLogOptions options = {}) : path_(std::move(path)), options_(options) {
        file_ = detail::FileDescriptor(::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666));
        if (file_.number() < 0) detail::throw_cannot_write(path_, errno);
        require_own_file();
        const detail::StepLogTail tail = detail::read_step_log_tail(file_.number(), path_, options_.weights);
        size_ = tail.size;
        episode_ = tail.next_episode;
        buffer_.reserve(flush_at + 256);
        if (::ftruncate(file_.number(), static_cast<off_t>(size_)) != 0) detail::throw_cannot_write(path_, errno);
        if (size_ != 0) return;
        buffer_ = options_.weights ? detail::weighted_step_log_header : detail::step_log_header;
        buffer_ += '\n';
        flush();
        synchronise_directory();
    }

    StepLog(const StepLog&) = delete;
    StepLog& operator=(const StepLog&) = delete;
    ~StepLog() {
        try {
            close();
        } catch (const std::exception&) {  // said by close(), if anybody asked
        }
    }

    /// One step. The first one, and the first after a step that terminated or was truncated, begins an episode.
    /// \throws std::invalid_argument, with nothing logged, for a step that does not begin where the episode's last one
    /// led, ids that are none, a reward that is not finite, or a weight other than 1 in a log without weights.
    void write(const Transition& step, bool truncated = false) {
        require_open();
        require_valid(step);
        if (buffer_.size() >= most_kept) flush();  // throws if it still cannot
        append(step, truncated);
        running_ = !(step.terminated || truncated);
        last_ = step.next;
        step_ = running_ ? step_ + 1 : 0;
        if (!running_) ++episode_;
        if (options_.flush == LogFlush::every_step || !running_ || buffer_.size() >= flush_at) flush();
    }

    /// The running episode goes no further: the next step begins another one. Nothing between episodes.
    void abort() {
        if (!running_) return;
        running_ = false;
        step_ = 0;
        ++episode_;
        flush();
    }

    /// Hands over what is held back, and waits for the disk if the options say so.
    void flush() {
        require_open();
        if (buffer_.empty() && !unsynchronised_) return;
        // At a known place: after a failure the same bytes go there again.
        if (const int error = detail::write_all_at(file_.number(), buffer_.data(), buffer_.size(), size_)) {
            detail::throw_cannot_write(path_, error);
        }
        size_ += buffer_.size();
        buffer_.clear();
        unsynchronised_ = options_.synchronise;
        if (!unsynchronised_) return;
        if (const int error = detail::synchronise(file_.number())) detail::throw_cannot_write(path_, error);
        unsynchronised_ = false;
    }

    /// Flushes and closes. No calls but close() after that.
    void close() {
        if (file_.number() < 0) return;
        flush();
        if (const int error = file_.close()) detail::throw_cannot_write(path_, error);
    }

    /// Refuses a weight that write() would refuse, before anything is learnt from the step.
    /// \throws std::invalid_argument for a weight that this log cannot take: outside [1e-30, 1e30], or other than 1
    /// without the option `weights`.
    void require_weight(double weight) const {
        require_in("weight", weight, min_weight, max_weight);
        if (!options_.weights && weight != 1.0) throw_invalid("weight", "be 1 in a step log without weights", weight);
    }

    /// Number of the running episode, or of the one that begins next.
    [[nodiscard]] std::uint64_t episode() const noexcept { return episode_; }

    /// Where the log is, as it was opened.
    [[nodiscard]] const std::string& path() const noexcept { return path_; }

private:
    static constexpr std::size_t flush_at = std::size_t{1} << 16;
    static constexpr std::size_t most_kept = std::size_t{1} << 20;

    void require_open() const {
        if (file_.number() < 0) throw std::logic_error("StepLog: " + path_ + " was closed before");
    }

    void require_own_file() const {
        struct stat status {};
        if (::fstat(file_.number(), &status) != 0) detail::throw_cannot_write(path_, errno);
        if (!S_ISREG(status.st_mode)) {
            throw std::runtime_error("cannot write " + path_ + ": not a regular file");
        }
        if (::flock(file_.number(), LOCK_EX | LOCK_NB) == 0) return;
        if (errno != EWOULDBLOCK) return;  // a file system without locks
        throw std::runtime_error("cannot write " + path_ + ": somebody else is writing it");
    }

    void require_valid(const Transition& step) const {
        if (index(step.state) >= max_ids) throw_invalid("state", "be a state's id", index(step.state));
        if (index(step.action) >= max_ids) throw_invalid("action", "be an action's id", index(step.action));
        if (index(step.next) >= max_ids) throw_invalid("next", "be a state's id", index(step.next));
        if (running_ && step.state != last_) {
            throw_invalid("state", "be where the last step led, " + std::to_string(index(last_)), index(step.state));
        }
        require_finite("reward", step.reward);
        require_weight(step.weight);
    }

    void append(const Transition& step, bool truncated) {
        append_number(episode_, ',');
        append_number(step_, ',');
        append_number(index(step.state), ',');
        append_number(index(step.action), ',');
        append_number(step.reward, ',');
        append_number(index(step.next), ',');
        append_number(step.terminated ? 1 : 0, ',');
        append_number(truncated ? 1 : 0, options_.weights ? ',' : '\n');
        if (options_.weights) append_number(step.weight, '\n');
    }

    template <class Number>
    void append_number(Number value, char separator) {
        std::array<char, 40> text;
        const auto result = std::to_chars(text.data(), text.data() + text.size(), value);
        buffer_.append(text.data(), static_cast<std::size_t>(result.ptr - text.data()));
        buffer_ += separator;
    }

    /// A new file is there after a power cut only if its directory knows it.
    void synchronise_directory() const {
        if (!options_.synchronise) return;
        const std::size_t slash = path_.rfind('/');
        const std::string directory = slash == std::string::npos ? "./" : path_.substr(0, slash + 1);
        if (const int error = detail::synchronise_directory(directory)) detail::throw_cannot_write(path_, error);
    }

    std::string path_;
    StepLogOptions options_;
    detail::FileDescriptor file_;
    std::string buffer_;           // whole lines
    std::uint64_t size_ = 0;       // of the file, without what failed to be written
    std::uint64_t episode_ = 0;    // running, or next
    std::uint64_t step_ = 0;       // next
    StateId last_ = no_state;      // where the last step led
    bool running_ = false;         // an episode
    bool unsynchronised_ = false;  // written, but not on the disk for certain
};

}  // namespace sspql
