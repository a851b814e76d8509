// SPDX-License-Identifier: MIT
#include <sspql/io/atomic_file.hpp>

#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <unistd.h>

#include <csignal>
#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "io/file_testing.hpp"

namespace sspql {
namespace {

namespace fs = std::filesystem;
using testing::content;
using testing::error_of;
using testing::in_child;
using testing::limit_files_to;
using testing::set_content;

using AtomicFileTest = testing::FileTest;
using AtomicFileThreads = testing::FileTest;

void write_file(const std::string& path, const std::string& text) {
    AtomicFile file(path);
    file.write(text);
    file.commit();
}

std::string refusal(const std::string& path) {
    return error_of<std::runtime_error>([&] { write_file(path, "x"); });
}

TEST_F(AtomicFileTest, ReplacesWithCommitOnly) {
    const std::string file = path("state");
    write_file(file, "one");
    EXPECT_EQ(content(file), "one");
    {
        AtomicFile unfinished(file);
        unfinished.write(std::string(200000, 'x'));
        EXPECT_EQ(content(file), "one");
    }
    EXPECT_EQ(content(file), "one");
    write_file(file, "");
    EXPECT_TRUE(fs::exists(file));
    EXPECT_EQ(content(file), "");
    EXPECT_EQ(files(), 1u);
}

// Sizes around the buffer's, in pieces: what is read is what was written.
TEST_F(AtomicFileTest, PiecesOfAllSizesAddUp) {
    std::string whole;
    AtomicFile file(path("pieces"));
    for (const int n : {0, 1, 65535, 1, 65536, 65537, 3, 200000, 65533, 5, 65536, 0}) {
        const auto size = static_cast<std::size_t>(n);
        std::string piece(size, '\0');
        for (std::size_t i = 0; i < size; ++i) piece[i] = static_cast<char>((whole.size() + i) * 31 % 251);
        file.write(piece);
        whole += piece;
    }
    file.commit();
    EXPECT_TRUE(content(path("pieces")) == whole);
}

TEST_F(AtomicFileTest, NoCallsAfterCommit) {
    AtomicFile file(path("state"));
    file.commit();
    const std::string expected = "AtomicFile: " + path("state") + " was committed before";
    EXPECT_EQ(error_of<std::logic_error>([&] { file.write("x"); }), expected);
    EXPECT_EQ(error_of<std::logic_error>([&] { file.commit(); }), expected);
}

TEST_F(AtomicFileTest, KeepsPermissionsAndLinks) {
    write_file(path("real"), "old");
    ASSERT_EQ(::chmod(path("real").c_str(), 0640), 0);
    fs::create_directory(path("elsewhere"));
    fs::create_symlink("../real", path("elsewhere/link"));
    write_file(path("elsewhere/link"), "new");
    EXPECT_TRUE(fs::is_symlink(path("elsewhere/link")));
    EXPECT_EQ(content(path("real")), "new");
    struct stat status {};
    ASSERT_EQ(::stat(path("real").c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 07777u, 0640u);
}

TEST_F(AtomicFileTest, NewFilesFollowTheUmask) {
    EXPECT_TRUE(in_child([&] {
        ::umask(0027);
        write_file(path("new"), "x");
        struct stat status {};
        return ::stat(path("new").c_str(), &status) == 0 && (status.st_mode & 07777u) == 0640u;
    }));
}

// A program may change its directory between opening and committing.
TEST_F(AtomicFileTest, RelativePathsAreThoseOfTheConstruction) {
    fs::create_directory(path("below"));
    EXPECT_TRUE(in_child([&] {
        if (::chdir(directory_.c_str()) != 0) return false;
        AtomicFile file("relative");
        if (::chdir("below") != 0) return false;
        file.write("x");
        file.commit();
        return true;
    }));
    EXPECT_EQ(content(path("relative")), "x");
    EXPECT_EQ(files(), 2u);
}

TEST_F(AtomicFileTest, BadPathsAreNamedWithTheReason) {
    EXPECT_EQ(refusal(path("missing/x")), "cannot write " + path("missing/x") + ": No such file or directory");
    EXPECT_EQ(refusal(path("new/")), "cannot write " + path("new/") + ": Is a directory");
    EXPECT_EQ(refusal(path("")), "cannot write " + path("") + ": Is a directory");
    EXPECT_EQ(refusal(""), "cannot write '': No such file or directory");
    const std::string longest = path(std::string(300, 'x'));
    EXPECT_EQ(refusal(longest), "cannot write " + longest + ": File name too long");
    write_file(path("file"), "x");
    EXPECT_EQ(refusal(path("file/x")), "cannot write " + path("file/x") + ": Not a directory");
    fs::create_symlink("nowhere", path("dangling"));
    EXPECT_EQ(refusal(path("dangling")), "cannot write " + path("dangling") + ": No such file or directory");
    EXPECT_TRUE(fs::is_symlink(path("dangling")));
    EXPECT_EQ(files(), 2u);
}

// The limit stops a large piece, or what was buffered, in commit() at the latest.
TEST_F(AtomicFileTest, FullDiskKeepsTheOldFileAndIsRemembered) {
    const std::string file = path("state");
    write_file(file, "old");
    for (const std::size_t size : {std::size_t{5000}, std::size_t{1000000}}) {
        EXPECT_TRUE(in_child([&] {
            if (!limit_files_to(4096)) return false;
            AtomicFile full(file);
            const std::string expected = "cannot write " + file + ": File too large";
            const auto all = [&] {
                full.write(std::string(size, 'x'));
                full.commit();
            };
            return error_of<std::runtime_error>(all) == expected &&
                   error_of<std::runtime_error>([&] { full.write("y"); }) == expected &&
                   error_of<std::runtime_error>([&] { full.commit(); }) == expected;
        })) << size;
        EXPECT_EQ(content(file), "old");
        EXPECT_EQ(files(), 1u);
    }
}

TEST_F(AtomicFileTest, WritesToDevicesDirectly) {
    write_file("/dev/null", "nothing");
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
    EXPECT_EQ(refusal("/dev/full"), "cannot write /dev/full: No space left on device");
    EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

// A reader slower than the writer and a timer: writes to the pipe are short and interrupted all the time.
TEST_F(AtomicFileTest, InterruptedAndShortWritesLoseNothing) {
    ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
    const std::string sent(3000000, 'z');
    EXPECT_TRUE(in_child([&] {
        struct sigaction action {};
        action.sa_handler = [](int) {};
        ::sigaction(SIGALRM, &action, nullptr);  // without SA_RESTART
        std::size_t received = 0;
        std::thread reader([&] {
            sigset_t signals;
            sigemptyset(&signals);
            sigaddset(&signals, SIGALRM);
            pthread_sigmask(SIG_BLOCK, &signals, nullptr);  // the writer is to be interrupted
            const int pipe = ::open(path("pipe").c_str(), O_RDONLY);
            std::vector<char> block(1000);
            for (ssize_t n = 0; (n = ::read(pipe, block.data(), block.size())) > 0;) {
                received += static_cast<std::size_t>(n);
            }
            ::close(pipe);
        });
        const int held = ::open(path("pipe").c_str(), O_WRONLY);  // waits for the reader
        AtomicFile file(path("pipe"));
        const itimerval often{{0, 200}, {0, 200}};
        ::setitimer(ITIMER_REAL, &often, nullptr);
        file.write(sent);
        file.commit();
        const itimerval never{};
        ::setitimer(ITIMER_REAL, &never, nullptr);
        ::close(held);
        reader.join();
        return received == sent.size();
    }));
}

TEST_F(AtomicFileThreads, WritersOfOneFileDoNotMixTheirContents) {
    std::vector<std::thread> writers;
    for (const char letter : {'a', 'b', 'c', 'd'}) {
        writers.emplace_back([this, letter] {
            for (int i = 0; i < 25; ++i) write_file(path("shared"), std::string(1000, letter));
        });
    }
    for (std::thread& writer : writers) writer.join();
    const std::string last = content(path("shared"));
    EXPECT_EQ(last, std::string(1000, last.at(0)));
    EXPECT_EQ(files(), 1u);
}

}  // namespace
}  // namespace sspql
