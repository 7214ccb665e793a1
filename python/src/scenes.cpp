// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <pybind11/stl.h>

#include "findspace/scene.h"
#include "interruptible.h"

namespace findspace::python {

void bind_scenes(py::module_& m) {
  py::class_<Scene>(m, "Scene", R"doc(A scene file: its shapes, its world, and what it asks.

Examples
--------
>>> import findspace as fs
>>> scene = fs.Scene.json('''{"findspace": 1, "shapes": {"A": {"box": {"min": [0, 0], "max": [9, 9]}},
...     "B": {"disc": {"center": [0, 0], "radius": 1}}}, "moving": "B", "where": "inside(B, A)"}''')
>>> scene.world.solve(scene.where).area
49.0
)doc")
      .def_static(
          "file",
          [](const std::string& path, const std::optional<ReadOptions>& reading) {
            return interruptible([&] { return Scene::file(path, reading.value_or(ReadOptions())); });
          },
          py::arg("path"), py::arg("reading") = py::none(),
          "Files of shapes are looked for beside it; `reading` says what may be opened, and at what cost.")
      .def_static(
          "json",
          [](const std::string& text, const std::string& folder, const std::optional<ReadOptions>& reading) {
            return interruptible([&] { return Scene::json(text, folder, reading.value_or(ReadOptions())); });
          },
          py::arg("text"), py::arg("folder") = ".", py::arg("reading") = py::none(),
          "The text of a scene; files are looked for in the folder.")
      .def_property_readonly("shapes", &Scene::shapes, "By name.")
      .def_property_readonly(
          "world", [](const Scene& s) { return interruptible([&] { return s.world(); }); },
          "The world, with what moves.")
      .def_property_readonly("where", &Scene::where, "The formula, `true` without one.")
      .def_property_readonly("minimize", &Scene::minimize, "The objective, or ''.")
      .def_property_readonly("maximize", &Scene::maximize, "The objective, or ''.")
      .def_property_readonly("notes", &Scene::notes, "What was changed on the way: points rounded, rings reversed.")
      .def_property_readonly("text", &Scene::text, "What it was read from.")
      .def_property_readonly("folder", &Scene::folder, "Where its files are looked for.")
      .def_property_readonly("reading", &Scene::reading, "What may be opened, and at what cost.")
      .def(py::pickle([](const Scene& s) { return py::make_tuple(s.text(), s.folder(), s.reading()); },
                      [](const py::tuple& t) {
                        return Scene::json(t[0].cast<std::string>(), t[1].cast<std::string>(),
                                           t[2].cast<ReadOptions>());
                      }));
}

}  // namespace findspace::python
