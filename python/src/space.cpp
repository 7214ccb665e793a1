// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <pybind11/stl.h>

#include "arrays.h"
#include "findspace/phi.h"
#include "findspace/space_region.h"
#include "findspace/world.h"
#include "interruptible.h"
#include "numbers.h"
#include "pickles.h"
#include "surfaces.h"

namespace findspace::python {
namespace {

py::array_t<bool> contains_rows(const SpaceRegion& region, const Doubles& at) {
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
      .def_property_readonly("surface", &SpaceRegion::surface, "Its boundary, as a Surface.")
      .def(
          "thin",
          [](const SpaceRegion& r, const Position3& low, const Position3& high) {
            const SpaceRegion::Thin thin = r.thin({low, high});
            return py::make_tuple(thin.sheets, thin.curves, thin.points);
          },
          py::arg("low"), py::arg("high"),
          "What it has without volume: (sheets, curves, points) by their corners; cut off at the box from low to high.")
      .def_property_readonly("svg", &SpaceRegion::svg, "Its boundary, seen from the side.")
      .def_property_readonly(
          "form", [](const SpaceRegion& r) { return r.form() == SpaceRegion::Form::kBoxes ? "boxes" : "convex"; },
          "What it is made of: 'boxes' or 'convex'.")
      .def_property_readonly("query", &SpaceRegion::query, "What it answers: the formula over its world.")
      .def_property_readonly(
          "question",
          [](const SpaceRegion& r) {
            const SpaceQuestion& q = r.question();
            return py::dict(py::arg("apply") = q.apply, py::arg("minimize") = q.minimize,
                            py::arg("maximize") = q.maximize);
          },
          "What it is of those positions: the words of World.solve_space.")
      .def(py::pickle(
          [](const SpaceRegion& r) {
            const SpaceQuestion& q = r.question();
            return py::make_tuple(r.query().world(), r.query().text(), q.apply, q.minimize, q.maximize);
          },
          [](const py::tuple& t) {
            return t[0].cast<World>().solve_space(
                t[1].cast<std::string>(),
                {t[2].cast<std::string>(), t[3].cast<std::string>(), t[4].cast<std::string>()});
          }))
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

template <std::size_t N, class Function>
py::tuple evaluated(const Function& phi, const Array& at) {
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

void bind_adjusted(py::module_& m, py::class_<Phi>& phi) {
  using Value = AdjustedPhi::Value;
  using Limit = AdjustedPhi::Limit;
  py::class_<Value>(m, "AdjustedPhiValue", "A Phi-function that is adjusted for a limit, at a position.")
      .def_readonly("value", &Value::value, "Not negative where the limit is kept.")
      .def_readonly("sign", &Value::sign, "-1, 0 or 1, exactly.")
      .def_readonly("gradient", &Value::gradient, "Of length 1, or 0 where it is not defined.")
      .def("__float__", [](const Value& v) { return v.value; })
      .def(pickled<Value>(&Value::value, &Value::sign, &Value::gradient))
      .def("__repr__",
           [](const Value& v) { return "<AdjustedPhiValue " + std::string(py::repr(py::cast(v.value))) + ">"; });
  py::class_<AdjustedPhi>(m, "AdjustedPhi", R"doc(A Phi-function adjusted for a limit of the distance.

`Phi.at_least` and `Phi.at_most` make it: the distance minus the limit, or the limit minus the distance. Inside, the
distance is the normalised form.
)doc")
      .def(
          "__call__",
          [](const AdjustedPhi& f, const py::sequence& u) {
            return py::len(u) == 3 ? f.at(point3(u)) : f.at(point(u));
          },
          py::arg("position"))
      .def(
          "evaluate",
          [](const AdjustedPhi& f, const Doubles& at) {
            return f.phi().dimension() == 3 ? evaluated<3>(f, at) : evaluated<2>(f, at);
          },
          py::arg("positions"), "(values, gradients) at each position, side by side.")
      .def_property_readonly("phi", &AdjustedPhi::phi, "What is adjusted.")
      .def_property_readonly(
          "limit", [](const AdjustedPhi& f) { return f.limit() == Limit::kLeast ? "least" : "greatest"; },
          "'least' or 'greatest'.")
      .def_property_readonly(
          "distance", [](const AdjustedPhi& f) { return f.distance().text(); }, "The limit, as text.")
      .def(py::pickle(
          [](const AdjustedPhi& f) { return py::make_tuple(f.phi(), int(f.limit()), f.distance().text()); },
          [](const py::tuple& t) { return AdjustedPhi(t[0].cast<Phi>(), Limit(t[1].cast<int>()), number(t[2])); }));
  phi.def(
         "at_least", [](const Phi& f, const py::object& distance) { return f.at_least(number(distance)); },
         py::arg("distance"), R"doc(The function adjusted for a least distance: not negative where the shapes keep it.

Examples
--------
>>> import findspace as fs
>>> phi = fs.Phi(fs.Shape.box((0, 0), (4, 2)), fs.Shape.box((0, 0), (1, 1)))
>>> phi.at_least(5)((7, 6)).value, phi.at_least(5)((7, 6)).gradient, phi.at_most(5)((7, 6)).sign
(0.0, [0.6, 0.8], 0)
)doc")
      .def(
          "at_most", [](const Phi& f, const py::object& distance) { return f.at_most(number(distance)); },
          py::arg("distance"), "The function adjusted for a greatest distance; overlap keeps it too.");
}

std::pair<std::size_t, double> told(const Shape::Rounded& rounded) { return {rounded.points, rounded.largest}; }

void bind_phi_text(py::class_<Phi>& phi) {
  phi.def(
      "text",
      [](const Phi& f, const std::string& ending, const std::optional<py::sequence>& position, const py::object& least,
         const py::object& greatest, std::string a, std::string b, std::string unit) {
        PhiQuestion question{std::move(a), std::move(b), std::move(unit), {}, amount(least), amount(greatest)};
        if (position)
          for (const py::object& coordinate : *position) question.at.push_back(number(coordinate));
        return py::bytes(interruptible([&] { return f.text(ending, question); }));
      },
      py::arg("ending"), py::arg("position") = py::none(), py::arg("least") = py::none(),
      py::arg("greatest") = py::none(), py::arg("a") = "A", py::arg("b") = "B", py::arg("unit") = "",
      R"doc(As `findspace phi` writes it, in bytes.

Parameters
----------
ending : str
    '.json' and '.txt' have all parts and lines or planes, and the value at the position; '.svg' is a picture of the
    positions of overlap, or in space of the surface of contact, which '.obj', '.off' and '.stl' are too.
position : (x, y) or (x, y, z), optional
    Where the second shape is translated to.
least, greatest : number, optional
    A least and a greatest distance that are allowed there.
a, b : str
    Names of the shapes.
unit : str
    Of them, or ''.

Raises
------
Error
    Of code 'unsupported' for other endings, and for such a surface of a ball; 'bad value' for a position with another
    number of coordinates, or a negative distance.

Examples
--------
>>> import findspace as fs
>>> phi = fs.Phi(fs.Shape.box((0, 0), (4, 2)), fs.Shape.box((0, 0), (1, 1)))
>>> phi.parts_of_a, phi.text(".svg")[:4]
(1, b'<svg')
)doc");
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
      .def_readonly("normalised_gradient", &Phi::Value::normalised_gradient, "That of `normalised`.")
      .def_readonly("pair", &Phi::Value::pair, "Which two convex parts are nearest.")
      .def_readonly("active", &Phi::Value::active, "Their facets that are highest.")
      .def("__float__", [](const Phi::Value& v) { return v.value; })
      .def(pickled<Phi::Value>(&Phi::Value::value, &Phi::Value::normalised, &Phi::Value::state, &Phi::Value::gradient,
                               &Phi::Value::normalised_gradient, &Phi::Value::pair, &Phi::Value::active))
      .def("__repr__",
           [](const Phi::Value& v) { return "<PhiValue " + std::string(py::repr(py::cast(v.value))) + ">"; });
  py::class_<Phi> phi(m, "Phi", R"doc(The Phi-function of two shapes, of the translation of the second.

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
)doc");
  phi.def(py::init<const Shape&, const Shape&>(), py::arg("a"), py::arg("b"))
      .def(
          "__call__",
          [](const Phi& phi, const py::sequence& u) { return py::len(u) == 3 ? phi.at(point3(u)) : phi.at(point(u)); },
          py::arg("position"))
      .def(
          "evaluate",
          [](const Phi& phi, const Doubles& at) {
            return phi.dimension() == 3 ? evaluated<3>(phi, at) : evaluated<2>(phi, at);
          },
          py::arg("positions"), "(values, gradients) at each position, side by side.")
      .def(
          "compare",
          [](const Phi& phi, const py::sequence& u, const py::object& distance) {
            return py::len(u) == 3 ? phi.compare(point3(u), number(distance)) : phi.compare(point(u), number(distance));
          },
          py::arg("position"), py::arg("distance"), "The sign of the normalised form minus a distance, exactly.")
      .def_property_readonly("a", &Phi::a, "The shape that stands still.")
      .def_property_readonly("b", &Phi::b, "The shape that moves.")
      .def(py::pickle([](const Phi& phi) { return py::make_tuple(phi.a(), phi.b()); },
                      [](const py::tuple& t) { return Phi(t[0].cast<Shape>(), t[1].cast<Shape>()); }))
      .def_property_readonly(
          "form", [](const Phi& phi) { return phi.form() == Phi::Form::kParts ? "parts" : "curves"; },
          "'parts': all convex parts of both; 'curves': the curves of contact, with nothing active.")
      .def_property_readonly("dimension", &Phi::dimension, "2 or 3.")
      .def_property_readonly("parts_of_a", &Phi::parts_of_a, "How many convex parts; 0 by curves.")
      .def_property_readonly("parts_of_b", &Phi::parts_of_b, "How many convex parts; 0 by curves.")
      .def_property_readonly(
          "rounded_of_a", [](const Phi& phi) { return told(phi.rounded_of_a()); },
          "(points, largest): vertices of convex parts that had to be rounded, and how far the farthest was moved.")
      .def_property_readonly(
          "rounded_of_b", [](const Phi& phi) { return told(phi.rounded_of_b()); }, "The same of b.");
  bind_phi_text(phi);
  bind_adjusted(m, phi);
}

void bind_surface(py::module_& m) {
  py::class_<Surface>(m, "Surface", R"doc(A surface of flat faces, with `vertices` and `faces` as trimesh has them.

Examples
--------
>>> import findspace as fs
>>> box = fs.Shape.box((0, 0, 0), (1, 2, 3)).surface
>>> box.vertices.shape, box.faces.shape
((8, 3), (12, 3))
>>> fs.shape(box).dimension
3
)doc")
      .def_property_readonly("vertices", &vertices_of, "Shape (n, 3).")
      .def_property_readonly("faces", &triangles_of, "Triangles, shape (m, 3), counter-clockwise seen from outside.")
      .def_readonly("polygons", &Surface::faces, "The faces as they are: circuits of vertices.")
      .def(
          "text",
          [](const Surface& s, const std::string& ending, const std::string& unit, const std::string& name) {
            return py::bytes(s.text(ending, unit, name));
          },
          py::arg("ending"), py::arg("unit") = "", py::arg("name") = "surface",
          "As a file, in bytes; the unit and the name for those that state them.")
      .def_static("endings", &Surface::endings, "Those of such files.")
      .def("scene_json", &Surface::scene_json, py::arg("name"), py::arg("unit") = "",
           "A scene with what it encloses as its one shape.")
      .def_readonly("lost", &Surface::lost, "Of a shape: what it has that flat faces cannot hold; else ''.")
      .def(py::pickle([](const Surface& s) { return py::make_tuple(s.vertices, s.faces, s.lost); },
                      [](const py::tuple& t) {
                        return Surface{t[0].cast<std::vector<Position3>>(), t[1].cast<std::vector<std::vector<int>>>(),
                                       t[2].cast<std::string>()};
                      }));
}

}  // namespace

void bind_space(py::module_& m) {
  bind_surface(m);
  bind_region(m);
  bind_phi(m);
}

}  // namespace findspace::python
