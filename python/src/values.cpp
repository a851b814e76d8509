// SPDX-License-Identifier: MIT
#include "values.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include <sspql/core/errors.hpp>
#include <sspql/learn/schedule.hpp>

namespace py = pybind11;

namespace sspql::python {

namespace {

[[noreturn]] void throw_type(const std::string& name, const std::string& what, py::handle got) {
    throw py::type_error(name + " must be " + what + ", got " + std::string(py::repr(got)));
}

std::uint64_t whole_number(const std::string& name, py::handle given) {
    if (PyIndex_Check(given.ptr()) == 0 || PyBool_Check(given.ptr()) != 0) throw_type(name, "a whole number", given);
    const auto number = py::reinterpret_steal<py::object>(PyNumber_Index(given.ptr()));
    if (!number) throw py::error_already_set();
    const std::uint64_t value = PyLong_AsUnsignedLongLong(number.ptr());
    if (PyErr_Occurred() != nullptr) {
        PyErr_Clear();
        throw py::value_error(name + " must lie between 0 and 2^64 - 1, got " + std::string(py::str(number)));
    }
    return value;
}

double real_number(const std::string& name, const char* what, py::handle given) {
    const bool number = PyFloat_Check(given.ptr()) != 0 || PyIndex_Check(given.ptr()) != 0 ||
                        py::hasattr(given, "__float__");  // NumPy's numbers
    if (!number || PyBool_Check(given.ptr()) != 0) throw_type(name, what, given);
    const double value = PyFloat_AsDouble(given.ptr());
    if (PyErr_Occurred() != nullptr) throw py::error_already_set();
    return value;
}

/// `given` as the alternative that `like` has.
Value read(const std::string& name, py::handle given, const Value& like) {
    if (std::holds_alternative<bool>(like)) {
        py::detail::make_caster<bool> truth;
        if (!truth.load(given, false)) throw_type(name, "True or False", given);  // takes NumPy's too
        return py::detail::cast_op<bool>(truth);
    }
    if (std::holds_alternative<std::uint64_t>(like)) return whole_number(name, given);
    if (std::holds_alternative<double>(like)) return real_number(name, "a number", given);
    if (const auto* choice = std::get_if<Choice>(&like)) {
        std::string all;
        for (const std::string& word : choice->words) all += (all.empty() ? "'" : " or '") + word + "'";
        if (!py::isinstance<py::str>(given)) throw_type(name, all, given);
        const auto word = given.cast<std::string>();
        for (std::size_t i = 0; i < choice->words.size(); ++i) {
            if (choice->words[i] == word) return Choice{i, choice->words};
        }
        throw py::value_error(name + " must be " + all + ", got '" + word + "'");
    }
    if (std::holds_alternative<Schedule::Rule>(like)) {
        if (py::isinstance<VisitDecay>(given)) return Schedule::Rule(given.cast<VisitDecay>());
        if (py::isinstance<ExponentialDecay>(given)) return Schedule::Rule(given.cast<ExponentialDecay>());
        return Schedule::Rule(Constant{real_number(name, "a number, a VisitDecay or an ExponentialDecay", given)});
    }
    if (!(py::isinstance<py::tuple>(given) || py::isinstance<py::list>(given)) || py::len(given) != 2) {
        throw_type(name, "two whole numbers (per_step, bank)", given);
    }
    const auto two = py::reinterpret_borrow<py::sequence>(given);
    return std::array<std::uint64_t, 2>{whole_number(name, py::object(two[0])), whole_number(name, py::object(two[1]))};
}

/// "gamma, alpha, trust.cap"
std::string names_of(const std::vector<Parameter>& parameters) {
    std::string names;
    for (const Parameter& parameter : parameters) names += (names.empty() ? "" : ", ") + parameter.name;
    return names;
}

void add(Settings& settings, const std::string& name, py::handle value, const Kind& kind,
         const std::vector<Parameter>& parameters) {
    for (const Parameter& parameter : parameters) {
        if (parameter.name == name) {
            settings.emplace_back(name, read(name, value, parameter.value));
            return;
        }
        if (parameter.name.rfind(name + ".", 0) == 0) throw_type(name, "a dict of its members", value);
    }
    throw py::type_error(kind.name + " has no parameter '" + name + "'; it has " + names_of(parameters));
}

std::string key_of(py::handle key) {
    if (!py::isinstance<py::str>(key)) throw_type("the name of a parameter", "a string", key);
    return key.cast<std::string>();
}

}  // namespace

void bind_schedules(py::module_& m) {
    py::class_<VisitDecay> visit(m, "VisitDecay",
                                 "min(1, N^-p) after N visits: a learning rate or weight that falls with the visits.");
    visit.attr("__module__") = "sspql";
    visit
        .def(py::init([](double p) {
                 return std::get<VisitDecay>(Schedule(VisitDecay{p}).rule());  // which checks it
             }),
             py::arg("p") = 2.0)
        .def_readonly("p", &VisitDecay::p)
        .def("__repr__",
             [](const VisitDecay& d) { return "VisitDecay(p=" + std::string(py::repr(py::float_(d.p))) + ")"; })
        .def(
            "__eq__", [](const VisitDecay& a, const VisitDecay& b) { return a.p == b.p; }, py::is_operator())
        .def("__hash__", [](const VisitDecay& d) { return py::hash(py::make_tuple("VisitDecay", d.p)); })
        .def(py::pickle([](const VisitDecay& d) { return py::make_tuple(d.p); },
                        [](const py::tuple& t) { return VisitDecay{t[0].cast<double>()}; }));

    py::class_<ExponentialDecay> exponential(m, "ExponentialDecay",
                                             "floor + (start - floor) e^(-rate N) after N visits.");
    exponential.attr("__module__") = "sspql";
    const auto key = [](const ExponentialDecay& d) { return py::make_tuple(d.start, d.rate, d.floor); };
    exponential
        .def(py::init([](double start, double rate, double floor) {
                 return std::get<ExponentialDecay>(Schedule(ExponentialDecay{start, rate, floor}).rule());
             }),
             py::arg("start") = 1.0, py::arg("rate") = 0.01, py::arg("floor") = 0.0)
        .def_readonly("start", &ExponentialDecay::start)
        .def_readonly("rate", &ExponentialDecay::rate)
        .def_readonly("floor", &ExponentialDecay::floor)
        .def("__repr__",
             [key](const ExponentialDecay& d) {
                 return std::string(py::str("ExponentialDecay(start={!r}, rate={!r}, floor={!r})").format(*key(d)));
             })
        .def(
            "__eq__", [key](const ExponentialDecay& a, const ExponentialDecay& b) { return key(a).equal(key(b)); },
            py::is_operator())
        .def("__hash__", [key](const ExponentialDecay& d) { return py::hash(key(d)); })
        .def(py::pickle(key, [](const py::tuple& t) {
            return ExponentialDecay{t[0].cast<double>(), t[1].cast<double>(), t[2].cast<double>()};
        }));
}

Settings settings_from(const py::dict& given, const Kind& kind, const std::string& preset) {
    const std::vector<Parameter> parameters = kind.parameters(preset);
    Settings settings;
    for (const auto& [key, value] : given) {
        const std::string name = key_of(key);
        if (py::isinstance<py::dict>(value)) {
            for (const auto& [member, inner] : py::reinterpret_borrow<py::dict>(value)) {
                add(settings, name + "." + key_of(member), inner, kind, parameters);
            }
        } else {
            add(settings, name, value, kind, parameters);
        }
    }
    return settings;
}

py::object to_python(const Value& value) {
    return std::visit(
        [](const auto& v) -> py::object {
            using T = std::decay_t<decltype(v)>;
            if constexpr (std::is_same_v<T, Choice>) {
                return py::str(v.words.at(v.at));
            } else if constexpr (std::is_same_v<T, Schedule::Rule>) {
                if (const auto* decay = std::get_if<VisitDecay>(&v)) return py::cast(*decay);
                if (const auto* decay = std::get_if<ExponentialDecay>(&v)) return py::cast(*decay);
                return py::float_(std::get<Constant>(v).value);
            } else if constexpr (std::is_same_v<T, std::array<std::uint64_t, 2>>) {
                return py::make_tuple(v[0], v[1]);
            } else {
                return py::cast(v);
            }
        },
        value);
}

py::dict to_python(const Settings& settings) {
    py::dict all;
    for (const auto& [name, value] : settings) {
        const std::size_t dot = name.find('.');
        if (dot == std::string::npos) {
            all[py::str(name)] = to_python(value);
            continue;
        }
        const py::str group(name.substr(0, dot));
        if (!all.contains(group)) all[group] = py::dict();
        all[group][py::str(name.substr(dot + 1))] = to_python(value);
    }
    return all;
}

}  // namespace sspql::python
