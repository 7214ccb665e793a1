// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What explanations say, as values of Python.

#include <pybind11/stl.h>

#include "findspace/explanation.h"
#include "pickles.h"

namespace findspace::python {

void bind_explanation(py::module_& m) {
  py::class_<LevelChange>(m, "LevelChange", "How the level of one condition can move while all others stay.")
      .def_property_readonly(
          "kind",
          [](const LevelChange& c) {
            static const char* const kKinds[] = {"to", "none", "free", "unknown"};
            return kKinds[static_cast<int>(c.kind)];
          },
          "'to' another level; 'none' leaves room; 'free': as tight as you like; 'unknown': not decided.")
      .def_readonly("text", &LevelChange::text, "The condition.")
      .def_readonly("becomes", &LevelChange::becomes, "The condition at that level, or ''.")
      .def_readonly("to", &LevelChange::to, "The level.")
      .def_readonly("by", &LevelChange::by, "How far it moves.")
      .def_readonly("exact", &LevelChange::exact, "Whether the level is known exactly.")
      .def_readonly("lower", &LevelChange::lower, "The level is not less.")
      .def_readonly("upper", &LevelChange::upper, "The level is not more.")
      .def_readonly("reached", &LevelChange::reached, "Whether there is room at this very level.")
      .def_readonly("at", &LevelChange::at, "The last position that remains, or None.")
      .def_readonly("angle", &LevelChange::angle, "The angle there in degrees, of some or all angles; else None.")
      .def_readonly("time", &LevelChange::time, "Of the instants of a motion the last that remains; else None.")
      .def_readonly("refused", &LevelChange::refused, "Why it is not decided, or ''.")
      .def(pickled<LevelChange>(&LevelChange::kind, &LevelChange::text, &LevelChange::becomes, &LevelChange::to,
                                &LevelChange::by, &LevelChange::exact, &LevelChange::lower, &LevelChange::upper,
                                &LevelChange::reached, &LevelChange::at, &LevelChange::angle, &LevelChange::time,
                                &LevelChange::refused))
      .def("__repr__", [](const LevelChange& c) { return "<LevelChange " + c.text + ">"; });
  using Together = Explanation::Together;
  py::class_<Explanation> explanation(m, "Explanation", "Why a formula holds nowhere, or how much slack it has.");
  py::class_<Together>(explanation, "Together", "All levels move by one amount.")
      .def_readonly("lower", &Together::lower, "Less leaves no position.")
      .def_readonly("upper", &Together::upper, "So much does, or None.")
      .def_readonly("at", &Together::at, "A position for it, or None.")
      .def_readonly("angle", &Together::angle, "The angle there in degrees, of some or all angles; else None.")
      .def_readonly("time", &Together::time, "Of the instants of a motion one for it; else None.")
      .def(pickled<Together>(&Together::lower, &Together::upper, &Together::at, &Together::angle, &Together::time));
  explanation.def_readonly("feasible", &Explanation::feasible, "Whether the formula holds somewhere.")
      .def_readonly("conflict", &Explanation::conflict, "Conditions that contradict each other.")
      .def_readonly("smallest", &Explanation::smallest, "No conflict has fewer.")
      .def_readonly("relax", &Explanation::relax, "The least change of each level that leaves a position.")
      .def_readonly("slack", &Explanation::slack, "How far each level can be tightened.")
      .def_readonly("together", &Explanation::together, "All levels at once, or None.")
      .def_readonly("here", &Explanation::here, "The check at the position that was given, or None.")
      .def_readonly("change", &Explanation::change, "Conditions without which the formula holds there.")
      .def_readonly("text", &Explanation::text, "All of it in words.")
      .def_readonly("json", &Explanation::json, "As `findspace explain --json` writes it.")
      .def(pickled<Explanation>(&Explanation::feasible, &Explanation::conflict, &Explanation::smallest,
                                &Explanation::relax, &Explanation::slack, &Explanation::together, &Explanation::here,
                                &Explanation::change, &Explanation::text, &Explanation::json))
      .def("__str__", [](const Explanation& e) { return e.text; });
}

}  // namespace findspace::python
