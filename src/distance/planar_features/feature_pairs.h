// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Which features (vertices, insides of edges) of two boundary parts can be nearest or farthest, and whether the parts
// meet; in numbers, right to about 1e-15 of the coordinates. What they say is made exact by exact_pairs.h. Keywords:
// closest features, elementary distances.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "distance/planar_features/boundary_features.h"
#include "distance/planar_features/exact_pairs.h"
#include "exact/margins/planar_distance.h"

namespace findspace::distance {

/// A feature seen as what its end points and its inside are; moved to its place.
struct Placed {
  BoundaryFeature s;
  std::array<plane::Index, 2> vertex;  // equal for an isolated vertex
};

inline Placed placed(const plane::Region& r, const BoundaryFeature& feature, double px, double py) {
  Placed out{feature, {feature.cell.index, feature.cell.index}};
  if (!feature.is_vertex()) out.vertex = {r.edges[feature.cell.index].v0, r.edges[feature.cell.index].v1};
  BoundaryFeature& s = out.s;
  s.x0 += px;
  s.x1 += px;
  s.cx += px;
  s.y0 += py;
  s.y1 += py;
  s.cy += py;
  return out;
}

inline double cross(double ax, double ay, double bx, double by) { return ax * by - ay * bx; }

/// How far something may be moved, along x and along y.
struct Moves {
  double x, y;
};

/// They cross, and still do when one is moved so far.
inline bool segments_cross(const BoundaryFeature& s, const BoundaryFeature& t, const Moves& by) {
  double dx = s.x1 - s.x0, dy = s.y1 - s.y0, ex = t.x1 - t.x0, ey = t.y1 - t.y0;
  double a = cross(dx, dy, t.x0 - s.x0, t.y0 - s.y0), b = cross(dx, dy, t.x1 - s.x0, t.y1 - s.y0);
  double c = cross(ex, ey, s.x0 - t.x0, s.y0 - t.y0), d = cross(ex, ey, s.x1 - t.x0, s.y1 - t.y0);
  if ((a > 0) == (b > 0) || (c > 0) == (d > 0)) return false;
  double wide = std::abs(dy) * by.x + std::abs(dx) * by.y, high = std::abs(ey) * by.x + std::abs(ex) * by.y;
  return std::min(std::abs(a), std::abs(b)) > wide && std::min(std::abs(c), std::abs(d)) > high;
}

/// Within `tolerance` of the feature, for a place on its line or circle.
inline bool is_on(const BoundaryFeature& s, double x, double y, double tolerance) {
  return s.distance(x, y) <= tolerance;
}

/// The first place where an arc and another feature meet or seem to that `wanted(x, y)` takes.
template <class Wanted>
std::optional<std::array<double, 2>> arc_meeting(const BoundaryFeature& arc, const BoundaryFeature& other,
                                                 double tolerance, Wanted&& wanted) {
  if (other.is_vertex()) {
    const bool on = is_on(arc, other.x0, other.y0, tolerance) && wanted(other.x0, other.y0);
    return on ? std::optional(std::array{other.x0, other.y0}) : std::nullopt;
  }
  double ux, uy, fx, fy, h2;
  if (other.arc) {
    double dx = other.cx - arc.cx, dy = other.cy - arc.cy, d = plain_length(dx, dy);
    if (d == 0) return std::nullopt;
    double along = (d * d + arc.r * arc.r - other.r * other.r) / (2 * d);
    ux = -dy / d;
    uy = dx / d;
    fx = arc.cx + along * dx / d;
    fy = arc.cy + along * dy / d;
    h2 = arc.r * arc.r - along * along;
  } else {
    double dx = other.x1 - other.x0, dy = other.y1 - other.y0, n = plain_length(dx, dy);
    ux = dx / n;
    uy = dy / n;
    double t = (arc.cx - other.x0) * ux + (arc.cy - other.y0) * uy;
    fx = other.x0 + t * ux;
    fy = other.y0 + t * uy;
    double off = plain_length(fx - arc.cx, fy - arc.cy);
    h2 = (arc.r - off) * (arc.r + off);
  }
  if (h2 < -tolerance * arc.r) return std::nullopt;
  double h = std::sqrt(std::max(0.0, h2)), wide = tolerance + std::sqrt(tolerance * arc.r) * (h2 < tolerance * arc.r);
  for (double side : {-h, h}) {
    const double x = fx + side * ux, y = fy + side * uy;
    if (is_on(arc, x, y, wide) && is_on(other, x, y, wide) && wanted(x, y)) return std::array{x, y};
  }
  return std::nullopt;
}

inline std::optional<std::array<double, 2>> arc_meeting(const BoundaryFeature& arc, const BoundaryFeature& other,
                                                        double tolerance) {
  return arc_meeting(arc, other, tolerance, [](double, double) { return true; });
}

/// Two edges cross, and still do when one is moved so far: within reach of the place where they meet, short of all
/// ends, both bend by less than an eighth of what they part. `slack`: what the place may be off.
inline bool edges_cross(const BoundaryFeature& s, const BoundaryFeature& t, const Moves& by, double slack) {
  if (!s.arc && !t.arc) return segments_cross(s, t, {by.x + slack, by.y + slack});
  const double farthest = plain_length(by.x, by.y);
  const auto tangent = [](const BoundaryFeature& e, double x, double y) {
    const double dx = e.arc ? e.cy - y : e.x1 - e.x0, dy = e.arc ? x - e.cx : e.y1 - e.y0, n = plain_length(dx, dy);
    return std::array{dx / n, dy / n};
  };
  const auto wanted = [&](double x, double y) {
    const auto u = tangent(s, x, y), v = tangent(t, x, y);
    const double sine = std::abs(cross(u[0], u[1], v[0], v[1]));
    double reach = std::numeric_limits<double>::infinity();
    for (const BoundaryFeature* e : {&s, &t}) {
      reach = std::min({reach, plain_length(x - e->x0, y - e->y0), plain_length(x - e->x1, y - e->y1)});
      if (e->arc) reach = std::min(reach, e->r * sine / 4);
    }
    return reach * sine / 2 > farthest + slack + slack / sine;
  };
  return (s.arc ? arc_meeting(s, t, slack, wanted) : arc_meeting(t, s, slack, wanted)).has_value();
}

inline bool may_meet(const BoundaryFeature& s, const BoundaryFeature& t, double tolerance) {
  if (s.arc) return arc_meeting(s, t, tolerance).has_value();
  if (t.arc) return arc_meeting(t, s, tolerance).has_value();
  return !s.is_vertex() && !t.is_vertex() && segments_cross(s, t, {0, 0});
}

/// Calls take(candidate) for the pairs of features of two features that can be nearest, coordinates being off by no
/// more than `slack`. Whether a point lies on an edge is decided exactly later (exact_pair).
template <class Take>
void nearest_features(const Placed& p, const Placed& q, double slack, Take&& take) {
  const BoundaryFeature &s = p.s, &t = q.s;
  for (int i = 0; i < (s.is_vertex() ? 1 : 2); ++i) {
    double x = i ? s.x1 : s.x0, y = i ? s.y1 : s.y0;
    for (int k = 0; k < (t.is_vertex() ? 1 : 2); ++k)
      take(Candidate{plain_length(x - (k ? t.x1 : t.x0), y - (k ? t.y1 : t.y0)), {0, p.vertex[i]}, {0, q.vertex[k]}});
    if (!t.is_vertex() && t.faces(x, y, slack)) take(Candidate{t.distance(x, y), {0, p.vertex[i]}, t.cell});
  }
  for (int k = 0; k < (t.is_vertex() ? 1 : 2); ++k) {
    double x = k ? t.x1 : t.x0, y = k ? t.y1 : t.y0;
    if (!s.is_vertex() && s.faces(x, y, slack)) take(Candidate{s.distance(x, y), s.cell, {0, q.vertex[k]}});
  }
  if (s.arc && t.arc) {
    double dx = t.cx - s.cx, dy = t.cy - s.cy, d = plain_length(dx, dy);
    if (d == 0) return;
    double tolerance = (s.r + t.r) * margin::kPairMeets;  // circles that touch may seem to cross
    if (d > s.r + t.r - tolerance && s.has_direction(dx, dy, slack) && t.has_direction(-dx, -dy, slack))
      take(Candidate{std::abs(d - s.r - t.r), s.cell, t.cell});
    double turn = s.r > t.r ? 1 : -1;
    if (d < std::abs(s.r - t.r) + tolerance && s.has_direction(turn * dx, turn * dy, slack) &&
        t.has_direction(turn * dx, turn * dy, slack))
      take(Candidate{std::abs(std::abs(s.r - t.r) - d), s.cell, t.cell});
  } else if ((s.arc && !t.is_vertex()) || (t.arc && !s.is_vertex())) {
    const BoundaryFeature &arc = s.arc ? s : t, &line = s.arc ? t : s;
    double dx = line.x1 - line.x0, dy = line.y1 - line.y0,
           at = ((arc.cx - line.x0) * dx + (arc.cy - line.y0) * dy) / (dx * dx + dy * dy);
    double fx = line.x0 + at * dx - arc.cx, fy = line.y0 + at * dy - arc.cy, d = plain_length(fx, fy);
    if (line.faces(arc.cx, arc.cy, slack) && d > arc.r * (1 - margin::kPairMeets) && arc.has_direction(fx, fy, slack))
      take(Candidate{std::abs(d - arc.r), s.cell, t.cell});
  }
}

/// Points of both arcs lie opposite each other, seen from a common centre.
inline bool are_opposite(const BoundaryFeature& s, const BoundaryFeature& t) {
  const double low = std::max((s.x0 - s.cx) / s.r, (t.cx - t.x1) / t.r),
               high = std::min((s.x1 - s.cx) / s.r, (t.cx - t.x0) / t.r);
  return s.half != t.half && low <= high;
}

/// Of arcs about one centre the farthest points are ends of one or of both.
template <class Take>
void farthest_features(const Placed& p, const Placed& q, Take&& take) {
  const BoundaryFeature &s = p.s, &t = q.s;
  for (int i = 0; i < (s.is_vertex() ? 1 : 2); ++i) {
    double x = i ? s.x1 : s.x0, y = i ? s.y1 : s.y0;
    for (int k = 0; k < (t.is_vertex() ? 1 : 2); ++k)
      take(Candidate{plain_length(x - (k ? t.x1 : t.x0), y - (k ? t.y1 : t.y0)), {0, p.vertex[i]}, {0, q.vertex[k]}});
    if (t.arc && t.has_direction(t.cx - x, t.cy - y))
      take(Candidate{plain_length(t.cx - x, t.cy - y) + t.r, {0, p.vertex[i]}, t.cell});
  }
  for (int k = 0; k < (t.is_vertex() ? 1 : 2) && s.arc; ++k) {
    double dx = s.cx - (k ? t.x1 : t.x0), dy = s.cy - (k ? t.y1 : t.y0);
    if (s.has_direction(dx, dy)) take(Candidate{plain_length(dx, dy) + s.r, s.cell, {0, q.vertex[k]}});
  }
  if (!s.arc || !t.arc) return;
  const double dx = t.cx - s.cx, dy = t.cy - s.cy, d = plain_length(dx, dy);
  const double scale = std::abs(s.cx) + std::abs(s.cy) + std::abs(t.cx) + std::abs(t.cy) + s.r + t.r;
  if (d <= scale * margin::kOneCentre ? are_opposite(s, t) : s.has_direction(-dx, -dy) && t.has_direction(dx, dy))
    take(Candidate{d + s.r + t.r, s.cell, t.cell});
}

}  // namespace findspace::distance
