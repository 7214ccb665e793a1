// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/curve_meetings.h"

#include <algorithm>
#include <cmath>

namespace findspace::plane {
namespace {

using exact::Real;

double dot(RoughPoint a, RoughPoint b) { return a.real() * b.real() + a.imag() * b.imag(); }
double cross(RoughPoint a, RoughPoint b) { return a.real() * b.imag() - a.imag() * b.real(); }

/// nx * x + ny * y = h, each times 1 + u^2.
struct Form {
  HalfAngle nx, ny, h;
};

Form line_of(const SectorCurve& c) { return {c.nx, c.ny, c.h}; }

/// The line through the points that the circle shares with the one of radius `level` around the origin.
Form radical_line(const SectorCurve& c, double level) {
  return {2.0 * c.nx, 2.0 * c.ny, c.h + HalfAngle::linear(level * level, 0, 0)};
}

/// The line through the points that two circles share.
Form radical_line(const SectorCurve& c, const SectorCurve& d) {
  return {2.0 * (d.nx - c.nx), 2.0 * (d.ny - c.ny), d.h - c.h};
}

/// The meeting point of two lines is (x, y) / w.
struct Meeting {
  HalfAngle x, y, w;
};

Meeting meeting(const Form& f, const Form& g) {
  return {f.h * g.ny - g.h * f.ny, f.nx * g.h - g.nx * f.h, f.nx * g.ny - f.ny * g.nx};
}

/// A bound of the polynomial's value for |u| < 1, as it is rounded.
double size(const HalfAngle& a) {
  double most = 0;
  for (double x : a.c) most = std::max(most, std::abs(x));
  return most;
}

bool is_nothing(const Meeting& m, const Form& f, const Form& g) {
  const double scale = (size(f.nx) + size(f.ny)) * (size(g.nx) + size(g.ny));
  return size(m.w) <= scale * 1e-12;  // no sign: parallel at all angles, up to rounding
}

double squares(const Meeting& m) { return size(m.x) * size(m.x) + size(m.y) * size(m.y); }

}  // namespace

std::vector<double> corner_roots(const SectorCurve& c, const SectorCurve& d, double level, double span) {
  const Form f = c.line ? line_of(c) : radical_line(c, level), g = d.line ? line_of(d) : radical_line(d, level);
  const Meeting m = meeting(f, g);
  if (is_nothing(m, f, g)) return {};
  const HalfAngle p = m.x * m.x + m.y * m.y - (level * level) * (m.w * m.w);
  return roots(p, span, squares(m) + level * level * size(m.w) * size(m.w));
}

std::vector<double> meeting_roots(const SectorCurve& c, const SectorCurve& d, const SectorCurve& e, double span) {
  std::array<const SectorCurve*, 3> all{&c, &d, &e};
  std::stable_sort(all.begin(), all.end(), [](const auto* p, const auto* q) { return p->line < q->line; });
  const SectorCurve& first = *all[0];
  const auto form = [&](const SectorCurve& s) { return s.line ? line_of(s) : radical_line(first, s); };
  if (first.line) {
    const Form f = line_of(first), g = line_of(*all[1]), h = line_of(*all[2]);
    const Meeting m = meeting(f, g);
    const HalfAngle p = h.nx * m.x + h.ny * m.y - h.h * m.w;
    return roots(p, span, (size(h.nx) + size(h.ny)) * (size(m.x) + size(m.y)) + size(h.h) * size(m.w));
  }
  const Form f = form(*all[1]), g = form(*all[2]);
  const Meeting m = meeting(f, g);
  if (is_nothing(m, f, g)) return {};
  const HalfAngle x = raised(m.x) - first.nx * m.w, y = raised(m.y) - first.ny * m.w, w = first.radius * raised(m.w);
  const double center = size(first.nx) + size(first.ny);
  return roots(x * x + y * y - w * w, span,
               squares(m) + (center * center + first.radius * first.radius) * size(m.w) * size(m.w));
}

namespace {

std::vector<RoughPoint> line_meets_circle(RoughPoint n, double offset, const RoughCurve& c) {
  const double away = offset - dot(n, c.center), rest = c.radius * c.radius - away * away;
  if (rest < -1e-9 * c.radius * c.radius) return {};  // no sign: a tangent counts
  const RoughPoint foot = c.center + away * n, half = std::sqrt(std::max(0.0, rest)) * RoughPoint(0, 1) * n;
  return {foot - half, foot + half};
}

}  // namespace

std::vector<RoughPoint> rough_meetings(const RoughCurve& c, const RoughCurve& d) {
  if (c.line && d.line) {
    const double w = cross(c.normal, d.normal);
    if (std::abs(w) < 1e-11) return {};  // no sign: parallel lines have no corner
    const RoughPoint s = (c.offset() * d.normal - d.offset() * c.normal) * RoughPoint(0, -1) / w;
    return {s};
  }
  if (c.line) return line_meets_circle(c.normal, c.offset(), d);
  if (d.line) return line_meets_circle(d.normal, d.offset(), c);
  const RoughPoint way = d.center - c.center;
  const double far = std::abs(way);
  if (far == 0) return {};
  const RoughPoint n = way / far;
  const double offset = dot(n, c.center) + (far * far + c.radius * c.radius - d.radius * d.radius) / (2 * far);
  return line_meets_circle(n, offset, c);
}

namespace {

std::vector<RealVector> line_meets_circle(const RealVector& n, const Real& offset, const ExactCurve& c) {
  const Real square = plane::dot(n, n), away = offset - plane::dot(n, c.center);
  const Real rest = c.radius * c.radius * square - away * away;
  if (rest.sign() < 0) return {};
  const RealVector foot = c.center + away / square * n;
  if (rest.sign() == 0) return {foot};
  const RealVector half = sqrt(rest) / square * turned_left(n);
  return {foot - half, foot + half};
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

std::optional<RoughPoint> rough_meeting(const std::array<RoughCurve, 3>& c, double room) {
  for (int k = 0; k < 3; ++k) {
    const RoughCurve &a = c[std::size_t(k)], &b = c[std::size_t((k + 1) % 3)], &d = c[std::size_t((k + 2) % 3)];
    for (const RoughPoint& s : rough_meetings(a, b)) {
      const double off =
          d.line ? std::abs(dot(d.normal, s) - d.offset()) : std::abs(std::abs(s - d.center) - std::abs(d.radius));
      if (off > room || !a.holds(s, room) || !b.holds(s, room) || !d.holds(s, room)) continue;
      // Some direction has a positive part along all three normals exactly if they lie in an open half plane.
      std::array<RoughPoint, 3> u{a.normal_at(s), b.normal_at(s), d.normal_at(s)};
      for (const RoughCurve* r : {&a, &b, &d})
        if (!r->line && std::abs(r->radius) <= room) return s;  // a corner has many normals
      const double p = cross(u[0], u[1]), q = cross(u[1], u[2]), r = cross(u[2], u[0]);
      const double slack = 1e-7;  // no sign: meetings too many do no harm
      if ((p > -slack && q > -slack && r > -slack) || (p < slack && q < slack && r < slack)) return s;
    }
  }
  return std::nullopt;
}

}  // namespace findspace::plane
