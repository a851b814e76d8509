// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <stdexcept>
#include <string>

#include "io/file_testing.hpp"
#include "report/output_file.hpp"

namespace sspql::report {
namespace {

namespace fs = std::filesystem;

using OutputFile = sspql::testing::FileTest;
using sspql::testing::content;
using sspql::testing::in_child;

template <class Call>
std::string error_of(Call call) {
    return sspql::testing::error_of<std::runtime_error>(call);
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
        if (!sspql::testing::limit_files_to(4096)) return false;
        return error_of([&] { write_file(file, std::string(100000, 'x')); }) ==
               "cannot write " + file + ": File too large";
    }));
    EXPECT_EQ(content(file), "old");
    EXPECT_EQ(files(), 1u);
}

TEST_F(OutputFile, FullDeviceIsAnError) {
    EXPECT_EQ(error_of([] { write_file("/dev/full", "x"); }), "cannot write /dev/full: No space left on device");
}

}  // namespace
}  // namespace sspql::report
