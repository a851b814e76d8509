// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include <pybind11/pybind11.h>

namespace sspql::python {

/// What a checkpoint says of the learner in it.
struct CheckpointType {
    std::string type_name;
    std::size_t states = 0;
    std::size_t actions = 0;
};

/// \throws std::runtime_error "checkpoint NAME: ..." for bytes that are no sound checkpoint.
[[nodiscard]] CheckpointType checkpoint_type(std::string_view bytes, const std::string& name);

/// Whole files, written as by AtomicFile. `path` is what os.fspath takes; \throws OSError, or the subclass that Python
/// has for the reason, TypeError for what is no path.
void write_file(const pybind11::object& path, std::string_view bytes);
[[nodiscard]] std::string read_file(const pybind11::object& path);

/// The path as errors name it.
[[nodiscard]] std::string path_text(const pybind11::object& path);

}  // namespace sspql::python
