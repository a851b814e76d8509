// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <sspql/core/ids.hpp>
#include <sspql/paths/shortest_paths.hpp>

#include "any_learner.hpp"
#include "learner.hpp"
#include "model.hpp"

namespace py = pybind11;

namespace sspql::python {

namespace {

/// Read-only, without a copy; the array keeps the learner alive.
py::array q_view(const Learner& self) {
    auto* owner = new std::shared_ptr<const AnyLearner>(self.learner);
    const py::capsule base(owner, [](void* p) { delete static_cast<std::shared_ptr<const AnyLearner>*>(p); });
    const auto states = static_cast<py::ssize_t>(self->states());
    const auto actions = static_cast<py::ssize_t>(self->actions());
    py::array_t<double> view({states, actions}, self->q(), base);
    view.attr("setflags")(py::arg("write") = false);
    return std::move(view);
}

template <class T>
py::array column(const std::vector<T>& values) {
    return py::array_t<T>(static_cast<py::ssize_t>(values.size()), values.data());
}

py::tuple counts(const Learner& self) {
    const CountColumns c = count_columns(*self.learner);
    return py::make_tuple(c.whole, c.rewards, column(c.s), column(c.a), column(c.next), column(c.n), column(c.weight),
                          column(c.terminal), column(c.reward_sum));
}

py::array visits(const Learner& self) {
    return column(self->visits())
        .reshape({static_cast<py::ssize_t>(self->states()), static_cast<py::ssize_t>(self->actions())});
}

py::array policy(const Learner& self) {
    std::vector<Number> best;
    for (std::size_t s = 0; s < self->states(); ++s) best.push_back(self->best(static_cast<Number>(s)));
    return column(best);
}

py::array legal_actions(const Learner& self, Number state) {
    const std::vector<bool> mask = self->legal_actions(state);
    py::array_t<bool> array(static_cast<py::ssize_t>(mask.size()));
    for (std::size_t a = 0; a < mask.size(); ++a) array.mutable_at(a) = mask[a];
    return std::move(array);
}

py::tuple paths(const Learner& self) {
    const ShortestPathTree tree = paths_of(*self.learner);
    std::vector<Number> next;
    for (const StateId s : tree.next) next.push_back(s == no_state ? -1 : static_cast<Number>(index(s)));
    return py::make_tuple(column(tree.distance), column(next));
}

}  // namespace

void bind_arrays(LearnerClass& c) {
    c.def_property_readonly("q", &q_view,
                            "Q: a read-only array of shape (states, actions). No copy: it shows what is learnt later,\n"
                            "and stays valid without the learner. After load() take it anew.");
    c.def("visits", &visits, "How often each action was tried in each state: shape (states, actions), a copy.");
    c.def("policy", &policy, "best() of every state: an array of shape (states,), a copy.");
    c.def("legal_actions", &legal_actions, py::arg("state"),
          "The mask of `state`: an array of shape (actions,), a copy.");

    // For learners that keep counts; their classes make it public.
    c.def("_counts", &counts);
    c.def("_paths", &paths);
    c.def("_goals", [](const Learner& self) {
        py::list goals;
        for (const Goal& goal : goals_of(*self.learner)) goals.append(py::make_tuple(index(goal.state), goal.offset));
        return goals;
    });
}

}  // namespace sspql::python
