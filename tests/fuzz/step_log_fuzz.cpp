// SPDX-License-Identifier: MIT
// Any bytes as a step log: read, learnt from and continued, or refused with the place.
#include <sspql/io/replay.hpp>
#include <sspql/io/step_log.hpp>

#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>

#include <sspql/learn/q_learning.hpp>

#include "fuzz/fuzz_testing.hpp"

namespace {

using sspql::fuzz::require;

/// What the log holds; nothing if it is refused.
std::optional<sspql::StepLogContent> read(const std::string& text) {
    std::istringstream in(text);
    std::uint64_t steps = 0;
    std::uint64_t ends = 0;
    try {
        const sspql::StepLogContent content = sspql::for_each_step(in, "input", [&](const sspql::LoggedStep& step) {
            ++steps;
            ends += step.transition.terminated || step.truncated ? 1 : 0;
        });
        require(content.steps == steps && content.episodes - content.unfinished == ends, "counts are right");
        require((content.cut_line == 0) == (text.empty() || text.back() == '\n'), "a cut line is noticed");
        return content;
    } catch (const std::runtime_error& error) {
        sspql::fuzz::require_place(error, "input");
        return std::nullopt;
    }
}

void learn(const std::string& text) {
    std::istringstream in(text);
    sspql::QLearning<> learner(16, 4);
    try {
        static_cast<void>(sspql::replay(in, "input", learner));
    } catch (const std::runtime_error& error) {
        sspql::fuzz::require_place(error, "input");
    }
    require(!learner.running(), "no episode is left running");
}

/// A log in memory with this text is continued: the whole text now.
std::optional<std::string> continued(const std::string& text) {
    const int memory = ::memfd_create("log", MFD_CLOEXEC);
    require(memory >= 0 && ::write(memory, text.data(), text.size()) == static_cast<ssize_t>(text.size()), "memory");
    std::optional<std::string> result;
    try {
        sspql::StepLog log("/proc/self/fd/" + std::to_string(memory));
        log.write({sspql::state_id(1), sspql::action_id(0), 0.5, sspql::state_id(2), true});
        log.close();
        result.emplace(static_cast<std::size_t>(::lseek(memory, 0, SEEK_END)), '\0');
        require(::pread(memory, result->data(), result->size(), 0) == static_cast<ssize_t>(result->size()), "memory");
    } catch (const std::runtime_error&) {
    }
    ::close(memory);
    return result;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(sspql::fuzz::text_of(data, size));
    const std::optional<sspql::StepLogContent> before = read(text);
    if (before) learn(text);  // which ends where reading ends, else
    const std::optional<std::string> more = continued(text);
    const bool other = text.substr(0, text.find('\n')).find("weight") != std::string::npos ||  // another kind of log
                       text.substr(0, 1) == "\xEF" || text.find("18446744073709551614,") != std::string::npos;
    require(!before || more || other, "what can be read can be continued");
    if (!before || !more) return 0;
    const std::optional<sspql::StepLogContent> after = read(*more);
    require(after && after->steps == before->steps + 1 && after->cut_line == 0, "one step more");
    return 0;
}
