// SPDX-License-Identifier: MIT
#pragma once

#include <cstdlib>
#include <optional>
#include <stdexcept>
#include <string>

/// \file
/// A micro-benchmark's own options, taken out of the command line before Google Benchmark reads it.

namespace sspql::floors {

/// The value of the last NAME=VALUE, if there is one.
inline std::optional<std::string> take_argument(int& argc, char** argv, const std::string& name) {
    std::optional<std::string> value;
    int kept = 1;
    for (int i = 1; i < argc; ++i) {
        const std::string argument = argv[i];
        if (argument.rfind(name + "=", 0) == 0) {
            value = argument.substr(name.size() + 1);
        } else {
            argv[kept++] = argv[i];
        }
    }
    argc = kept;
    return value;
}

/// The same for a whole number. \throws std::invalid_argument unless least <= value <= most.
inline unsigned long long take_number(int& argc, char** argv, const std::string& name, unsigned long long least,
                                      unsigned long long most, unsigned long long otherwise) {
    const auto text = take_argument(argc, argv, name);
    if (!text) return otherwise;
    char* end = nullptr;
    const unsigned long long value = std::strtoull(text->c_str(), &end, 10);
    if (end == text->c_str() || *end != '\0' || value < least || value > most) {
        throw std::invalid_argument(name + " must lie between " + std::to_string(least) + " and " +
                                    std::to_string(most));
    }
    return value;
}

}  // namespace sspql::floors
