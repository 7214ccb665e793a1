// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <pybind11/operators.h>

#include "findspace/formula.h"
#include "numbers.h"

namespace findspace::python {

using namespace words;

namespace {

void bind_words(py::module_& m) {
  const auto word = [&](const char* name, Distance (*make)(std::string_view, std::string_view), const char* doc) {
    m.def(name, make, py::arg("a"), py::arg("b"), doc);
  };
  word("gap", gap, "Separation of two shapes, or minus the depth of penetration.");
  word("reach", reach, "The largest distance between points of the two.");
  word("margin", margin, "How far inside b the shape a is; negative where it is not.");
  word("cover", cover, "How far around b the shape a reaches; negative where it does not.");
  word("protrusion", protrusion, "The greatest distance of a point of a from b.");
  word("hausdorff", hausdorff, "The Hausdorff distance.");
  word("distance", distance, "The least distance between points of the two; 0 where they meet.");
  word("diameter", diameter, "The diameter of both together.");
  word("depth", depth, "The depth of penetration; 0 where the shapes do not overlap.");
}

void bind_predicates(py::module_& m) {
  m.def("overlaps", &overlaps, py::arg("a"), py::arg("b"), "gap < 0: the insides meet.");
  m.def("touches", &touches, py::arg("a"), py::arg("b"), "gap = 0: only boundaries meet.");
  m.def("disjoint", &disjoint, py::arg("a"), py::arg("b"), "gap > 0: no common point.");
  using Make = Formula (*)(std::string_view, std::string_view, const Level&);
  const auto taking = [](Make make) {
    return [make](std::string_view a, std::string_view b, const py::object& l) { return make(a, b, level(l)); };
  };
  const auto with_level = [&](const char* name, Make make, const char* doc) {
    m.def(name, taking(make), py::arg("a"), py::arg("b"), py::arg("level") = 0, doc);
  };
  const auto needs_level = [&](const char* name, Make make, const char* doc) {
    m.def(name, taking(make), py::arg("a"), py::arg("b"), py::arg("level"), doc);
  };
  with_level("clear", clear, "gap >= level: at least so far apart; touching is allowed at 0.");
  with_level("inside", inside, "margin >= level: a inside b with so much to spare; touching is allowed at 0.");
  with_level("covers", covers, "cover >= level: a around b with so much to spare.");
  with_level("keepout", keepout, "gap >= level: a stays out of b, and so far away from it.");
  needs_level("within", within, "gap <= level: at most so far apart.");
  needs_level("near", near, "gap <= level: at most so far apart.");
  needs_level("far", far, "gap >= level: at least so far apart.");
  needs_level("group", group, "diameter <= level: both together at most so far across.");
}

}  // namespace

void bind_formulas(py::module_& m) {
  py::class_<Formula>(m, "Formula", "A formula of the formula language, as text or put together with & | ~.")
      .def(py::init<std::string>(), py::arg("text"))
      .def_property_readonly("text", &Formula::text, "In the formula language.")
      .def("__and__", [](const Formula& a, const Formula& b) { return a && b; })
      .def("__or__", [](const Formula& a, const Formula& b) { return a || b; })
      .def("__invert__", [](const Formula& a) { return !a; })
      .def("__bool__",
           [](const Formula&) -> bool { throw py::type_error("combine formulas with & | ~, not with and, or, not"); })
      .def("__str__", &Formula::text)
      .def("__repr__", [](const Formula& f) { return "Formula(" + std::string(py::repr(py::str(f.text()))) + ")"; })
      .def(py::pickle([](const Formula& f) { return py::make_tuple(f.text()); },
                      [](const py::tuple& t) { return Formula(t[0].cast<std::string>()); }));
  py::implicitly_convertible<std::string, Formula>();
  py::class_<Distance>(m, "Distance", "A distance of two shapes; comparing it with a level makes a Formula.")
      .def(py::init<std::string_view, std::string_view, std::string_view>(), py::arg("word"), py::arg("first"),
           py::arg("second"))
      .def_property_readonly("text", &Distance::text, "In the formula language.")
      .def(
          "along", [](const Distance& d, const py::sequence& v) { return d.along(point(v)); }, py::arg("direction"),
          "Moved both ways along a direction.")
      .def(
          "toward", [](const Distance& d, const py::sequence& v) { return d.toward(point(v)); }, py::arg("direction"),
          "Moved one way.")
      .def(
          "rotating", [](const Distance& d, const py::sequence& v) { return d.rotating(point(v)); }, py::arg("about"),
          "Rotated about a point; the value is in degrees.")
      .def("inf", &Distance::inf, "The least value over the time of a motion.")
      .def("sup", &Distance::sup, "The greatest value over the time of a motion.")
      .def("minimal", &Distance::minimal, "The positions of the least value.")
      .def("__lt__", [](const Distance& d, const py::object& l) { return d < level(l); })
      .def("__le__", [](const Distance& d, const py::object& l) { return d <= level(l); })
      .def("__eq__", [](const Distance& d, const py::object& l) { return d == level(l); })
      .def("__ne__", [](const Distance& d, const py::object& l) { return d != level(l); })
      .def("__ge__", [](const Distance& d, const py::object& l) { return d >= level(l); })
      .def("__gt__", [](const Distance& d, const py::object& l) { return d > level(l); })
      .def(py::pickle([](const Distance& d) { return py::make_tuple(d.text()); },
                      [](const py::tuple& t) { return Distance(t[0].cast<std::string>()); }))
      .def("__str__", &Distance::text)
      .def("__repr__", [](const Distance& d) { return "<Distance " + d.text() + ">"; });
  bind_words(m);
  bind_predicates(m);
}

}  // namespace findspace::python
