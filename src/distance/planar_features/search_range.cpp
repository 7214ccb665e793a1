// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/planar_features/search_range.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace findspace::distance {

Spot MovedFeatures::on_edge(int edge, double t) const {
  const BoundaryFeature& s = features_[std::size_t(edge)];
  if (!s.arc) return {px_ + s.x0 + t * (s.x1 - s.x0), py_ + s.y0 + t * (s.y1 - s.y0)};
  double from = std::atan2(s.y0 - s.cy, s.x0 - s.cx), to = std::atan2(s.y1 - s.cy, s.x1 - s.cx);
  // Ends on the horizontal diameter belong to either half.
  if (s.half > 0 ? from < 0 : from > 0) from = -from;
  if (s.half > 0 ? to < 0 : to > 0) to = -to;
  const double angle = from + t * (to - from);
  return {px_ + s.cx + s.r * std::cos(angle), py_ + s.cy + s.r * std::sin(angle)};
}

double MovedFeatures::length(const SearchRange& part) const {
  const Spot from = on_edge(part.edge, part.t0), to = on_edge(part.edge, part.t1);
  const BoundaryFeature& s = features_[std::size_t(part.edge)];
  const double chord = std::hypot(to.x - from.x, to.y - from.y);
  return s.arc ? std::max(chord, s.r * 3.2 * (part.t1 - part.t0)) : chord;
}

/// The corners of a convex polygon around the range.
std::vector<Spot> MovedFeatures::hull(const SearchRange& r) const {
  if (r.edge < 0) return {{r.x0, r.y0}, {r.x1, r.y0}, {r.x0, r.y1}, {r.x1, r.y1}};
  const Spot p = on_edge(r.edge, r.t0), q = on_edge(r.edge, r.t1);
  const BoundaryFeature& s = features_[std::size_t(r.edge)];
  if (!s.arc) return {p, q};
  // The end tangents bound the arc: for less than a half circle they meet over its middle.
  const Spot m = on_edge(r.edge, (r.t0 + r.t1) / 2);
  const double cx = px_ + s.cx, cy = py_ + s.cy;
  const double half = std::hypot(p.x - q.x, p.y - q.y) / 2 / s.r, cosine = std::sqrt(std::max(0.0, 1 - half * half));
  if (cosine < 0.5) {
    const double h = s.r;
    return {{cx - h, cy - h}, {cx + h, cy - h}, {cx - h, cy + h}, {cx + h, cy + h}};
  }
  return {p, q, {cx + (m.x - cx) / cosine, cy + (m.y - cy) / cosine}};
}

/// Such that its has_direction is that of the part.
BoundaryFeature MovedFeatures::arc_part(const SearchRange& part) const {
  Spot p = on_edge(part.edge, part.t0), q = on_edge(part.edge, part.t1);
  if (p.x > q.x) std::swap(p, q);
  BoundaryFeature s = features_[std::size_t(part.edge)];
  s.x0 = p.x - px_;
  s.y0 = p.y - py_;
  s.x1 = q.x - px_;
  s.y1 = q.y - py_;
  return s;
}

double MovedFeatures::farthest(const SearchRange& r, const std::vector<Spot>& hull, double x, double y) const {
  double far = 0;
  if (r.edge < 0 || !features_[std::size_t(r.edge)].arc) {
    for (const Spot& h : hull) far = std::max(far, std::hypot(h.x - x, h.y - y));
    return far;
  }
  // On an arc: an end, or the point opposite to (x, y).
  const BoundaryFeature& e = features_[std::size_t(r.edge)];
  const Spot p = on_edge(r.edge, r.t0), q = on_edge(r.edge, r.t1);
  far = std::max(std::hypot(p.x - x, p.y - y), std::hypot(q.x - x, q.y - y));
  const double dx = px_ + e.cx - x, dy = py_ + e.cy - y, d = std::hypot(dx, dy);
  return d == 0 || arc_part(r).has_direction(dx, dy) ? std::max(far, d + e.r) : far;
}

/// The least distance of a point around the range; never more than that of the range itself.
double MovedFeatures::nearest(const SearchRange& r, const std::vector<Spot>& hull, double x, double y) const {
  if (hull.size() == 2) {
    BoundaryFeature part;
    part.cell = {1, 0};
    part.x0 = hull[0].x;
    part.y0 = hull[0].y;
    part.x1 = hull[1].x;
    part.y1 = hull[1].y;
    return part.distance(x, y);
  }
  double x0 = hull[0].x, x1 = x0, y0 = hull[0].y, y1 = y0;
  for (const Spot& h : hull) {
    x0 = std::min(x0, h.x);
    x1 = std::max(x1, h.x);
    y0 = std::min(y0, h.y);
    y1 = std::max(y1, h.y);
  }
  const double near = std::hypot(std::max({x0 - x, 0.0, x - x1}), std::max({y0 - y, 0.0, y - y1}));
  if (r.edge < 0) return near;
  const BoundaryFeature& e = features_[std::size_t(r.edge)];
  return std::max(near, e.r - std::hypot(px_ + e.cx - x, py_ + e.cy - y));
}

/// At least the greatest distance from a point of the range to the feature.
double MovedFeatures::most(const BoundaryFeature& s, const SearchRange& r, const std::vector<Spot>& hull) const {
  if (s.is_vertex()) return farthest(r, hull, s.x0, s.y0);
  if (!s.arc) {
    double far = 0;
    for (const Spot& h : hull) far = std::max(far, s.distance(h.x, h.y));
    return far;
  }
  // No place is farther from an arc than from an end of it.
  for (const Spot& h : hull)
    if (!s.has_direction(h.x - s.cx, h.y - s.cy))
      return std::min(farthest(r, hull, s.x0, s.y0), farthest(r, hull, s.x1, s.y1));
  return std::max(farthest(r, hull, s.cx, s.cy) - s.r, s.r - nearest(r, hull, s.cx, s.cy));
}

double MovedFeatures::bound(const SearchRange& r, const std::vector<BoundaryFeature>& a) const {
  const auto around = hull(r);
  double least = std::numeric_limits<double>::infinity();
  for (plane::Index k : r.a) least = std::min(least, most(a[k], r, around));
  return least;
}

std::vector<Spot> MovedFeatures::max_mins(const SearchRange& part, const BoundaryFeature& a) const {
  const BoundaryFeature& e = features_[std::size_t(part.edge)];
  if (!e.arc) {
    if (!a.arc) return {};
    // The projection of the circle's centre.
    const Spot p = on_edge(part.edge, part.t0), q = on_edge(part.edge, part.t1);
    const double dx = q.x - p.x, dy = q.y - p.y, square = dx * dx + dy * dy;
    const double t = square > 0 ? ((a.cx - p.x) * dx + (a.cy - p.y) * dy) / square : -1;
    return t >= 0 && t <= 1 ? std::vector<Spot>{{p.x + t * dx, p.y + t * dy}} : std::vector<Spot>{};
  }
  const double cx = px_ + e.cx, cy = py_ + e.cy;
  double dx = a.arc ? cx - a.cx : cx - a.x0, dy = a.arc ? cy - a.cy : cy - a.y0;
  if (!a.arc && !a.is_vertex()) {
    dx = a.y0 - a.y1;
    dy = a.x1 - a.x0;
  }
  const double d = std::hypot(dx, dy);
  std::vector<Spot> out;
  const BoundaryFeature own = arc_part(part);
  for (const double side : {1.0, -1.0})
    if (d > 0 && own.has_direction(side * dx, side * dy))
      out.push_back({cx + side * e.r * dx / d, cy + side * e.r * dy / d});
  return out;
}

}  // namespace findspace::distance
