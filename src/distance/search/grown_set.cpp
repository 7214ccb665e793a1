// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/search/grown_set.h"

#include <algorithm>

#include "distance/search/convex_distance.h"
#include "exact/margins/space_distance.h"
#include "plane/base/search_work.h"
#include "space/body/open_union.h"
#include "space/body/position_covers.h"

namespace findspace::distance {

using exact::Real;
using space::HalfSpace;
using space::RealVector;
using space::Vector;

namespace {

/// The greatest value of the planes, or one that is not less than 0.
double greatest_value(std::span<const HalfSpace> planes, const Vector& x) {
  double most = -exact::kInfinity;
  for (const HalfSpace& h : planes) {
    most = std::max(most, h.approx_value(x));
    if (most >= 0) break;
  }
  return most;
}

}  // namespace

ConvexDistance grown_distance(const GrownSet& set) {
  const double radius = set.radius.to_double();
  if (set.planes.empty())
    return
        [center = space::rounded(set.center), radius](const Vector& x) { return space::length(x - center) - radius; };
  return [planes = set.planes, distance = distance_to(set.planes), radius](const Vector& x) {
    const double most = greatest_value(planes, x);
    return (most < 0 ? most : distance(x)) - radius;
  };
}

TouchingConstraint less_radius(TouchingConstraint away, double radius) {
  return [away = std::move(away), radius](const Vector& x) {
    Touching at = away(x);
    at.value -= radius;
    return at;
  };
}

TouchingConstraint touching_distance(const space::BodyPart& part, const Vector& p, double radius) {
  if (part.point()) return less_radius(distance_to_point(space::plus(exact::approx(part.center), p)), radius);
  return touching_way(way_to(part.planes()), p, radius);
}

TouchingConstraint touching_way(std::function<Vector(const Vector&)> way, const Vector& p, double radius) {
  return [way = std::move(way), p, radius](const Vector& x) {
    const Vector at = x - p, off = way(at);
    const double d = space::length(off);
    // So near the core the slope is rounding; 0 is one as well.
    if (d <= margin::kNoSlope * (space::size_of(at) + 1)) return Touching{-radius, {}};
    return Touching{d - radius, space::scaled(-1 / d, off)};
  };
}

bool GrownSet::holds(const RealVector& p) const {
  const Vector near = space::rounded(p);
  if (planes.empty()) {
    const RealVector off = space::minus(p, center);
    return space::dot(off, off) < radius * radius;
  }
  const bool inside =
      std::all_of(planes.begin(), planes.end(), [&](const HalfSpace& h) { return h.sign(p, near) < 0; });
  if (inside || radius.sign() == 0) return inside;
  const RealVector off = space::minus(p, *nearest_in(planes, p));
  return space::dot(off, off) < radius * radius;
}

Answer GrownSet::to_boundary(const RealVector& p) const {
  RealVector projection = center;
  bool inside = false;
  if (!planes.empty()) {
    const plane::ScopedSearchWork of_no_question(nullptr);  // a few looks, also where that may take no more
    space::OpenUnion core;
    core.add(space::everywhere(), planes);
    inside = core.covers(p);
    projection = *(inside ? core.nearest_in_complement(p).settled().or_throw() : nearest_in(planes, p));
  }
  const RealVector w = space::minus(p, projection);
  const Real d = sqrt(space::dot(w, w));
  Answer out;
  out.value = (inside ? -d : d) - radius;
  // The boundary lies a radius further out, on the line through p; at d = 0 the line is not known.
  if (out.value.sign() != 0 && d.sign() != 0)
    out.nearest = space::along(projection, (inside ? -radius : radius) / d, w);
  return out;
}

TouchingConstraint highest_plane(std::vector<HalfSpace> planes, const Vector& p, double inward) {
  return [planes = std::move(planes), p, inward](const Vector& x) { return highest_of(planes, x - p, inward); };
}

TouchingConstraint touching_boundary(const space::BodyPart& part, const Vector& p, double radius) {
  TouchingConstraint away = touching_distance(part, p, radius);
  if (!part.core) return away;
  return [inside = highest_plane(part.planes(), p, -radius), away = std::move(away), radius](const Vector& x) {
    const Touching at = inside(x);
    if (at.value < -radius) return at;
    const Touching out = away(x);
    return space::length(out.slope) > 0 ? out : at;  // so near a face its plane says the slope
  };
}

TouchingConstraint distance_to_point(const Vector& p) {
  return [p](const Vector& x) {
    const double d = space::length(x - p);
    return Touching{d, d > 0 ? space::scaled(1 / d, x - p) : Vector{}};
  };
}

GrownSet grown_set(const space::BodyPart& part) { return {part.planes(), space::real(part.center), part.radius}; }

std::vector<GrownSet> differences_of_parts(const space::Body& a, const space::Body& b) {
  std::vector<GrownSet> out;
  for (const space::BodyPart& t : a.parts) {
    for (const space::BodyPart& s : b.parts) out.push_back(difference(t, s));
  }
  return out;
}

std::vector<GrownSet> differences_of_outside(const space::Body& a, const space::Body& b) {
  std::vector<GrownSet> out;
  const std::vector<space::OutsideCell> cells = space::outside_cells(a);
  for (const space::BodyPart& part : b.parts) {
    space::Body core;
    core.scale = b.scale;
    core.parts.push_back(part);
    core.parts[0].radius = Real();
    const space::OpenUnion cover = space::outside_cover(core, cells);
    for (std::size_t k = 0; k < cover.size(); ++k) out.push_back({cover.planes(k), {}, part.radius});
  }
  return out;
}

GrownSet difference(const space::BodyPart& a, const space::BodyPart& b) {
  return {space::difference_planes(a, b), space::real(a.center - b.center), a.radius + b.radius};
}

}  // namespace findspace::distance
