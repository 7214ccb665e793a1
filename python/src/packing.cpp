// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Packing in Python: problems are built of parts and sheets, layouts come back with exact coordinates as text.

#include "findspace/packing.h"

#include <pybind11/functional.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cmath>

#include "arrays.h"
#include "files.h"
#include "interruptible.h"
#include "numbers.h"
#include "options.h"
#include "packing.h"
#include "packings.h"
#include "pickles.h"

namespace findspace::python {
namespace {

std::vector<Ring> rings_of(const py::sequence& outline, const py::sequence& holes) {
  std::vector<Ring> rings;
  const auto add = [&](const py::sequence& corners) {
    Ring& ring = rings.emplace_back();
    for (const py::object& p : corners) ring.push_back(point(p));
  };
  add(outline);
  for (const py::object& hole : holes) add(hole);
  return rings;
}

std::vector<Number> numbers(const py::sequence& values) {
  refuse_text(values, "angles are a list of numbers");
  std::vector<Number> result;
  for (const py::object& value : values) result.push_back(number(value));
  return result;
}

PackProblem problem_of(std::vector<PackPart> parts, const py::object& height, std::vector<PackSheet> sheets,
                       const py::object& gap, const py::object& edge, std::string name, bool box,
                       const std::vector<NamedGap>& gaps, const std::vector<NamedCondition>& conditions,
                       std::vector<FixedPart> fixed, const std::optional<Formula>& where,
                       std::vector<PackGroup> groups) {
  PackProblem problem;
  problem.name = std::move(name);
  problem.height = number(height);
  problem.sheets = std::move(sheets);
  problem.box = box;
  problem.parts = std::move(parts);
  problem.gap = number(gap);
  problem.edge = number(edge);
  problem.fixed = std::move(fixed);
  set_conditions(problem, gaps, conditions, where, std::move(groups));
  return problem;
}

py::tuple packed_problem(const PackProblem& p) {
  return py::make_tuple(p.parts, packed(p.height), p.sheets, packed(p.gap), packed(p.edge), p.name, p.box,
                        named(p.gaps), named(p.conditions), p.fixed, where_of(p), p.groups);
}

PackProblem unpacked_problem(const py::tuple& t) {
  return problem_of(t[0].cast<std::vector<PackPart>>(), t[1], t[2].cast<std::vector<PackSheet>>(), t[3], t[4],
                    t[5].cast<std::string>(), t[6].cast<bool>(), t[7].cast<std::vector<NamedGap>>(),
                    t[8].cast<std::vector<NamedCondition>>(), t[9].cast<std::vector<FixedPart>>(),
                    t[10].cast<std::optional<Formula>>(), t[11].cast<std::vector<PackGroup>>());
}

void bind_problem(py::module_& m) {
  py::class_<PackPart>(m, "PackPart",
                       "A kind of part: an outline with holes or a Shape, how many, at which angles (degrees), and by "
                       "how many degrees a copy may be off one of them (`tilt`).")
      .def(py::init([](std::string name, const Shape& shape, int count, const py::sequence& angles, bool mirrored,
                       const py::object& value, const py::object& tilt) {
             return PackPart{std::move(name), {}, count, numbers(angles), mirrored, amount(value), shape, number(tilt)};
           }),
           py::arg("name"), py::arg("shape"), py::arg("count") = 1, py::arg("angles") = py::make_tuple(0),
           py::arg("mirrored") = false, py::arg("value") = py::none(), py::arg("tilt") = 0)
      .def(py::init([](std::string name, const py::sequence& outline, const py::sequence& holes, int count,
                       const py::sequence& angles, bool mirrored, const py::object& value, const py::object& tilt) {
             return PackPart{std::move(name), rings_of(outline, holes),
                             count,           numbers(angles),
                             mirrored,        amount(value),
                             std::nullopt,    number(tilt)};
           }),
           py::arg("name"), py::arg("outline"), py::arg("holes") = py::tuple(), py::arg("count") = 1,
           py::arg("angles") = py::make_tuple(0), py::arg("mirrored") = false, py::arg("value") = py::none(),
           py::arg("tilt") = 0)
      .def(pickled<PackPart>(&PackPart::name, &PackPart::rings, &PackPart::count, &PackPart::angles,
                             &PackPart::mirrored, &PackPart::value, &PackPart::shape, &PackPart::tilt))
      .def_readonly("name", &PackPart::name, "Its name in problems and layouts.")
      .def_property_readonly("rings", showing(&PackPart::rings), "Outline and holes, exactly; none of a Shape.")
      .def_readonly("shape", &PackPart::shape, "Instead of rings, or None.")
      .def_property_readonly("angles", showing(&PackPart::angles), "Those allowed, in degrees, as text.")
      .def_readonly("mirrored", &PackPart::mirrored, "Whether it may be turned over.")
      .def_property_readonly("value", showing(&PackPart::value), "Of a copy, as text; None: its area.")
      .def_property_readonly("tilt", showing(&PackPart::tilt), "By how many degrees it may be off an angle, as text.")
      .def_readwrite("count", &PackPart::count, "How many copies are wanted.");
  py::class_<PackZone>(m, "PackZone", "What the parts named may not enter, or may not leave: an outline or a Shape.")
      .def(py::init([](const Shape& shape, std::vector<std::string> keeps_out, std::vector<std::string> holds) {
             return PackZone{{}, std::move(keeps_out), std::move(holds), shape};
           }),
           py::arg("shape"), py::arg("keeps_out") = py::list(), py::arg("holds") = py::list())
      .def(py::init([](const py::sequence& outline, std::vector<std::string> keeps_out, std::vector<std::string> holds,
                       const py::sequence& holes) {
             return PackZone{rings_of(outline, holes), std::move(keeps_out), std::move(holds)};
           }),
           py::arg("outline"), py::arg("keeps_out") = py::list(), py::arg("holds") = py::list(),
           py::arg("holes") = py::tuple())
      .def(pickled<PackZone>(&PackZone::rings, &PackZone::keeps_out, &PackZone::holds, &PackZone::shape))
      .def_property_readonly("rings", showing(&PackZone::rings), "Outline and holes, exactly; none of a Shape.")
      .def_readonly("shape", &PackZone::shape, "Instead of rings, or None.")
      .def_readonly("keeps_out", &PackZone::keeps_out, "Names of the parts that stay out.")
      .def_readonly("holds", &PackZone::holds, "Names of the parts that lie within it.");
  py::class_<PackSheet>(m, "PackSheet",
                        "A kind of sheet: an outline with holes or a Shape, whose box begins at (0, 0).")
      .def(py::init([](std::string name, const Shape& shape, int count, const py::object& cost,
                       std::vector<PackZone> zones) {
             return PackSheet{std::move(name), {}, count, amount(cost), std::move(zones), shape};
           }),
           py::arg("name"), py::arg("shape"), py::arg("count") = 1, py::arg("cost") = py::none(),
           py::arg("zones") = std::vector<PackZone>())
      .def(py::init([](std::string name, const py::sequence& outline, const py::sequence& holes, int count,
                       const py::object& cost, std::vector<PackZone> zones) {
             return PackSheet{std::move(name), rings_of(outline, holes), count, amount(cost), std::move(zones)};
           }),
           py::arg("name"), py::arg("outline"), py::arg("holes") = py::tuple(), py::arg("count") = 1,
           py::arg("cost") = py::none(), py::arg("zones") = std::vector<PackZone>())
      .def(pickled<PackSheet>(&PackSheet::name, &PackSheet::rings, &PackSheet::count, &PackSheet::cost,
                              &PackSheet::zones, &PackSheet::shape))
      .def_static(
          "rectangle",
          [](std::string name, const py::object& width, const py::object& height, int count) {
            return PackSheet::rectangle(std::move(name), number(width), number(height), count);
          },
          py::arg("name"), py::arg("width"), py::arg("height"), py::arg("count") = 1, "A rectangular one.")
      .def_readonly("name", &PackSheet::name, "Its name in layouts.")
      .def_property_readonly("rings", showing(&PackSheet::rings), "Outline and holes, exactly; none of a Shape.")
      .def_readonly("shape", &PackSheet::shape, "Instead of rings, or None.")
      .def_readonly("count", &PackSheet::count, "How many there are.")
      .def_property_readonly("cost", showing(&PackSheet::cost), "Of one, as text, or None.")
      .def_readonly("zones", &PackSheet::zones, "What parts may not enter, or may not leave.");
  py::class_<PackGroup>(m, "PackGroup", "Parts that stay together: on one sheet, and at most `within` apart.")
      .def(py::init([](std::vector<std::string> parts, const py::object& within) {
             return PackGroup{std::move(parts), amount(within)};
           }),
           py::arg("parts"), py::arg("within") = py::none())
      .def(pickled<PackGroup>(&PackGroup::parts, &PackGroup::within))
      .def_readonly("parts", &PackGroup::parts, "Names of the parts.")
      .def_property_readonly("within", showing(&PackGroup::within), "How far they may be apart, as text, or None.");
  py::class_<FixedPart>(m, "FixedPart", "A copy that stands where it stands; it counts as one of its part's.")
      .def(py::init([](std::string part, const py::sequence& at, const py::object& angle, bool mirrored,
                       std::string sheet, int sheet_number) {
             const Point to = point(at);
             return FixedPart{std::move(part), to.x, to.y, number(angle), mirrored, std::move(sheet), sheet_number};
           }),
           py::arg("part"), py::arg("at"), py::arg("angle") = 0, py::arg("mirrored") = false, py::arg("sheet") = "",
           py::arg("number") = 1)
      .def(pickled<FixedPart>(&FixedPart::part, &FixedPart::x, &FixedPart::y, &FixedPart::angle, &FixedPart::mirrored,
                              &FixedPart::sheet, &FixedPart::number))
      .def_readonly("part", &FixedPart::part, "The name of its kind.")
      .def_property_readonly(
          "at", [](const FixedPart& f) { return py::make_tuple(f.x.text(), f.y.text()); },
          "Where its origin is, exactly, as text.")
      .def_property_readonly("angle", showing(&FixedPart::angle), "Degrees, counter-clockwise, as text.")
      .def_readonly("mirrored", &FixedPart::mirrored, "Whether it is turned over.")
      .def_readonly("sheet", &FixedPart::sheet, "The kind of sheet that it lies on, or ''.")
      .def_readonly("number", &FixedPart::number, "Which of that kind, from 1.");
  py::class_<PackProblem> problem(m, "PackProblem",
                                  R"doc(What is to be packed: into a strip of a height, a box, or onto sheets.

Parameters
----------
parts : list of PackPart
height : number
    Of the strip.
sheets : list of PackSheet
    Instead of a strip.
gap, edge : number
    The least distance of two parts, and of a part to the sides of what holds it.
name : str
    How files call it.
box : bool
    Instead of either: a rectangle of the least area.
gaps : list of (str, str, number)
    Wider gaps of two kinds of parts.
conditions : list of (str, str, Formula or str)
    Of two kinds of parts, "self" and "other": such as "gap(self, other) <= 8".
fixed : list of FixedPart
    Copies that stand already.
where : Formula or str, optional
    What holds for any two copies, "self" and "other".
groups : list of PackGroup
    Parts that stay together.

Examples
--------
>>> import findspace as fs
>>> square = [(0, 0), (1, 0), (1, 1), (0, 1)]
>>> parts = [fs.PackPart("plug", square), fs.PackPart("socket", square)]
>>> near = ("plug", "socket", fs.gap("self", "other") <= 0.5)
>>> fs.pack(fs.PackProblem(parts, height=1, gap=0.25, conditions=[near]), work=1).length
'2.25'
)doc");
  problem
      .def(py::init(&problem_of), py::arg("parts"), py::arg("height") = 0, py::arg("sheets") = std::vector<PackSheet>(),
           py::arg("gap") = 0, py::arg("edge") = 0, py::arg("name") = "", py::arg("box") = false,
           py::arg("gaps") = py::list(), py::arg("conditions") = py::list(), py::arg("fixed") = py::list(),
           py::arg("where") = py::none(), py::arg("groups") = py::list())
      .def(py::pickle(&packed_problem, &unpacked_problem))
      .def_static(
          "json", [](const std::string& text) { return pack_problem(text); }, py::arg("text"),
          "A problem as nesting JSON.")
      .def_readonly("parts", &PackProblem::parts, "The kinds of parts.")
      .def_property_readonly("height", showing(&PackProblem::height), "Of the strip, exactly, as text.")
      .def_readonly("box", &PackProblem::box, "Whether a rectangle of the least area is sought.")
      .def_readonly("fixed", &PackProblem::fixed, "Copies that stand already.")
      .def_readonly("sheets", &PackProblem::sheets, "The kinds of sheets; none for a strip or a box.");
  bind_conditions(problem);
}

/// q goes to M q, in doubles: q and the result have a third coordinate of 1.
Array matrix_of(const PlacedPart& p) {
  const double radians = p.angle.value() * std::acos(-1.0) / 180, c = std::cos(radians), s = std::sin(radians);
  const double x = p.mirrored ? -1 : 1;
  const double entries[3][3] = {{c * x, -s, p.x.value()}, {s * x, c, p.y.value()}, {0, 0, 1}};
  Array out({py::ssize_t(3), py::ssize_t(3)});
  for (py::ssize_t r = 0; r < 3; ++r)
    for (py::ssize_t k = 0; k < 3; ++k) out.mutable_at(r, k) = entries[r][k];
  return out;
}

void bind_items(py::module_& m) {
  py::class_<PlacedPart>(m, "PlacedPart", "A copy of a part: q goes to at + R(angle) M q.")
      .def(pickled<PlacedPart>(&PlacedPart::part, &PlacedPart::copy, &PlacedPart::sheet, &PlacedPart::angle,
                               &PlacedPart::mirrored, &PlacedPart::x, &PlacedPart::y))
      .def_readonly("part", &PlacedPart::part, "The name of its kind.")
      .def_readonly("copy", &PlacedPart::copy, "Which copy of it, from 1.")
      .def_readonly("sheet", &PlacedPart::sheet, "The sheet that it lies on, from 0.")
      .def_readonly("mirrored", &PlacedPart::mirrored, "Whether x became -x before the rotation.")
      .def_property_readonly(
          "angle", [](const PlacedPart& p) { return p.angle.text(); }, "Degrees, counter-clockwise, as text.")
      .def_property(
          "at", [](const PlacedPart& p) { return py::make_tuple(p.x.text(), p.y.text()); },
          [](PlacedPart& p, const py::sequence& at) {
            const Point q = point(at);
            p.x = q.x;
            p.y = q.y;
          },
          "Exact coordinates as text.")
      .def_property_readonly("matrix", &matrix_of, "What takes the part to where it lies, shape (3, 3), in doubles.");
  py::class_<LeftOutPart>(m, "LeftOutPart", "Copies that are not in a layout, and why.")
      .def(pickled<LeftOutPart>(&LeftOutPart::part, &LeftOutPart::copies, &LeftOutPart::why))
      .def_readonly("part", &LeftOutPart::part, "The name of its kind.")
      .def_readonly("copies", &LeftOutPart::copies, "How many are left out.")
      .def_readonly("why", &LeftOutPart::why, "Why, in words.");
  py::class_<PackRemnant>(m, "PackRemnant", "The largest rectangle along the axes that the last sheet has left.")
      .def(pickled<PackRemnant>(&PackRemnant::sheet, &PackRemnant::x, &PackRemnant::y, &PackRemnant::width,
                                &PackRemnant::height))
      .def_readonly("sheet", &PackRemnant::sheet, "The sheet, from 0.")
      .def_property_readonly(
          "at", [](const PackRemnant& r) { return py::make_tuple(r.x.text(), r.y.text()); },
          "The lower left corner, exactly, as text.")
      .def_property_readonly(
          "size", [](const PackRemnant& r) { return py::make_tuple(r.width.text(), r.height.text()); },
          "Width and height, exactly, as text.");
}

py::class_<PackLayout> bind_layout(py::module_& m) {
  py::class_<PackLayout> layout(m, "PackLayout", py::dynamic_attr(),
                                "Where the parts are. `problem` is what was packed: its texts and pictures know it.");
  layout
      .def(pickled_with_problem<PackLayout>(&PackLayout::length, &PackLayout::items, &PackLayout::left_out,
                                            &PackLayout::sheets, &PackLayout::height, &PackLayout::density,
                                            &PackLayout::remnant, &PackLayout::met, &PackLayout::seconds,
                                            &PackLayout::seed, &PackLayout::threads))
      .def_property_readonly(
          "met", [](const PackLayout& l) { return limit_name(l.met); },
          "The limit that ended the search: 'time', 'memory', 'cancelled', or None.")
      .def_readonly("seconds", &PackLayout::seconds, "How long the search took to find it.")
      .def_readonly("seed", &PackLayout::seed, "Of the search.")
      .def_readonly("threads", &PackLayout::threads, "Of the search.")
      .def_property_readonly(
          "length", [](const PackLayout& l) { return l.length.text(); }, "Of the strip or box, exactly, as text.")
      .def_property_readonly(
          "items", [](PackLayout& l) -> std::vector<PlacedPart>& { return l.items; },
          py::return_value_policy::reference_internal, "The copies that are placed.")
      .def_property_readonly(
          "height", [](const PackLayout& l) { return l.height.text(); }, "Of the strip or box, exactly, as text.")
      .def_readonly("left_out", &PackLayout::left_out, "What is not placed, and why.")
      .def_readonly("sheets", &PackLayout::sheets, "The names of the sheets that are used.")
      .def_readonly("remnant", &PackLayout::remnant, "What the last sheet has left, or None.")
      .def_readonly("density", &PackLayout::density, "Area of the parts by the area of what holds them.");
  return layout;
}

using GivenPacking = std::optional<Packing>;

/// Of a layout in Python, asked with what was given or with the problem that it remembers.
template <class Ask>
auto asking(const Ask& ask) {
  return [ask](const py::object& self, const GivenPacking& given) {
    const Packing packing = packing_of(self, given);
    const auto layout = self.cast<PackLayout>();  // its items may be moved meanwhile
    return interruptible([&] { return ask(packing, layout); });
  };
}

void bind_texts(py::class_<PackLayout>& layout) {
  const char* const kOf = "problem";
  layout
      .def("json", asking([](const Packing& p, const PackLayout& l) { return p.json(l); }), py::arg(kOf) = py::none(),
           "The layout file (docs/nesting.md). A Packing or a PackProblem; without it the one that is remembered.")
      .def("svg", asking([](const Packing& p, const PackLayout& l) { return p.svg(l); }), py::arg(kOf) = py::none(),
           "A picture with a page a sheet.")
      .def(
          "dxf",
          [](const py::object& self, const GivenPacking& given, const std::string& version) {
            return packing_of(self, given).dxf(self.cast<const PackLayout&>(), dxf_version(version));
          },
          py::arg(kOf) = py::none(), py::arg("version") = "R12",
          R"doc(A drawing to cut: outlines on the layers "cut" and "sheet", arcs as bulges.

Parameters
----------
problem : Packing or PackProblem, optional
    Without it the one that is remembered.
version : 'R12' or '2000'
    Every program reads the first; in the second layers may have any name.
)doc")
      .def("faults", asking([](const Packing& p, const PackLayout& l) {
             std::vector<std::string> out;
             for (const PackFault& fault : p.verdict(l).faults) out.push_back(fault.text);
             return out;
           }),
           py::arg(kOf) = py::none(), "What is wrong with it, exactly; an empty list where it is feasible.");
}

void bind_class(py::module_& m) {
  bind_packing_of<Packing, PackProblem, PackLayout>(m, "Packing", R"doc(A packing problem, put on its grid once.

It is immutable and answers many questions, from many threads. Where a problem is taken, a packing is too.

Parameters
----------
problem : PackProblem

Raises
------
Error
    Where a part is not a simple polygon, is higher than the strip, a name is unknown, or the fixed parts overlap.

Examples
--------
>>> import findspace as fs
>>> ell = fs.PackPart("ell", [(0, 0), (3, 0), (3, 1), (1, 1), (1, 3), (0, 3)], count=4, angles=[0, 90, 180, 270])
>>> packing = fs.Packing(fs.PackProblem([ell], height=4))
>>> packing.copies
4
>>> first = packing.search(work=1)
>>> bool(packing.verdict(first)), packing.layout(first.json(packing)).length == first.length
(True, True)
>>> first.items[0].at = (-5, 0)
>>> packing.verdict(first).faults[0].kind
'outside'
)doc")
      .def_static(
          "sparrow",
          [](const std::string& svg, const std::string& name) {
            auto [packing, layout] = Packing::sparrow(svg, name);
            const py::object problem = py::cast(packing.problem());
            return std::make_pair(std::move(packing), Remembering<PackLayout>{std::move(layout), problem});
          },
          py::arg("svg"), py::arg("name") = "layout",
          "(packing, layout) of a drawing that sparrow writes. Parts may stand at the angles at which they stand.")
      .def("check_start", &Packing::check_start, py::arg("layout"),
           "Raises Error unless a search can begin with the layout: every copy that is wanted is in it, or said to be "
           "left out; fixed parts stand where they stand; no more sheets are used than there are, and each item is on "
           "one of them.")
      .def(
          "moved",
          [](const Packing& p, PackLayout layout, std::size_t item, const Position& at) {
            return Remembering<PackLayout>{interruptible([&] { return p.moved(layout, item, at); }),
                                           py::cast(p.problem())};
          },
          py::arg("layout"), py::arg("item"), py::arg("at"),
          R"doc(The layout with one of its items put elsewhere, and the others out of its way.

Parameters
----------
layout : PackLayout
item : int
    Which of its items, from 0; not one that is fixed.
at : (float, float)
    Where its origin goes, on the grid.

Returns
-------
PackLayout or None
    The strip or box may become longer, on sheets all stays on those in use. The item may lie a little aside. None where
    the others cannot make room.
)doc")
      .def("outline", &Packing::outline, py::arg("part"),
           "A part, counted as in `problem.parts`, as SVG path data about its origin, y downwards.")
      .def("sheet_outline", &Packing::sheet_outline, py::arg("sheet"),
           "A kind of sheet, counted as in `problem.sheets`, in the same way: its outline and holes.")
      .def("sheet_zones", &Packing::sheet_zones, py::arg("sheet"),
           "All zones on a kind of sheet, in the same way; empty where there are none.");
}

}  // namespace

void bind_packing(py::module_& m) {
  bind_problem(m);
  bind_items(m);
  py::class_<PackLayout> layout = bind_layout(m);
  bind_class(m);
  bind_texts(layout);
  m.def("pack", &packed_in_python<PackLayout, PackProblem>, py::arg("problem"), py::arg("options") = py::none(),
        py::arg("better") = py::none(),
        R"doc(The best layout found, or None where there is nothing to pack. Ctrl-C ends the search.

Parameters
----------
problem : PackProblem
options : Options, optional
    Or its words. The search ends after `seconds` or `work`; after 10 seconds where nothing is said. With `work` alone
    the same `seed` and `threads` bring the same layout.
better : callable, optional
    Called with each better layout at once. What it raises ends the search.

Examples
--------
>>> import findspace as fs
>>> domino = fs.PackPart("domino", [(0, 0), (1, 0), (1, 2), (0, 2)], count=8, angles=[0, 90])
>>> fs.pack(fs.PackProblem([domino], height=4), work=5).length
'4'
)doc");
}

}  // namespace findspace::python
