// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <pybind11/stl.h>

#include "arrays.h"
#include "findspace/phi.h"
#include "findspace/space_region.h"
#include "interruptible.h"
#include "numbers.h"

namespace findspace::python {
namespace {

Array vertices_of(const Surface& surface) {
  Array out({py::ssize_t(surface.vertices.size()), py::ssize_t(3)});
  double* to = out.mutable_data();
  for (const Position3& v : surface.vertices) to = std::copy(v.begin(), v.end(), to);
  return out;
}

py::array_t<bool> contains_rows(const SpaceRegion& region, const Array& at) {
  const std::span<const Position3> all = rows<Position3>(at, "positions");
  py::array_t<bool> out{py::ssize_t(all.size())};
  const std::span<bool> answers(out.mutable_data(), all.size());
  interruptible([&] {
    region.contains(all, answers);
    return true;
  });
  return out;
}

void bind_region(py::module_& m) {
  py::class_<SpaceRegion>(m, "SpaceRegion", R"doc(An exact set of positions in space, of boxes or one convex polytope.

Examples
--------
>>> import findspace as fs
>>> world = fs.World({"room": fs.Shape.box((0, 0, 0), (9, 9, 9)), "crate": fs.Shape.box((0, 0, 0), (2, 2, 2))}, "crate")
>>> region = world.solve("inside(crate, room)")
>>> region.volume, len(region.faces), (7, 7, 7) in region
(343.0, 6, True)
)doc")
      .def_property_readonly("empty", &SpaceRegion::empty, "Whether nothing belongs to it.")
      .def_property_readonly("whole", &SpaceRegion::whole, "All of space.")
      .def_property_readonly("bounded", &SpaceRegion::bounded, "Within some ball.")
      .def_property_readonly("open", &SpaceRegion::open, "As a point set of space.")
      .def_property_readonly("closed", &SpaceRegion::closed, "As a point set of space.")
      .def_property_readonly("volume", &SpaceRegion::volume, "None where it is unbounded.")
      .def_property_readonly(
          "bounds",
          [](const SpaceRegion& r) -> py::object {
            const auto b = r.bounds();
            return b ? py::object(py::make_tuple(b->low, b->high)) : py::none();
          },
          "(low, high); None where it is empty or unbounded.")
      .def_property_readonly("components", &SpaceRegion::components, "The number of connected parts.")
      .def_property_readonly(
          "vertices", [](const SpaceRegion& r) { return vertices_of(r.surface()); }, "Of its boundary, shape (n, 3).")
      .def_property_readonly(
          "faces", [](const SpaceRegion& r) { return r.surface().faces; },
          "Circuits of vertices, counter-clockwise seen from outside.")
      .def_property_readonly(
          "boxes",
          [](const SpaceRegion& r) {
            py::list out;
            for (const SpaceRegion::Box& b : r.boxes())
              out.append(py::make_tuple(b.low, b.high, b.low_belongs, b.high_belongs));
            return out;
          },
          "Disjoint boxes (low, high, low_belongs, high_belongs); none of a polytope.")
      .def_property_readonly("json", &SpaceRegion::json, "As `findspace map --json` writes it.")
      .def("contains", &contains_rows, py::arg("positions"), "Of each position, shape (n, 3), a bool. Exact.")
      .def(
          "__contains__", [](const SpaceRegion& r, const py::sequence& p) { return r.contains(point3(p)); },
          py::arg("position"));
}

template <std::size_t N>
py::tuple evaluated(const Phi& phi, const Array& at) {
  using Row = std::array<double, N>;
  const std::span<const Row> all = rows<Row>(at, "positions");
  Array values{py::ssize_t(all.size())}, gradients({py::ssize_t(all.size()), py::ssize_t(N)});
  const std::span<double> to(values.mutable_data(), all.size());
  const std::span<Row> steep(reinterpret_cast<Row*>(gradients.mutable_data()), all.size());
  interruptible([&] {
    phi.evaluate(all, to, steep);
    return true;
  });
  return py::make_tuple(values, gradients);
}

void bind_phi(py::module_& m) {
  py::class_<Phi::Value>(m, "PhiValue", "A Phi-function at a position.")
      .def_readonly("value", &Phi::Value::value, "What the gradient is of.")
      .def_readonly("normalised", &Phi::Value::normalised, "Outside it is the distance.")
      .def_property_readonly(
          "state",
          [](const Phi::Value& v) {
            static const char* const kStates[] = {"overlap", "contact", "apart"};
            return kStates[static_cast<int>(v.state)];
          },
          "'overlap', 'contact' or 'apart', exactly.")
      .def_readonly("gradient", &Phi::Value::gradient, "Of length 1, or 0 where it is not defined.")
      .def_readonly("pair", &Phi::Value::pair, "Which two convex parts are nearest.")
      .def_readonly("active", &Phi::Value::active, "Their facets that are highest.")
      .def("__float__", [](const Phi::Value& v) { return v.value; })
      .def("__repr__",
           [](const Phi::Value& v) { return "<PhiValue " + std::string(py::repr(py::cast(v.value))) + ">"; });
  py::class_<Phi>(m, "Phi", R"doc(The Phi-function of two shapes, of the translation of the second.

Negative where they overlap, 0 where they touch, positive where they are apart.

Parameters
----------
a : Shape
    It stands still.
b : Shape
    It moves.

Examples
--------
>>> import findspace as fs
>>> phi = fs.Phi(fs.Shape.box((0, 0), (4, 2)), fs.Shape.disc((0, 0), 1))
>>> phi((7, 1)).value, phi((7, 1)).gradient, phi((5, 1)).state
(2.0, [1.0, 0.0], 'contact')
>>> values, gradients = phi.evaluate([[7, 1], [2, 7]])
>>> values
array([2., 4.])
)doc")
      .def(py::init<const Shape&, const Shape&>(), py::arg("a"), py::arg("b"))
      .def(
          "__call__",
          [](const Phi& phi, const py::sequence& u) { return py::len(u) == 3 ? phi.at(point3(u)) : phi.at(point(u)); },
          py::arg("position"))
      .def(
          "evaluate",
          [](const Phi& phi, const Array& at) {
            return phi.dimension() == 3 ? evaluated<3>(phi, at) : evaluated<2>(phi, at);
          },
          py::arg("positions"), "(values, gradients) at each position, side by side.")
      .def(
          "compare",
          [](const Phi& phi, const py::sequence& u, const py::object& distance) {
            return py::len(u) == 3 ? phi.compare(point3(u), number(distance)) : phi.compare(point(u), number(distance));
          },
          py::arg("position"), py::arg("distance"), "The sign of the normalised form minus a distance, exactly.")
      .def_property_readonly("dimension", &Phi::dimension, "2 or 3.");
}

}  // namespace

void bind_space(py::module_& m) {
  bind_region(m);
  bind_phi(m);
}

}  // namespace findspace::python
