// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/search/solid_protrusion.h"

#include <algorithm>

#include "distance/search/convex_distance.h"
#include "distance/search/grown_set.h"
#include "distance/search/position_set.h"
#include "distance/search/round_solid.h"
#include "exact/margins/space_distance.h"

namespace findspace::distance {

using exact::Real;
using space::Body;
using space::BodyPart;
using space::dot;
using space::HalfSpace;
using space::is_zero;
using space::real;
using space::RealVector;
using space::Vector;

namespace {

Real length(const RealVector& v) { return sqrt(space::dot(v, v)); }

/// The greatest plane value over its normal's length at x, among planes that come near it in doubles.
Real depth_value(std::span<const HalfSpace> planes, const RealVector& x, const Vector& near, double top) {
  std::optional<Real> best;
  for (const HalfSpace& h : planes) {
    if (h.approx_value(near) < top - 2 * h.error(near)) continue;
    const Real value = h.value(x) / sqrt(dot(h.normal, h.normal));
    if (!best || *best < value) best = value;
  }
  return *best;
}

struct FarCorner {
  const BodyPart* part;
  RealVector at;
  Vector near;
  double floor = 0;  // at most the signed distance to the core, plus the part's radius
};

}  // namespace

RoundSolid round_solid(const BodyPart& part, const Vector& by) {
  RoundSolid out;
  out.radius = part.radius.to_double();
  const std::span<const space::Point> ends = part.vertices();
  if (ends.size() <= 2) {
    out.from = space::plus(exact::approx(ends.front()), by);
    out.to = space::plus(exact::approx(ends.back()), by);
    return out;
  }
  out.way = [way = way_to(part.planes()), by](const Vector& x) { return way(x - by); };
  const Vector first = space::plus(exact::approx(ends.front()), by);
  space::Extent box{first, first};
  for (const space::Point& v : ends) {
    const Vector at = space::plus(exact::approx(v), by);
    box.add({at, at});
  }
  out.from = box.low;
  out.to = box.high;
  return out;
}

bool polyhedra_and_balls(const Body& b) {
  return std::none_of(b.parts.begin(), b.parts.end(),
                      [](const BodyPart& part) { return !part.point() && part.radius.sign() > 0; });
}

std::optional<std::pair<Body, Body>> without_radius(const Body& b, const Body& a) {
  const Real by = a.parts[0].radius;
  std::pair<Body, Body> out{b, a};
  for (BodyPart& part : out.first.parts) {
    if (part.radius < by) return std::nullopt;
    part.radius -= by;
  }
  out.second.parts[0].radius = Real();
  return out;
}

Answer protrusion_of_convex(const Body& b, const BodyPart& a, const RealVector& p) {
  const std::vector<HalfSpace> planes = a.planes();
  const RealVector center = real(a.center);
  std::vector<FarCorner> corners;
  for (const BodyPart& part : b.parts) {
    for (const space::Point& v : part.vertices()) {
      FarCorner c{&part, space::plus(real(v), p), {}, 0};
      c.near = space::rounded(c.at);
      double highest = !a.point() ? -exact::kInfinity : space::length(c.near - space::rounded(center));
      for (const HalfSpace& h : planes) highest = std::max(highest, h.approx_value(c.near));
      c.floor = highest + part.radius.to_double();
      corners.push_back(std::move(c));
    }
  }
  std::sort(corners.begin(), corners.end(), [](const FarCorner& x, const FarCorner& y) { return x.floor > y.floor; });
  std::optional<Answer> best;
  std::vector<Vector> projections;
  const double slack = margin::kFarCorner * (space::size_of(corners[0].near) + std::fabs(corners[0].floor));
  for (const FarCorner& c : corners) {
    const double radius = c.part->radius.to_double();
    const double highest = c.floor - radius;
    double ceiling = highest > 0 ? exact::kInfinity : highest;
    for (const Vector& q : projections) ceiling = std::min(ceiling, space::length(c.near - q));
    const double known = best ? (best->value + a.radius).to_double() : 0;
    if (best && ceiling + radius < known - slack) continue;
    RealVector projection = center;
    Real core;
    if (a.point()) {
      core = length(space::minus(c.at, center));
    } else if (highest < -slack) {
      core = depth_value(planes, c.at, c.near, highest);
    } else {
      projection = *nearest_in(planes, c.at);
      projections.push_back(space::rounded(projection));
      const RealVector off = space::minus(c.at, projection);
      core = is_zero(off) ? depth_value(planes, c.at, c.near, highest) : length(off);
    }
    const Real value = core + c.part->radius - a.radius;
    if (best && !(best->value < value)) continue;
    best = Answer{};
    best->value = value;
    if (core.sign() > 0) {
      const RealVector away = space::minus(c.at, projection);
      best->witness =
          point_pair(space::along(c.at, c.part->radius / core, away), space::along(projection, a.radius / core, away));
    }
  }
  return *best;
}

Solids solids_of(const Body& b, const RealVector& p) {
  Solids out;
  const Vector by = space::rounded(p);
  for (const BodyPart& part : b.parts) {
    if (!part.core || part.radius.sign() > 0) {
      out.round.push_back(round_solid(part, by));
    } else {
      for (const space::Point& v : part.vertices()) out.corners.push_back(space::plus(exact::approx(v), by));
      for (Tetrahedron& t : tetrahedra(*part.core)) {
        for (Vector& v : t) v = space::plus(v, by);
        out.cells.push_back(t);
      }
    }
  }
  return out;
}

namespace {

/// To the nearest set.
Answer exact_distance(std::span<const GrownSet> targets, const RealVector& at) {
  NearestBall nearest(at);
  for (const GrownSet& t : targets)
    nearest.offer(space::minus(t.planes.empty() ? t.center : *nearest_in(t.planes, at), at), t.radius);
  return *nearest.found();
}

/// From the union of the sets.
Answer protrusion(const Body& b, std::span<const GrownSet> targets, const RealVector& p) {
  std::vector<ConvexDistance> distances;
  for (const GrownSet& t : targets) distances.push_back(grown_distance(t));
  return protrusion_answer(solid_max_min(solids_of(b, p), distances, 0), sharp_corners(b), p,
                           [&](const RealVector& at) { return exact_distance(targets, at); });
}

}  // namespace

void NearestBall::offer(const RealVector& way, const Real& radius) {
  const Real core = length(way), value = core - radius;
  if (found_ && !(value < found_->value)) return;
  found_ = Answer{};
  found_->value = value;
  if (core.sign() > 0) found_->witness = point_pair(from_, space::along(from_, value / core, way));
}

std::vector<space::Point> sharp_corners(const Body& b) {
  std::vector<space::Point> out;
  for (const BodyPart& part : b.parts) {
    if (part.radius.sign() == 0) out.insert(out.end(), part.vertices().begin(), part.vertices().end());
  }
  return out;
}

std::optional<RealVector> corner_at(std::span<const space::Point> corners, const RealVector& p, const Vector& place,
                                    double size) {
  const Vector off = place - space::rounded(p);
  for (const space::Point& v : corners) {
    if (space::length(exact::approx(v) - off) <= margin::kAtVertex * size) return space::plus(real(v), p);
  }
  return std::nullopt;
}

Answer protrusion_answer(const SolidMaxMin& found, std::span<const space::Point> corners, const RealVector& p,
                         const std::function<Answer(const RealVector&)>& exact) {
  const double size = space::size_of(found.place);
  if (const auto at = found.complete ? corner_at(corners, p, found.place, size) : std::nullopt) return exact(*at);
  return unproven_answer(found.value, found.bound - found.value + margin::kFoundError * size);
}

Answer protrusion_of_union(const Body& b, const Body& a, const RealVector& p) {
  std::vector<GrownSet> targets;
  for (const BodyPart& part : a.parts) targets.push_back(grown_set(part));
  return protrusion(b, targets, p);
}

Answer protrusion_of_cells(const Body& b, std::span<const space::OutsideCell> a, const RealVector& p) {
  std::vector<GrownSet> targets;
  for (const space::OutsideCell& cell : a) targets.push_back({cell.planes, {}, Real()});
  return protrusion(b, targets, p);
}

}  // namespace findspace::distance
