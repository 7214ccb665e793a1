// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/csg/swept_part.h"

#include <algorithm>
#include <cmath>

#include "exact/margins/space_distance.h"
#include "exact/number/interval.h"

namespace findspace::distance {

using space::dot;
using space::Point;
using space::Vector;

namespace {

Touching nearest_plane(const std::vector<NearPlane>& planes, const Vector& x) {
  Touching best{-exact::kInfinity, {}};
  for (const NearPlane& h : planes) {
    const double value = dot(h.unit, x) + h.shift;
    if (value > best.value) best = {value, h.unit};
  }
  return best;
}

}  // namespace

SweptPart::SweptPart(const space::BodyPart& part, const Vector& unit)
    : unit_(unit), center_(exact::approx(part.center)), radius_(part.radius.to_double()), point_(part.point()) {
  if (point_) return;
  for (const space::HalfSpace& h : part.planes()) planes_.push_back({h.unit, h.shift});
  const auto corners = part.vertices();
  const auto add = [&](const Point& from, const Point& to) {
    add_silhouette(corners, exact::approx(from), exact::approx(to - from));
  };
  if (part.core) {
    for (const space::HalfEdge& h : part.core->half_edges())
      add(corners[static_cast<std::size_t>(h.origin)], corners[static_cast<std::size_t>(h.target)]);
    return;
  }
  for (std::size_t k = 0; k < corners.size(); ++k) {
    for (std::size_t n = 0; n < corners.size(); ++n) {
      if (n != k) add(corners[k], corners[n]);
    }
  }
}

/// The plane along the edge and the way, if all is on one side of it. An edge comes once each way.
void SweptPart::add_silhouette(std::span<const Point> corners, const Vector& corner, const Vector& edge) {
  Vector n = space::cross(edge, unit_);
  const double size = space::length(n);
  if (size <= margin::kSameNormal * space::length(edge)) return;  // nothing new: the edge is swept along itself
  n = space::scaled(1 / size, n);
  double most = -exact::kInfinity, wide = 0;
  for (const Point& p : corners) {
    const Vector v = exact::approx(p);
    most = std::max(most, dot(n, v));
    wide = std::max(wide, space::size_of(v));
  }
  if (most > dot(n, corner) + margin::kSameNormal * wide) return;
  const auto same = [&](const NearPlane& h) { return space::length(h.unit - n) < margin::kSameNormal; };
  if (std::any_of(planes_.begin(), planes_.end(), same) || std::any_of(along_.begin(), along_.end(), same)) return;
  along_.push_back({n, -most});
}

TouchingConstraint SweptPart::gap(const Vector& start, double from, double to) const {
  if (point_) {
    return [away = distance_to_segment(space::plus(start, center_), unit_, from, to), r = radius_](const Vector& x) {
      Touching at = away(x);
      at.value -= r;
      return at;
    };
  }
  std::vector<NearPlane> planes = planes_;
  for (NearPlane& h : planes) {
    const double ahead = dot(h.unit, unit_);
    h.shift -= std::max(from * ahead, to * ahead);
  }
  if (from < to) planes.insert(planes.end(), along_.begin(), along_.end());
  return [way = way_to(planes), planes, start, radius = radius_](const Vector& x) {
    const Vector at = x - start;
    if (radius == 0) {
      const Touching inside = nearest_plane(planes, at);
      if (inside.value < 0) return inside;
    }
    const Vector off = way(at);
    const double d = space::length(off);
    // So near the core the slope is rounding; 0 is one as well.
    if (d <= margin::kNoSlope * (space::size_of(at) + 1)) return Touching{-radius, {}};
    return Touching{d - radius, space::scaled(-1 / d, off)};
  };
}

TouchingConstraint distance_to_segment(const Vector& start, const Vector& unit, double from, double to) {
  return [=](const Vector& x) {
    Vector off = x - start;
    off = off - space::scaled(std::clamp(dot(off, unit), from, to), unit);
    const double d = space::length(off);
    return Touching{d, d > 0 ? space::scaled(1 / d, off) : Vector{}};
  };
}

}  // namespace findspace::distance
