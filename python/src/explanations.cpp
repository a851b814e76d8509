// SPDX-License-Identifier: MIT
#include <cstddef>
#include <functional>
#include <string>

#include <pybind11/pybind11.h>

#include <sspql/core/ids.hpp>
#include <sspql/io/explain.hpp>
#include <sspql/learn/transition.hpp>

#include "any_learner.hpp"
#include "learner.hpp"
#include "model.hpp"

namespace py = pybind11;

namespace sspql::python {

namespace {

template <class Id>
py::object to_python(Id id, Id none) {
    return id == none ? py::none() : py::object(py::int_(index(id)));
}

/// A function of ids from what Python gave: a function, a list of words, or None for numbers.
template <class Id>
std::function<std::string(Id)> words(const py::object& given) {
    if (given.is_none()) return {};
    if (PyCallable_Check(given.ptr()) != 0) {
        return [given](Id id) { return std::string(py::str(given(index(id)))); };
    }
    return [given](Id id) { return std::string(py::str(py::object(given[py::int_(index(id))]))); };
}

std::string table(const Explanation& why) {
    std::string text = to_text(why);
    while (!text.empty() && text.back() == '\n') text.pop_back();
    return text;
}

void bind_terms(py::module_& m) {
    py::class_<ActionTerms> c(m, "ActionTerms", "Why an action is chosen: the terms of its score.");
    c.attr("__module__") = "sspql";
    c.def_readonly("q", &ActionTerms::q, "what Q contributes")
        .def_readonly("ssp", &ActionTerms::ssp, "what the shortest path contributes")
        .def_readonly("exploration", &ActionTerms::exploration, "the bonus for what was seldom tried")
        .def_readonly("hint", &ActionTerms::hint, "what is left of a trainer's hint")
        .def_readonly("n", &ActionTerms::n, "how often the action was tried here")
        .def("sum", &ActionTerms::sum, "The score: all four together.")
        .def("__repr__", [](const ActionTerms& t) {
            return std::string(py::str("ActionTerms(q={:.6g}, ssp={:.6g}, exploration={:.6g}, hint={:.6g}, n={:g})")
                                   .format(t.q, t.ssp, t.exploration, t.hint, t.n));
        });
}

void bind_explanation(py::module_& m) {
    py::class_<Explanation> c(m, "Explanation",
                              "Why a learner does what it does in a state. print() shows a table; the members are its "
                              "numbers.");
    c.attr("__module__") = "sspql";
    c.def_property_readonly(
         "state", [](const Explanation& why) { return index(why.state); }, "the state")
        .def_property_readonly(
            "chosen", [](const Explanation& why) { return to_python(why.chosen, no_action); },
            "what the running episode does here now; None if it is elsewhere")
        .def_property_readonly(
            "leading", [](const Explanation& why) { return index(why.leading); },
            "the legal action with the greatest sum of terms")
        .def_property_readonly(
            "best", [](const Explanation& why) { return index(why.best); }, "what best() answers")
        .def_readonly("distance", &Explanation::distance,
                      "to the goal, in expected steps (Sspql: in costs); infinite where no way is known")
        .def_property_readonly(
            "next", [](const Explanation& why) { return to_python(why.next, no_state); },
            "the next state on the way to the goal; None if there is none")
        .def_property_readonly(
            "path",
            [](const Explanation& why) {
                py::list path;
                for (const PathStep& step : why.path) {
                    path.append(py::make_tuple(index(step.state), to_python(step.action, no_action)));
                }
                return path;
            },
            "the way to the goal: pairs (state, action), the first ones and the last")
        .def("__str__", &table)
        .def("__repr__", &table);
}

}  // namespace

void bind_explanations(py::module_& m, LearnerClass& c) {
    bind_terms(m);
    bind_explanation(m);
    c.def(
        "terms", [](const Learner& self, Number state, Number action) { return self->terms(state, action); },
        py::arg("state"), py::arg("action"), "Why: what the action's score is made of.");
    c.def(
        "explain",
        [](const Learner& self, Number state, const py::object& states, const py::object& actions, std::size_t most) {
            ExplainOptions options;
            options.state = words<StateId>(states);
            options.action = words<ActionId>(actions);
            options.most_states = most;
            return explanation_of(*self.learner, state, options);
        },
        py::arg("state"), py::arg("states") = py::none(), py::arg("actions") = py::none(), py::arg("most_states") = 8,
        "Why it does what it does in `state`: print(learner.explain(state)) shows a table of its actions, and the way "
        "to\n"
        "the goal. `states` and `actions` are their words: a list, or a function of the number. At most `most_states`\n"
        "states of the way are listed.");
}

}  // namespace sspql::python
