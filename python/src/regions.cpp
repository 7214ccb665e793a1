// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <pybind11/operators.h>
#include <pybind11/stl.h>

#include <utility>

#include "arrays.h"
#include "files.h"
#include "findspace/region.h"
#include "findspace/shape.h"
#include "interruptible.h"
#include "numbers.h"
#include "options.h"

namespace findspace::python {
namespace {

/// A ring of a component, which keeps the region that it is of.
struct RingOf {
  Region region;
  Region::Ring sides;
};
struct ComponentOf {
  Region region;
  std::size_t index;
  const Region::Component& get() const { return region.components()[index]; }
};
/// An edge in the direction in which it is met.
struct EdgeOf {
  Region::Edge edge;
  Position start, end;
  bool ccw;
};

EdgeOf edge_of(const Region& region, const Region::Side& s) {
  const Region::Edge& e = region.edges()[s.edge];
  const Position &a = region.vertices()[e.start].at, &b = region.vertices()[e.end].at;
  if (s.forward) return {e, a, b, true};
  EdgeOf back{e, b, a, false};
  std::swap(back.edge.left_belongs, back.edge.right_belongs);
  return back;
}

py::array_t<bool> contains(const Region& region, const Doubles& at) {
  const std::span<const Position> all = positions(at);
  py::array_t<bool> out(py::ssize_t(all.size()));
  const std::span<bool> answers(out.mutable_data(), all.size());
  const py::gil_scoped_release release;
  region.contains(all, answers);
  return out;
}

using ExactText = std::pair<std::string, std::string>;

ExactText exact_text(const Region& region, std::size_t vertex) {
  const ExactPoint p = region.exact(vertex);
  return {p.x.text(), p.y.text()};
}

/// The vertex that a side begins at.
std::size_t start_of(const Region& region, const Region::Side& side) {
  const Region::Edge& edge = region.edges()[side.edge];
  return side.forward ? edge.start : edge.end;
}

std::optional<std::tuple<double, double, double, double>> corners(const std::optional<Bounds>& bounds) {
  if (!bounds) return std::nullopt;
  return std::tuple(bounds->low[0], bounds->low[1], bounds->high[0], bounds->high[1]);
}

void bind_parts(py::module_& m) {
  py::class_<EdgeOf>(m, "Edge", "A segment or an arc of a boundary, in the direction in which it is met.")
      .def_readonly("start", &EdgeOf::start, "Where it begins; a whole circle begins and ends in one point.")
      .def_readonly("end", &EdgeOf::end, "Where it ends.")
      .def_property_readonly(
          "belongs", [](const EdgeOf& e) { return e.edge.belongs; }, "Whether it is in the set.")
      .def_property_readonly(
          "is_arc", [](const EdgeOf& e) { return e.edge.arc; }, "Whether it is an arc of a circle.")
      .def_property_readonly(
          "center", [](const EdgeOf& e) { return e.edge.arc ? std::optional(e.edge.center) : std::nullopt; },
          "Of an arc, else None.")
      .def_property_readonly(
          "radius", [](const EdgeOf& e) { return e.edge.arc ? std::optional(e.edge.radius) : std::nullopt; },
          "Of an arc, else None.")
      .def_property_readonly(
          "angle", [](const EdgeOf& e) { return e.edge.angle; }, "That an arc spans, in radians.")
      .def_property_readonly(
          "left_belongs", [](const EdgeOf& e) { return e.edge.left_belongs; },
          "Whether what lies on its left is in the set.")
      .def_property_readonly(
          "right_belongs", [](const EdgeOf& e) { return e.edge.right_belongs; }, "The same of its right.")
      .def_readonly("counterclockwise", &EdgeOf::ccw, "Which way an arc is met.")
      .def(py::pickle(
          [](const EdgeOf& e) {
            return py::make_tuple(e.start, e.end, e.ccw, e.edge.belongs, e.edge.arc, e.edge.center, e.edge.radius,
                                  e.edge.angle, e.edge.left_belongs, e.edge.right_belongs);
          },
          [](const py::tuple& t) {
            EdgeOf out{{}, t[0].cast<Position>(), t[1].cast<Position>(), t[2].cast<bool>()};
            out.edge.belongs = t[3].cast<bool>();
            out.edge.arc = t[4].cast<bool>();
            out.edge.center = t[5].cast<Position>();
            out.edge.radius = t[6].cast<double>();
            out.edge.angle = t[7].cast<double>();
            out.edge.left_belongs = t[8].cast<bool>();
            out.edge.right_belongs = t[9].cast<bool>();
            return out;
          }));
  py::class_<RingOf>(m, "Ring", "A closed boundary, the set on its left.")
      .def_property_readonly(
          "edges",
          [](const RingOf& r) {
            std::vector<EdgeOf> out;
            for (const Region::Side& s : r.sides) out.push_back(edge_of(r.region, s));
            return out;
          },
          "In order; the set lies on the left.")
      .def_property_readonly(
          "vertices",
          [](const RingOf& r) {
            std::vector<Position> out;
            for (const Region::Side& s : r.sides) out.push_back(edge_of(r.region, s).start);
            return array_of(out);
          },
          "Where its edges meet, shape (n, 2).")
      .def_property_readonly(
          "exact_vertices",
          [](const RingOf& r) {
            std::vector<ExactText> out;
            for (const Region::Side& s : r.sides) out.push_back(exact_text(r.region, start_of(r.region, s)));
            return out;
          },
          "The same exactly, as text: '3', '-5/3', '(1+2*sqrt(5))/3'; of numbers that are more nested the nearest "
          "decimal, with a leading '~'.")
      .def_property_readonly(
          "belong",
          [](const RingOf& r) {
            std::vector<bool> out;
            for (const Region::Side& s : r.sides) out.push_back(r.region.vertices()[start_of(r.region, s)].belongs);
            return out;
          },
          "Of each of its vertices, whether it is in the set.")
      .def(py::pickle(
          [](const RingOf& r) {
            std::vector<std::pair<std::size_t, bool>> sides;
            for (const Region::Side& s : r.sides) sides.emplace_back(s.edge, s.forward);
            return py::make_tuple(r.region, sides);
          },
          [](const py::tuple& t) {
            RingOf out{t[0].cast<Region>(), {}};
            for (const auto& [edge, forward] : t[1].cast<std::vector<std::pair<std::size_t, bool>>>())
              out.sides.push_back({edge, forward});
            return out;
          }))
      .def("__len__", [](const RingOf& r) { return r.sides.size(); });
  py::class_<ComponentOf>(m, "Component", "A connected part of a region.")
      .def_property_readonly(
          "dimension", [](const ComponentOf& c) { return c.get().dimension; },
          "2: it has an area; 1: curves alone; 0: a point.")
      .def_property_readonly(
          "area", [](const ComponentOf& c) { return c.get().area; }, "None where it is unbounded.")
      .def_property_readonly(
          "holes", [](const ComponentOf& c) { return c.get().holes; }, "Bounded components of its complement.")
      .def_property_readonly(
          "sample", [](const ComponentOf& c) { return c.get().sample; },
          "A point of it, inside where it has an inside.")
      .def_property_readonly(
          "rings",
          [](const ComponentOf& c) {
            std::vector<RingOf> out;
            for (const Region::Ring& r : c.get().rings) out.push_back({c.region, r});
            return out;
          },
          "Outer ring first, then its holes, face by face.")
      .def_property_readonly(
          "curves",
          [](const ComponentOf& c) {
            std::vector<EdgeOf> out;
            for (const std::size_t e : c.get().curves) out.push_back(edge_of(c.region, {e, true}));
            return out;
          },
          "Edges without area beside them.")
      .def_property_readonly(
          "points",
          [](const ComponentOf& c) {
            std::vector<Position> out;
            for (const std::size_t v : c.get().isolated) out.push_back(c.region.vertices()[v].at);
            return array_of(out);
          },
          "Isolated points, shape (n, 2).")
      .def_property_readonly(
          "exact_points",
          [](const ComponentOf& c) {
            std::vector<ExactText> out;
            for (const std::size_t v : c.get().isolated) out.push_back(exact_text(c.region, v));
            return out;
          },
          "The same exactly, as text.")
      .def_property_readonly(
          "bounds", [](const ComponentOf& c) { return corners(c.get().bounds); },
          "(min x, min y, max x, max y), or None where it is unbounded.")
      .def(py::pickle([](const ComponentOf& c) { return py::make_tuple(c.region, c.index); },
                      [](const py::tuple& t) {
                        return ComponentOf{t[0].cast<Region>(), t[1].cast<std::size_t>()};
                      }));
}

Region::Towards towards(const std::string& side) {
  using Towards = Region::Towards;
  if (side == "inside") return Towards::kInside;
  if (side == "outside") return Towards::kOutside;
  if (side == "on_arcs") return Towards::kOnArcs;
  throw py::value_error("side is 'inside', 'outside' or 'on_arcs'");
}

void bind_sets(py::class_<Region>& region) {
  region.def(py::self | py::self)
      .def(py::self & py::self)
      .def(py::self - py::self)
      .def("__eq__", [](const Region& a, const Region& b) { return a == b; })
      .def("__invert__", &Region::complement)
      .def("complement", &Region::complement, "What does not belong to it.")
      .def("interior", &Region::interior, "Its points with a disc around them in it.")
      .def("closure", &Region::closure, "With all of its boundary.")
      .def("boundary", &Region::boundary, "The closure without the interior.")
      .def("regularized", &Region::regularized, "The closure of the interior.")
      .def(
          "offset", [](const Region& r, const py::object& radius) { return r.offset(number(radius)); },
          py::arg("radius"), "All points no farther than the radius from it; eroded if negative.");
}

void bind_questions(py::class_<Region>& region) {
  region.def_property_readonly("empty", &Region::empty, "Whether nothing belongs to it.")
      .def_property_readonly("whole", &Region::whole, "The whole plane.")
      .def_property_readonly("open", &Region::open, "As a point set of the plane.")
      .def_property_readonly("closed", &Region::closed, "As a point set of the plane.")
      .def_property_readonly("bounded", &Region::bounded, "Within some disc.")
      .def_property_readonly("area", &Region::area, "None where it is unbounded.")
      .def_property_readonly("holes", &Region::holes, "Bounded components of the complement.")
      .def_property_readonly(
          "bounds", [](const Region& r) { return corners(r.bounds()); }, "(min x, min y, max x, max y), or None.")
      .def_property_readonly(
          "components",
          [](const Region& r) {
            std::vector<ComponentOf> out;
            for (std::size_t k = 0; k < r.components().size(); ++k) out.push_back({r, k});
            return out;
          },
          "Connected parts, unbounded first, then by dimension, then from left to right.")
      .def("contains", &contains, py::arg("positions"), "Of each position, shape (n, 2): exact, on boundaries too.")
      .def("__contains__", [](const Region& r, const py::sequence& p) { return r.contains(point(p)); })
      .def(
          "nearest",
          [](const Region& r, const Position& to) -> py::object {
            const auto found = r.nearest(to);
            return found ? py::object(py::make_tuple(found->at, found->distance, found->attained)) : py::none();
          },
          py::arg("to"), "(position, distance, whether it belongs) of the nearest point of the closure, or None.")
      .def(
          "snapped",
          [](const Region& r, const Position& to, const py::object& within) { return r.snapped(to, number(within)); },
          py::arg("to"), py::arg("within"),
          "Where something that is dragged to a place snaps to: a corner that belongs and is no farther than `within`, "
          "or "
          "else such a point of the boundary; None where there is none.")
      .def("some", &Region::some, "A position that belongs, an isolated one where there is one; None of the empty set.")
      .def_property_readonly(
          "extent", [](const Region& r) { return corners(r.extent()); },
          "(min x, min y, max x, max y) of all vertices and curves, also where the set goes on beyond; None without "
          "any.")
      .def(
          "paths",
          [](const Region& r, const std::tuple<double, double, double, double>& window, bool y_down) {
            const auto& [x0, y0, x1, y1] = window;
            const Region::Paths p = r.paths({{x0, y0}, {x1, y1}}, y_down);
            return py::dict(py::arg("faces") = p.faces, py::arg("closed") = p.closed, py::arg("open") = p.open,
                            py::arg("free") = p.free, py::arg("points") = p.points, py::arg("full") = p.full,
                            py::arg("hollow") = p.hollow);
          },
          py::arg("window"), py::arg("y_down") = false,
          R"doc(How it looks, for a program that draws it itself: SVG path data and places in the unit, with y downwards.

'faces' are filled by the even-odd rule; edges are 'closed' where they belong, else 'open'; 'free' curves have no area
beside them; 'points' are isolated; ends of curves are 'full' where they belong and these do not, or 'hollow'.

Parameters
----------
window : (min x, min y, max x, max y)
    What is unbounded is cut off there.
y_down : bool
    The coordinates run downwards already, as those of boards.

Examples
--------
>>> import findspace as fs
>>> fs.Shape.box((0, 0), (2, 1)).region.paths((0, 0, 2, 1))["faces"]
'M0 0L2 0L2 -1L0 -1L0 0Z'
)doc")
      .def(
          "sample",
          [](const Region& r, std::size_t n, const std::optional<Options>& options, const py::kwargs& words) {
            const Options asked = options_of(options, words);
            return array_of(interruptible([&] { return r.sample(n, asked); }));
          },
          py::arg("count"), py::arg("options") = py::none(),
          "Random points of the inside, shape (count, 2): the same for the same `seed` of the options.")
      .def(
          "flattened",
          [](const Region& r, double bound, const std::string& side) {
            std::vector<Array> out;
            for (const auto& ring : r.flattened(bound, towards(side))) out.push_back(array_of(ring));
            return out;
          },
          py::arg("bound"), py::arg("side") = "inside",
          "Rings as points, arcs cut into chords no farther than `bound` from them; `side` as of geojson().")
      .def(
          "geojson",
          [](const Region& r, double bound, const std::string& side) { return r.geojson(bound, towards(side)); },
          py::arg("bound"), py::arg("side") = "on_arcs",
          "The closure as GeoJSON, as text. No chord is farther than `bound` from its arc; corners lie within the set "
          "('inside'), outside of it ('outside'), or on the arcs ('on_arcs').");
}

void bind_texts(py::class_<Region>& region) {
  region
      .def_property_readonly(
          "json", [](const Region& r) { return r.json(); }, "As `findspace map --json` writes it.")
      .def_property_readonly("exact_json", &Region::exact_json, "As a shape of a scene, exactly.")
      .def_property_readonly("wkt", &Region::wkt, "Closed sets only: what is open is lost.")
      .def_property_readonly("svg", &Region::svg, "A drawing in true size.")
      .def("text", &Region::text, py::arg("title") = "region",
           "What it is like, in words: whether it is open, its area, box and components.")
      .def(
          "scene_json", &Region::scene_json, py::arg("name") = "region",
          R"doc(A scene with this one shape, stated by polygons, discs, segments and points where decimals say them exactly.

Examples
--------
>>> import findspace as fs
>>> region = fs.Shape.box((0, 0), (2, 1)).region - fs.Shape.disc((1, 0), "0.5").region
>>> fs.Scene.json(region.scene_json("plate")).shapes["plate"].region == region
True
)doc")
      .def(
          "drawn",
          [](const Region& r, const std::string& ending, const std::string& name, const std::string& version) {
            const Region::Drawn drawn = r.drawn(ending, name, dxf_version(version));
            return std::make_pair(drawn.text, drawn.lost);
          },
          py::arg("ending"), py::arg("name") = "region", py::arg("version") = "R12",
          R"doc(The text of a file, and what it does not say of the set, in words: open ends, cracks; '' if nothing.

Parameters
----------
ending : '.svg', '.dxf', '.wkt' or '.geojson'
name : str
    Of a layer, or of a feature.
version : 'R12' or '2000'
    Of DXF.

Raises
------
Error
    Of code 'unsupported' where the region is unbounded, for another ending, and of arcs in GeoJSON.

Examples
--------
>>> import findspace as fs
>>> text, lost = fs.Shape.box((0, 0), (2, 1)).region.interior().drawn(".wkt")
>>> text
'POLYGON ((0 0, 2 0, 2 1, 0 1, 0 0))\n'
)doc")
      .def("picture", &Region::picture, py::arg("title"), py::arg("subtitle") = "",
           "SVG with a frame, for people; unbounded regions are cut off.");
}

}  // namespace

void bind_regions(py::module_& m) {
  bind_parts(m);
  py::class_<Region> region(m, "Region", "An exact set of the plane; every vertex, edge and face belongs or not.");
  bind_questions(region);
  bind_sets(region);
  bind_texts(region);
  region
      .def(py::pickle([](const Region& r) { return py::make_tuple(r.exact_json(), Shape(r).grid().step.text()); },
                      [](const py::tuple& t) {
                        return Shape::json(t[0].cast<std::string>(), {Number(t[1].cast<std::string>())}).region();
                      }))
      .def("__repr__",
           [](const Region& r) { return "<Region of " + std::to_string(r.components().size()) + " components>"; });
}

}  // namespace findspace::python
