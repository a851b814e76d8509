// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include <pybind11/pybind11.h>

#include "any_learner.hpp"

namespace sspql::python {

/// The Python object. Arrays shown to Python share the learner; load() replaces it, so that theirs stays what it was.
struct Learner {
    std::shared_ptr<AnyLearner> learner;

    AnyLearner* operator->() const { return learner.get(); }
};

using LearnerClass = pybind11::class_<Learner>;

/// None for a negative number, as AnyLearner has it for no id.
inline pybind11::object id_or_none(Number id) {
    return id < 0 ? pybind11::none() : pybind11::object(pybind11::int_(id));
}

/// Parts of the class, compiled side by side: what is an array, and what tells why.
void bind_arrays(LearnerClass& c);
void bind_explanations(pybind11::module_& m, LearnerClass& c);

}  // namespace sspql::python
