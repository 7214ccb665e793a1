// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <pybind11/operators.h>
#include <pybind11/stl.h>

#include "arrays.h"
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
  return {e, s.forward ? a : b, s.forward ? b : a, s.forward};
}

py::array_t<bool> contains(const Region& region, const Doubles& at) {
  const std::span<const Position> all = positions(at);
  py::array_t<bool> out(py::ssize_t(all.size()));
  const std::span<bool> answers(out.mutable_data(), all.size());
  const py::gil_scoped_release release;
  region.contains(all, answers);
  return out;
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
      .def_readonly("counterclockwise", &EdgeOf::ccw, "Which way an arc is met.")
      .def(py::pickle(
          [](const EdgeOf& e) {
            return py::make_tuple(e.start, e.end, e.ccw, e.edge.belongs, e.edge.arc, e.edge.center, e.edge.radius,
                                  e.edge.angle);
          },
          [](const py::tuple& t) {
            EdgeOf out{{}, t[0].cast<Position>(), t[1].cast<Position>(), t[2].cast<bool>()};
            out.edge.belongs = t[3].cast<bool>();
            out.edge.arc = t[4].cast<bool>();
            out.edge.center = t[5].cast<Position>();
            out.edge.radius = t[6].cast<double>();
            out.edge.angle = t[7].cast<double>();
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
      .def(py::pickle([](const ComponentOf& c) { return py::make_tuple(c.region, c.index); },
                      [](const py::tuple& t) {
                        return ComponentOf{t[0].cast<Region>(), t[1].cast<std::size_t>()};
                      }));
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
          py::arg("radius"), "Grown by the closed disc, eroded if negative.");
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
          "bounds",
          [](const Region& r) -> py::object {
            const auto b = r.bounds();
            if (!b) return py::none();
            return py::make_tuple(b->low[0], b->low[1], b->high[0], b->high[1]);
          },
          "(min x, min y, max x, max y), or None.")
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
          "sample",
          [](const Region& r, std::size_t n, const std::optional<Options>& options, const py::kwargs& words) {
            const Options asked = options_of(options, words);
            return array_of(interruptible([&] { return r.sample(n, asked); }));
          },
          py::arg("count"), py::arg("options") = py::none(),
          "Random points of the inside, shape (count, 2): the same for the same `seed` of the options.")
      .def(
          "flattened",
          [](const Region& r, double bound, bool outside) {
            std::vector<Array> out;
            for (const auto& ring : r.flattened(bound, outside ? Region::Towards::kOutside : Region::Towards::kInside))
              out.push_back(array_of(ring));
            return out;
          },
          py::arg("bound"), py::arg("outside") = false,
          "Rings as points, arcs cut into chords no farther than `bound` from them, within the set or around it.")
      .def(
          "geojson",
          [](const Region& r, double bound, const std::string& side) {
            using Towards = Region::Towards;
            const std::map<std::string, Towards> sides{
                {"inside", Towards::kInside}, {"outside", Towards::kOutside}, {"on_arcs", Towards::kOnArcs}};
            const auto found = sides.find(side);
            if (found == sides.end()) throw py::value_error("side is 'inside', 'outside' or 'on_arcs'");
            return r.geojson(bound, found->second);
          },
          py::arg("bound"), py::arg("side") = "on_arcs",
          "The closure as GeoJSON, as text. No chord is farther than `bound` from its arc; corners lie within the set, "
          "outside of it, or on the arcs.");
}

}  // namespace

void bind_regions(py::module_& m) {
  bind_parts(m);
  py::class_<Region> region(m, "Region", "An exact set of the plane; every vertex, edge and face belongs or not.");
  bind_questions(region);
  bind_sets(region);
  region.def_property_readonly("json", &Region::json, "As `findspace map --json` writes it.")
      .def_property_readonly("exact_json", &Region::exact_json, "As a shape of a scene, exactly.")
      .def_property_readonly("wkt", &Region::wkt, "Closed sets only: what is open is lost.")
      .def_property_readonly("svg", &Region::svg, "A drawing in true size.")
      .def(py::pickle([](const Region& r) { return py::make_tuple(r.exact_json(), Shape(r).grid().step.text()); },
                      [](const py::tuple& t) {
                        return Shape::json(t[0].cast<std::string>(), {Number(t[1].cast<std::string>())}).region();
                      }))
      .def("__repr__",
           [](const Region& r) { return "<Region of " + std::to_string(r.components().size()) + " components>"; });
}

}  // namespace findspace::python
