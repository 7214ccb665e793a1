// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <pybind11/stl.h>

#include <algorithm>
#include <array>

#include "answers.h"
#include "findspace/board.h"
#include "findspace/scene.h"
#include "interruptible.h"
#include "numbers.h"
#include "options.h"
#include "pickles.h"

namespace findspace::python {
namespace {

std::vector<std::string> texts(const std::vector<Number>& numbers) {
  std::vector<std::string> out;
  for (const Number& n : numbers) out.push_back(n.text());
  return out;
}

/// One of a scene knows its scene and its place there: its words alone do not say it all.
py::object rotation_of(const Scene& scene, std::size_t index) {
  py::object out = py::cast(scene.free().rotations.at(index));
  out.attr("_scene") = scene;
  out.attr("_index") = index;
  return out;
}

void bind_rotation(py::module_& m) {
  py::class_<Rotation>(m, "Rotation", py::dynamic_attr(), R"doc(How a shape of space is turned.

Parameters
----------
text : str
    A quaternion "w,x,y,z"; an axis and degrees, "z:90" or "1,1,0:45"; or a matrix of nine numbers, row by row.

Examples
--------
>>> import findspace as fs
>>> fs.Rotation("z:90").matrix[0]
[0.0, -1.0, 0.0]
)doc")
      .def(py::init(&Rotation::read), py::arg("text"))
      .def_static("read", &Rotation::read, py::arg("text"), "The same.")
      .def_property_readonly("text", &Rotation::text, "The text, or the words of a scene.")
      .def_property_readonly("matrix", &Rotation::matrix, "Its rows, rounded.")
      .def_property_readonly("exact", &Rotation::exact, "Whether the angle is taken exactly.")
      .def("__repr__", [](const Rotation& r) { return "<Rotation " + r.text() + ">"; })
      .def(py::pickle([](const py::object& r) { return py::make_tuple(r.attr("text"), r.attr("__dict__")); },
                      [](const py::tuple& t) {
                        const auto of = t[1].cast<py::dict>();
                        if (!of.contains("_scene")) return std::make_pair(Rotation::read(t[0].cast<std::string>()), of);
                        const auto index = of["_index"].cast<std::size_t>();
                        return std::make_pair(of["_scene"].cast<Scene>().free().rotations.at(index), of);
                      }));
}

constexpr std::array<const char*, 5> kFreeWords{"position", "line", "angle", "time", "pose"};

std::optional<Scene::Free::Kind> free_kind(const std::optional<std::string>& word) {
  if (!word) return std::nullopt;
  const auto found = std::find(kFreeWords.begin(), kFreeWords.end(), *word);
  if (found == kFreeWords.end()) throw py::value_error("free: 'position', 'angle' or 'time'");
  return Scene::Free::Kind(found - kFreeWords.begin());
}

/// Over what the answers range, with the scene that says so.
struct FreeOf {
  Scene scene;
  Scene::Free free;
};

void bind_free(py::class_<Scene>& scene) {
  py::class_<FreeOf>(scene, "Free", "Over what the answers of a scene range.")
      .def(py::pickle([](const FreeOf& f) { return py::make_tuple(f.scene); },
                      [](const py::tuple& t) {
                        const auto of = t[0].cast<Scene>();
                        return FreeOf{of, of.free()};
                      }))
      .def_property_readonly(
          "kind", [](const FreeOf& f) { return kFreeWords[std::size_t(f.free.kind)]; },
          "'position', 'line', 'angle', 'time' or 'pose'.")
      .def_property_readonly(
          "through", [](const FreeOf& f) { return texts(f.free.through); }, "Of a line: a point of it.")
      .def_property_readonly(
          "direction", [](const FreeOf& f) { return texts(f.free.direction); }, "Of a line: integers.")
      .def_property_readonly(
          "about", [](const FreeOf& f) { return texts(f.free.about); },
          "Of angles and poses: the point that it turns about.")
      .def_property_readonly(
          "angles", [](const FreeOf& f) { return texts(f.free.angles); }, "Of poses of the plane, in degrees.")
      .def_property_readonly(
          "rotations",
          [](const FreeOf& f) {
            py::list out;
            for (std::size_t k = 0; k < f.free.rotations.size(); ++k) out.append(rotation_of(f.scene, k));
            return out;
          },
          "Of poses of space.");
}

/// A scene as a pickle has it: what it was read from, and what was changed since then.
py::tuple state_of(const Scene& s) {
  py::list changes;
  for (const Scene::Change& change : s.changes()) {
    if (change.rotation) {
      changes.append(py::make_tuple("rotation", change.rotation->text()));
    } else if (change.degrees) {
      changes.append(py::make_tuple("degrees", change.degrees->text()));
    } else {
      const Scene::Question& q = *change.question;
      const auto free = q.free ? std::optional(int(*q.free)) : std::nullopt;
      changes.append(py::make_tuple(q.where, q.minimize, q.maximize, q.before, q.moving, free));
    }
  }
  Options limits = s.options();
  limits.progress = nullptr;  // few functions pickle
  if (const auto board = s.board()) {
    const BoardQuestion q = *s.board_question();
    const py::tuple question =
        py::make_tuple(q.move, q.where, q.minimize, q.maximize, q.before, q.place, texts(q.angles));
    return py::make_tuple(*board, question, changes, limits, s.is_prepared());
  }
  return py::make_tuple(s.text(), s.folder(), s.reading(), s.name(), changes, limits, s.is_prepared());
}

/// The scene without what was changed since it was read.
Scene read_again(const py::tuple& t) {
  if (t.size() == 7)
    return Scene::json(t[0].cast<std::string>(), t[1].cast<std::string>(), t[2].cast<ReadOptions>(),
                       t[3].cast<std::string>());
  const auto q = t[1].cast<py::tuple>();
  BoardQuestion question{q[0].cast<std::vector<std::string>>(),
                         q[1].cast<std::string>(),
                         q[2].cast<std::string>(),
                         q[3].cast<std::string>(),
                         q[4].cast<std::string>(),
                         q[5].cast<bool>(),
                         {}};
  for (const py::handle angle : q[6]) question.angles.push_back(number(angle));
  return t[0].cast<Board>().scene(question);
}

/// One of the scene's by its words, or another one.
Rotation rotation_named(const Scene& scene, const std::string& text) {
  for (const Rotation& r : scene.free().rotations)
    if (r.text() == text) return r;
  return Rotation::read(text);
}

Scene scene_of(const py::tuple& t) {
  Scene out = read_again(t);
  using Text = std::optional<std::string>;
  for (const py::handle each : t[t.size() - 3]) {
    const auto c = each.cast<py::tuple>();
    if (c.size() != 2) {
      const auto free = c[5].cast<std::optional<int>>();
      out = out.asking({c[0].cast<Text>(), c[1].cast<Text>(), c[2].cast<Text>(), c[3].cast<std::string>(),
                        c[4].cast<std::optional<std::vector<std::string>>>(),
                        free ? std::optional(Scene::Free::Kind(*free)) : std::nullopt});
    } else if (c[0].cast<std::string>() == "degrees") {
      out = out.rotated(Number(c[1].cast<std::string>()));
    } else {
      out = out.rotated(rotation_named(out, c[1].cast<std::string>()));
    }
  }
  out = out.with(t[t.size() - 2].cast<Options>());
  return t[t.size() - 1].cast<bool>() ? out.prepared() : out;
}

}  // namespace

void bind_scenes(py::module_& m) {
  bind_answer(m);
  bind_rotation(m);
  py::class_<Scene> scene(m, "Scene", R"doc(A scene file: its shapes, its world, what it asks, and the answers.

Examples
--------
>>> import findspace as fs
>>> scene = fs.Scene.json('''{"findspace": 1, "shapes": {"A": {"box": {"min": [0, 0], "max": [9, 9]}},
...     "B": {"disc": {"center": [0, 0], "radius": 1}}}, "moving": "B", "where": "inside(B, A)"}''')
>>> scene.world.solve(scene.where).area
49.0
>>> answer = scene.check((0, 5))
>>> answer.found, answer.nearest
('no', ((1.0, 5.0), 1.0, True))
)doc");
  bind_free(scene);
  scene
      .def_static(
          "file",
          [](const std::string& path, const std::optional<ReadOptions>& reading) {
            return interruptible([&] { return Scene::file(path, reading.value_or(ReadOptions())); });
          },
          py::arg("path"), py::arg("reading") = py::none(),
          "Files of shapes are looked for beside it; `reading` says what may be opened, and at what cost.")
      .def_static(
          "json",
          [](const std::string& text, const std::string& folder, const std::optional<ReadOptions>& reading,
             const std::string& name) {
            return interruptible([&] { return Scene::json(text, folder, reading.value_or(ReadOptions()), name); });
          },
          py::arg("text"), py::arg("folder") = ".", py::arg("reading") = py::none(), py::arg("name") = "scene",
          "The text of a scene; files are looked for in the folder. Messages call it by the name.")
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
      .def("shape", &Scene::shape, py::arg("name"), "One of them.")
      .def_property_readonly("groups", &Scene::groups, "Names of shapes by the name of a group.")
      .def_property_readonly("board", &Scene::board, "The Board that it is a scene of, or None.")
      .def_property_readonly("names", &Scene::names, "Names of its shapes in the order of the file.")
      .def_property_readonly("dimension", &Scene::dimension, "2 or 3.")
      .def_property_readonly("unit", &Scene::unit, "Of lengths, or ''.")
      .def_property_readonly("asks", &Scene::asks, "Whether it has a \"where\".")
      .def_property_readonly("used", &Scene::used, "Names of the shapes that the formula speaks of, sorted.")
      .def_property_readonly(
          "grid", [](const Scene& s) { return s.grid().step.text(); },
          "The step of the grid of its coordinates, as text.")
      .def_property_readonly("y_down", &Scene::y_down, "Whether y runs downwards in pictures.")
      .def_property_readonly(
          "clockwise", &Scene::clockwise,
          "Whether its angles count clockwise as pictures show them: where y runs downwards, but not "
          "on a board.")
      .def_property_readonly("moving", &Scene::moving, "What moves, together.")
      .def_property_readonly("name", &Scene::name, "As messages call it.")
      .def_property_readonly(
          "free",
          [](const Scene& s) {
            return FreeOf{s, s.free()};
          },
          "Over what its answers range.")
      .def(
          "asking",
          [](const Scene& s, const std::optional<std::string>& where, const std::optional<std::string>& minimize,
             const std::optional<std::string>& maximize, const std::string& before,
             const std::optional<std::vector<std::string>>& moving, const std::optional<std::string>& free) {
            return s.asking({where, minimize, maximize, before, moving, free_kind(free)});
          },
          py::arg("where") = py::none(), py::arg("minimize") = py::none(), py::arg("maximize") = py::none(),
          py::kw_only(), py::arg("before") = "", py::arg("moving") = py::none(), py::arg("free") = py::none(),
          "The same scene with another question, other moving shapes, or over 'position', or 'angle' or 'time' at a "
          "position; `before` stands before the words of the question in messages.")
      .def(
          "rotated", [](const Scene& s, const Rotation& r) { return interruptible([&] { return s.rotated(r); }); },
          py::arg("rotation"),
          "Of space: what moves is turned about the scene's \"about\"; notes say what was rounded.")
      .def(
          "rotated", [](const Scene& s, const py::object& degrees) { return s.rotated(number(degrees)); },
          py::arg("degrees"),
          "Of the plane: the same by an angle, counter-clockwise; where y runs downwards as `clockwise` says.")
      .def("prepared", &Scene::prepared, R"doc(The same scene, which keeps what it makes for one question for the next.

That are its shapes as sets, the region of its formula and tables to look positions up in. So do the scenes that it
becomes by `asking` and `rotated`. For many questions, one after another; it takes the memory of it.

Examples
--------
>>> import findspace as fs
>>> scene = fs.Scene.json('{"findspace": 1, "shapes": {"A": {"box": {"min": [0, 0], "max": [9, 9]}}, '
...     '"B": {"box": {"min": [0, 0], "max": [2, 1]}}}, "moving": "B", "where": "inside(B, A)"}').prepared()
>>> scene.check((7.2, 7.9), snap=0.5).at
(7.0, 8.0)
>>> [scene.check((x, 3), nearest=False).found for x in (6, 7, 8)]
['yes', 'yes', 'no']
)doc")
      .def_property_readonly("is_prepared", &Scene::is_prepared, "Whether it keeps what it makes.")
      .def("edited_text", &Scene::edited_text,
           "Its text with what `asking` has changed; all else stays as it was written, comments too.")
      .def_property_readonly(
          "options", [](const Scene& s) { return s.options(); }, "The limits of its questions, a copy.")
      .def(
          "limited",
          [](const Scene& s, const std::optional<Options>& options, const py::kwargs& words) {
            return s.with(options_of(options, words));
          },
          py::arg("options") = py::none(), "The same scene with other limits: an Options, or its words.")
      .def(
          "require",
          [](const Scene& s, const std::optional<py::sequence>& at, const py::object& degrees, const py::object& time) {
            s.require(pose_of(at, degrees, time));
          },
          py::arg("at") = py::none(), py::arg("degrees") = py::none(), py::arg("time") = py::none(),
          "Refuses a pose as the questions do, without asking one.")
      .def(
          "check",
          [](const Scene& s, const std::optional<py::sequence>& at, const py::object& degrees, const py::object& time,
             bool nearest,
             const py::object& snap) { return answered(s, "check", py::make_tuple(at, degrees, time, nearest, snap)); },
          py::arg("at") = py::none(), py::arg("degrees") = py::none(), py::arg("time") = py::none(), py::kw_only(),
          py::arg("nearest") = true, py::arg("snap") = py::none(),
          R"doc(Whether the formula holds at a pose, and the nearest feasible position where it does not.

Parameters
----------
at : sequence of numbers, optional
    The position; (0, 0) without it.
degrees : number, optional
    Of the plane: what moves is turned by so much first.
time : number, optional
    An instant of the motion; over all its time without it.
nearest : bool
    The nearest feasible position too, where the position is none.
snap : number, optional
    Where a corner of the region, an edge of it, or in space the nearest feasible position is no farther, the answer is
    about that one, exactly.
)doc")
      .def(
          "nearest",
          [](const Scene& s, const std::optional<py::sequence>& at, const py::object& time) {
            return answered(s, "nearest", py::make_tuple(at, py::none(), time));
          },
          py::arg("at") = py::none(), py::arg("time") = py::none(),
          "The feasible position that is nearest to one, which may be feasible itself.")
      .def(
          "between",
          [](const Scene& s, const py::sequence& first, const py::sequence& second,
             const std::optional<py::sequence>& at) {
            return answered(s, "between", py::make_tuple(at, py::none(), py::none(), first, second));
          },
          py::arg("first"), py::arg("second"), py::arg("at") = py::none(),
          R"doc(Of the plane: the distance between two vertices, edges or arcs of shapes: those nearest to two places.

Parameters
----------
first, second : sequences of two numbers
    The places; a vertex is taken where one is about as near.
at : sequence of numbers, optional
    Where what moves stands.

Examples
--------
>>> import findspace as fs
>>> scene = fs.Scene.json('{"findspace": 1, "shapes": {"A": {"box": {"min": [0, 0], "max": [9, 9]}}, '
...     '"B": {"disc": {"center": [0, 0], "radius": 1}}}, "moving": "B"}')
>>> value = scene.between((9, 5), (14, 5), at=(15, 5)).measured[0].value
>>> value.value, [f.kind for f in value.features], value.points
(5.0, ['edge', 'arc'], [[9.0, 5.0], [14.0, 5.0]])
)doc")
      .def(
          "measure",
          [](const Scene& s, const std::optional<py::sequence>& at, const py::object& degrees, const py::object& time,
             const std::vector<std::string>& words) {
            return answered(s, "measure", py::make_tuple(at, degrees, time, words));
          },
          py::arg("at") = py::none(), py::arg("degrees") = py::none(), py::arg("time") = py::none(),
          py::arg("words") = std::vector<std::string>(),
          "Distances of what moves to the other shapes at a pose; `words`: which, none: all.")
      .def(
          "map",
          [](const Scene& s, const std::optional<py::sequence>& at, const std::string& apply, bool pictures,
             bool surface, const std::string& before, int lines, const py::object& apart, const std::string& axis,
             const std::string& side, int resolution) {
            return answered(s, "map",
                            py::make_tuple(at, apply, pictures, surface, before,
                                           py::make_tuple(lines, apart, axis, side), resolution));
          },
          py::arg("at") = py::none(), py::arg("apply") = "", py::kw_only(), py::arg("pictures") = true,
          py::arg("surface") = false, py::arg("before") = "", py::arg("lines") = 0, py::arg("apart") = py::none(),
          py::arg("axis") = "z", py::arg("side") = "", py::arg("resolution") = 0,
          R"doc(Where the formula holds, or is best, among all that is free.

In space positions are given where they are made of boxes or are a convex polytope, exactly, with open and closed ends,
else on many lines; of several orientations each is asked alone (`rotated`). Lengths are in the scene's unit.

Parameters
----------
at : sequence of numbers, optional
    The position of a map of angles or of instants.
apply : str
    What is made of a region: 'interior', 'closure', 'boundary', 'regularize', 'complement', or nothing.
pictures : bool
    The answer may be drawn; else it takes less memory.
surface : bool
    Of space: it is wanted with flat faces, which a polytope grown by a ball has not.
before : str
    What messages put before "apply".
lines : int
    Of space: on so many lines each way, from 1 to 16384.
apart : number, optional
    Or on lines so far apart, a multiple of the grid's step.
axis : str
    Along which they run: 'x', 'y', 'z', or 'xyz' for all three.
side : str
    Of cells about the lines: 'inner', those that certainly belong; 'outer', those that certainly hold all.
resolution : int
    Of space, where there is no exact form: lines each way of each axis; 0: 128.

Examples
--------
>>> import findspace as fs
>>> scene = fs.Scene.json('{"findspace": 1, "shapes": {"A": {"box": {"min": [0, 0], "max": [9, 9]}}, '
...     '"B": {"box": {"min": [0, 0], "max": [2, 1]}}}, "moving": "B", "where": "inside(B, A)"}')
>>> answer = scene.map()
>>> answer.found, answer.region[0].area
('yes', 56.0)
>>> scene = fs.Scene.json('{"findspace": 1, "shapes": {"A": {"box": {"min": [0, 0, 0], "max": [9, 9, 9]}}, '
...     '"B": {"box": {"min": [0, 0, 0], "max": [2, 1, 1]}}}, "moving": "B", "where": "inside(B, A)"}')
>>> region = scene.map().space_region
>>> region.volume, region.boxes
(448.0, [([0.0, 0.0, 0.0], [7.0, 8.0, 8.0], [True, True, True], [True, True, True])])
)doc")
      .def(
          "explain",
          [](const Scene& s, const std::optional<py::sequence>& at, const py::object& degrees) {
            return answered(s, "explain", py::make_tuple(at, degrees, py::none()));
          },
          py::arg("at") = py::none(), py::arg("degrees") = py::none(),
          "Why the formula holds nowhere, or how far its levels can be tightened; and what is in the way at a "
          "position.")
      .def(
          "describe",
          [](const Scene& s, const std::string& shape, bool surface, const std::string& before, int lines,
             const py::object& apart, const std::string& axis, const std::string& side) {
            return answered(s, "describe",
                            py::make_tuple(shape, surface, before, py::make_tuple(lines, apart, axis, side)));
          },
          py::arg("shape"), py::kw_only(), py::arg("surface") = false, py::arg("before") = "", py::arg("lines") = 0,
          py::arg("apart") = py::none(), py::arg("axis") = "z", py::arg("side") = "",
          R"doc(A shape as a point set: in the plane exactly, in space where it is made of boxes or is one convex set.

Parameters
----------
shape : str
    Its name.
surface : bool
    Of space: it is wanted with flat faces, which a polytope grown by a ball has not.
before, lines, apart, axis, side
    Of space, as in `map`.

Examples
--------
>>> import findspace as fs
>>> scene = fs.Scene.json('{"findspace": 1, "shapes": {"A": {"box": {"min": [0, 0, 0], "max": [9, 9, 9]}}, '
...     '"B": {"ball": {"center": [0, 0, 0], "radius": 2}}}}')
>>> scene.describe("A").found, scene.describe("B", lines=16).sampled
('yes', True)
)doc")
      .def_property_readonly("places", &Scene::places, "Whether it says what to place.")
      .def(
          "place",
          [](const Scene& s, const py::iterable& near, int lines) {
            return answered(s, "place", py::make_tuple(py::tuple(near), lines));
          },
          py::arg("near") = py::tuple(), py::arg("lines") = 0,
          R"doc(The placement that the scene asks for in "place".

Parameters
----------
near : iterable of tuples
    Bodies that come first, each as near to its place as it goes: (name, at), (name, at, degrees), or
    (name, at, degrees, copy) with None for any angle.
lines : int
    Of space: each way, where positions are taken on lines; 0: as usual.

Examples
--------
>>> import findspace as fs
>>> scene = fs.Scene.json('{"findspace": 1, "shapes": {"A": {"box": {"min": [0, 0], "max": [9, 9]}}, '
...     '"B": {"box": {"min": [0, 0], "max": [2, 1]}}}, "place": {"shapes": ["B"], "each": "inside(self, A)", '
...     '"minimize": ["x", "y"]}}')
>>> answer = scene.place()
>>> answer.found, answer.placement.placed
('yes', [<B at [0.0, 0.0]>])
>>> scene.place(near=[("B", (20, 3))]).placement.placed
[<B at [7.0, 3.0]>]
)doc")
      .def(py::pickle(&state_of, &scene_of));
}

}  // namespace findspace::python
