// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Packing of solids in Python, in the words of the plane.

#include "findspace/solid_packing.h"

#include <pybind11/functional.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "arrays.h"
#include "interruptible.h"
#include "numbers.h"
#include "options.h"
#include "packing.h"
#include "packings.h"
#include "pickles.h"

namespace findspace::python {
namespace solids {
namespace {

Orientation orientation_of(const py::sequence& rows) {
  if (py::len(rows) != 3) throw py::value_error("an orientation has three rows");
  Orientation result;
  for (std::size_t r = 0; r < 3; ++r) {
    const auto row = rows[r].cast<py::sequence>();
    if (py::len(row) != 3) throw py::value_error("a row of an orientation has three numbers");
    for (std::size_t c = 0; c < 3; ++c) result.rows[r][c] = number(row[c]);
  }
  return result;
}

py::tuple rows_of(const Orientation& o) {
  py::list rows;
  for (const auto& row : o.rows) rows.append(py::make_tuple(row[0].text(), row[1].text(), row[2].text()));
  return py::tuple(rows);
}

py::tuple shown_point(const Point3& p) { return py::make_tuple(p.x.text(), p.y.text(), p.z.text()); }

/// "right-angles", "upright", or a list of Orientation.
std::vector<Orientation> orientations_of(const py::object& allowed) {
  const char* const meant = "orientations are 'right-angles', 'upright' or a list of Orientation";
  if (py::isinstance<py::str>(allowed)) {
    const auto word = allowed.cast<std::string>();
    if (word == "right-angles") return Orientation::right_angles();
    if (word == "upright") return Orientation::upright();
    throw py::value_error(meant);
  }
  try {
    return allowed.cast<std::vector<Orientation>>();
  } catch (const py::cast_error&) {
    throw py::type_error(meant);
  }
}

PackContainer container_of(std::string name, const std::optional<py::sequence>& size, int count, const py::object& cost,
                           const std::optional<Shape>& shape) {
  PackContainer result{std::move(name), 0, 0, 0, count, amount(cost), shape};
  if (!size) return result;
  if (PyUnicode_Check(size->ptr()) || py::len(*size) != 3) throw py::value_error("a size is (x, y, z)");
  const Point3 sides = point3(*size);
  result.width = sides.x;
  result.depth = sides.y;
  result.height = sides.z;
  return result;
}

/// p goes to M p, in doubles, with a fourth coordinate of 1.
Array matrix_of(const PlacedSolid& p) {
  const py::object fraction = py::module_::import("fractions").attr("Fraction");
  const auto value = [&](const Number& n) { return py::float_(fraction(n.text())).cast<double>(); };
  const Number* at[] = {&p.at.x, &p.at.y, &p.at.z};
  Array out({py::ssize_t(4), py::ssize_t(4)});
  for (py::ssize_t r = 0; r < 3; ++r) {
    for (py::ssize_t c = 0; c < 3; ++c)
      out.mutable_at(r, c) = value(p.orientation.rows[std::size_t(r)][std::size_t(c)]);
    out.mutable_at(r, 3) = value(*at[r]);
    out.mutable_at(3, r) = 0;
  }
  out.mutable_at(3, 3) = 1;
  return out;
}

SolidPackProblem problem_of(std::vector<PackSolid> parts, const py::object& floor,
                            std::vector<PackContainer> containers, const py::object& gap, const py::object& edge,
                            std::string name, const std::vector<NamedGap>& gaps,
                            const std::vector<NamedCondition>& conditions, const std::optional<Formula>& where,
                            std::vector<PackGroup> groups, std::vector<FixedSolid> fixed) {
  SolidPackProblem problem;
  problem.name = std::move(name);
  if (!floor.is_none()) {
    const Point sides = point(floor);
    problem.width = sides.x;
    problem.depth = sides.y;
  }
  problem.containers = std::move(containers);
  problem.parts = std::move(parts);
  problem.gap = number(gap);
  problem.edge = number(edge);
  set_conditions(problem, gaps, conditions, where, std::move(groups));
  problem.fixed = std::move(fixed);
  return problem;
}

py::tuple packed_problem(const SolidPackProblem& p) {
  return py::make_tuple(p.parts, py::make_tuple(p.width.text(), p.depth.text()), p.containers, packed(p.gap),
                        packed(p.edge), p.name, named(p.gaps), named(p.conditions), where_of(p), p.groups, p.fixed);
}

SolidPackProblem unpacked_problem(const py::tuple& t) {
  return problem_of(t[0].cast<std::vector<PackSolid>>(), t[1], t[2].cast<std::vector<PackContainer>>(), t[3], t[4],
                    t[5].cast<std::string>(), t[6].cast<std::vector<NamedGap>>(),
                    t[7].cast<std::vector<NamedCondition>>(), t[8].cast<std::optional<Formula>>(),
                    t[9].cast<std::vector<PackGroup>>(), t[10].cast<std::vector<FixedSolid>>());
}

void bind_orientation(py::module_& m) {
  py::class_<Orientation>(m, "Orientation", R"doc(How a solid stands: its point q goes to the rows times q, exactly.

Parameters
----------
rows : sequence of three rows of three numbers
    Of a rotation; a number may be text of a fraction, "3/5".

Examples
--------
>>> import findspace as fs
>>> fs.Orientation.about("z", 90).rows
(('0', '-1', '0'), ('1', '0', '0'), ('0', '0', '1'))
>>> fs.Orientation.quaternion(2, 0, 0, 1).rows[0]
('0.6', '-0.8', '0')
>>> len(fs.Orientation.right_angles())
24
)doc")
      .def(py::init(&orientation_of), py::arg("rows"))
      .def_static(
          "quaternion",
          [](const py::object& w, const py::object& x, const py::object& y, const py::object& z) {
            return Orientation::quaternion(number(w), number(x), number(y), number(z));
          },
          py::arg("w"), py::arg("x"), py::arg("y"), py::arg("z"), "Of any length but 0.")
      .def_static(
          "about",
          [](const std::string& axis, const py::object& degrees) {
            if (axis != "x" && axis != "y" && axis != "z") throw py::value_error("axis is 'x', 'y' or 'z'");
            return Orientation::about(Shape::Axis(axis[0] - 'x'), number(degrees));
          },
          py::arg("axis"), py::arg("degrees"), "Counter-clockwise about 'x', 'y' or 'z', by a multiple of 90 degrees.")
      .def_static("right_angles", &Orientation::right_angles, "All 24 that take axes to axes.")
      .def_static("upright", &Orientation::upright, "The four of them about z.")
      .def(py::pickle(&rows_of, [](const py::tuple& rows) { return orientation_of(rows); }))
      .def_property_readonly("rows", &rows_of, "Exactly, as text.");
}

void bind_problem(py::module_& m) {
  py::class_<PackSolid>(m, "PackSolid", R"doc(A kind of solid: how many, and how they may stand.

Parameters
----------
name : str
shape : Shape
    Of space: with flat faces, a ball, or a union of such.
count : int
    How many copies are wanted.
orientations : 'right-angles', 'upright', or list of Orientation
    How it may stand; as it is given where there are none.
value : number, optional
    Of a copy, where not all fit; without it its volume.
)doc")
      .def(py::init([](std::string name, const Shape& shape, int count, const py::object& orientations,
                       const py::object& value) {
             return PackSolid{std::move(name), shape, count, orientations_of(orientations), amount(value)};
           }),
           py::arg("name"), py::arg("shape"), py::arg("count") = 1, py::arg("orientations") = py::list(),
           py::arg("value") = py::none())
      .def(py::pickle(
          [](const PackSolid& p) { return py::make_tuple(p.name, p.shape, p.count, p.orientations, packed(p.value)); },
          [](const py::tuple& t) {
            return PackSolid{t[0].cast<std::string>(), t[1].cast<Shape>(), t[2].cast<int>(),
                             t[3].cast<std::vector<Orientation>>(), amount(t[4])};
          }))
      .def_readonly("name", &PackSolid::name, "Its name in problems and layouts.")
      .def_readonly("shape", &PackSolid::shape, "What is packed.")
      .def_readonly("orientations", &PackSolid::orientations, "How it may stand.")
      .def_property_readonly("value", showing(&PackSolid::value), "Of a copy, as text; None: its volume.")
      .def_readwrite("count", &PackSolid::count, "How many copies are wanted.");
  py::class_<PackContainer>(
      m, "PackContainer", "A kind of container: a box from (0, 0, 0) to its size (x, y, z), or of a shape of its own.")
      .def(py::init(&container_of), py::arg("name"), py::arg("size") = py::none(), py::arg("count") = 1,
           py::arg("cost") = py::none(), py::arg("shape") = py::none())
      .def(pickled<PackContainer>(&PackContainer::name, &PackContainer::width, &PackContainer::depth,
                                  &PackContainer::height, &PackContainer::count, &PackContainer::cost,
                                  &PackContainer::shape))
      .def_readonly("name", &PackContainer::name, "Its name in layouts.")
      .def_property_readonly(
          "size",
          [](const PackContainer& c) { return py::make_tuple(c.width.text(), c.depth.text(), c.height.text()); },
          "Along x, y and z, exactly, as text; 0 where it has a shape.")
      .def_readonly("shape", &PackContainer::shape,
                    "What it holds, moved so that its box begins at (0, 0, 0); None of a box.")
      .def_readonly("count", &PackContainer::count, "How many there are.")
      .def_property_readonly("cost", showing(&PackContainer::cost), "Of one, as text, or None.");
  py::class_<FixedSolid>(m, "FixedSolid", "A copy that stands already; it counts as one of its kind's.")
      .def(py::init([](std::string part, const py::sequence& at, const std::optional<Orientation>& orientation,
                       std::string container, int which) {
             return FixedSolid{std::move(part), point3(at), orientation.value_or(Orientation{}), std::move(container),
                               which};
           }),
           py::arg("part"), py::arg("at"), py::arg("orientation") = py::none(), py::arg("container") = "",
           py::arg("number") = 1)
      .def(py::pickle(
          [](const FixedSolid& f) {
            return py::make_tuple(f.part, shown_point(f.at), f.orientation, f.container, f.number);
          },
          [](const py::tuple& t) {
            return FixedSolid{t[0].cast<std::string>(), point3(t[1]), t[2].cast<Orientation>(),
                              t[3].cast<std::string>(), t[4].cast<int>()};
          }))
      .def_readonly("part", &FixedSolid::part, "The name of its kind.")
      .def_property_readonly(
          "at", [](const FixedSolid& f) { return shown_point(f.at); }, "Where its origin is, exactly, as text.")
      .def_readonly("orientation", &FixedSolid::orientation, "How it stands.")
      .def_readonly("container", &FixedSolid::container, "The kind of container that it stands in, or ''.")
      .def_readonly("number", &FixedSolid::number, "Which of that kind, from 1.");
  py::class_<SolidPackProblem> problem(m, "SolidPackProblem",
                                       R"doc(Solids to be packed upon a floor, or into containers.

Parameters
----------
parts : list of PackSolid
floor : (x, y)
    Its size; the height is sought.
containers : list of PackContainer
    Instead of a floor.
gap, edge : number
    The least distance of two solids, and of a solid to the walls, the floor and the lid.
name : str
    How files call it.
gaps : list of (str, str, number)
    Wider gaps of two kinds.
conditions : list of (str, str, Formula or str)
    Of two kinds, "self" and "other".
where : Formula or str, optional
    What holds for any two copies.
groups : list of PackGroup
    Solids that stay together.
fixed : list of FixedSolid
    Copies that stand already; the others are placed round them.

Examples
--------
>>> import findspace as fs
>>> brick = fs.PackSolid("brick", fs.Shape.box((0, 0, 0), (2, 1, 1)), count=8, orientations="right-angles")
>>> problem = fs.SolidPackProblem([brick], floor=(4, 2))
>>> layout = fs.pack(problem, work=5)
>>> layout.height, layout.lower_bound, layout.faults(problem)
('2', '2', [])
)doc");
  problem
      .def(py::init(&problem_of), py::arg("parts"), py::arg("floor") = py::none(),
           py::arg("containers") = std::vector<PackContainer>(), py::arg("gap") = 0, py::arg("edge") = 0,
           py::arg("name") = "", py::arg("gaps") = py::list(), py::arg("conditions") = py::list(),
           py::arg("where") = py::none(), py::arg("groups") = py::list(), py::arg("fixed") = std::vector<FixedSolid>())
      .def(py::pickle(&packed_problem, &unpacked_problem))
      .def_static(
          "json", [](const std::string& text, const std::string& folder) { return solid_pack_problem(text, folder); },
          py::arg("text"), py::arg("folder") = "", "A problem as nesting JSON; files are looked for in the folder.")
      .def_readonly("parts", &SolidPackProblem::parts, "The kinds of solids.")
      .def_readonly("containers", &SolidPackProblem::containers, "The kinds of containers; none upon a floor.")
      .def_readonly("fixed", &SolidPackProblem::fixed, "What stands already.")
      .def_property_readonly(
          "floor", [](const SolidPackProblem& p) { return py::make_tuple(p.width.text(), p.depth.text()); },
          "Its size, exactly, as text.");
  bind_conditions(problem);
}

void bind_item(py::module_& m) {
  py::class_<PlacedSolid>(m, "PlacedSolid", "A copy of a solid: q goes to at + orientation q.")
      .def(py::pickle(
          [](const PlacedSolid& p) {
            return py::make_tuple(p.part, p.copy, p.container, p.orientation, shown_point(p.at));
          },
          [](const py::tuple& t) {
            return PlacedSolid{t[0].cast<std::string>(), t[1].cast<int>(), t[2].cast<std::size_t>(),
                               t[3].cast<Orientation>(), point3(t[4])};
          }))
      .def_readonly("part", &PlacedSolid::part, "The name of its kind.")
      .def_readonly("copy", &PlacedSolid::copy, "Which copy of it, from 1.")
      .def_readonly("container", &PlacedSolid::container, "The container that it stands in, from 0.")
      .def_property(
          "orientation", [](const PlacedSolid& p) { return p.orientation; },
          [](PlacedSolid& p, const Orientation& o) { p.orientation = o; }, "How it stands.")
      .def_property_readonly("matrix", &matrix_of, "Where it stands, shape (4, 4), in doubles.")
      .def_property(
          "at", [](const PlacedSolid& p) { return shown_point(p.at); },
          [](PlacedSolid& p, const py::sequence& at) { p.at = point3(at); }, "Exact coordinates as text.");
}

py::class_<SolidPackLayout> bind_layout(py::module_& m) {
  py::class_<SolidPackLayout> layout(
      m, "SolidPackLayout", py::dynamic_attr(),
      "Where the solids are. `problem` is what was packed: its texts and pictures know it.");
  layout
      .def(pickled_with_problem<SolidPackLayout>(
          &SolidPackLayout::height, &SolidPackLayout::items, &SolidPackLayout::left_out, &SolidPackLayout::containers,
          &SolidPackLayout::density, &SolidPackLayout::lower_bound, &SolidPackLayout::met, &SolidPackLayout::seconds,
          &SolidPackLayout::seed, &SolidPackLayout::threads))
      .def_property_readonly(
          "height", [](const SolidPackLayout& l) { return l.height.text(); },
          "What is used of the last container, exactly, as text.")
      .def_property_readonly(
          "lower_bound", [](const SolidPackLayout& l) { return l.lower_bound.text(); },
          "No layout is lower; in containers how few of them no layout of all solids goes below.")
      .def_property_readonly(
          "items", [](SolidPackLayout& l) -> std::vector<PlacedSolid>& { return l.items; },
          py::return_value_policy::reference_internal, "The copies that are placed.")
      .def_readonly("left_out", &SolidPackLayout::left_out, "What is not placed, and why.")
      .def_readonly("containers", &SolidPackLayout::containers, "The names of the containers that are used.")
      .def_readonly("density", &SolidPackLayout::density, "Volume of the solids by the volume of what holds them.")
      .def_property_readonly(
          "met", [](const SolidPackLayout& l) { return limit_name(l.met); },
          "The limit that ended the search: 'time', 'memory', 'cancelled', or None.")
      .def_readonly("seconds", &SolidPackLayout::seconds, "How long the search took to find it.")
      .def_readonly("seed", &SolidPackLayout::seed, "Of the search.")
      .def_readonly("threads", &SolidPackLayout::threads, "Of the search.");
  return layout;
}

using GivenPacking = std::optional<SolidPacking>;

/// Of a layout in Python, asked with what was given or with the problem that it remembers.
template <class Ask>
auto asking(const Ask& ask) {
  return [ask](const py::object& self, const GivenPacking& given) {
    const SolidPacking packing = packing_of(self, given);
    const auto layout = self.cast<SolidPackLayout>();  // its items may be moved meanwhile
    return interruptible([&] { return ask(packing, layout); });
  };
}

void bind_texts(py::class_<SolidPackLayout>& layout) {
  using Layout = SolidPackLayout;
  const char* const kOf = "problem";
  layout
      .def("json", asking([](const SolidPacking& p, const Layout& l) { return p.json(l); }), py::arg(kOf) = py::none(),
           "The layout file (docs/nesting.md). A SolidPacking or a problem; without it the one that is remembered.")
      .def("svg", asking([](const SolidPacking& p, const Layout& l) { return p.svg(l); }), py::arg(kOf) = py::none(),
           "A view from above.")
      .def(
          "text",
          [](const py::object& self, const GivenPacking& given, const std::string& ending) {
            const SolidPacking packing = packing_of(self, given);
            const auto layout = self.cast<Layout>();
            return py::bytes(interruptible([&] { return packing.file(layout, ending); }));
          },
          py::arg(kOf) = py::none(), py::arg("ending") = ".3mf",
          "As a file, in bytes: '.3mf' '.glb' '.obj' '.stl' '.ply' '.off' '.step' '.svg'.")
      .def("surface", asking([](const SolidPacking& p, const Layout& l) { return p.surface(l); }),
           py::arg(kOf) = py::none(), "All copies as one surface; a notebook shows it to be turned.")
      .def("faults", asking([](const SolidPacking& p, const Layout& l) {
             std::vector<std::string> out;
             for (const PackFault& fault : p.verdict(l).faults) out.push_back(fault.text);
             return out;
           }),
           py::arg(kOf) = py::none(), "What is wrong with it, exactly; an empty list where it is feasible.");
}

void bind_class(py::module_& m) {
  bind_packing_of<SolidPacking, SolidPackProblem, SolidPackLayout>(
      m, "SolidPacking", R"doc(A packing problem of solids, put on its grid once.

It is immutable and answers many questions, from many threads. Where a problem is taken, a packing is too.

Parameters
----------
problem : SolidPackProblem

Raises
------
Error
    Where a shape is none that is packed, stands on the floor in no orientation, has too many digits, or a name is
    unknown.

Examples
--------
>>> import findspace as fs
>>> brick = fs.PackSolid("brick", fs.Shape.box((0, 0, 0), (2, 1, 1)), count=4, orientations="upright")
>>> packing = fs.SolidPacking(fs.SolidPackProblem([brick], floor=(2, 2)))
>>> layout = packing.search(work=1)
>>> layout.height, packing.lower_bound, packing.verdict(layout).feasible
('2', '2', True)
)doc")
      .def(
          "moved",
          [](const SolidPacking& p, SolidPackLayout layout, std::size_t item, const py::sequence& at) {
            const Point3 to = point3(at);
            return Remembering<SolidPackLayout>{interruptible([&] { return p.moved(layout, item, to); }),
                                                py::cast(p.problem())};
          },
          py::arg("layout"), py::arg("item"), py::arg("at"),
          R"doc(The layout with one of its solids put elsewhere in its container, and the others out of its way.

Parameters
----------
layout : SolidPackLayout
item : int
    Which of its items, from 0.
at : (x, y, z)
    Where its origin goes. Where it is free there, it stands there exactly and nothing else moves.

Returns
-------
SolidPackLayout or None
    Else the item may be moved a little too, and upon a floor the height may grow; None where the others cannot make
    room.
)doc")
      .def("outline", &SolidPacking::outline, py::arg("part"),
           "A solid, counted as in `problem.parts`, about its origin, not turned: a Surface.")
      .def("inside", &SolidPacking::inside, py::arg("container"),
           "What a container holds, counted as in `problem.containers`, from (0, 0, 0) on: a Surface.")
      .def_static("is_stated_in", &SolidPacking::is_stated_in, py::arg("json"), py::arg("name") = "problem",
                  "Whether JSON is such a problem, not one of the plane. An Error of code 'syntax' where it is none.");
}

}  // namespace
}  // namespace solids

void bind_solid_packing(py::module_& m) {
  solids::bind_orientation(m);
  solids::bind_problem(m);
  solids::bind_item(m);
  py::class_<SolidPackLayout> layout = solids::bind_layout(m);
  solids::bind_class(m);
  solids::bind_texts(layout);
  m.def("pack", &packed_in_python<SolidPackLayout, SolidPackProblem>, py::arg("problem"),
        py::arg("options") = py::none(), py::arg("better") = py::none(),
        "The same of solids; the search ends where no layout can be lower.");
}

}  // namespace findspace::python
