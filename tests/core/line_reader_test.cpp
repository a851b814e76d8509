// SPDX-License-Identifier: MIT
#include <sspql/core/line_reader.hpp>

#include <cstddef>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <streambuf>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

namespace {

template <class F>
std::string error_of(F&& f) {
    try {
        f();
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "no error";
}

std::vector<std::string> lines_of(const std::string& text, std::size_t max_line = 100) {
    std::istringstream in(text);
    sspql::LineReader reader(in, "f", max_line);
    std::vector<std::string> lines;
    while (reader.next()) lines.emplace_back(reader.line());
    return lines;
}

using Lines = std::vector<std::string>;

/// An endless line that counts how much of it was read.
class EndlessLine : public std::streambuf {
public:
    std::size_t bytes_read = 0;

protected:
    int_type underflow() override {
        bytes_read += sizeof(block_);
        for (char& c : block_) c = 'x';
        setg(block_, block_, block_ + sizeof(block_));
        return traits_type::to_int_type(block_[0]);
    }

private:
    char block_[4096]{};
};

class BrokenDisk : public std::streambuf {
protected:
    int_type underflow() override { throw std::runtime_error("broken"); }
};

}  // namespace

TEST(LineReader, SplitsAtLineFeeds) {
    EXPECT_EQ(lines_of(""), Lines{});
    EXPECT_EQ(lines_of("\n"), Lines{""});
    EXPECT_EQ(lines_of("a"), Lines{"a"});
    EXPECT_EQ(lines_of("a\n"), Lines{"a"});
    EXPECT_EQ(lines_of("a\n\nb"), (Lines{"a", "", "b"}));
}

TEST(LineReader, TellsWhetherALineHasAnEnd) {
    std::istringstream in("a\n\r\nb");
    sspql::LineReader reader(in, "f");
    for (const bool ended : {true, true, false}) {
        ASSERT_TRUE(reader.next());
        EXPECT_EQ(reader.ended(), ended) << reader.number();
    }
    EXPECT_FALSE(reader.next());
}

TEST(LineReader, TakesCarriageReturnsOnlyFromLineEnds) {
    EXPECT_EQ(lines_of("a\r\nb\r\n"), (Lines{"a", "b"}));
    EXPECT_EQ(lines_of("\r\n"), Lines{""});
    EXPECT_EQ(lines_of("a\rb\r\r\n"), Lines{"a\rb\r"});
    EXPECT_EQ(lines_of("a\r"), Lines{"a\r"});
}

TEST(LineReader, SkipsAByteOrderMarkOnTheFirstLine) {
    EXPECT_EQ(lines_of("\xEF\xBB\xBF"
                       "a\n\xEF\xBB\xBF"
                       "b"),
              (Lines{"a",
                     "\xEF\xBB\xBF"
                     "b"}));
}

TEST(LineReader, CountsLinesAndNamesThePlace) {
    std::istringstream in("a\nb\n");
    sspql::LineReader reader(in, "dir/f.txt");
    EXPECT_EQ(reader.number(), 0u);
    EXPECT_EQ(error_of([&] { reader.fail(1, "nothing"); }), "dir/f.txt:1:1: nothing");
    ASSERT_TRUE(reader.next());
    ASSERT_TRUE(reader.next());
    EXPECT_EQ(reader.number(), 2u);
    EXPECT_EQ(error_of([&] { reader.fail(7, "bad"); }), "dir/f.txt:2:7: bad");
    EXPECT_FALSE(reader.next());
    EXPECT_FALSE(reader.next());
    EXPECT_EQ(reader.number(), 2u);
}

TEST(LineReader, LimitIsTheLengthWithoutTheLineEnd) {
    EXPECT_EQ(lines_of("abc\nabc\r\nabc", 3), (Lines{"abc", "abc", "abc"}));
    EXPECT_EQ(error_of([] { (void)lines_of("a\nabcd", 3); }), "f:2:4: line is longer than 3 bytes");
    EXPECT_EQ(error_of([] { (void)lines_of("abcd\r\n", 3); }), "f:1:4: line is longer than 3 bytes");
    EXPECT_EQ(error_of([] { (void)lines_of("abc\r", 3); }), "f:1:4: line is longer than 3 bytes");
    EXPECT_EQ(error_of([] { (void)lines_of("abc\rd", 3); }), "f:1:4: line is longer than 3 bytes");
    std::istringstream in;
    EXPECT_THROW(sspql::LineReader(in, "f", 0), std::invalid_argument);
}

TEST(LineReader, RefusesAnEndlessLineSoon) {
    EndlessLine endless;
    std::istream in(&endless);
    sspql::LineReader reader(in, "f");
    EXPECT_EQ(error_of([&] { (void)reader.next(); }), "f:1:1048577: line is longer than 1048576 bytes");
    EXPECT_LE(endless.bytes_read, 1048576u + 4096u);
}

TEST(LineReader, RefusesNulBytes) {
    EXPECT_EQ(error_of([] { (void)lines_of(std::string("ab\ncd\0e", 7)); }), "f:2:3: NUL byte in what should be text");
}

TEST(LineReader, SaysWhatCannotBeRead) {
    BrokenDisk disk;
    std::istream in(&disk);
    sspql::LineReader reader(in, "f");
    EXPECT_EQ(error_of([&] { (void)reader.next(); }), "f: cannot be read");
    EXPECT_EQ(error_of([] { (void)sspql::open_text("/no/such/file"); }), "/no/such/file: cannot be opened");
    EXPECT_EQ(error_of([] {
                  std::ifstream directory = sspql::open_text("/");
                  sspql::LineReader lines(directory, "/");
                  (void)lines.next();
              }),
              "/: cannot be read");
}

TEST(LineReader, QuotesWhatCannotBePrinted) {
    EXPECT_EQ(sspql::detail::quoted('x'), "'x'");
    EXPECT_EQ(sspql::detail::quoted('\x07'), "'\\x07'");
    EXPECT_EQ(sspql::detail::quoted('\xEF'), "'\\xEF'");
    EXPECT_EQ(sspql::detail::quoted(std::string_view("a\tb")), "'a?b'");
    EXPECT_EQ(sspql::detail::quoted(std::string_view(std::string(41, 'y'))), "'" + std::string(40, 'y') + "...'");
}
