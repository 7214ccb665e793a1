// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/rays/round_directional.h"

#include <findspace/error.h>

#include <algorithm>

#include "distance/rays/depth_values.h"
#include "distance/rays/ray_covers.h"
#include "distance/rays/ray_signs.h"
#include "distance/rays/value_rays.h"
#include "distance/search/grown_set.h"
#include "exact/margins/space_distance.h"
#include "space/body/position_covers.h"
#include "space/rays/ray_sources.h"

namespace findspace::distance {

using exact::Real;
using space::Body;
using space::BodyPart;
using space::RayGrid;
using space::Vector;
using Source = space::RaySourcePointer;

namespace {

/// Of positions within a box: where all of `out` are at least 0, or `in` is at most 0.
struct Positions {
  std::vector<ConvexDistance> out;
  ConvexDistance in;
  Vector low, high;
};

/// Constraints along the ways of a query.
class Sweeper {
 public:
  Sweeper(const DirectionalQuery& query, std::int64_t scale, const RayGrid& grid)
      : unit_(space::rounded(query.unit)), both_ways_(query.both_ways), scale_(scale), grid_(grid) {}

  /// Forward, or both ways, as far as that.
  PathStretch way(double reach) const { return {unit_, both_ways_ ? -reach : 0, reach}; }
  PathStretch stretch(double from, double to) const { return {unit_, from, to}; }

  /// - where all of the way lies in the union of the open sets that the functions are less than 0 in.
  Source held(const Positions& sets, const PathStretch& way) const {
    return map(sets, way, [functions = sets.out, way](const Vector& p, double size) {
      return greatest_of_least(functions, p, way, size);
    });
  }
  /// - where some place of the way belongs to the inside of the positions, + where none belongs.
  Source met(const Positions& fits, const PathStretch& way) const {
    return map(fits, way, [fits, way](const Vector& p, double size) {
      if (fits.in) return least_on(fits.in, p, way, size);
      const Between most = greatest_of_least(fits.out, p, way, size);
      return Between{-most.high, -most.low};
    });
  }
  /// - where all places of the way do.
  Source kept(const Positions& fits, const PathStretch& way) const {
    return map(fits, way, [fits, way](const Vector& p, double size) {
      if (!fits.in) {
        const Between least = least_on(fits.out, p, way, size);
        return Between{-least.high, -least.low};
      }
      const auto at = [&](double s) { return fits.in(space::plus(p, space::scaled(s, way.unit))); };
      const double most = std::max(at(way.from), at(way.to)), noise = margin::kRayNoise * size;
      return Between{most - noise, most + noise};
    });
  }

 private:
  using Rule = std::function<Between(const Vector&, double)>;

  Source map(const Positions& set, const PathStretch& way, const Rule& rule) const {
    const double reach = std::max(std::fabs(way.from), std::fabs(way.to));
    const double size = space::length(set.high - set.low) + 2 * reach + 1;
    const double all = size + space::size_of(set.low) + space::size_of(set.high);
    const RayRule at = [rule, all](const space::RealVector& p) { return rule(space::rounded(p), all); };
    return std::make_unique<ValueRays>(at, space::scaled(0.5, space::plus(set.low, set.high)), size, scale_, grid_);
  }

  Vector unit_;
  bool both_ways_;
  std::int64_t scale_;
  RayGrid grid_;
};

Vector box_corner(const Body& a, const Body& b, bool high, bool fit) {
  const space::Bounds3 outer = bounds(a), inner = bounds(b);
  if (high) return space::rounded(space::minus(outer.high, fit ? inner.high : inner.low));
  return space::rounded(space::minus(outer.low, fit ? inner.low : inner.high));
}

/// The open sets of U.
Positions overlaps(const Body& b, const Body& a) {
  Positions out{{}, {}, box_corner(a, b, false, false), box_corner(a, b, true, false)};
  for (const BodyPart& t : a.parts) {
    for (const BodyPart& s : b.parts) out.out.push_back(grown_distance(difference(t, s)));
  }
  return out;
}

/// How far a corner of B is from A, less the radii, at most.
ConvexDistance corner_distance(const Body& b, const BodyPart& a) {
  struct Corner {
    Vector at;
    double radius;
  };
  std::vector<Corner> corners;
  for (const BodyPart& part : b.parts) {
    for (const space::Point& v : part.vertices()) corners.push_back({exact::approx(v), part.radius.to_double()});
  }
  return [corners, to = grown_distance({a.planes(), space::real(a.center), a.radius})](const Vector& p) {
    double most = -exact::kInfinity;
    for (const Corner& c : corners) most = std::max(most, to(space::plus(p, c.at)) + c.radius);
    return most;
  };
}

/// E; A is convex, or without radii.
Positions fits(const Body& b, const Body& a) {
  Positions out{{}, {}, box_corner(a, b, false, true), box_corner(a, b, true, true)};
  if (a.convex()) {
    out.in = corner_distance(b, a.parts[0]);
    return out;
  }
  const std::vector<space::OutsideCell> cells = space::outside_cells(a);
  for (const BodyPart& part : b.parts) {
    Body core;
    core.scale = b.scale;
    core.parts.push_back(part);
    core.parts[0].radius = Real();
    const space::OpenUnion cover = space::outside_cover(core, cells);
    for (std::size_t k = 0; k < cover.size(); ++k)
      out.out.push_back(grown_distance({cover.planes(k), {}, part.radius}));
  }
  return out;
}

}  // namespace

Source round_depth_map(const Real& level, const DirectionalQuery& query, const Body& b, const Body& a,
                       const RayGrid& grid) {
  const Sweeper sweep(query, b.scale, grid);
  return sweep.held(overlaps(b, a), sweep.way(-level.to_double()));
}

exact::Tried<Source> round_fit_map(const Real& level, const DirectionalQuery& query, const Body& b, const Body& a,
                                   const RayGrid& grid) {
  if (a.round() && !a.convex())
    return exact::Refusal(
        "containment in a union of round parts along a direction is computed on rays at level 0 only");
  const Positions places = fits(b, a);
  const Vector size = places.high - places.low;
  const bool never = size.x < 0 || size.y < 0 || size.z < 0;
  if (never || (query.farthest && level.sign() < 0)) return space::constant_rays(grid, 1);
  const Sweeper sweep(query, b.scale, grid);
  const double reach = std::fabs(level.to_double());
  if (!query.farthest)
    return level.sign() > 0 ? sweep.met(places, sweep.way(reach)) : sweep.kept(places, sweep.way(reach));
  std::vector<Source> all;
  // At level 0 only what is met at once counts.
  all.push_back(level.sign() > 0 ? sweep.met(places, sweep.way(reach))
                                 : space::mapped_rays(ray_sign_map(Which::kEta1, Real(), b, a, grid),
                                                      [](int s) { return s <= 0 ? 0 : 1; }));
  // From within the level of a place no other place is farther than this.
  const double most = reach + space::length(size) + 1;
  all.push_back(space::negated_rays(sweep.met(places, sweep.stretch(reach, most))));
  if (query.both_ways) all.push_back(space::negated_rays(sweep.met(places, sweep.stretch(-most, -reach))));
  return space::greatest_rays(std::move(all));
}

}  // namespace findspace::distance
