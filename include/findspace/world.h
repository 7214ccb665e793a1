// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A world of named shapes of the plane or of space, one of which moves by a translation p, and the questions about it:
// distances at a position, their sign maps, the region in which a formula holds, and optima over it. p is in the
// world's unit; at p = 0 the moving shape is where it is drawn. What is computed for one question (no-fit polygons,
// trees) is kept for the next, and for the world that it becomes when other shapes change. A World is a value: copies
// are cheap, a change to one leaves the others as they are. Questions from many threads are safe. Guarantee: truths,
// signs and regions are exact at every real position; values say their bounds. Cost: shapes are built by the
// constructor, maps of two shapes when they are first asked for, after that a question costs one overlay, or the work
// at one position. Errors: findspace::Error, kUnknownName and kSyntax for a formula with its line and column,
// kUnsupported for what is not computed; Stopped at a limit of the options. Source: Pustylnik, arXiv:0808.2931.
// Keywords: configuration space, feasible region, solver, interactive layout.
#pragma once

#include <concepts>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "findspace/error.h"
#include "findspace/explanation.h"
#include "findspace/formula.h"
#include "findspace/line_map.h"
#include "findspace/motion.h"
#include "findspace/options.h"
#include "findspace/region.h"
#include "findspace/shape.h"
#include "findspace/space_region.h"
#include "findspace/values.h"

namespace findspace {

struct WorldOptions {
  std::string unit;  // um mm cm m in mil, or empty
};

/// Groups of shapes that formulas may name: "between(smd, smd) >= 1", "all except power".
struct ShapeGroups {
  /// Names of shapes. In a distance a group is the collection of those that stand still, as they are when it is made;
  /// if a shape has its name, that shape. Without one that stands still it is the empty set.
  std::map<std::string, std::vector<std::string>> groups{};
  /// What `all` and `others` mean, if not all shapes.
  std::optional<std::vector<std::string>> all{};
};

struct Optimum {
  std::optional<double> value;  // the infimum; nothing where the region is empty or there is no lower bound
  bool exact = false;           // the infimum is known exactly, `value` is that rounded
  double lower = 0, upper = 0;  // of a value: what the infimum lies between
  std::string closed_form;      // "2*sqrt(2)": of an exact value that has one; else empty
  std::string side = "exact";   // of an enclosed value "inner": a position has it; "outer": only the bounds are known
  bool unbounded = false;       // there is no lower bound
  bool attained = false;        // a position of the region takes it
  Region at;                    // all that do; else those of the region's closure
};

class Query;

class World {
 public:
  /// `moving` is one of the names. All shapes are of the plane, or all of space. Distances are those of the shapes'
  /// closures. Throws what is wrong with a shape: kGeometry, kBadValue, kOutOfRange, kUnknownName, kSyntax, kFile.
  World(const std::map<std::string, Shape>& shapes, const std::string& moving, const WorldOptions& options = {});
  /// Several move together.
  World(const std::map<std::string, Shape>& shapes, const std::vector<std::string>& moving,
        const WorldOptions& options = {});

  // ---- changes; what does not speak of the shape is kept. Queries that were made keep the world that they had
  /// A shape that is new, or replaces that of its name.
  void set(const std::string& name, const Shape& shape);
  /// Not the moving one. kUnknownName for none of that name.
  void remove(const std::string& name);
  /// A shape elsewhere.
  void move(const std::string& name, const Point& by);
  void move(const std::string& name, const Point3& by);
  /// The same world with other limits.
  World with(const Options& options) const;
  /// The same world with groups beside those that it has. kUnknownName for what is no shape.
  World with(const ShapeGroups& groups) const;
  /// The same world, of the plane, with shapes that move in time; distances may then be asked with inf and sup, and
  /// without these are least over the time. Error(kBadValue) for times that do not ascend, kUnknownName for a path of
  /// no shape.
  World with(const Motion& motion) const;
  /// The same at one instant of its motion: distances without inf and sup are those of that time.
  World at_time(const Number& time) const;

