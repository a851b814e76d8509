// SPDX-License-Identifier: MIT
#include "checkpoint_files.hpp"

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>

#include <sspql/io/atomic_file.hpp>
#include <sspql/io/checkpoint_reader.hpp>
#include <sspql/io/checkpoint_source.hpp>

namespace py = pybind11;

namespace sspql::python {

namespace {

std::string native(const py::object& path) {
    return py::module_::import("os").attr("fsencode")(path).cast<std::string>();
}

/// The library says "cannot read PATH: REASON"; Python has an exception for most reasons, chosen by their number.
[[noreturn]] void throw_os_error(const std::runtime_error& error, const py::object& path) {
    const std::string text = error.what();
    for (int number = 1; number < 134; ++number) {
        const std::string reason = std::generic_category().message(number);
        if (text.size() <= reason.size() || text.substr(text.size() - reason.size() - 1) != " " + reason) continue;
        PyErr_SetObject(PyExc_OSError, py::make_tuple(number, reason, path).ptr());
        throw py::error_already_set();
    }
    PyErr_SetString(PyExc_OSError, text.c_str());
    throw py::error_already_set();
}

}  // namespace

CheckpointType checkpoint_type(std::string_view bytes, const std::string& name) {
    MemorySource source(bytes);
    CheckpointReader<MemorySource> reader(source, name);
    CheckpointType type;
    reader.section("type", [&] {
        bool grows = false;
        reader(type.type_name);
        reader.size(type.states);
        reader.size(type.actions);
        reader(grows);
        if (grows) reader.refuse("the states of this learner grow in number; in Python that number is fixed");
        // Each (s,a) takes 12 bytes at least; memory is only asked for where there is a file to fill it.
        reader.require(type.actions > 0 && type.states <= reader.left() / 12 / type.actions,
                       "there are more states than the file has room for");
    });
    return type;
}

void write_file(const py::object& path, std::string_view bytes) {
    const std::string file_path = native(path);
    try {
        AtomicFile file(file_path);
        file.write(bytes.data(), bytes.size());
        file.commit();
    } catch (const std::runtime_error& error) {
        throw_os_error(error, path);
    }
}

std::string read_file(const py::object& path) {
    const std::string file_path = native(path);
    try {
        FileSource file(file_path);
        std::string bytes(static_cast<std::size_t>(file.size()), '\0');
        bytes.resize(file.read(bytes.data(), bytes.size()));
        return bytes;
    } catch (const std::runtime_error& error) {
        throw_os_error(error, path);
    }
}

std::string path_text(const py::object& path) { return py::str(py::module_::import("os").attr("fsdecode")(path)); }

}  // namespace sspql::python
