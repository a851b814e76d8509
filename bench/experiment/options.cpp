// SPDX-License-Identifier: MIT
#include "experiment/options.hpp"

#include <algorithm>
#include <csignal>
#include <exception>
#include <iostream>
#include <sstream>

#include <CLI/CLI.hpp>

#include <sspql/core/version.hpp>

#include "experiment/learner_catalog.hpp"

namespace sspql::experiment {

struct Options::Parser {
    CLI::App app;
};

namespace {

std::string one_line(std::string text) {
    for (char& c : text) {
        if (c == '\n' || c == '\r') c = ' ';
    }
    while (!text.empty() && text.back() == ' ') text.pop_back();
    return text;
}

std::string listed(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
    return text;
}

}  // namespace

Options::Options(const std::string& program, const std::string& description) : parser_(std::make_unique<Parser>()) {
    CLI::App& app = parser_->app;
    app.name(program);
    app.description(description);
    app.set_version_flag("--version", program + " " SSPQL_VERSION, "Print the version and exit");
    app.get_formatter()->column_width(34);
    app.set_help_flag("--help,-h", "Print this and exit");
}

Options::~Options() = default;

void Options::text(const std::string& name, std::string& value, const std::string& help) {
    parser_->app.add_option(name, value, help)->option_text("TEXT");
}

void Options::choice(const std::string& name, std::string& value, const std::vector<std::string>& choices,
                     const std::string& help) {
    const auto check = [name, choices](const std::string& given) {
        for (const std::string& known : choices) {
            if (given == known) return std::string();
        }
        return name + " must be one of " + listed(choices) + ", got '" + given + "'";
    };
    std::string words;
    for (const std::string& known : choices) words += (words.empty() ? "" : "|") + known;
    parser_->app.add_option(name, value, help + " (default " + value + ")")->option_text(words)->check(check);
}

void Options::whole(const std::string& name, std::int64_t& value, std::int64_t least, std::int64_t most,
                    const std::string& help) {
    const auto check = [name, least, most](const std::string& given) {
        std::int64_t number = 0;
        if (CLI::detail::lexical_cast(given, number) && number >= least && number <= most) return std::string();
        return name + " must be a whole number from " + std::to_string(least) + " to " + std::to_string(most) +
               ", got '" + given + "'";
    };
    parser_->app.add_option(name, value, help + " (default " + std::to_string(value) + ")")
        ->option_text("N")
        ->check(check);
}

namespace {

std::string text_of(double x) {
    std::ostringstream out;
    out << x;
    return out.str();
}

/// Checks that a text is a number from `least` to `most`; empty if it is.
auto number_check(const std::string& name, double least, double most) {
    return [=](const std::string& given) {
        double number = 0.0;
        if (CLI::detail::lexical_cast(given, number) && number >= least && number <= most) return std::string();
        return name + " must be a number from " + text_of(least) + " to " + text_of(most) + ", got '" + given + "'";
    };
}

}  // namespace

void Options::number(const std::string& name, double& value, double least, double most, const std::string& help) {
    parser_->app.add_option(name, value, help + " (default " + text_of(value) + ")")
        ->option_text("X")
        ->check(number_check(name, least, most));
}

void Options::number(const std::string& name, std::optional<double>& value, double least, double most,
                     const std::string& help) {
    parser_->app.add_option(name, value, help)->option_text("X")->check(number_check(name, least, most));
}

void Options::common(CommonOptions& options) {
    CLI::App& app = parser_->app;
    app.add_option("--learners", options.learners, "Learners, separated by commas (default " + options.learners + ")")
        ->option_text("A,B,...");
    whole("--seeds", options.seeds, 1, 1000000, "Seeds 1 to N, a run each for every learner");
    whole("--episodes", options.episodes, 1, 1000000, "Episodes of a run");
    whole("--steps-per-episode", options.steps_per_episode, 1, 1000000000, "An episode is cut after N steps");
    whole("--threads", options.threads, 0, 1024, "Threads; 0 = as many as the machine has; results do not depend on it");
    app.add_option("--set", options.set, "Change a learner's parameter; '*' reaches all learners; may be repeated")
        ->option_text("NAME.key=value")
        ->allow_extra_args(false);
    reports(options.files);
}

void Options::reports(report::OutputFiles& files) {
    CLI::App& app = parser_->app;
    app.add_option("--json", files.json, "Write all results as JSON")->option_text("FILE");
    app.add_option("--html", files.html, "Write a report to look at, one self-contained file")->option_text("FILE");
    app.add_option("--csv", files.csv, "Write a row per episode")->option_text("FILE");
}

void Options::shards(ShardOptions& options) {
    CLI::App& app = parser_->app;
    app.add_option("--shard", options.shard,
                   "Do only part i of n, i from 1 to n, and write it to --out; merge_results puts the n parts together")
        ->option_text("i/n");
    app.add_option("--out", options.out, "The file of the shard")->option_text("FILE");
}

void Options::files(const std::string& name, std::vector<std::string>& values, const std::string& help) {
    const auto check = [](const std::string& path) {
        return CLI::ExistingFile(path).empty() ? std::string() : "no such file: " + path;
    };
    parser_->app.add_option(name, values, help)->required()->option_text("...")->check(check);
}

void Options::footer(const std::string& text) { parser_->app.footer(text); }

bool Options::parse(int argc, const char* const* argv) {
    try {
        parser_->app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        std::cout << parser_->app.help() << std::flush;
        return false;
    } catch (const CLI::CallForVersion& version) {
        std::cout << version.what() << std::endl;
        return false;
    } catch (const CLI::ParseError& error) {
        std::string text = one_line(error.what());
        // A failed check is prefixed with the option's name once more.
        const std::size_t colon = text.find(": ");
        if (error.get_name() == "ValidationError" && colon != std::string::npos) text = text.substr(colon + 2);
        throw UsageError(text + " (--help lists the options)");
    }
    return true;
}

std::string shell_word(const std::string& word) {
    const bool plain = !word.empty() && word.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                                               "0123456789_-+=./,:@%") == std::string::npos;
    if (plain) return word;
    std::string quoted = "'";
    for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return quoted + "'";
}