  // ---- at a position
  /// A distance in its formula text, e.g. "gap(B, A)" (docs/formula.md), at p; in degrees where it is one in rotation
  /// ("gap(B, A, rotating=(0, 0))").
  DistanceValue distance(std::string_view distance, const Point& p) const;
  DistanceValue distance(std::string_view distance, const Point3& p) const;
  DistanceValue distance(const Distance& d, const Point& p) const { return distance(d.text(), p); }
  DistanceValue distance(const Distance& d, const Point3& p) const { return distance(d.text(), p); }
  /// Whether the formula holds at p, without a map of all positions.
  bool holds(const Formula& formula, const Point& p) const;
  bool holds(const Formula& formula, const Point3& p) const;
  /// The same, with every atom and its value.
  Check check(const Formula& formula, const Point& p) const;
  Check check(const Formula& formula, const Point3& p) const;
  /// With the moving shape rotated about a point of its own first. Values are those of the shape whose vertices are put
  /// on the grid. Of the plane, without a motion.
  Check check_rotated(const Formula& formula, const Point& p, const Number& degrees, const Point& about = {0, 0}) const;

  // ---- at all positions
  /// {p : the formula holds at p} (docs/formula.md). kUnsupported in space, and for distances in rotation.
  Region solve(const Formula& formula) const;
  /// The sign of the distance minus the level, in the unit, at every position. kUnsupported as for solve.
  SignMap sign_map(std::string_view distance, const Number& level) const;
  /// The least value of an objective (a distance, x, y, "distance to [1, 2]") where the formula holds; enclosed where
  /// that region is known between bounds.
  Optimum minimize(std::string_view objective, const Formula& formula = "true") const;
  /// Why the formula holds nowhere, or how far each of its levels can be tightened; and what stands in the way at a
  /// position. kUnsupported where shapes rotate in time, and for distances in rotation; in space also for those along a
  /// direction and for `-> min`, and kLimit where a search does not decide whether there is room.
  Explanation explain(const Formula& formula, const std::optional<Point>& at = {}) const;
  Explanation explain(const Formula& formula, const Point3& at) const;
  /// {p : the formula holds at p} in space, the best ones, or what is made of them; where that is made of boxes or is a
  /// convex polytope; kUnsupported elsewhere. kBadValue for two objectives or another operation.
  SpaceRegion solve_space(const Formula& formula, const SpaceQuestion& question = {}) const;
  /// Where the formula holds, in degrees, for the moving shape at p and rotated about a point of its own (in the
  /// coordinates in which it is drawn). Intervals begin in [0, 360) and may go across 360. Of the plane, without a
  /// motion.
  std::vector<Interval> angles(const Formula& formula, const Point& p, const Point& about = {0, 0}) const;
  /// At some angles of the moving shape about a point of its own, and between neighbouring ones; or at so many angles,
  /// evenly over a turn. Of the plane.
  PoseMap poses(const Formula& formula, const std::vector<Number>& degrees, const Point& about = {0, 0}) const;
  PoseMap poses(const Formula& formula, int count, const Point& about = {0, 0}) const;
  /// explain() where the moving shape stands at one of these angles, in degrees: there is room where there is at one of
  /// them, and a conflict is one at all of them. Of the plane, without a motion.
  Explanation explain_poses(const Formula& formula, const std::vector<Number>& degrees,
                            const Point& about = {0, 0}) const;
  /// explain() for the moving shape at p, over all its angles: whether there is one, and how far each level can move
  /// until there is one, or none. Refused as angles() is. Of the plane, without a motion.
  Explanation explain_angles(const Formula& formula, const Point& p, const Point& about = {0, 0}) const;
  /// explain() over the instants of the motion, for the moving shape at p: whether there is one at which the formula
  /// holds, and how far each level can move until there is one, or none. Refused where shapes turn in time and for
  /// distances in rotation. kBadValue without a motion. Of the plane.
  Explanation explain_instants(const Formula& formula, const Point& p) const;
  /// The same as solve(), also where shapes turn in time or distances are in rotation: between bounds.
  RegionBounds solve_bounds(const Formula& formula) const;
  /// The instants of the motion at which the formula holds at p.
  Instants instants(const Formula& formula, const Point& p) const;

