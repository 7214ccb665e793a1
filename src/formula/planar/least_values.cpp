// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "formula/planar/least_values.h"

#include <algorithm>
#include <cmath>

#include "distance/planar_least/directional_least.h"
#include "distance/planar_least/level_extremum.h"
#include "exact/margins/formula.h"
#include "formula/language/text.h"
#include "formula/planar/position_functions.h"
#include "formula/planar/rotation_values.h"
#include "plane/query/topology.h"

namespace findspace::formula {

using distance::DiscRange;
using distance::PositionBounds;
using distance::SearchWindow;
using distance::Sense;
using distance::ValueRange;
using exact::kInfinity;
using exact::RealPoint;
using plane::CellComplex;
using plane::Mark;

namespace {

constexpr std::size_t kBoxes = 600, kBoxesOverTime = 320, kBoxesOfRotationOverTime = 24;

double far(const RealPoint& p) { return std::hypot(distance::near_value(p.x), distance::near_value(p.y)); }

/// 0 where shapes are far apart; the others grow with the way.
bool ends(Kind kind) { return kind == Kind::kPenetration || kind == Kind::kDstar; }

/// All values of a distance over discs of positions.
DiscRange disc_range(const PreparedWorld& world, const Roles& r) {
  const Sense sense = sense_over_time(r.wanted);
  if (r.wanted.mode == Mode::kRotation) {
    return [f = rotation_in_time(world, r, {}, false), sense](const RealPoint& p, double radius) {
      return f.around(p, radius).extremum(sense);
    };
  }
  if (!has_rate(r.wanted.kind))
    refuse(r.wanted, "has no best position of shapes that rotate in time: the places where a shape fits come and go");
  return [f = rotation_motion(world, r, false), sense](const RealPoint& p, double radius) {
    const auto v = f.extremum(p, sense, radius / 4);
    if (!v) return ValueRange{kInfinity, kInfinity};
    if (radius > 0 && v->low == v->high && std::isinf(v->low)) return ValueRange{-kInfinity, kInfinity};  // here alone
    return ValueRange{v->low - radius, v->high + radius};
  };
}

/// Where to look for the best; `unbounded`: positions go on without end.
SearchWindow search_window(const PreparedWorld& world, const Roles& r, const plane::Region& over, bool unbounded) {
  const plane::SharedRegion a = world.shape(r.names.second);
  const bool rotation = r.wanted.mode == Mode::kRotation;
  double size = 2 + distance::reach(world.shape(r.names.first)) + distance::reach(a), way = 0;
  for (const distance::RotatingPose& p : rotation_poses(world, r, false))
    way = std::max(way, far(p.at) + 2 * far(p.fixed_at));
  if (rotation) size += 2 * far(world.steps({r.wanted.vector.at(0), r.wanted.vector.at(1)}));
  size += way;
  SearchWindow out{{},
                   !rotation && !ends(r.wanted.kind),
                   rotation ? margin::kBestDegrees : margin::kBestPart * size,
                   !world.motion().given() ? kBoxes
                   : rotation              ? kBoxesOfRotationOverTime
                                           : kBoxesOverTime};
  if (out.worse_outside && unbounded) {
    if (!plane::is_bounded(a) || !plane::is_bounded(world.shape(r.names.first)))
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

distance::Extremum least_directional(const PreparedWorld& world, const Roles& r) {
  return distance::least_directional(directional_base(world, r)->base(), direction(r.wanted),
                                     is_farthest(r.wanted.kind));
}

distance::Extremum least_over_time(const PreparedWorld& world, const Distance& wanted) {
  return level_extremum(*position_function(world, wanted), CellComplex::uniform(1), Sense::kMinimum,
                        wanted.mode == Mode::kPlain);
}

distance::Extremum found_least(const PreparedWorld& world, const Distance& wanted) {
  const plane::Region whole = CellComplex::uniform(1);
  if (is_bounded(world, wanted)) return best_position(world, wanted, {whole, whole}, Sense::kMinimum);
  if (world.motion().given()) return least_over_time(world, wanted);
  if (is_directional(wanted)) return least_directional(world, world.roles(wanted));
  return distance::least(*objective_distance(world, wanted));
}

}  // namespace

distance::Extremum best_position(const PreparedWorld& world, const Distance& wanted, const PositionBounds& over,
                                 Sense sense, bool goes_on) {
  const Roles r = world.roles(wanted);
  const DiscRange range = disc_range(world, r);
  const bool looks_far = goes_on && (sense == Sense::kMinimum || plane::is_bounded(world.shape(r.names.second)));
  const bool unbounded = looks_far || over.possible.faces[0].mark > 0;
  const SearchWindow window = search_window(world, r, over.possible, unbounded && range({}, 0).low < kInfinity);
  if (looks_far && window.worse_outside && sense == Sense::kMaximum)
    return distance::no_optimum<plane::Region>(sense, true);
  return distance::best_position(range, over, sense, window);
}

distance::Extremum least_at_rest(const PreparedWorld& world, const Roles& r) {
  if (is_directional(r.wanted)) return least_directional(world, r);
  if (r.wanted.mode != Mode::kPlain)
    refuse(r.wanted, "the least value over positions at an instant is not computed in rotation");
  return distance::least(*searched_distance(world, r));
}

distance::Extremum least(const PreparedWorld& world, const Distance& wanted) {
  const std::string key = text(wanted);
  if (auto known = world.least_values().find(key)) return *std::move(known);
  return world.least_values().keep(key, found_least(world, wanted));
}

plane::SignMap minimiser_map(distance::Extremum least) {
  if (!least.exists()) return CellComplex::uniform(1);
  return plane::remark(std::move(least.at), [](Mark k) { return Mark(k > 0 ? 0 : 1); });
}

}  // namespace findspace::formula
