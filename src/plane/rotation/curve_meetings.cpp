// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/rotation/curve_meetings.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "exact/margins/plane.h"

namespace findspace::plane {
namespace {

using exact::Real;

/// A bound of the polynomial's value for |u| < 1, as it is rounded.
double size(const HalfAngle& a) {
  double most = 0;
  for (double x : a.c) most = std::max(most, std::abs(x));
  return most;
}

/// Of what the terms of a meeting were before they cancelled.
struct MeetingSize {
  double x, y, w;
};

MeetingSize size(const LineForm<HalfAngle>& f, const LineForm<HalfAngle>& g) {
  return {size(f.h) * size(g.ny) + size(g.h) * size(f.ny), size(f.nx) * size(g.h) + size(g.nx) * size(f.h),
          size(f.nx) * size(g.ny) + size(f.ny) * size(g.nx)};
}

}  // namespace

std::vector<RootPlace> corner_places(const SectorCurve& c, const SectorCurve& d, double level, double span) {
  const auto [f, g] = corner_lines(c, d, level);
  const MeetingSize m = size(f, g);
  return root_places(corner_polynomial(meeting(f, g), level), span, m.x * m.x + m.y * m.y + level * level * m.w * m.w);
}

std::vector<RootPlace> meeting_places(const SectorCurve& c, const SectorCurve& d, const SectorCurve& e, double span) {
  const auto all = ordered(c, d, e);
  const auto [f, g] = meeting_lines(all);
  const MeetingSize m = size(f, g);
  const SectorCurve& first = *all[0];
  const double x = size(first.nx), y = size(first.ny), r = std::abs(first.radius);
  const double line = x * m.x + y * m.y + size(first.h) * m.w;
  const double circle = (m.x + x * m.w) * (m.x + x * m.w) + (m.y + y * m.w) * (m.y + y * m.w) + r * r * m.w * m.w;
  return root_places(meeting_polynomial(first, meeting(f, g)), span, first.line ? line : circle);
}

namespace {

std::vector<RoughMeeting> line_meets_circle(RoughPoint n, double offset, const RoughCurve& c, double error) {
  const double away = offset - dot(n, c.center), rest = c.radius * c.radius - away * away;
  const double lost = 4 * (std::abs(c.radius) + std::abs(away) + error) * error;
  if (rest < -lost) return {};
  // The root of a number that is off by `lost`.
  const double root = std::sqrt(std::max(0.0, rest)), off = 2 * error + std::min(lost / root, std::sqrt(2 * lost));
  const RoughPoint projection = c.center + away * n, half = root * RoughPoint(0, 1) * n;
  return {{projection - half, off}, {projection + half, off}};
}

}  // namespace

std::vector<RoughMeeting> rough_meetings(const RoughCurve& c, const RoughCurve& d, double error) {
  if (c.line && d.line) {
    const double w = cross(c.normal, d.normal);
    if (w == 0) return {};
    const RoughPoint s = (c.offset() * d.normal - d.offset() * c.normal) * RoughPoint(0, -1) / w;
    return {{s, 2 * error * (1 + (std::abs(s) + 1) / std::abs(w))}};
  }
  if (c.line) return line_meets_circle(c.normal, c.offset(), d, error);
  if (d.line) return line_meets_circle(d.normal, d.offset(), c, error);
  const RoughPoint way = d.center - c.center;
  const double far = length(way);
  if (far == 0) return {};
  const RoughPoint n = way / far;
  const double radii = std::abs(c.radius) + std::abs(d.radius);
  if (far <= error) return {{c.center, radii + far}};
  const double offset = dot(n, c.center) + (far * far + c.radius * c.radius - d.radius * d.radius) / (2 * far);
  return line_meets_circle(n, offset, c, error * (1 + 2 * (radii + std::abs(c.center)) / far));
}

namespace {

std::vector<RealVector> line_meets_circle(const RealVector& n, const Real& offset, const ExactCurve& c) {
  const Real square = plane::dot(n, n), away = offset - plane::dot(n, c.center);
  const Real rest = c.radius * c.radius * square - away * away;
  if (rest.sign() < 0) return {};
  const RealVector projection = c.center + away / square * n;
  if (rest.sign() == 0) return {projection};
  const RealVector half = sqrt(rest) / square * left_normal(n);
  return {projection - half, projection + half};
}

}  // namespace

std::vector<RealVector> exact_meetings(const ExactCurve& c, const ExactCurve& d) {
  if (c.line && d.line) {
    const Real w = plane::cross(c.normal, d.normal);
    if (w.sign() == 0) return {};
    return {{(c.offset * d.normal.y - d.offset * c.normal.y) / w, (c.normal.x * d.offset - d.normal.x * c.offset) / w}};
  }
  if (c.line) return line_meets_circle(c.normal, c.offset, d);
  if (d.line) return line_meets_circle(d.normal, d.offset, c);
  const RealVector way = d.center - c.center;
  if (way == RealVector{}) return {};
  const auto power = [](const ExactCurve& k) { return plane::dot(k.center, k.center) - k.radius * k.radius; };
  return line_meets_circle(way, (power(d) - power(c)) / Real(2), c);
}

std::optional<RealVector> exact_meeting(const ExactCurve& c, const ExactCurve& d, RoughPoint at) {
  std::optional<RealVector> best;
  double least = 0;
  for (RealVector& s : exact_meetings(c, d)) {
    const double off = length(RoughPoint(rough(s.x), rough(s.y)) - at);
    if (!best || off < least) {
      best = std::move(s);
      least = off;
    }
  }
  return best;
}

std::vector<RoughPoint> rough_projections(const RoughCurve& c, double tolerance) {
  std::vector<RoughPoint> out;
  const auto add = [&](RoughPoint s) {
    if (c.holds(s, tolerance)) out.push_back(s);
  };
  const double far = length(c.center), radius = std::abs(c.radius);
  if (c.line) {
    add(c.offset() * c.normal);
  } else if (radius <= tolerance) {
    out.push_back(c.center);
  } else if (far <= tolerance) {
    for (const Cone& k : {c.normals, c.opposed})
      for (double part : {0.0, 0.5, 1.0}) {
        const RoughPoint u = std::polar(1.0, k.from + part * k.width);
        if (c.allows(u, margin::kOneDirection)) out.push_back(c.center + c.radius * u);
      }
  } else {
    for (double side : {-1.0, 1.0}) add(c.center + side * radius * c.center / far);
  }
  return out;
}

RealVector exact_projection(const ExactCurve& c, RoughPoint at) {
  if (c.line) return c.offset / plane::dot(c.normal, c.normal) * c.normal;
  if (c.radius.sign() == 0) return c.center;
  const Real square = plane::dot(c.center, c.center);
  const RoughPoint center(rough(c.center.x), rough(c.center.y)), way = at - center;
  if (square.sign() == 0)
    return abs(c.radius) * exact::ExactAngle::near(std::arg(way) * 180 / std::numbers::pi, 30)({1, 0});
  const Real part = abs(c.radius) / sqrt(square);
  return (Real(1) + (dot(way, center) > 0 ? part : -part)) * c.center;
}

std::optional<RoughPoint> rough_meeting(const std::array<RoughCurve, 3>& c, double tolerance) {
  for (int k = 0; k < 3; ++k) {
    const RoughCurve &a = c[std::size_t(k)], &b = c[std::size_t((k + 1) % 3)], &d = c[std::size_t((k + 2) % 3)];
    for (const RoughMeeting& m : rough_meetings(a, b, tolerance / 1000)) {
      const RoughPoint s = m.at;
      const double reach = tolerance + m.off, off = d.line ? std::abs(dot(d.normal, s) - d.offset())
                                                           : std::abs(length(s - d.center) - std::abs(d.radius));
      if (off > reach || !a.holds(s, reach) || !b.holds(s, reach) || !d.holds(s, reach)) continue;
      // Some direction has a positive part along all three normals exactly if they lie in an open half plane.
      std::array<RoughPoint, 3> u{a.normal_at(s), b.normal_at(s), d.normal_at(s)};
      for (const RoughCurve* r : {&a, &b, &d})
        if (!r->line && std::abs(r->radius) <= tolerance) return s;  // a corner has many normals
      const double p = cross(u[0], u[1]), q = cross(u[1], u[2]), r = cross(u[2], u[0]);
      constexpr double slack = margin::kOneDirection;
      if ((p > -slack && q > -slack && r > -slack) || (p < slack && q < slack && r < slack)) return s;
    }
  }
  return std::nullopt;
}

}  // namespace findspace::plane
