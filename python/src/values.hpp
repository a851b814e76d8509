// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <pybind11/pybind11.h>

#include "any_learner.hpp"

namespace sspql::python {

/// How Python names and gives parameters: keyword arguments, those of a member ("trust.cap") in a dict under the
/// member's name (trust={"cap": 10}).

/// Schedules, which parameters may be.
void bind_schedules(pybind11::module_& m);

/// \throws TypeError for a name the kind does not have, naming those it has, or a value of another type; ValueError for
/// a word or number that cannot be.
[[nodiscard]] Settings settings_from(const pybind11::dict& given, const Kind& kind, const std::string& preset);

[[nodiscard]] pybind11::object to_python(const Value& value);
[[nodiscard]] pybind11::dict to_python(const Settings& settings);

}  // namespace sspql::python
