// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

#include "report/output_file.hpp"

namespace sspql::report {
namespace {

namespace fs = std::filesystem;

/// A directory of its own for each test.
class OutputFile : public testing::Test {
protected:
    void SetUp() override {
        std::string name = (fs::temp_directory_path() / "sspql-output-XXXXXX").string();
        ASSERT_NE(::mkdtemp(name.data()), nullptr);
        directory_ = name;
    }
    void TearDown() override {
        std::error_code ignored;
        fs::permissions(directory_, fs::perms::owner_all, ignored);
        fs::remove_all(directory_, ignored);
    }

    [[nodiscard]] std::string path(const std::string& name) const { return (directory_ / name).string(); }
    [[nodiscard]] std::size_t files() const {
        return static_cast<std::size_t>(std::distance(fs::directory_iterator(directory_), fs::directory_iterator()));
    }
    static std::string content(const std::string& file) {
        std::ifstream in(file, std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }

    fs::path directory_;
};

template <class Call>
std::string error_of(Call call) {
    try {
        call();
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "no error";
}

TEST_F(OutputFile, WritesAndReplaces) {
    const std::string file = path("report.json");
    write_file(file, "one\n");
    EXPECT_EQ(content(file), "one\n");
    write_file(file, "two");
    EXPECT_EQ(content(file), "two");
    EXPECT_EQ(files(), 1u);
    write_file(file, "");
    EXPECT_EQ(content(file), "");
}

TEST_F(OutputFile, KeepsPermissionsAndLinks) {
    const std::string file = path("real");
    write_file(file, "old");
    ASSERT_EQ(::chmod(file.c_str(), 0640), 0);
    fs::create_symlink("real", path("link"));
    write_file(path("link"), "new");
    EXPECT_TRUE(fs::is_symlink(path("link")));
    EXPECT_EQ(content(file), "new");
    struct stat status {};
    ASSERT_EQ(::stat(file.c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777u, 0640u);
}

TEST_F(OutputFile, RequireWritableLeavesNothingAndTouchesNothing) {
    require_writable(path("new"));
    EXPECT_EQ(files(), 0u);
    write_file(path("old"), "content");
    require_writable(path("old"));
    EXPECT_EQ(content(path("old")), "content");
    EXPECT_EQ(files(), 1u);
    require_writable("/dev/null");
    write_file("/dev/null", "nothing");
    EXPECT_FALSE(fs::is_regular_file("/dev/null"));
}

TEST_F(OutputFile, BadPathsAreNamedWithTheReason) {
    const std::string missing = path("missing/report.json");
    EXPECT_EQ(error_of([&] { require_writable(missing); }), "cannot write " + missing + ": No such file or directory");
    EXPECT_EQ(error_of([&] { write_file(missing, "x"); }), "cannot write " + missing + ": No such file or directory");
    const std::string directory = path("");
    EXPECT_EQ(error_of([&] { require_writable(directory); }), "cannot write " + directory + ": Is a directory");
    EXPECT_EQ(error_of([&] { require_writable(path("new/")); }), "cannot write " + path("new/") + ": Is a directory");
    EXPECT_EQ(error_of([] { require_writable(""); }), "cannot write '': No such file or directory");
    const std::string longest = path(std::string(300, 'x'));
    EXPECT_EQ(error_of([&] { require_writable(longest); }), "cannot write " + longest + ": File name too long");
    write_file(path("file"), "x");
    const std::string below = path("file/report");
    EXPECT_EQ(error_of([&] { require_writable(below); }), "cannot write " + below + ": Not a directory");
    fs::create_symlink("nowhere", path("dangling"));
    EXPECT_NE(error_of([&] { write_file(path("dangling"), "x"); }), "no error");
    EXPECT_TRUE(fs::is_symlink(path("dangling")));
    EXPECT_EQ(files(), 2u);
}

/// Runs `check` in a child process, which may change its limits and its user; true if it returned true.
template <class Check>
bool in_child(Check check) {
    const pid_t child = ::fork();
    if (child == 0) ::_exit(check() ? 0 : 1);
    int status = 0;
    return child > 0 && ::waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

TEST_F(OutputFile, ReadOnlyDirectoryIsRefused) {
    write_file(path("old"), "content");
    ASSERT_EQ(::chmod(directory_.c_str(), 0555), 0);
    ASSERT_EQ(::chmod(path("old").c_str(), 0666), 0);
    EXPECT_TRUE(in_child([&] {
        if (::geteuid() == 0 && ::seteuid(65534) != 0) return false;  // root may write everywhere
        return error_of([&] { require_writable(path("new")); }) ==
                   "cannot write " + path("new") + ": Permission denied" &&
               error_of([&] { write_file(path("old"), "x"); }) == "cannot write " + path("old") + ": Permission denied";
    }));
    EXPECT_EQ(content(path("old")), "content");
    EXPECT_EQ(files(), 1u);
}

TEST_F(OutputFile, ReadOnlyFileIsRefused) {
    write_file(path("old"), "content");
    ASSERT_EQ(::chmod(directory_.c_str(), 0777), 0);
    ASSERT_EQ(::chmod(path("old").c_str(), 0444), 0);
    EXPECT_TRUE(in_child([&] {
        if (::geteuid() == 0 && ::seteuid(65534) != 0) return false;
        return error_of([&] { require_writable(path("old")); }) ==
                   "cannot write " + path("old") + ": Permission denied" &&
               error_of([&] { require_writable(path("new")); }) == "no error";
    }));
    EXPECT_EQ(content(path("old")), "content");
    EXPECT_EQ(files(), 1u);
}

TEST_F(OutputFile, FullDiskKeepsTheOldFile) {
    const std::string file = path("report.json");
    write_file(file, "old");
    EXPECT_TRUE(in_child([&] {
        std::signal(SIGXFSZ, SIG_IGN);
        const rlimit limit{4096, 4096};
        if (::setrlimit(RLIMIT_FSIZE, &limit) != 0) return false;
        return error_of([&] { write_file(file, std::string(100000, 'x')); }) ==
               "cannot write " + file + ": File too large";
    }));
    EXPECT_EQ(content(file), "old");
    EXPECT_EQ(files(), 1u);
}

TEST_F(OutputFile, FullDeviceIsAnError) {
    if (!fs::exists("/dev/full")) GTEST_SKIP();
    EXPECT_EQ(error_of([] { write_file("/dev/full", "x"); }), "cannot write /dev/full: No space left on device");
}

}  // namespace
}  // namespace sspql::report
