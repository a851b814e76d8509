// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "report/output_file.hpp"

/// \file
/// Command lines: the only place that knows CLI11.

namespace sspql::experiment {

/// What is wrong with a command line, in one line.
struct UsageError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// What every experiment program takes.
struct CommonOptions {
    std::string learners;
    std::int64_t seeds = 0;
    std::int64_t episodes = 0;
    std::int64_t threads = 0;  ///< 0: as many as the machine has
    std::int64_t steps_per_episode = 0;
    std::vector<std::string> set;
    report::OutputFiles files;
};

/// Which part of a run is asked for, as typed.
struct ShardOptions {
    std::optional<std::string> shard{};
    std::string out{};
};

/// A program's options. Values are what they were before parse() unless the command line says otherwise; they must
/// outlive it.
class Options {
public:
    Options(const std::string& program, const std::string& description);
    ~Options();
    Options(const Options&) = delete;
    Options& operator=(const Options&) = delete;

    void text(const std::string& name, std::string& value, const std::string& help);
    void choice(const std::string& name, std::string& value, const std::vector<std::string>& choices,
                const std::string& help);
    void whole(const std::string& name, std::int64_t& value, std::int64_t least, std::int64_t most,
               const std::string& help);
    void number(const std::string& name, double& value, double least, double most, const std::string& help);
    void number(const std::string& name, std::optional<double>& value, double least, double most,
                const std::string& help);
    void common(CommonOptions& options);
    void reports(report::OutputFiles& files);
    void shards(ShardOptions& options);

    /// One or more arguments without an option before them: files that exist.
    void files(const std::string& name, std::vector<std::string>& values, const std::string& help);

    /// A paragraph after the list of options.
    void footer(const std::string& text);

    /// False if there is nothing left to do: --help or --version was answered on stdout.
    /// \throws UsageError for anything the program does not understand.
    [[nodiscard]] bool parse(int argc, const char* const* argv);

private:
    struct Parser;
    std::unique_ptr<Parser> parser_;
};

/// A word as a shell takes it, quoted where it must be.
[[nodiscard]] std::string shell_word(const std::string& word);

/// The command line as a person could type it again, without those options (each has a value) in `dropped`.
[[nodiscard]] std::string command_line(int argc, const char* const* argv, const std::vector<std::string>& dropped = {});

/// "g++ 12.2.0" or the like.
[[nodiscard]] std::string compiler_name();

/// ["a","b"]: a list of words as JSON.
[[nodiscard]] std::string json_list(const std::vector<std::string>& words);

/// The parts of a text between separators: "a,b" and ',' make a and b; an empty text has none.
[[nodiscard]] std::vector<std::string> split(const std::string& text, char separator);

/// Runs a program's body: what it returns is the exit status; an exception becomes one line "PROGRAM: what" on stderr
/// and exit status 2.
int run_program(const char* program, const std::function<int(int, char**)>& body, int argc, char** argv);

}  // namespace sspql::experiment
