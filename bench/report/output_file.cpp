// SPDX-License-Identifier: MIT
#include "report/output_file.hpp"

#include <sspql/io/atomic_file.hpp>

namespace sspql::report {

void require_writable(const std::string& path) { const AtomicFile probe(path); }

std::vector<std::pair<std::string, std::string>> OutputFiles::given() const {
    std::vector<std::pair<std::string, std::string>> all;
    const auto add = [&](const char* option, const std::string& path) {
        if (!path.empty()) all.emplace_back(option, path);
    };
    add("--json", json);
    add("--html", html);
    add("--csv", csv);
    add("--arena-svg", arena_svg);
    add("--curves-svg", curves_svg);
    return all;
}

void require_writable(const OutputFiles& files) {
    for (const auto& [option, path] : files.given()) require_writable(path);
}

void write_file(const std::string& path, const std::string& text) {
    AtomicFile file(path);
    file.write(text);
    file.commit();
}

}  // namespace sspql::report
