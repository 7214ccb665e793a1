// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Solver: the best positions of distances in rotation and of shapes that turn in time, by branch and bound
// (best_position.h); and the positions that `-> min` of such certainly and possibly means.

#include <algorithm>
#include <cmath>
#include <limits>

#include "formula/language/which.h"
#include "formula/planar/solve.h"
#include "plane/query/topology.h"

namespace findspace::formula {

using distance::DiscRange;
using distance::PositionBounds;
using distance::SearchWindow;
using distance::Sense;
using distance::ValueRange;
using exact::Real;
using exact::RealPoint;
using plane::CellComplex;
using plane::Mark;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::size_t kBoxes = 600, kBoxesOverTime = 320, kBoxesOfRotationOverTime = 24;
constexpr double kCloseDegrees = 1e-7, kClosePart = 1e-9;  // no sign: where a search may end
const Real kAllRotations(-180);                            // below it a rotational distance is -infinity

double far(const RealPoint& p) { return std::hypot(distance::near_value(p.x), distance::near_value(p.y)); }

/// Changes no faster than its shapes move, wherever they are.
bool has_rate(Kind kind) {
  return kind != Kind::kEta1 && kind != Kind::kEta2 && kind != Kind::kDelta1 && kind != Kind::kDelta2;
}

/// 0 where shapes are far apart; the others grow with the way.
bool ends(Kind kind) { return kind == Kind::kPenetration || kind == Kind::kDstar; }

}  // namespace

bool Solver::is_bounded(const Distance& wanted) const {
  return wanted.mode == Mode::kRotation || roles(wanted).rotating;
}

DiscRange Solver::disc_range(const Roles& r) const {
  const Sense sense = sense_over_time(r.wanted);
  if (r.wanted.mode == Mode::kRotation) {
    return [f = rotation_in_time(r, {}, false), sense](const RealPoint& p, double radius) {
      return f.around(p, radius).extremum(sense);
    };
  }
  if (!has_rate(r.wanted.kind))
    refuse(r.wanted, "has no best position of shapes that turn in time: the places where a shape fits come and go");
  return [f = rotation_motion(r, false), sense](const RealPoint& p, double radius) {
    const auto v = f.extremum(p, sense, radius / 4);
    return v ? ValueRange{v->low - radius, v->high + radius} : ValueRange{kInfinity, kInfinity};
  };
}

SearchWindow Solver::search_window(const Roles& r, const plane::Region& over) const {
  const plane::Region a = shape(r.names.second);
  const bool rotation = r.wanted.mode == Mode::kRotation;
  double size = 2 + distance::reach(shape(r.names.first)) + distance::reach(a), way = 0;
  for (const distance::RotatingPose& p : rotation_poses(r, false)) way = std::max(way, far(p.at) + 2 * far(p.fixed_at));
  if (rotation) size += 2 * far(steps({r.wanted.vector.at(0), r.wanted.vector.at(1)}));
  size += way;
  SearchWindow out{{},
                   !rotation && !ends(r.wanted.kind),
                   rotation ? kCloseDegrees : kClosePart * size,
                   !world_.motion.given() ? kBoxes
                   : rotation             ? kBoxesOfRotationOverTime
                                          : kBoxesOverTime};
  if (out.worse_outside && over.faces[0].mark > 0) {
    if (!plane::is_bounded(a))
      refuse(r.wanted, "over unbounded positions, of an unbounded shape, no best is looked for");
    // Some position has at most |p| + size; one farther off by twice that has more.
    double nearest = 0;
    if (!over.vertices.empty()) nearest = far(over.geometry.exact(over.vertices[0].point));
    size = 2 * (nearest + size);
  }
  size = std::ceil(size);
  out.box = {-size, -size, size, size};
  return out;
}

distance::Extremum Solver::best_position(const Distance& wanted, const PositionBounds& over, Sense sense) const {
  const Roles r = roles(wanted);
  return distance::best_position(disc_range(r), over, sense, search_window(r, over.possible));
}

/// The least value lies between bounds, and so do the positions: those where the lower bound of the distance is not
/// above the least value's upper one.
distance::BoundedMaps Solver::bounded_minimisers(const SignMap& wanted) const {
  const distance::Extremum best = least(wanted.distance);
  const auto map = [](plane::SignMap m, auto belongs) {
    return plane::remark(std::move(m), [belongs](Mark k) { return Mark(belongs(k) ? 0 : 1); });
  };
  if (best.unbounded && wanted.distance.mode == Mode::kRotation) {
    const distance::BoundedMaps all = bounded_maps({wanted.distance, kAllRotations});
    const auto below = [](Mark k) { return k < 0; };
    return {map(all.low, below), map(all.high, below)};
  }
  if (!best.exists) return {CellComplex::uniform(best.proven ? 1 : 0), CellComplex::uniform(1)};
  const bool rotation = wanted.distance.mode == Mode::kRotation;
  const double level = distance::near_value(best.level);
  const Real above = Real::from_double(level + (std::abs(level) + 1) * 0x1p-40);
  const distance::BoundedMaps near = bounded_maps({wanted.distance, rotation ? above : above * world_.step});
  return {map(near.low, [](Mark k) { return k <= 0; }), CellComplex::uniform(1)};
}

}  // namespace findspace::formula