std::string command_line(int argc, const char* const* argv, const std::vector<std::string>& dropped) {
    std::string text;
    for (int i = 0; i < argc; ++i) {
        std::string word = argv[i];
        if (std::find(dropped.begin(), dropped.end(), word.substr(0, word.find('='))) != dropped.end()) {
            if (word.find('=') == std::string::npos) ++i;  // its value is the next word
            continue;
        }
        if (i == 0) word = word.substr(word.find_last_of('/') + 1);
        text += (i == 0 ? "" : " ") + shell_word(word);
    }
    return text;
}

std::string compiler_name() {
#if defined(__clang__)
    return "clang++ " __clang_version__;
#elif defined(__GNUC__)
    return "g++ " __VERSION__;
#else
    return "unknown";
#endif
}

std::string json_list(const std::vector<std::string>& words) {
    std::string text = "[";
    for (const std::string& word : words) {
        if (text.size() > 1) text += ",";
        text += '"';
        for (const char c : word) {
            if (c == '"' || c == '\\') text += '\\';
            text += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
        }
        text += '"';
    }
    return text + "]";
}

std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> parts;
    if (text.empty()) return parts;
    std::size_t begin = 0;
    for (;;) {
        const std::size_t end = text.find(separator, begin);
        parts.push_back(text.substr(begin, end - begin));
        if (end == std::string::npos) return parts;
        begin = end + 1;
    }
}

int run_program(const char* program, const std::function<int(int, char**)>& body, int argc, char** argv) {
    std::signal(SIGXFSZ, SIG_IGN);  // a file size limit is an error to report, not a way to die
    try {
        return body(argc, argv);
    } catch (const std::exception& error) {
        std::cerr << program << ": " << one_line(error.what()) << std::endl;
        return 2;
    }
}

}  // namespace sspql::experiment
