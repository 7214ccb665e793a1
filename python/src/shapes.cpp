// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <pybind11/stl.h>

#include "arrays.h"
#include "findspace/region.h"
#include "findspace/shape.h"
#include "interruptible.h"
#include "numbers.h"

namespace findspace::python {
namespace {

const char* const kStep = "0.000001";

Shape polygon(const Doubles& ring, const std::vector<Doubles>& holes, const py::object& step) {
  std::vector<std::span<const Position>> inner;
  for (const Doubles& hole : holes) inner.push_back(positions(hole, "holes"));
  return Shape::polygon(positions(ring, "the vertices of a ring"), inner, grid(step));
}

py::list polygons(const py::object& rings, const py::object& step) {
  std::vector<Doubles> held;
  std::vector<std::span<const Position>> spans;
  if (py::isinstance<py::array>(rings) && rings.cast<py::array>().ndim() == 3) {
    const Array& all = held.emplace_back(rings.cast<Array>());
    if (all.shape(2) != 2) throw py::value_error("rings have the shape (k, n, 2)");
    const auto* first = reinterpret_cast<const Position*>(all.data());
    const std::size_t corners = std::size_t(all.shape(1));
    for (std::size_t k = 0; k < std::size_t(all.shape(0)); ++k) spans.emplace_back(first + k * corners, corners);
  } else {
    held = rings.cast<std::vector<Doubles>>();
    for (const Doubles& ring : held) spans.push_back(positions(ring, "the vertices of a ring"));
  }
  const Grid on = grid(step);
  std::vector<Shape> made = interruptible([&] { return Shape::polygons(spans, on); });
  py::list out(made.size());
  for (std::size_t k = 0; k < made.size(); ++k) out[k] = std::move(made[k]);
  return out;
}

/// What an arc is given by; what it has besides is refused.
std::string way_of_arc(const py::dict& arc) {
  std::string way;
  for (const auto& [key, value] : arc) {
    const std::string name = py::str(key);
    if (name == "to" || (name == "ccw" && arc.contains("center"))) continue;
    if (name != "bulge" && name != "through" && name != "center")
      throw py::value_error("an arc to a point has no \"" + name + "\"");
    if (!way.empty()) throw py::value_error("an arc has \"" + way + "\" or \"" + name + "\", not both");
    way = name;
  }
  if (way.empty()) throw py::value_error("an arc has \"bulge\", \"through\" or \"center\"");
  return way;
}

/// A list of steps: (x, y) is a segment; a dict with "to" and "bulge", "through", or "center" an arc.
Contour contour(const py::list& steps) {
  if (steps.empty()) throw py::value_error("a contour needs points");
  Contour out(point(steps[0]));
  for (std::size_t k = 1; k < steps.size(); ++k) {
    if (!py::isinstance<py::dict>(steps[k])) {
      out.line_to(point(steps[k]));
      continue;
    }
    const py::dict arc = steps[k];
    const std::string way = way_of_arc(arc);
    const Point end = point(arc["to"]);
    if (way == "bulge")
      out.bulge_to(number(arc["bulge"]), end);
    else if (way == "through")
      out.arc_through(point(arc["through"]), end);
    else
      out.arc_about(point(arc["center"]), end, !arc.contains("ccw") || arc["ccw"].cast<bool>());
  }
  return out;
}

Shape box(const py::sequence& low, const py::sequence& high, const py::object& step) {
  if (py::len(low) == 3) return Shape::box(point3(low), point3(high), grid(step));
  return Shape::box(point(low), point(high), grid(step));
}

Shape height_field(const Doubles& heights, const py::sequence& step, const py::object& floor, const py::sequence& at,
                   std::optional<double> missing, const py::object& on) {
  if (heights.ndim() != 2) throw py::value_error("heights have the shape (rows, columns)");
  const std::span<const double> all(heights.data(), std::size_t(heights.size()));
  return Shape::height_field({all, std::size_t(heights.shape(1)), point(step), number(floor), point(at), missing},
                             grid(on));
}

void bind_makers(py::class_<Shape>& shape) {
  shape
      .def_static("polygon", &polygon, py::arg("ring"), py::arg("holes") = py::list(), py::arg("grid") = kStep,
                  R"doc(The closed set within a ring and outside its holes.

Parameters
----------
ring : array_like, shape (n, 2)
    A simple ring, either way round; the first point may be repeated at the end.
holes : list of array_like
    Rings inside it, whose insides are left out.
grid : number
    Coordinates are rounded to multiples of it, once.

Raises
------
Error
    Where a ring crosses itself or another, with ring and vertex.

Examples
--------
>>> import findspace as fs
>>> fs.Shape.polygon([[0, 0], [4, 0], [4, 3]]).region.area
6.0
)doc")
      .def_static("polygons", &polygons, py::arg("rings"), py::arg("grid") = kStep,
                  R"doc(A polygon of each ring, on all threads: the quick way to make thousands.

Parameters
----------
rings : array_like, shape (k, n, 2), or sequence of array_like, shape (n, 2)
grid : number
    As of polygon.

Raises
------
Error
    Its place begins with "polygon K".

Examples
--------
>>> import findspace as fs
>>> [s.region.area for s in fs.Shape.polygons([[[0, 0], [4, 0], [4, 3]], [[0, 0], [2, 0], [2, 2], [0, 2]]])]
[6.0, 4.0]
)doc")
      .def_static(
          "contour",
          [](const py::list& ring, const std::vector<py::list>& holes, const py::object& step) {
            std::vector<Contour> inner;
            for (const py::list& hole : holes) inner.push_back(contour(hole));
            return Shape::polygon(contour(ring), inner, grid(step));
          },
          py::arg("ring"), py::arg("holes") = std::vector<py::list>(), py::arg("grid") = kStep,
          R"doc(As polygon, of rings with arcs.

A ring is a list of points. An arc to a point is a dict with "to" and one of "bulge" (tan of a quarter of its angle),
"through" (a third point) or "center" (and "ccw", True by default).

Examples
--------
>>> import findspace as fs
>>> half = fs.Shape.contour([(-1, 0), {"to": (1, 0), "center": (0, 0)}, (-1, 0)])
>>> round(half.region.area, 6)
1.570796
)doc")
      .def_static(
          "disc",
          [](const py::sequence& center, const py::object& radius, const py::object& step) {
            return Shape::disc(point(center), number(radius), grid(step));
          },
          py::arg("center"), py::arg("radius"), py::arg("grid") = kStep, "The closed disc.")
      .def_static("box", &box, py::arg("min"), py::arg("max"), py::arg("grid") = kStep,
                  "The closed box between two corners, of the plane or of space.")
      .def_static(
          "points",
          [](const Doubles& at, const py::object& step) { return Shape::points(positions(at, "points"), grid(step)); },
          py::arg("points"), py::arg("grid") = kStep, "Isolated points, shape (n, 2).")
      .def_static(
          "polyline",
          [](const Doubles& at, const py::object& step) {
            return Shape::polyline(positions(at, "points"), grid(step));
          },
          py::arg("points"), py::arg("grid") = kStep, "A chain of closed segments, a set without inside.")
      .def_static(
          "path", [](std::string_view data, const py::object& step) { return Shape::path(data, grid(step)); },
          py::arg("data"), py::arg("grid") = kStep, "SVG path data of M L H V A C S Q T Z; y points upwards.")
      .def_static(
          "file", [](const std::string& path, const py::object& step) { return Shape::file(path, grid(step)); },
          py::arg("path"), py::arg("grid") = kStep,
          "A drawing (SVG, DXF, WKT, GeoJSON) a mesh (STL, OBJ, PLY, 3MF), or STEP or IGES.")
      .def_static(
          "json", [](std::string_view text, const py::object& step) { return Shape::json(text, grid(step)); },
          py::arg("text"), py::arg("grid") = kStep, "What a scene file would say of a shape.");
}

void bind_solids(py::class_<Shape>& shape) {
  shape
      .def_static(
          "polytope",
          [](const Doubles& points, const py::object& step) {
            return Shape::polytope(rows<Position3>(points, "points"), grid(step));
          },
          py::arg("points"), py::arg("grid") = kStep, "The convex hull of points of space, shape (n, 3).")
      .def_static(
          "ball",
          [](const py::sequence& center, const py::object& radius, const py::object& step) {
            return Shape::ball(point3(center), number(radius), grid(step));
          },
          py::arg("center"), py::arg("radius"), py::arg("grid") = kStep, "The closed ball.")
      .def_static(
          "prism",
          [](const Shape& base, const py::object& low, const py::object& high) {
            return Shape::prism(base, number(low), number(high));
          },
          py::arg("polygon"), py::arg("low"), py::arg("high"), "A polygon of the plane between two heights.")
      .def_static("height_field", &height_field, py::arg("heights"), py::arg("step"), py::arg("floor"),
                  py::arg("at") = py::make_tuple(0, 0), py::arg("missing") = py::none(), py::arg("grid") = kStep,
                  R"doc(Ground: the solid between a grid of heights and a flat floor.

Parameters
----------
heights : array_like, shape (rows, columns)
    The height `heights[j][i]` stands at `(at[0] + i * step[0], at[1] + j * step[1])`.
step : pair of numbers
    From a column to the next, and from a row to the next.
floor : number
    Below all heights.
at : pair of numbers
    Where the first height stands.
missing : float, optional
    What stands for a height that is missing, such as `nan`: there is nothing over squares with such a corner.
grid : number
    Coordinates are rounded to multiples of it, once.

A square of four heights is two triangles; its diagonal goes from the corner of least x and y to that of greatest.

Examples
--------
>>> import findspace as fs
>>> ground = fs.Shape.height_field([[1, 1, 1], [1, 2, 1], [1, 1, 1]], step=(5, 5), floor=0)
>>> len(ground.surface.vertices)
17
)doc")
      .def_static(
          "mesh",
          [](const Doubles& vertices, const WholeNumbers& faces, const py::object& step) {
            using Triangle = std::array<std::int32_t, 3>;
            return Shape::mesh(rows<Position3>(vertices, "vertices"), rows<Triangle>(faces, "faces"), grid(step));
          },
          py::arg("vertices"), py::arg("faces"), py::arg("grid") = kStep,
          "What a closed surface encloses: vertices of shape (n, 3), triangles of shape (m, 3).");
}

void bind_operations(py::class_<Shape>& shape) {
  shape.def("__or__",
            [](const Shape& a, const Shape& b) {
              return Shape::unite({a, b});
            })
      .def("__and__",
           [](const Shape& a, const Shape& b) {
             return Shape::intersect({a, b});
           })
      .def("__sub__",
           [](const Shape& a, const Shape& b) {
             return Shape::subtract({a, b});
           })
      .def("__invert__", [](const Shape& a) { return Shape::complement(a); })
      .def_static(
          "collection",
          [](const py::dict& parts) {
            std::vector<std::pair<std::string, Shape>> all;
            for (const auto& [name, part] : parts) all.emplace_back(name.cast<std::string>(), part.cast<Shape>());
            return Shape::collection(all);
          },
          py::arg("parts"), "The union of parts by name, which keep their names in witnesses.")
      .def_static("unite", &Shape::unite, py::arg("shapes"), "What belongs to any of them.")
      .def_static("intersect", &Shape::intersect, py::arg("shapes"), "What belongs to all of them.")
      .def_static("subtract", &Shape::subtract, py::arg("shapes"), "The first without the others.")
      .def_static("minkowski_sum", &Shape::minkowski_sum, py::arg("a"), py::arg("b"), "{a + b}")
      .def_static("minkowski_difference", &Shape::minkowski_difference, py::arg("a"), py::arg("b"),
                  "The intersection of all a + q, q in b.")
      .def(
          "complement", [](const Shape& s) { return Shape::complement(s); }, "What does not belong to it.")
      .def(
          "interior", [](const Shape& s) { return Shape::interior(s); },
          "Its points with a disc or ball around them in it.")
      .def(
          "closure", [](const Shape& s) { return Shape::closure(s); }, "With all of its boundary.")
      .def(
          "boundary", [](const Shape& s) { return Shape::boundary(s); }, "The closure without the interior.")
      .def(
          "regularized", [](const Shape& s) { return Shape::regularize(s); }, "The closure of the interior.")
      .def(
          "hull", [](const Shape& s) { return Shape::hull(s); }, "The convex hull.")
      .def(
          "reflected", [](const Shape& s) { return Shape::reflect(s); }, "Reflected through the origin.")
      .def(
          "offset", [](const Shape& s, const py::object& radius) { return Shape::offset(s, number(radius)); },
          py::arg("radius"), "All points no farther than the radius from it, with true arcs; eroded if negative.")
      .def(
          "translated",
          [](const Shape& s, const py::sequence& by) {
            return py::len(by) == 3 ? s.translated(point3(by)) : s.translated(point(by));
          },
          py::arg("by"), "Moved by (x, y), or (x, y, z).")
      .def(
          "rotated",
          [](const Shape& s, const py::object& degrees, const py::object& about, const std::string& axis) {
            const auto center = [&] {
              return about.is_none() ? py::sequence(py::make_tuple(0, 0, 0)) : py::sequence(about);
            };
            if (s.dimension() == 2)
              return s.rotated(number(degrees), about.is_none() ? Point{0, 0} : point(py::sequence(about)));
            if (axis != "x" && axis != "y" && axis != "z") throw py::value_error("axis is 'x', 'y' or 'z'");
            return s.rotated(number(degrees), Shape::Axis(axis[0] - 'x'), point3(center()));
          },
          py::arg("degrees"), py::arg("about") = py::none(), py::arg("axis") = "z",
          "Counter-clockwise about a point, in space about an axis through it; exact for multiples of 90 degrees, else "
          "each vertex is rounded once.");
}

}  // namespace

void bind_shapes(py::module_& m) {
  py::class_<Shape> shape(m, "Shape",
                          "A point set of the plane or of space, given by exact decimal numbers on a grid. Immutable.");
  bind_makers(shape);
  bind_solids(shape);
  bind_operations(shape);
  shape.def_property_readonly("dimension", &Shape::dimension, "2 or 3.")
      .def_property_readonly(
          "grid", [](const Shape& s) { return s.grid().step.text(); }, "The step of its grid, as text.")
      .def_property_readonly(
          "rounded_points", [](const Shape& s) { return s.rounded().points; },
          "How many points given were off the grid.")
      .def_property_readonly(
          "largest_move", [](const Shape& s) { return s.rounded().largest; },
          "How far the farthest of these was moved.")
      .def_property_readonly(
          "rotated_points",
          [](const Shape& s) {
            const Shape::Rounded rounded = s.rotated_points();
            return std::make_pair(rounded.points, rounded.largest);
          },
          "(points, largest): vertices that rotations put on the grid, and how far the farthest was moved; of the "
          "plane.")
      .def_property_readonly("exact_json", &Shape::exact_json, "The set as text that `Shape.json` brings back.")
      .def_property_readonly(
          "region", [](const Shape& s) { return s.region(); }, py::call_guard<py::gil_scoped_release>(),
          "The set itself; of the plane only.")
      .def_property_readonly("surface", &Shape::surface, "Of space: the boundary, where flat faces bound one solid.")
      .def("drawn_surface", &Shape::drawn_surface, py::arg("lines") = 48,
           "Of space: how it looks: what is unbounded is left open, what has no volume left out, and what has other "
           "faces "
           "is as found on so many lines each way; with 0 lines there are no faces of it.")
      .def_property_readonly("svg", &Shape::svg, "A drawing in true size, or a view of a solid.")
      .def(py::init<const Region&>(), py::arg("region"))
      .def(py::pickle(
          [](const Shape& s) { return py::make_tuple(s.exact_json(), s.grid().step.text()); },
          [](const py::tuple& t) { return Shape::json(t[0].cast<std::string>(), {Number(t[1].cast<std::string>())}); }))
      .def("__repr__", [](const Shape& s) { return s.dimension() == 2 ? "<Shape of the plane>" : "<Shape of space>"; });
}

}  // namespace findspace::python
