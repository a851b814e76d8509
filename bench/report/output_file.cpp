// SPDX-License-Identifier: MIT
#include "report/output_file.hpp"

#include <sspql/io/atomic_file.hpp>

namespace sspql::report {

void require_writable(const std::string& path) { const AtomicFile probe(path); }

void write_file(const std::string& path, const std::string& text) {
    AtomicFile file(path);
    file.write(text);
    file.commit();
}

}  // namespace sspql::report
