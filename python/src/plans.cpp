// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Placements, motions, poses and maps of space on lines.

#include <pybind11/stl.h>

#include "findspace/placement.h"
#include "findspace/world.h"
#include "interruptible.h"
#include "numbers.h"
#include "options.h"
#include "pickles.h"
#include "surfaces.h"

namespace findspace::python {
namespace {

std::vector<Number> numbers(const py::iterable& values) {
  std::vector<Number> out;
  for (const py::handle& v : values) out.push_back(number(v));
  return out;
}

/// {"name": [(time, (x, y)), (time, (x, y), degrees), ...]}
Motion motion(const py::dict& paths, const py::object& start, const py::object& end) {
  Motion out{number(start), number(end), {}};
  for (const auto& [name, points] : paths) {
    std::vector<WayPoint>& path = out.paths[name.cast<std::string>()];
    for (const py::handle& p : points) {
      const auto step = p.cast<py::sequence>();
      if (py::len(step) != 2 && py::len(step) != 3)
        throw py::value_error("a way point is (time, (x, y)) or (time, (x, y), degrees)");
      WayPoint& at = path.emplace_back(WayPoint{number(step[0]), point(step[1])});
      if (py::len(step) == 3) at.degrees = number(step[2]);
    }
  }
  return out;
}

std::vector<std::string> names(const py::object& one_or_more) {
  if (py::isinstance<py::str>(one_or_more)) return {one_or_more.cast<std::string>()};
  return one_or_more.cast<std::vector<std::string>>();
}

Body body(const py::object& value) { return py::isinstance<Body>(value) ? value.cast<Body>() : Body(names(value)); }

void bind_motion(py::module_& m, py::class_<World>& world) {
  py::class_<Instants>(m, "Instants", "The instants of a motion at which a formula holds.")
      .def_readonly("certain", &Instants::certain, "Intervals of time, in order.")
      .def_readonly("possible", &Instants::possible, "Intervals that hold them all; the same where `exact`.")
      .def_readonly("exact", &Instants::exact, "Whether these are all.")
      .def(pickled<Instants>(&Instants::certain, &Instants::possible, &Instants::exact));
  world
      .def(
          "in_motion",
          [](World w, const py::dict& paths, const py::object& start, const py::object& end) {
            const Motion given = motion(paths, start, end);
            return interruptible([&] { return w.with(given); });
          },
          py::arg("paths"), py::arg("start") = 0, py::arg("end") = 1,
          R"doc(The same world with shapes that move in time.

Parameters
----------
paths : dict of str to list
    Of each shape that moves its way points (time, (x, y)), or (time, (x, y), degrees): what is added to where it is
    drawn, and how far it is turned about its own origin. Legs are straight, at even speed.
start, end : number
    The time of the motion.

Examples
--------
>>> import findspace as fs
>>> world = fs.World({"cart": fs.Shape.disc((0, 0), 1), "post": fs.Shape.disc((0, 0), 1)}, moving="cart")
>>> world = world.in_motion({"post": [(0, (-5, 0)), (1, (5, 0))]})
>>> world.distance("inf gap(cart, post)", (0, 3)).value
1.0
>>> world.instants("gap(cart, post) <= 1", (0, 3)).certain
[[0.5, 0.5]]
>>> round((~world.solve("inf gap(cart, post) >= 0")).area, 6)
52.566371
)doc")
      .def(
          "at_time",
          [](World w, const py::object& time) {
            const Number at = number(time);
            return interruptible([&] { return w.at_time(at); });
          },
          py::arg("time"), "The same world at one instant of its motion.")
      .def(
          "instants",
          [](World w, const Formula& f, const py::sequence& p) {
            const Point at = point(p);
            return interruptible([&] { return w.instants(f, at); });
          },
          py::arg("formula"), py::arg("position"), "The instants of the motion at which the formula holds there.");
}

void bind_poses(py::module_& m, py::class_<World>& world) {
  py::class_<PoseMap> poses(m, "PoseMap", "Positions at some angles, and between neighbouring ones.");
  py::class_<PoseMap::Slice>(poses, "Slice", "Positions at one angle.")
      .def_readonly("degrees", &PoseMap::Slice::degrees, "The angle, counter-clockwise.")
      .def_readonly("region", &PoseMap::Slice::region, "Exact where there is no `outer`, else certain positions.")
      .def_readonly("outer", &PoseMap::Slice::outer, "Possible positions, or None.")
      .def(py::pickle(
          [](const PoseMap::Slice& s) { return py::make_tuple(s.degrees, s.region, s.outer); },
          [](const py::tuple& t) {
            return PoseMap::Slice{t[0].cast<double>(), t[1].cast<Region>(), t[2].cast<std::optional<Region>>()};
          }));
  py::class_<PoseMap::Sector>(poses, "Sector", "Positions between two neighbouring angles.")
      .def_readonly("start", &PoseMap::Sector::from, "Degrees.")
      .def_readonly("end", &PoseMap::Sector::to, "Degrees, more than `start`; the last may go across 360.")
      .def_readonly("bound", &PoseMap::Sector::bound, "How far a point can be from where the nearer end has it.")
      .def_readonly("inner", &PoseMap::Sector::inner, "Feasible at every angle of the sector.")
      .def_readonly("outer", &PoseMap::Sector::outer, "Holds every position that is feasible at some.")
      .def(py::pickle([](const PoseMap::Sector& s) { return py::make_tuple(s.from, s.to, s.bound, s.inner, s.outer); },
                      [](const py::tuple& t) {
                        return PoseMap::Sector{t[0].cast<double>(), t[1].cast<double>(), t[2].cast<double>(),
                                               t[3].cast<Region>(), t[4].cast<Region>()};
                      }));
  poses.def_readonly("slices", &PoseMap::slices, "By angle.")
      .def_readonly("sectors", &PoseMap::sectors, "Between neighbours at most 180 degrees apart.")
      .def(pickled<PoseMap>(&PoseMap::slices, &PoseMap::sectors));
  world
      .def(
          "poses",
          [](World w, const Formula& f, const py::object& angles, const py::sequence& about) {
            const Point centre = point(about);
            if (py::isinstance<py::int_>(angles)) {
              const int count = angles.cast<int>();
              return interruptible([&] { return w.poses(f, count, centre); });
            }
            const std::vector<Number> degrees = numbers(angles.cast<py::iterable>());
            return interruptible([&] { return w.poses(f, degrees, centre); });
          },
          py::arg("formula"), py::arg("angles"), py::arg("about") = py::make_tuple(0, 0),
          R"doc(Maps of positions at several angles of the moving shape.

Parameters
----------
formula : Formula or str
angles : int or sequence of numbers
    So many angles evenly over a turn, or these, in degrees.
about : (x, y)
    The point of the moving shape that stays where it is.

Examples
--------
>>> import findspace as fs
>>> world = fs.World({"room": fs.Shape.box((0, 0), (5, 3)), "bar": fs.Shape.box((-2, -1), (2, 1))}, moving="bar")
>>> [(s.degrees, s.region.empty) for s in world.poses("inside(bar, room)", 4).slices]
[(0.0, False), (90.0, True), (180.0, False), (270.0, True)]
)doc")
      .def(
          "explain_poses",
          [](World w, const Formula& f, const py::iterable& angles, const py::sequence& about) {
            const Point centre = point(about);
            const std::vector<Number> degrees = numbers(angles);
            return interruptible([&] { return w.explain_poses(f, degrees, centre); });
          },
          py::arg("formula"), py::arg("angles"), py::arg("about") = py::make_tuple(0, 0),
          R"doc(The same as `explain` where the moving shape stands at one of some angles.

There is room where there is at one of them, a conflict is one at all of them, and a level is the best of all of them.

Parameters
----------
formula : Formula or str
angles : sequence of numbers
    In degrees.
about : (x, y)
    The point of the moving shape that stays where it is.

Examples
--------
>>> import findspace as fs
>>> world = fs.World({"room": fs.Shape.box((0, 0), (3, 5)), "bar": fs.Shape.box((-2, -1), (2, 1))}, moving="bar")
>>> slack = world.explain_poses("margin(bar, room) >= 0", [0, 90]).slack[0]
>>> slack.becomes, slack.at, slack.angle
('margin(bar, room) >= 0.5', [1.5, 2.5], 90.0)
)doc")
      .def(
          "explain_angles",
          [](World w, const Formula& f, const py::sequence& at, const py::sequence& about) {
            const Point place = point(at), centre = point(about);
            return interruptible([&] { return w.explain_angles(f, place, centre); });
          },
          py::arg("formula"), py::arg("position"), py::arg("about") = py::make_tuple(0, 0),
          R"doc(The same as `explain` for the moving shape at a position, over all its angles.

Parameters
----------
formula : Formula or str
position : (x, y)
about : (x, y)
    The point of the moving shape that stays where it is.

Raises
------
Error
    Where `angles` does, and where shapes move in time.

Examples
--------
>>> import findspace as fs
>>> world = fs.World({"room": fs.Shape.box((-4, -4), (4, 4)), "bar": fs.Shape.box((-3, -1), (3, 1))}, moving="bar")
>>> slack = world.explain_angles("margin(bar, room) >= 0.25", (0.5, 0)).slack[0]
>>> slack.becomes, slack.angle
('margin(bar, room) >= 1', 90.0)
)doc")
      .def(
          "explain_instants",
          [](World w, const Formula& f, const py::sequence& at) {
            const Point place = point(at);
            return interruptible([&] { return w.explain_instants(f, place); });
          },
          py::arg("formula"), py::arg("position"),
          R"doc(The same as `explain` for the moving shape at a position, over the instants of the motion.

Parameters
----------
formula : Formula or str
position : (x, y)

Raises
------
Error
    Without a motion; where shapes turn in time; for distances in rotation.

Examples
--------
>>> import findspace as fs
>>> world = fs.World({"post": fs.Shape.box((9, 3), (11, 5)), "bus": fs.Shape.box((0, 0), (2, 1))}, moving="bus")
>>> world = world.in_motion({"bus": [(0, (0, 0)), (1, (20, 0))]})
>>> slack = world.explain_instants("gap(bus, post) <= 3", (0, 0)).slack[0]
>>> slack.becomes, slack.time
('gap(bus, post) <= 2', 0.35)
)doc")
      .def(
          "solve_bounds",
          [](World w, const Formula& f) {
            const RegionBounds found = interruptible([&] { return w.solve_bounds(f); });
            return py::make_tuple(found.inner, found.outer);
          },
          py::arg("formula"),
          "(inner, outer): positions that certainly hold, and possibly, where shapes turn in time or distances are in "
          "rotation; else the exact region twice.");
}

py::tuple packed_lines(const LineMap& map) {
  py::list lines;
  for (const LineMap::Line& line : map.lines) lines.append(py::make_tuple(line.through, line.intervals));
  const py::object bounds = map.bounds ? py::object(py::make_tuple(map.bounds->low, map.bounds->high)) : py::none();
  return py::make_tuple(lines, map.exact, map.unbounded, map.volume, map.components, bounds);
}

LineMap unpacked_lines(const py::tuple& t) {
  LineMap out;
  for (const py::handle& item : t[0]) {
    const auto line = item.cast<py::tuple>();
    out.lines.push_back({line[0].cast<Position3>(), line[1].cast<std::vector<Interval>>()});
  }
  out.exact = t[1].cast<bool>();
  out.unbounded = t[2].cast<bool>();
  out.volume = t[3].cast<double>();
  out.components = t[4].cast<std::size_t>();
  if (t[5].is_none()) return out;
  const auto bounds = t[5].cast<py::tuple>();
  out.bounds = SpaceRegion::Bounds3{bounds[0].cast<Position3>(), bounds[1].cast<Position3>()};
  return out;
}

void bind_lines(py::module_& m, py::class_<World>& world) {
  py::class_<LineMap>(m, "LineMap", "A region of space on parallel lines.")
      .def_property_readonly(
          "lines", [](const LineMap& map) { return py::object(packed_lines(map)[0]); },
          "(point of the line, intervals) of each line that meets the region.")
      .def_readonly("exact", &LineMap::exact, "Whether ends are exact; else found by a search.")
      .def_readonly("unbounded", &LineMap::unbounded, "The region goes on for ever.")
      .def_readonly("volume", &LineMap::volume, "About: cells times lengths. World.volume has bounds.")
      .def_readonly("components", &LineMap::components, "About how many parts it has.")
      .def_property_readonly(
          "bounds", [](const LineMap& map) { return py::object(packed_lines(map)[5]); },
          "(low, high) of what the lines meet, or None.")
      .def(py::pickle(&packed_lines, &unpacked_lines));
  const auto lines = [](int count, const std::string& axis) {
    if (axis != "x" && axis != "y" && axis != "z") throw py::value_error("axis is 'x', 'y' or 'z'");
    return Lines{count, Shape::Axis(axis[0] - 'x')};
  };
  world
      .def(
          "on_lines",
          [lines](World w, const Formula& f, int count, const std::string& axis) {
            const Lines asked = lines(count, axis);
            return interruptible([&] { return w.on_lines(f, asked); });
          },
          py::arg("formula"), py::arg("count") = 64, py::arg("axis") = "z",
          "Where the formula holds on so many lines of space each way.")
      .def(
          "volume",
          [lines](World w, const Formula& f, int count, const std::string& axis) {
            const Lines asked = lines(count, axis);
            const VolumeBounds found = interruptible([&] { return w.volume(f, asked); });
            return py::make_tuple(found.lower, found.upper);
          },
          py::arg("formula"), py::arg("count") = 64, py::arg("axis") = "z",
          R"doc((lower, upper): between which the volume of the region lies.

Examples
--------
>>> import findspace as fs
>>> world = fs.World({"room": fs.Shape.box((0, 0, 0), (9, 9, 9)), "ball": fs.Shape.ball((0, 0, 0), 1)}, "ball")
>>> lower, upper = world.volume("inside(ball, room)", 32)
>>> lower <= 7 ** 3 <= upper
True
)doc")
      .def(
          "surface",
          [](World w, const Formula& f, int count) { return interruptible([&] { return w.surface(f, count); }); },
          py::arg("formula"), py::arg("count") = 64,
          "The surface of the region on a lattice of cubes, so many along its longest side.");
}

py::tuple packed_place(const Placement::Placed& p) {
  py::list exactly;
  for (const Exact& c : p.exact_at) exactly.append(c.full_text());
  return py::make_tuple(p.body, p.copy, p.degrees, p.at, exactly, p.attained);
}

Placement::Placed unpacked_place(const py::tuple& t) {
  Placement::Placed out{
      t[0].cast<std::string>(), t[1].cast<int>(), t[2].cast<double>(), t[3].cast<std::optional<Place>>(), {},
      t[5].cast<bool>()};
  for (const py::handle& c : t[4]) out.exact_at.push_back(Exact::read(c.cast<std::string>()));
  return out;
}

py::tuple packed_placement(const Placement& found) {
  const Placement::Told told = found.told();
  py::list positions;
  for (const Placement::Positions& at : told.positions)
    positions.append(py::make_tuple(at.placed, at.degrees, at.region));
  return py::make_tuple(told.placed, positions, told.complete, told.unproven, told.json, told.svg);
}

Placement unpacked_placement(const py::tuple& t) {
  Placement::Told told{t[0].cast<std::vector<Placement::Placed>>(),
                       {},
                       t[2].cast<bool>(),
                       t[3].cast<std::string>(),
                       t[4].cast<std::string>(),
                       t[5].cast<std::string>()};
  for (const py::handle& item : t[1]) {
    const auto at = item.cast<py::tuple>();
    told.positions.push_back({at[0].cast<std::size_t>(), at[1].cast<double>(), at[2].cast<Region>()});
  }
  return Placement(std::move(told));
}

void bind_placement(py::module_& m) {
  py::class_<Body>(m, "Body", "What has one position: a shape, or several that move together.")
      .def(py::init([](const py::object& shapes, const py::iterable& angles, int count) {
             return Body(names(shapes), numbers(angles), count);
           }),
           py::arg("shapes"), py::arg("angles") = py::make_tuple(0), py::arg("count") = 1)
      .def(py::pickle(
          [](const Body& b) {
            py::list angles;
            for (const Number& a : b.angles) angles.append(a.text());
            return py::make_tuple(b.shapes, angles, b.count);
          },
          [](const py::tuple& t) {
            return Body(t[0].cast<std::vector<std::string>>(), numbers(t[1].cast<py::iterable>()), t[2].cast<int>());
          }))
      .def_readonly("shapes", &Body::shapes, "Names.")
      .def_property_readonly(
          "angles",
          [](const Body& b) {
            std::vector<std::string> out;
            for (const Number& angle : b.angles) out.push_back(angle.text());
            return out;
          },
          "Those allowed, in degrees, as text.")
      .def_readonly("count", &Body::count, "How many of it are placed.");
  py::class_<Placement> placement(m, "Placement", "Bodies where they were put.");
  py::class_<Placement::Placed>(placement, "Placed", "One body where it was put.")
      .def_readonly("body", &Placement::Placed::body, "Its name: that of its shape, or \"A1+A2\".")
      .def_readonly("copy", &Placement::Placed::copy, "From 1 where it is placed several times, else 0.")
      .def_readonly("degrees", &Placement::Placed::degrees, "The angle that was taken.")
      .def_readonly("at", &Placement::Placed::at, "The position, or None where it has none.")
      .def_readonly("attained", &Placement::Placed::attained, "False: no position takes the least value.")
      .def_property_readonly(
          "exact_at",
          [](const Placement::Placed& p) {
            std::vector<std::string> out;
            for (const Exact& c : p.exact_at) out.push_back(c.text());
            return out;
          },
          "The position in full, as text.")
      .def(py::pickle(&packed_place, &unpacked_place))
      .def("__repr__", [](const Placement::Placed& p) {
        return "<" + p.body + " at " + std::string(py::str(py::cast(p.at))) + ">";
      });
  placement.def_property_readonly("placed", &Placement::placed, "In the order of the bodies.")
      .def_property_readonly("complete", &Placement::complete, "Whether every body has a position.")
      .def_property_readonly("unproven", &Placement::unproven,
                             "Why there may be others, or better ones; empty where the search ended with a proof.")
      .def_property_readonly(
          "positions",
          [](const Placement& p) {
            py::list out;
            for (const Placement::Positions& at : p.positions())
              out.append(py::make_tuple(at.placed, at.degrees, at.region));
            return out;
          },
          "(index in `placed`, degrees, region): all positions that a body had when its turn came; of the plane.")
      .def(py::pickle(&packed_placement, &unpacked_placement))
      .def_property_readonly("json", &Placement::json, "As `findspace place --json` writes it.")
      .def_property_readonly("svg", &Placement::svg, "What stands still and what was placed.");
  m.def(
      "place",
      [](const std::map<std::string, Shape>& shapes, const py::iterable& bodies, const std::optional<Formula>& each,
         const std::optional<Formula>& pairs, const std::vector<Formula>& constraints,
         const std::vector<std::string>& minimize, bool together, const std::string& unit, int lines,
         const std::optional<Options>& options, const py::kwargs& words) {
        Demands demands{{}, each, pairs, constraints, minimize, together, lines};
        for (const py::handle& b : bodies) demands.bodies.push_back(body(py::reinterpret_borrow<py::object>(b)));
        const Options asked = options_of(options, words);
        return interruptible([&] { return place(shapes, demands, {unit}, asked); });
      },
      py::arg("shapes"), py::arg("bodies"), py::arg("each") = py::none(), py::arg("pairs") = py::none(),
      py::arg("constraints") = std::vector<Formula>(), py::arg("minimize") = std::vector<std::string>(),
      py::arg("together") = false, py::arg("unit") = "", py::arg("lines") = 128, py::arg("options") = py::none(),
      R"doc(Several shapes put down, one after another or all at once.

Parameters
----------
shapes : dict of str to Shape
    Those of the bodies are placed, the others stand still.
bodies : list of str, list of str, or Body
    In the order in which they are placed; a list of names moves together.
each, pairs : Formula or str, optional
    Hold for every body, "self", and for every body and each one before it, "other".
constraints : list of Formula
    Between bodies by name.
minimize : list of str
    Objectives, the first first: "y", "-x", "gap(self, rim)", "x = 5", "grid".
together : bool
    All at once.
lines : int
    Each way, where positions of space are taken on lines.
options : Options, optional
    Or its words. At a limit of time what was found by then is given.

Examples
--------
>>> import findspace as fs
>>> shapes = {"sheet": fs.Shape.box((0, 0), (30, 20)), "A": fs.Shape.box((0, 0), (8, 8)), "B": fs.Shape.disc((0, 0), 4)}
>>> found = fs.place(shapes, ["A", "B"], each="inside(self, sheet)", pairs="clear(self, other, 1)", minimize=["y", "x"])
>>> found.placed
[<A at [0.0, 0.0]>, <B at [13.0, 4.0]>]
)doc");
}

}  // namespace

void bind_plans(py::module_& m, py::class_<World>& world) {
  bind_motion(m, world);
  bind_poses(m, world);
  bind_lines(m, world);
  bind_placement(m);
}

}  // namespace findspace::python
