// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <fcntl.h>
#include <poll.h>
#include <stdlib.h>
#include <unistd.h>

#include <array>
#include <string>
#include <thread>
#include <vector>

#include "report/progress.hpp"

namespace sspql::report {
namespace {

/// What can be read without waiting.
std::string pending(int descriptor) {
    std::string text;
    std::array<char, 4096> buffer{};
    pollfd waiting{descriptor, POLLIN, 0};
    while (::poll(&waiting, 1, 50) > 0 && (waiting.revents & POLLIN) != 0) {
        const ssize_t n = ::read(descriptor, buffer.data(), buffer.size());
        if (n <= 0) break;
        text.append(buffer.data(), static_cast<std::size_t>(n));
    }
    return text;
}

TEST(ProgressLine, ShowsShareAndTimeLeft) {
    ProgressState state{"pusher_experiment", "runs", 132, 400, 20.2};
    EXPECT_EQ(progress_line(state, 79), "pusher_experiment  [#######.................]  132/400 runs  33 %  ETA 0:41");
    EXPECT_EQ(progress_line(state, 62), "pusher_experiment  [###........]  132/400 runs  33 %  ETA 0:41");
    EXPECT_EQ(progress_line(state, 50), "pusher_experiment  132/400 runs  33 %  ETA 0:41");
    EXPECT_EQ(progress_line(state, 10), "pusher_exp");
    state.done = 0;
    EXPECT_EQ(progress_line(state, 50), "pusher_experiment    0/400 runs  0 %  ETA -:--");
    state.done = 400;
    EXPECT_EQ(progress_line(state, 50), "pusher_experiment  400/400 runs  100 %  ETA 0:00");
    state.done = 1;
    EXPECT_EQ(progress_line(state, 51), "pusher_experiment    1/400 runs  0 %  ETA 2:14:20");
}

TEST(ProgressLine, NothingToDo) {
    EXPECT_EQ(progress_line({"p", "runs", 0, 0, 0.0}, 38), "p  [######]  0/0 runs  100 %  ETA 0:00");
}

TEST(Progress, SilentWhereThereIsNoTerminal) {
    std::array<int, 2> ends{};
    ASSERT_EQ(::pipe(ends.data()), 0);
    {
        Progress progress("p", 10, "runs", ends[1]);
        progress.advance(10);
        progress.clear();
    }
    EXPECT_EQ(pending(ends[0]), "");
    ::close(ends[0]);
    ::close(ends[1]);
}

TEST(Progress, RewritesOneLineOnATerminalAndWipesIt) {
    const int master = ::posix_openpt(O_RDWR | O_NOCTTY);
    if (master < 0 || ::grantpt(master) != 0 || ::unlockpt(master) != 0) GTEST_SKIP() << "no pseudo-terminal";
    const int terminal = ::open(::ptsname(master), O_RDWR | O_NOCTTY);
    if (terminal < 0) GTEST_SKIP() << "no pseudo-terminal";
    const char* old = ::getenv("TERM");
    const std::string kept = old == nullptr ? "" : old;
    ::setenv("TERM", "xterm", 1);
    {
        Progress progress("p", 4000, "runs", terminal);
        std::vector<std::thread> threads;
        threads.reserve(4);
        for (int i = 0; i < 4; ++i) {
            threads.emplace_back([&] {
                for (int n = 0; n < 999; ++n) progress.advance();
            });
        }
        for (std::thread& thread : threads) thread.join();
        std::this_thread::sleep_for(std::chrono::milliseconds(120));
        progress.advance(4);
    }
    const std::string text = pending(master);
    EXPECT_EQ(text.rfind("\rp  [", 0), 0u) << text;
    EXPECT_NE(text.find("4000/4000 runs  100 %"), std::string::npos) << text;
    EXPECT_EQ(text.find('\n'), std::string::npos);
    const std::string wipe = "\r\x1b[K";
    ASSERT_GE(text.size(), wipe.size());
    EXPECT_EQ(text.substr(text.size() - wipe.size()), wipe);
    EXPECT_LT(text.size(), 4000u);  // a few updates, not one for each of 4000 calls

    ::setenv("TERM", "dumb", 1);
    { Progress progress("p", 1, "runs", terminal); }
    EXPECT_EQ(pending(master), "");
    if (old == nullptr) {
        ::unsetenv("TERM");
    } else {
        ::setenv("TERM", kept.c_str(), 1);
    }
    ::close(terminal);
    ::close(master);
}

}  // namespace
}  // namespace sspql::report