  // ---- in space, where a region has no exact form
  /// On many lines.
  LineMap on_lines(const Formula& formula, const Lines& lines = {}) const;
  /// Its volume.
  VolumeBounds volume(const Formula& formula, const Lines& lines = {}) const;
  /// Its surface, closed and outward: vertices lie on the boundary, on the lines of a lattice of cubes, so many along
  /// the longest side. What is thinner than a cube may be missed; what is unbounded is cut off.
  Surface surface(const Formula& formula, int count = 64) const;

  /// In space, where the formula holds along the line through a point; the direction is in integers.
  OnLine on_line(const Formula& formula, const Point3& through, const Point3& direction) const;
  /// A formula, ready for many positions; or the text of a distance, for its values.
  Query query(const Formula& formula) const;
  Query query(const Distance& distance) const;

  // ---- what it was made of
  /// As they were given, by name; the one that moves, or the first of several; the unit.
  const std::map<std::string, Shape>& shapes() const;
  const std::string& moving() const;
  /// All that move.
  const std::vector<std::string>& moving_together() const;
  std::string unit() const;
  /// 2 or 3.
  int dimension() const;
  const Options& options() const;
  /// Its groups, those without a shape too.
  ShapeGroups groups() const;
  /// The paths of shapes that move in time, and the instant of at_time().
  const std::optional<Motion>& motion() const;
  const std::optional<Number>& time() const;
  /// A shape as a point set of the plane, open ends and all. kUnknownName for none of that name.
  Region shape(const std::string& name) const;

  struct Data;
  explicit World(std::shared_ptr<const Data> data) : data_(std::move(data)) {}
  const Data& data() const { return *data_; }

 private:
  std::shared_ptr<const Data> data_;
};

/// A formula or a distance over a world, to be asked at many positions. Immutable, cheap to copy; asking from many
/// threads is safe. Guarantee: exact, as World::holds. Cost: in the plane the first question about many positions makes
/// the region of the formula, after that a position costs 10 to 100 ns; values, and positions in space, cost as much as
/// single ones. Spans are answered by all threads. Error(kBadValue) for a distance that is asked whether it holds, and
/// for a formula that is asked its values.
class Query {
 public:
  /// Whether the formula holds at one position.
  bool holds(const Point& p) const;
  bool holds(const Point3& p) const;
  template <std::same_as<Position> P>
  bool holds(const P& p) const {
    return holds_at(p);
  }
  /// Of each position; `out` is as long as `positions`.
  void holds(std::span<const Position> positions, std::span<bool> out) const;
  void holds(std::span<const Position3> positions, std::span<bool> out) const;

  /// The distance at a position, with its bounds.
  DistanceValue value(const Point& p) const;
  DistanceValue value(const Point3& p) const;
  /// The distance at each position, rounded; inf where it is undefined (of a margin or a cover -inf). `out` is as long
  /// as `positions`.
  void values(std::span<const Position> positions, std::span<double> out) const;
  void values(std::span<const Position3> positions, std::span<double> out) const;

  /// {p : the formula holds at p}, of the plane.
  const Region& region() const;
  /// The nearest feasible position, or of the closure of those; nothing where the formula holds nowhere. kUnsupported
  /// where it is not computed: in space where the region is neither made of boxes nor a convex polytope and contacts do
  /// not decide.
  std::optional<Region::Nearest> nearest(const Position& from) const;
  std::optional<Nearest3> nearest(const Position3& from) const;

  /// The world that is asked.
  const World& world() const;
  /// What was asked.
  const std::string& text() const;

  struct Data;
  explicit Query(std::shared_ptr<const Data> data) : data_(std::move(data)) {}

 private:
  bool holds_at(const Position& p) const;

  std::shared_ptr<const Data> data_;
};

}  // namespace findspace
