// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <pybind11/functional.h>
#include <pybind11/stl.h>

#include "arrays.h"
#include "findspace/world.h"
#include "interruptible.h"
#include "numbers.h"
#include "options.h"
#include "pickles.h"

namespace findspace::python {
namespace {

/// (x, y) or (x, y, z), exactly.
template <class Ask>
auto at_point(const py::sequence& p, const Ask& ask) {
  if (py::len(p) == 3) {
    const Point3 at = point3(p);
    return interruptible([&] { return ask(at); });
  }
  const Point at = point(p);
  return interruptible([&] { return ask(at); });
}

/// The answers at each row of an array of shape (n, 2) or (n, 3).
template <class Out>
py::array_t<Out> at_rows(const Query& query, const Array& at,
                         void (Query::*planar)(std::span<const Position>, std::span<Out>) const,
                         void (Query::*solid)(std::span<const Position3>, std::span<Out>) const) {
  const bool in_space = query.world().dimension() == 3;
  const std::size_t count = in_space ? rows<Position3>(at, "positions").size() : positions(at).size();
  py::array_t<Out> out{py::ssize_t(count)};
  const std::span<Out> answers(out.mutable_data(), count);
  interruptible([&] {
    if (in_space)
      (query.*solid)(rows<Position3>(at, "positions"), answers);
    else
      (query.*planar)(positions(at), answers);
    return true;
  });
  return out;
}

py::object nearest(const Query& query, const py::sequence& from) {
  const auto told = [](const auto& found) {
    return found ? py::object(py::make_tuple(py::tuple(py::cast(found->at)), found->distance, found->attained))
                 : py::none();
  };
  if (query.world().dimension() == 3) {
    const auto at = from.cast<Position3>();
    return told(interruptible([&] { return query.nearest(at); }));
  }
  const auto at = from.cast<Position>();
  return told(interruptible([&] { return query.nearest(at); }));
}

/// A sign map with what it was made of, which a pickle takes.
struct SignMapOf {
  World world;
  std::string distance;
  Number level;
  SignMap signs;
};

SignMapOf sign_map(const World& world, const std::string& distance, const Number& level) {
  return {world, distance, level, interruptible([&] { return world.sign_map(distance, level); })};
}

void bind_sign_map(py::module_& m) {
  py::class_<SignMapOf>(m, "SignMap", R"doc(The sign of a distance minus a level at every position, exactly.

Examples
--------
>>> import findspace as fs
>>> world = fs.World({"A": fs.Shape.box((0, 0), (10, 10)), "B": fs.Shape.box((-1, -1), (1, 1))}, "B")
>>> signs = world.sign_map("margin(B, A)", 2)
>>> signs.sign((3, 5)), signs.sign(("2.999999", 5))
(0, -1)
>>> signs.signs([[5, 5], [3, 5], [2, 5]])
array([ 1,  0, -1], dtype=int8)
>>> signs.where(zero=True, positive=True).area
16.0
)doc")
      .def(
          "sign", [](const SignMapOf& s, const py::sequence& p) { return s.signs.sign(point(p)); }, py::arg("position"),
          "-1, 0 or 1, exactly; a distance that is undefined counts as +infinity.")
      .def(
          "signs",
          [](const SignMapOf& s, const Doubles& at) {
            const std::span<const Position> all = positions(at);
            py::array_t<std::int8_t> out{py::ssize_t(all.size())};
            const std::span<std::int8_t> answers(out.mutable_data(), all.size());
            interruptible([&] {
              s.signs.signs(all, answers);
              return true;
            });
            return out;
          },
          py::arg("positions"), "Of each position, shape (n, 2), its sign. Exact; all threads.")
      .def(
          "where",
          [](const SignMapOf& s, bool negative, bool zero, bool positive) {
            return interruptible([&] { return s.signs.where(negative, zero, positive); });
          },
          py::arg("negative") = false, py::arg("zero") = false, py::arg("positive") = false,
          "The positions whose sign is one of those wanted, as a region.")
      .def(py::pickle(
          [](const SignMapOf& s) { return py::make_tuple(s.world, s.distance, s.level.text()); },
          [](const py::tuple& t) { return sign_map(t[0].cast<World>(), t[1].cast<std::string>(), number(t[2])); }))
      .def_readonly("distance", &SignMapOf::distance, "What was asked.")
      .def_property_readonly(
          "level", [](const SignMapOf& s) { return s.level.text(); }, "What is taken from it, as text.")
      .def("__repr__", [](const SignMapOf& s) { return "<SignMap " + s.distance + " - " + s.level.text() + ">"; });
}

void bind_values(py::module_& m) {
  py::class_<Feature>(m, "Feature", "What a point of a witness lies on.")
      .def_property_readonly(
          "kind",
          [](const Feature& f) {
            static const char* const kKinds[] = {"vertex", "edge", "arc", "inside"};
            return kKinds[static_cast<int>(f.kind)];
          },
          "'vertex', 'edge', 'arc', or 'inside' where it is not a boundary.")
      .def_readonly("shape", &Feature::shape, "The shape's name.")
      .def_readonly("part", &Feature::part, "The part of a collection, else empty.")
      .def_readonly("points", &Feature::points, "In the shape's own coordinates: a vertex, two ends, or a centre.")
      .def_readonly("radius", &Feature::radius, "Of an arc.")
      .def(pickled<Feature>(&Feature::kind, &Feature::shape, &Feature::part, &Feature::points, &Feature::radius));
  py::class_<DistanceValue>(m, "DistanceValue", "The value of a distance at a position, with its bounds.")
      .def_readonly("value", &DistanceValue::value, "None: undefined, +infinity.")
      .def_readonly("exact", &DistanceValue::exact, "Whether the number is known exactly; `value` is that rounded.")
      .def_readonly("lower", &DistanceValue::lower, "The true value is not less.")
      .def_readonly("upper", &DistanceValue::upper, "The true value is not more.")
      .def_readonly("closed_form", &DistanceValue::closed_form, "An exact value as text, where it has one.")
      .def_readonly("in_degrees", &DistanceValue::in_degrees, "Whether it is an angle, of a distance in rotation.")
      .def_readonly("nearest", &DistanceValue::nearest, "Of signed distances the nearest position where they are 0.")
      .def_readonly("points", &DistanceValue::points, "Two points that take the distance, or none.")
      .def_readonly("features", &DistanceValue::features, "What these lie on, in the plane; or none.")
      .def_property_readonly("witness", &DistanceValue::witness, "What these points lie on, in words.")
      .def(pickled<DistanceValue>(&DistanceValue::value, &DistanceValue::exact, &DistanceValue::lower,
                                  &DistanceValue::upper, &DistanceValue::closed_form, &DistanceValue::in_degrees,
                                  &DistanceValue::nearest, &DistanceValue::points, &DistanceValue::features))
      .def("__float__",
           [](const DistanceValue& d) { return d.value.value_or(std::numeric_limits<double>::infinity()); })
      .def("__repr__",
           [](const DistanceValue& d) { return "<DistanceValue " + std::string(py::str(py::cast(d.value))) + ">"; });
  py::class_<AtomValue>(m, "AtomValue", "One comparison of a formula at a position.")
      .def_readonly("text", &AtomValue::text, "The comparison.")
      .def_readonly("holds", &AtomValue::holds, "Exact, also on a boundary.")
      .def_readonly("distance", &AtomValue::distance, "The value that is compared.")
      .def_readonly("lacks", &AtomValue::lacks, "How far the value is from holding; None where it holds.")
      .def(pickled<AtomValue>(&AtomValue::text, &AtomValue::holds, &AtomValue::distance, &AtomValue::lacks));
  py::class_<Check>(m, "Check", "A formula at a position, atom by atom.")
      .def_readonly("holds", &Check::holds, "Exact, also on a boundary.")
      .def_readonly("atoms", &Check::atoms, "Its comparisons, from left to right.")
      .def(pickled<Check>(&Check::holds, &Check::atoms))
      .def("__bool__", [](const Check& c) { return c.holds; });
  py::class_<Optimum>(m, "Optimum", "The least value of an objective over a region.")
      .def_readonly("value", &Optimum::value, "The infimum; None where there is none.")
      .def_readonly("exact", &Optimum::exact, "Whether the infimum is known exactly.")
      .def_readonly("lower", &Optimum::lower, "The infimum is not less.")
      .def_readonly("upper", &Optimum::upper, "The infimum is not more.")
      .def_readonly("closed_form", &Optimum::closed_form, "'2*sqrt(2)': of an exact value that has one; else empty.")
      .def_readonly("side", &Optimum::side, "'exact', or of an enclosed value 'inner': a position has it; 'outer'.")
      .def_readonly("unbounded", &Optimum::unbounded, "Whether there is no lower bound.")
      .def_readonly("attained", &Optimum::attained, "Whether a position of the region takes it.")
      .def_readonly("at", &Optimum::at, "The positions, as a region.")
      .def(pickled_whole<Optimum>(&Optimum::value, &Optimum::exact, &Optimum::lower, &Optimum::upper,
                                  &Optimum::closed_form, &Optimum::side, &Optimum::unbounded, &Optimum::attained,
                                  &Optimum::at));
  py::class_<Interval>(m, "Interval", "A part of a line, by the length gone.")
      .def_readonly("start", &Interval::from, "None: it goes on for ever.")
      .def_readonly("end", &Interval::to, "None: it goes on for ever.")
      .def_readonly("start_belongs", &Interval::from_belongs, "Whether the start is in the set.")
      .def_readonly("end_belongs", &Interval::to_belongs, "Whether the end is in the set.")
      .def(pickled<Interval>(&Interval::from, &Interval::to, &Interval::from_belongs, &Interval::to_belongs))
      .def("__repr__", [](const Interval& i) {
        const auto end = [](const std::optional<double>& v, const char* none) {
          return v ? std::string(py::repr(py::cast(*v))) : std::string(none);
        };
        return (i.from_belongs ? "[" : "(") + end(i.from, "-inf") + ", " + end(i.to, "inf") +
               (i.to_belongs ? "]" : ")");
      });
}

void bind_query(py::module_& m) {
  py::class_<Query>(m, "Query", R"doc(A formula or a distance over a world, to be asked at many positions.

Examples
--------
>>> import findspace as fs
>>> world = fs.World({"A": fs.Shape.box((0, 0), (10, 10)), "B": fs.Shape.box((-1, -1), (1, 1))}, moving="B")
>>> world.query("inside(B, A)").holds([[5, 5], [9, 9], [9.5, 5]])
array([ True,  True, False])
>>> world.query("gap(B, A)").values([[14, 5], [14, 15]])
array([3., 5.])
)doc")
      .def(
          "holds", [](const Query& q, const Doubles& at) { return at_rows<bool>(q, at, &Query::holds, &Query::holds); },
          py::arg("positions"), "Of each position, an array of shape (n, 2) or (n, 3), a bool. Exact; all threads.")
      .def(
          "values",
          [](const Query& q, const Doubles& at) { return at_rows<double>(q, at, &Query::values, &Query::values); },
          py::arg("positions"), "The distance at each position, rounded; inf where it is undefined. All threads.")
      .def(
          "value",
          [](const Query& q, const py::sequence& p) {
            return at_point(p, [&](const auto& at) { return q.value(at); });
          },
          py::arg("position"), "The distance at one position, with its bounds.")
      .def(py::pickle([](const Query& q) { return py::make_tuple(q.world(), q.text()); },
                      [](const py::tuple& t) { return t[0].cast<World>().query(t[1].cast<std::string>()); }))
      .def_property_readonly("text", &Query::text, "What was asked.")
      .def_property_readonly(
          "world", [](const Query& q) { return q.world(); }, "The world that is asked, a copy.")
      .def_property_readonly(
          "region", [](const Query& q) { return interruptible([&] { return q.region(); }); },
          "{p : the formula holds at p}, of the plane.")
      .def("nearest", &nearest, py::arg("position"),
           "(position, distance, attained) of the nearest feasible position, or None.")
      .def("__repr__", [](const Query& q) { return "<Query " + q.text() + ">"; });
}

World made(const std::map<std::string, Shape>& shapes, const py::object& moving, const std::string& unit) {
  const std::vector<std::string> movers = py::isinstance<py::str>(moving) ? std::vector{moving.cast<std::string>()}
                                                                          : moving.cast<std::vector<std::string>>();
  return interruptible([&] { return World(shapes, movers, {unit}); });
}

/// Paths as (name, [(time, x, y, degrees), ...]), exactly.
py::object motion_state(const World& world) {
  if (!world.motion()) return py::none();
  py::list paths;
  for (const auto& [name, path] : world.motion()->paths) {
    py::list points;
    for (const WayPoint& p : path)
      points.append(py::make_tuple(p.time.text(), p.at.x.text(), p.at.y.text(), p.degrees.text()));
    paths.append(py::make_tuple(name, points));
  }
  return py::make_tuple(world.motion()->start.text(), world.motion()->end.text(), paths,
                        world.time() ? py::object(py::str(world.time()->text())) : py::none());
}

using Groups = std::map<std::string, std::vector<std::string>>;

/// Without members that are no shapes: parts of a board that have no body.
ShapeGroups known_groups(const World& world) {
  ShapeGroups out = world.groups();
  const auto none = [&](const std::string& name) { return world.shapes().count(name) == 0; };
  for (auto& [name, members] : out.groups) std::erase_if(members, none);
  return out;
}

py::object motion_of(const World& world) {
  if (!world.motion()) return py::none();
  py::dict paths;
  for (const auto& [name, path] : world.motion()->paths) {
    py::list points;
    for (const WayPoint& p : path)
      points.append(py::make_tuple(p.time.text(), py::make_tuple(p.at.x.text(), p.at.y.text()), p.degrees.text()));
    paths[py::str(name)] = points;
  }
  return py::make_tuple(world.motion()->start.text(), world.motion()->end.text(), paths);
}

World with_motion(World world, const py::object& state) {
  if (state.is_none()) return world;
  const auto t = state.cast<py::tuple>();
  Motion motion{number(t[0]), number(t[1]), {}};
  for (const py::handle& item : t[2]) {
    const auto path = item.cast<py::tuple>();
    std::vector<WayPoint>& points = motion.paths[path[0].cast<std::string>()];
    for (const py::handle& p : path[1]) {
      const auto at = p.cast<py::tuple>();
      points.push_back({number(at[0]), {number(at[1]), number(at[2])}, number(at[3])});
    }
  }
  const World moving = world.with(motion);
  return t[3].is_none() ? moving : moving.at_time(number(t[3]));
}

void bind_changes(py::class_<World>& world) {
  world
      .def("set", &World::set, py::arg("name"), py::arg("shape"),
           "A shape that is new, or replaces that of its name; what does not speak of it is kept.")
      .def("remove", &World::remove, py::arg("name"), "Without a shape; not the moving one.")
      .def(
          "move",
          [](World& w, const std::string& name, const py::sequence& by) {
            if (py::len(by) == 3)
              w.move(name, point3(by));
            else
              w.move(name, point(by));
          },
          py::arg("name"), py::arg("by"), "A shape elsewhere.")
      .def(
          "limited",
          [](const World& w, const std::optional<Options>& options, const py::kwargs& words) {
            return w.with(options_of(options, words));
          },
          py::arg("options") = py::none(),
          R"doc(The same world with limits for each question.

Parameters
----------
options : Options, optional
    Or its words: threads, seconds, memory, progress, cancel, seed, work, work_limit.

Returns
-------
World
    Its questions raise `Stopped` at a limit.

Examples
--------
>>> import findspace as fs
>>> world = fs.World({"A": fs.Shape.box((0, 0), (1, 1)), "B": fs.Shape.disc((0, 0), 1)}, "B")
>>> world.limited(seconds=5).options.seconds
5.0
)doc");
}

void bind_groups(py::class_<World>& world) {
  world.def(
      "grouped",
      [](World w, const Groups& groups, const std::optional<std::vector<std::string>>& all) {
        return interruptible([&] { return w.with(ShapeGroups{groups, all}); });
      },
      py::arg("groups"), py::arg("all") = py::none(),
      R"doc(The same world with groups of shapes that formulas may name, beside those that it has.

Parameters
----------
groups : dict of str to list of str
    Names of shapes. In a distance a group is the collection of those that stand still, as they are now; if a shape has
    its name, that shape. Without one that stands still it is the empty set.
all : list of str, optional
    What `all` and `others` mean, if not all shapes.

Raises
------
Error
    Of code 'unknown name' for what is no shape.

Examples
--------
>>> import findspace as fs
>>> box = fs.Shape.box((-1, -1), (1, 1))
>>> world = fs.World({"A": box.translated((5, 0)), "B": box.translated((9, 0)), "C": box}, moving="C")
>>> world = world.grouped({"both": ["A", "B"], "smd": ["A", "C"]})
>>> world.distance("gap(C, both)", (0, 0)).value, world.holds("between(smd, smd) >= 3.5", (0, 0))
(3.0, False)
)doc");
}

void bind_questions(py::class_<World>& world) {
  world
      .def(
          "solve",
          [](World w, const Formula& f) -> py::object {
            if (w.dimension() == 3) return py::cast(interruptible([&] { return w.solve_space(f); }));
            return py::cast(interruptible([&] { return w.solve(f); }));
          },
          py::arg("formula"),
          "{p : the formula holds at p}, exactly: a Region, in space a SpaceRegion where it has one of its forms.")
      .def(
          "solve_space",
          [](World w, const Formula& f, const std::string& apply, const std::string& minimize,
             const std::string& maximize) {
            return interruptible([&] { return w.solve_space(f, {apply, minimize, maximize}); });
          },
          py::arg("formula"), py::arg("apply") = "", py::kw_only(), py::arg("minimize") = "", py::arg("maximize") = "",
          R"doc(The positions of a formula in space, the best ones, or what is made of them.

Parameters
----------
formula : Formula or str
    It holds at boxes or at a convex polytope; else findspace.Error.
apply : str
    What is made of them: 'interior', 'closure', 'boundary', 'regularize', 'complement', or nothing.
minimize, maximize : str
    Only those where this objective is least, or greatest: 'x', 'distance to [1, 2, 3]'.

Examples
--------
>>> import findspace as fs
>>> world = fs.World({"A": fs.Shape.box((0, 0, 0), (9, 9, 9)), "B": fs.Shape.box((0, 0, 0), (2, 1, 1))}, "B")
>>> top = world.solve_space("inside(B, A)", maximize="z")
>>> top.bounds, (7, 8, 8) in top, (0, 0, 7) in top
(([0.0, 0.0, 8.0], [7.0, 8.0, 8.0]), True, False)
>>> (7, 8, 8) in world.solve_space("inside(B, A)", "interior")
False
)doc")
      .def(
          "sign_map",
          [](World w, const Distance& d, const py::object& level) { return sign_map(w, d.text(), number(level)); },
          py::arg("distance"), py::arg("level") = 0)
      .def(
          "sign_map",
          [](World w, const std::string& d, const py::object& level) { return sign_map(w, d, number(level)); },
          py::arg("distance"), py::arg("level") = 0,
          "The sign of a distance minus a level at every position of the plane.")
      .def(
          "angles",
          [](World w, const Formula& f, const py::sequence& p, const py::sequence& about) {
            const Point at = point(p), centre = point(about);
            return interruptible([&] { return w.angles(f, at, centre); });
          },
          py::arg("formula"), py::arg("position"), py::arg("about") = py::make_tuple(0, 0),
          "Where the formula holds for the moving shape rotated about a point of its own: intervals in degrees.")
      .def(
          "check_rotated",
          [](World w, const Formula& f, const py::sequence& p, const py::object& degrees, const py::sequence& about) {
            const Point at = point(p), centre = point(about);
            const Number angle = number(degrees);
            return interruptible([&] { return w.check_rotated(f, at, angle, centre); });
          },
          py::arg("formula"), py::arg("position"), py::arg("degrees"), py::arg("about") = py::make_tuple(0, 0),
          "The formula with the moving shape rotated first, atom by atom.")
      .def("query", py::overload_cast<const Distance&>(&World::query, py::const_), py::arg("distance"),
           "A distance, ready for many positions.")
      .def("query", py::overload_cast<const Formula&>(&World::query, py::const_), py::arg("formula"),
           "A formula, or the text of a distance, ready for many positions.")
      .def(
          "holds",
          [](World w, const Formula& f, const py::sequence& p) {
            return at_point(p, [&](const auto& at) { return w.holds(f, at); });
          },
          py::arg("formula"), py::arg("position"), "Whether the formula holds at p, exactly, without a map.")
      .def(
          "check",
          [](World w, const Formula& f, const py::sequence& p) {
            return at_point(p, [&](const auto& at) { return w.check(f, at); });
          },
          py::arg("formula"), py::arg("position"), "The same, with every comparison and its value.")
      .def(
          "distance",
          [](World w, const Distance& d, const py::sequence& p) {
            return at_point(p, [&](const auto& at) { return w.distance(d, at); });
          },
          py::arg("distance"), py::arg("position"))
      .def(
          "distance",
          [](World w, const std::string& d, const py::sequence& p) {
            return at_point(p, [&](const auto& at) { return w.distance(d, at); });
          },
          py::arg("distance"), py::arg("position"), "The value of a distance, its bounds and its witness.")
      .def(
          "on_line",
          [](World w, const Formula& f, const py::sequence& through, const py::sequence& direction) {
            const Point3 from = point3(through), along = point3(direction);
            const OnLine found = interruptible([&] { return w.on_line(f, from, along); });
            return py::make_tuple(found.intervals, found.exact);
          },
          py::arg("formula"), py::arg("through"), py::arg("direction"),
          "(intervals, exact): where the formula holds on a line of space; the direction is in integers.")
      .def(
          "explain",
          [](World w, const Formula& f, const std::optional<py::sequence>& p) {
            if (p && py::len(*p) == 3) {
              const Point3 at = point3(*p);
              return interruptible([&] { return w.explain(f, at); });
            }
            const auto at = p ? std::optional(point(*p)) : std::nullopt;
            return interruptible([&] { return w.explain(f, at); });
          },
          py::arg("formula"), py::arg("position") = py::none(),
          R"doc(Why the formula holds nowhere, or how far each of its levels can be tightened.

Parameters
----------
formula : Formula or str
position : (x, y) or (x, y, z), optional
    What stands in the way there is said, too.

Examples
--------
>>> import findspace as fs
>>> world = fs.World({"A": fs.Shape.box((0, 0), (10, 10)), "B": fs.Shape.box((-1, -1), (1, 1))}, "B")
>>> found = world.explain("margin(B, A) >= 5")
>>> found.feasible, found.conflict, found.relax[0].becomes
(False, ['margin(B, A) >= 5'], 'margin(B, A) >= 4')
>>> print(world.explain("margin(B, A) >= 3"), end="")
some positions are feasible
how far each level can be tightened:
  margin(B, A) >= 3: slack 1, to 4; the last position is (5, 5)
)doc")
      .def(
          "minimize",
          [](World w, const std::string& objective, const Formula& f) {
            return interruptible([&] { return w.minimize(objective, f); });
          },
          py::arg("objective"), py::arg("formula") = Formula("true"),
          "The least value of an objective where the formula holds.")
      .def("shape", &World::shape, py::arg("name"), "A shape as a region.");
}

}  // namespace

void bind_explanation(py::module_& m);
void bind_plans(py::module_& m, py::class_<World>& world);

void bind_worlds(py::module_& m) {
  bind_values(m);
  bind_query(m);
  bind_sign_map(m);
  bind_explanation(m);
  py::class_<World> world(m, "World", R"doc(Named shapes, one of which moves by a translation p.

Parameters
----------
shapes : dict of str to Shape
    All of the plane, or all of space.
moving : str or list of str
    One of the names, or several that move together.
unit : str, optional
    um mm cm m in mil.

Examples
--------
>>> import findspace as fs
>>> world = fs.World({"A": fs.Shape.box((0, 0), (10, 10)), "B": fs.Shape.box((-1, -1), (1, 1))}, moving="B")
>>> world.solve("inside(B, A)").area
64.0
>>> world.distance("gap(B, A)", (14, 5)).value
3.0
>>> world.move("A", (2, 0))
>>> world.distance("gap(B, A)", (14, 5)).value
1.0
)doc");
  world.def(py::init(&made), py::arg("shapes"), py::arg("moving"), py::arg("unit") = "")
      .def(py::pickle(
          [](const World& w) {
            const ShapeGroups groups = known_groups(w);
            return py::make_tuple(w.shapes(), w.moving_together(), w.unit(), motion_state(w), groups.groups,
                                  groups.all);
          },
          [](const py::tuple& t) {
            const World world = made(t[0].cast<std::map<std::string, Shape>>(), t[1], t[2].cast<std::string>());
            ShapeGroups groups{t[4].cast<Groups>(), t[5].cast<std::optional<std::vector<std::string>>>()};
            return with_motion(groups.groups.empty() && !groups.all ? world : world.with(groups), t[3]);
          }))
      .def_property_readonly(
          "shapes", [](const World& w) { return w.shapes(); }, "By name.")
      .def_property_readonly("moving", &World::moving, "The name of the shape that moves, or of the first of several.")
      .def_property_readonly("moving_together", &World::moving_together, "The names of all that move.")
      .def_property_readonly("unit", &World::unit, "The unit of length, or ''.")
      .def_property_readonly("dimension", &World::dimension, "2 or 3.")
      .def_property_readonly(
          "options", [](const World& w) { return w.options(); }, "The limits of its questions, a copy.")
      .def_property_readonly(
          "groups", [](const World& w) { return known_groups(w).groups; },
          "Lists of shapes by the names that formulas have for them.")
      .def_property_readonly("motion", &motion_of,
                             "(start, end, {name: [(time, (x, y), degrees)]}), exactly, as text; None where nothing "
                             "moves in time.")
      .def_property_readonly(
          "time", [](const World& w) { return w.time() ? std::optional(w.time()->text()) : std::nullopt; },
          "The instant of at_time(), as text, or None.");
  bind_changes(world);
  bind_groups(world);
  bind_questions(world);
  bind_plans(m, world);
}

}  // namespace findspace::python
