// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <pybind11/pybind11.h>

#include <sspql/core/errors.hpp>
#include <sspql/core/ids.hpp>
#include <sspql/core/version.hpp>

#include "any_learner.hpp"
#include "checkpoint_files.hpp"
#include "learner.hpp"
#include "values.hpp"

namespace py = pybind11;

namespace sspql::python {

namespace {

const std::vector<Kind>& kinds() {
    static const std::vector<Kind> all{adaptive_sspql(), sspql_of_the_paper(),   q_learning(), sarsa(), dyna_q(),
                                       dyna_q_plus(),    prioritized_sweeping(), rtdp(),       r_max()};
    return all;
}

const Kind* find(const std::string& text, std::string Kind::*member) {
    const auto found = std::find_if(kinds().begin(), kinds().end(), [&](const Kind& k) { return k.*member == text; });
    return found == kinds().end() ? nullptr : &*found;
}

const Kind& kind_named(const std::string& name) {
    const Kind* kind = find(name, &Kind::name);
    if (kind == nullptr) throw_invalid("kind", "be the name of a learner", name);
    return *kind;
}

const Kind& kind_of(const CheckpointType& type, const std::string& name) {
    const Kind* kind = find(type.type_name, &Kind::type_name);
    if (kind == nullptr) throw std::runtime_error("checkpoint " + name + ": holds a learner that Python does not have");
    return *kind;
}

Learner make(const std::string& kind_name, Number states, Number actions, std::uint64_t seed, const std::string& preset,
             const py::dict& parameters) {
    const Kind& kind = kind_named(kind_name);
    return {kind.make(states, actions, preset, settings_from(parameters, kind, preset), seed)};
}

Learner restore(const std::string& bytes, const std::string& name) {
    const CheckpointType type = checkpoint_type(bytes, name);
    return {kind_of(type, name)
                .make(static_cast<Number>(type.states), static_cast<Number>(type.actions), "", {}, 0)
                ->from_bytes(bytes, name)};
}

void set_goals(const Learner& self, const py::iterable& goals) {
    std::vector<std::pair<Number, double>> list;
    for (const py::handle goal : goals) {
        try {
            if (py::isinstance<py::tuple>(goal) && py::len(goal) == 2) {
                const auto pair = py::reinterpret_borrow<py::tuple>(goal);
                list.emplace_back(pair[0].cast<Number>(), pair[1].cast<double>());
            } else {
                list.emplace_back(goal.cast<Number>(), 0.0);
            }
        } catch (const py::cast_error&) {
            throw py::type_error("a goal must be a state or a pair (state, offset), got " +
                                 std::string(py::repr(goal)));
        }
    }
    self->set_goals(list);
}

void set_legal_actions(const Learner& self, Number state, const py::iterable& mask) {
    std::vector<bool> bits;
    for (const py::handle bit : mask) {
        const bool on = bit.equal(py::bool_(true));
        if (!on && !bit.equal(py::bool_(false))) {
            throw py::value_error("a mask must hold True or False (1 or 0) for each action, got " +
                                  std::string(py::repr(bit)));
        }
        bits.push_back(on);
    }
    self->set_legal_actions(state, bits);
}

void bind_learner(py::module_& m) {
    LearnerClass c(m, "Learner", "What all learners share; the classes of sspql derive from it.");
    c.attr("__module__") = "sspql";
    c.def(py::init(&make), py::arg("kind"), py::arg("states"), py::arg("actions"), py::arg("seed"), py::arg("preset"),
          py::arg("parameters"));
    c.def(py::init([](const py::bytes& bytes, const std::string& name) { return restore(bytes, name); }),
          py::arg("checkpoint"), py::arg("name"));
    c.def(py::init([](const Learner& other) { return Learner{other->copy()}; }), py::arg("other"));

    c.def(
        "begin", [](const Learner& self, Number state) { return self->begin(state); }, py::arg("state"),
        "Starts an episode in `state`; returns the first action.");
    c.def(
        "step",
        [](const Learner& self, double reward, Number state, double weight) {
            return self->step(reward, state, weight);
        },
        py::arg("reward"), py::arg("state"), py::arg("weight") = 1.0,
        "The chosen action brought `reward` and led to `state`, at the cost of `weight`: learns, returns the next "
        "action.");
    c.def(
        "end",
        [](const Learner& self, double reward, Number state, bool terminated, double weight) {
            self->end(reward, state, terminated, weight);
        },
        py::arg("reward"), py::arg("state"), py::arg("terminated"), py::arg("weight") = 1.0,
        "The same for an episode's last action. `terminated`: the task ended; False: somebody cut it short.");
    c.def(
        "abort", [](const Learner& self) { self->abort(); },
        "Drops the running episode, and the action whose outcome nobody will tell. What was learnt stays.");
    c.def(
        "replace_action", [](const Learner& self, Number action) { self->replace_action(action); }, py::arg("action"),
        "Not the chosen action but `action` is being carried out; the next step() or end() reports its outcome.");
    c.def(
        "observe",
        [](const Learner& self, Number state, Number action, double reward, Number next, bool terminated,
           double weight) { self->observe(state, action, reward, next, terminated, weight); },
        py::arg("state"), py::arg("action"), py::arg("reward"), py::arg("next"), py::arg("terminated"),
        py::arg("weight") = 1.0, "Learns from a step that somebody else took: a log, a teacher.");
    c.def(
        "teach",
        [](const Learner& self, Number state, Number action, double strength) { self->teach(state, action, strength); },
        py::arg("state"), py::arg("action"), py::arg("strength") = 1.0,
        "A trainer's hint: here, this action. It fades with the tries; negative warns, 0 takes it back.");
    c.def(
        "demonstrate",
        [](const Learner& self, Number state, Number action, double reward, Number next, bool terminated, double weight,
           double strength) { self->demonstrate(state, action, reward, next, terminated, weight, strength); },
        py::arg("state"), py::arg("action"), py::arg("reward"), py::arg("next"), py::arg("terminated"),
        py::arg("weight") = 1.0, py::arg("strength") = 1.0, "observe(), and a hint to do the same.");
    c.def(
        "best", [](const Learner& self, Number state) { return self->best(state); }, py::arg("state"),
        "The best action known in `state`: no exploration, nothing learnt.");
    c.def("set_goals", &set_goals, py::arg("goals"),
          "Other goals from now on: states, or pairs (state, offset), the offset being the cost still to pay there.\n"
          "What was learnt about the world stays. An empty list goes back to goals discovered by rewards.");
    c.def("set_legal_actions", &set_legal_actions, py::arg("state"), py::arg("mask"),
          "Which actions `state` has: True or False (1 or 0) for each. The last mask of each state holds.");
    c.def_property_readonly(
        "states", [](const Learner& self) { return self->states(); }, "The number of states.");
    c.def_property_readonly(
        "actions", [](const Learner& self) { return self->actions(); }, "The number of actions.");
    c.def_property_readonly(
        "running", [](const Learner& self) { return self->running(); }, "Whether an episode is under way.");
    c.def_property_readonly(
        "state", [](const Learner& self) { return id_or_none(self->state()); },
        "Where the running episode's last action was chosen; None between episodes.");
    c.def_property_readonly(
        "action", [](const Learner& self) { return id_or_none(self->action()); },
        "The running episode's last action; None between episodes.");
    c.def_property_readonly(
        "parameters", [](const Learner& self) { return to_python(self->parameters()); },
        "The parameters it works with, by name: a new dict.");

    c.def(
        "save", [](const Learner& self, const py::object& path) { write_file(path, self->to_bytes()); },
        py::arg("path"), "Writes a checkpoint, which C++ reads too. The file is replaced whole or not at all.");
    c.def(
        "load",
        [](Learner& self, const py::object& path) {
            self.learner = self->from_bytes(read_file(path), path_text(path));
        },
        py::arg("path"),
        "Makes the learner what it was when the checkpoint was saved, parameters included. It must be of the same\n"
        "kind and size. If this raises, nothing has changed.");
    c.def(
        "to_bytes", [](const Learner& self) { return py::bytes(self->to_bytes()); }, "The bytes save() would write.");

    // What only some have; their classes make it public.
    c.def("_status", [](const Learner& self) {
        py::dict status;
        for (const auto& [name, value] : self->status()) status[py::str(name)] = value;
        return status;
    });
    c.def("_update_paths", [](const Learner& self) { self->update_paths(); });
    bind_arrays(c);
    bind_explanations(m, c);
}

}  // namespace

}  // namespace sspql::python

PYBIND11_MODULE(_core, m) {
    using namespace sspql::python;
    m.doc() = "The compiled part of sspql.";
    m.attr("__version__") = std::to_string(SSPQL_VERSION_MAJOR) + "." + std::to_string(SSPQL_VERSION_MINOR) + "." +
                            std::to_string(SSPQL_VERSION_PATCH);
    bind_schedules(m);
    bind_learner(m);
    m.def(
        "parameters",
        [](const std::string& kind, const std::string& preset) {
            py::list list;
            for (const Parameter& p : kind_named(kind).parameters(preset)) {
                list.append(py::make_tuple(p.name, to_python(p.value), p.help));
            }
            return list;
        },
        py::arg("kind"), py::arg("preset") = "");
    m.def("presets", [](const std::string& kind) {
        py::list list;
        for (const std::string& name : kind_named(kind).presets) list.append(name);
        return list;
    });
    m.def("kind_of", [](const py::bytes& bytes, const std::string& name) {
        const std::string text = bytes;
        return kind_of(checkpoint_type(text, name), name).name;
    });
    m.def("read_file", [](const py::object& path) { return py::bytes(read_file(path)); });
    m.def("path_text", &path_text);
}
