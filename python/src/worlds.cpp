// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <pybind11/stl.h>

#include "arrays.h"
#include "findspace/world.h"
#include "numbers.h"

namespace findspace::python {
namespace {

py::array_t<bool> holds(const Query& query, const Array& at) {
  const std::span<const Position> all = positions(at);
  py::array_t<bool> out(py::ssize_t(all.size()));
  const std::span<bool> answers(out.mutable_data(), all.size());
  const py::gil_scoped_release release;
  query.holds(all, answers);
  return out;
}

void bind_query(py::module_& m) {
  py::class_<Query>(m, "Query", "A formula over a world, to be asked at many positions.")
      .def("holds", &holds, py::arg("positions"), "Of each position, shape (n, 2), a bool. Exact; uses all threads.")
      .def(py::pickle([](const Query& q) { return py::make_tuple(q.world(), q.formula().text()); },
                      [](const py::tuple& t) { return t[0].cast<World>().query(t[1].cast<std::string>()); }))
      .def_property_readonly("region", &Query::region, py::call_guard<py::gil_scoped_release>(),
                             "{p : the formula holds at p}.")
      .def(
          "nearest",
          [](const Query& q, const Position& from) -> py::object {
            const auto found = q.nearest(from);
            return found ? py::object(py::make_tuple(found->at, found->distance, found->attained)) : py::none();
          },
          py::arg("from_"), "(position, distance, attained) of the nearest feasible position, or None.");
}

}  // namespace

void bind_worlds(py::module_& m) {
  py::class_<DistanceValue>(m, "DistanceValue", "The value of a distance at a position.")
      .def_readonly("value", &DistanceValue::value, "None: undefined, +infinity.")
      .def_readonly("witness", &DistanceValue::witness)
      .def("__repr__",
           [](const DistanceValue& d) { return "<DistanceValue " + std::string(py::str(py::cast(d.value))) + ">"; });
  py::class_<Optimum>(m, "Optimum", "The least value of an objective over a region.")
      .def_readonly("value", &Optimum::value)
      .def_readonly("attained", &Optimum::attained)
      .def_readonly("at", &Optimum::at);
  bind_query(m);
  py::class_<World>(m, "World", R"doc(Named shapes, one of which moves by a translation p.

Examples
--------
>>> import findspace as fs
>>> world = fs.World({"A": fs.Shape.box((0, 0), (10, 10)), "B": fs.Shape.box((-1, -1), (1, 1))}, moving="B")
>>> world.solve("inside(B, A)").area
64.0
>>> world.distance("gap(B, A)", (14, 5)).value
3.0
)doc")
      .def(py::init([](const std::map<std::string, Shape>& shapes, const std::string& moving, const std::string& unit) {
             return World(shapes, moving, {unit});
           }),
           py::arg("shapes"), py::arg("moving"), py::arg("unit") = "", py::call_guard<py::gil_scoped_release>())
      .def(py::pickle([](const World& w) { return py::make_tuple(w.shapes(), w.moving(), w.unit()); },
                      [](const py::tuple& t) {
                        return World(t[0].cast<std::map<std::string, Shape>>(), t[1].cast<std::string>(),
                                     {t[2].cast<std::string>()});
                      }))
      .def("solve", &World::solve, py::arg("formula"), py::call_guard<py::gil_scoped_release>(),
           "{p : the formula holds at p}, exactly.")
      .def("query", &World::query, py::arg("formula"), "The formula, ready for many positions.")
      .def(
          "holds", [](const World& w, const Formula& f, const py::sequence& p) { return w.holds(f, point(p)); },
          py::arg("formula"), py::arg("position"), "Whether p is feasible, exactly, without making the region.")
      .def(
          "distance", [](const World& w, std::string_view d, const py::sequence& p) { return w.distance(d, point(p)); },
          py::arg("distance"), py::arg("position"), "The value of a distance and its witness.")
      .def("minimize", &World::minimize, py::arg("objective"), py::arg("formula") = Formula("true"),
           "The least value of an objective where the formula holds.")
      .def("shape", &World::shape, py::arg("name"), "A shape as a region.");
}

}  // namespace findspace::python
