// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/planar_features/common_corner.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "exact/margins/planar_distance.h"

namespace findspace::distance {

using plane::Edge;
using plane::Index;
using plane::kNone;
using plane::Region;

namespace {

/// +1 where the place is above the edge, whose ends lie on both sides of it, -1 below; 0 where numbers cannot tell.
int height(const Region& r, Index edge, double x, double y, double tolerance) {
  const Edge& e = r.edges[edge];
  const exact::Point &p = r.point(e.v0), &q = r.point(e.v1);
  tolerance += p.error + q.error;
  if (e.half == 0) {
    const double low = std::min(p.y, q.y), high = std::max(p.y, q.y);
    if (y > high + tolerance) return 1;
    if (y < low - tolerance) return -1;
    const double ahead = (q.x - p.x) * (y - p.y), up = (q.y - p.y) * (x - p.x), width = q.x - p.x + high - low;
    if (std::abs(ahead - up) <= 4 * tolerance * width) return 0;
    return ahead > up ? 1 : -1;
  }
  const exact::SupportingCurve& k = r.supporting_curve(edge);
  const double dy = (y - k.y().value) * e.half, gap = std::hypot(x - k.x().value, y - k.y().value) - k.z().value;
  const double near = 4 * (tolerance + k.z().value * margin::kLostByDoubles + k.x().error + k.y().error + k.z().error);
  if (dy < -near || gap < -near) return -e.half;  // on the side of the chord
  return dy > near && gap > near ? e.half : 0;
}

/// The place lies in an open face of the set: 1, outside: 0; or -1.
int side(const Region& r, double x, double y, double tolerance) {
  bool inside = r.faces[0].mark > 0;
  for (Index e = 0; e < r.edges.size(); ++e) {
    const exact::Point &p = r.point(r.edges[e].v0), &q = r.point(r.edges[e].v1);
    const double left = p.error + tolerance, right = q.error + tolerance;
    if (x < p.x - left || x > q.x + right) continue;
    if (x <= p.x + left || x >= q.x - right) return -1;
    const int above = height(r, e, x, y, tolerance);
    if (above == 0) return -1;
    const auto within = [&](Index h) { return r.faces[r.face(h)].mark > 0; };
    if (above < 0 && within(2 * e) != within(2 * e + 1)) inside = !inside;
  }
  return inside;
}

}  // namespace

Boxed::Boxed(const Region& r) : region(r) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  double x0 = kFar, y0 = kFar, x1 = -kFar, y1 = -kFar;
  for (const plane::Vertex& v : region.vertices) {
    const exact::Point& p = region.geometry.points[v.point];
    x0 = std::min(x0, p.x);
    x1 = std::max(x1, p.x);
    y0 = std::min(y0, p.y);
    y1 = std::max(y1, p.y);
  }
  if (x0 > x1) return;
  half_width = (x1 - x0) / 2;
  half_height = (y1 - y0) / 2;
  x = x0 + half_width;
  y = y0 + half_height;
  scale += std::max({std::abs(x0), std::abs(x1), std::abs(y0), std::abs(y1)});
}

std::optional<Index> vertex_within(const Boxed& of, const Boxed& in, double dx, double dy) {
  const double shift_x = dx - in.x, shift_y = dy - in.y;  // to the middle of `in`
  if (std::abs(of.x + shift_x) > of.half_width + in.half_width ||
      std::abs(of.y + shift_y) > of.half_height + in.half_height)
    return std::nullopt;
  Index best = kNone;
  double least = std::numeric_limits<double>::infinity();
  for (Index v = 0; v < of.region.vertices.size(); ++v) {
    if (of.region.vertices[v].mark <= 0) continue;
    const exact::Point& p = of.region.point(v);
    const double x = p.x + shift_x, y = p.y + shift_y, squared = x * x + y * y;
    if (squared < least) {
      least = squared;
      best = v;
    }
  }
  if (best == kNone) return std::nullopt;
  const exact::Point& p = of.region.point(best);
  const double tolerance = (of.scale + in.scale + std::abs(dx) + std::abs(dy)) * margin::kLostByDoubles + p.error;
  return side(in.region, p.x + dx, p.y + dy, tolerance) == 1 ? std::optional(best) : std::nullopt;
}

}  // namespace findspace::distance
