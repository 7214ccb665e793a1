// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/bent_front.h"

#include <algorithm>

#include "distance/front_planes.h"
#include "distance/sites.h"
#include "exact/polynomial_root.h"

namespace findspace::distance {

using exact::Polynomial;
using exact::Real;

namespace {

Polynomial operator+(const Polynomial& p, const Polynomial& q) {
  Polynomial out(std::max(p.size(), q.size()));
  for (std::size_t k = 0; k < p.size(); ++k) out[k] += p[k];
  for (std::size_t k = 0; k < q.size(); ++k) out[k] += q[k];
  return out;
}

Polynomial operator*(const Polynomial& p, const Polynomial& q) {
  Polynomial out(p.size() + q.size() - 1);
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::size_t j = 0; j < q.size(); ++j) out[i + j] += p[i] * q[j];
  return out;
}

Polynomial times(const Real& s, Polynomial p) {
  for (Real& c : p) c *= s;
  return p;
}

/// linear + bent * sqrt(T), polynomials in the level.
struct Bent {
  Polynomial linear, bent;
};

Polynomial under(const Bend& b) { return {b.t[0], b.t[1], b.t[2]}; }

/// A line as a plane of (x, y, level), bent by w * sqrt(T).
struct BentPlane {
  FrontPlane plain;
  Real w;
};

BentPlane bent_plane(const Front& line) { return {plane_of(line), line.bend ? line.bend->weight : Real()}; }

/// linear = -bent * sqrt(T) can be, by the signs of the sides.
bool is_possible(const Polynomial& linear, const Polynomial& bent, const Real& level) {
  return !(near_value(exact::value_at(linear, level)) * near_value(exact::value_at(bent, level)) > 0);
}

struct Range {
  Real low, high;
};

/// The levels at which f is 0.
void add_roots(const Bent& f, const Polynomial& t, const Range& range, std::vector<Real>& out) {
  const Polynomial square = f.linear * f.linear + times(-1, f.bent * f.bent * t);
  for (const Real& level : exact::roots_between(square, range.low, range.high))
    if (is_possible(f.linear, f.bent, level)) out.push_back(level);
}

/// Where the bent line touches a circle.
std::vector<Bent> touching_circle(const Front& f, const Front& g) {
  const Real n = sqrt(f.a * f.a + f.b * f.b), at = f.a * g.a + f.b * g.b - f.c;
  std::vector<Bent> out;
  for (const Real& side : {n, -n}) out.push_back({{at + side * g.c, side * g.k - f.k}, {-f.bend->weight}});
  return out;
}

/// Where a bent line is another line, bent or not: linear + u * sqrt(T) + v * sqrt(S) = 0.
void add_coinciding(const Front& f, const Front& g, const Range& range, std::vector<Real>& out) {
  if ((f.a * g.b - f.b * g.a).sign() != 0) return;
  const Real n = f.a * f.a + f.b * f.b, m = f.a * g.a + f.b * g.b;  // g's normal is m/n times f's
  const Polynomial linear{f.c * m - g.c * n, f.k * m - g.k * n}, t = under(*f.bend);
  const Real u = f.bend->weight * m;
  if (!g.bend) return add_roots({linear, {u}}, t, range, out);
  const Polynomial s = under(*g.bend);
  const Real v = -g.bend->weight * n;
  // linear^2 - u^2 T - v^2 S = 2 u v sqrt(T S).
  const Polynomial rest = linear * linear + times(-(u * u), t) + times(-(v * v), s);
  const Polynomial square = rest * rest + times(Real(-4) * u * u * v * v, t * s);
  for (const Real& level : exact::roots_between(square, range.low, range.high))
    if (is_possible(rest, {-(u * v)}, level)) out.push_back(level);
}

/// x and y at a level.
struct Crossing {
  Bent x, y;
};

std::optional<Crossing> crossing(const BentPlane& p, const BentPlane& q) {
  const FrontPlane &f = p.plain, &g = q.plain;
  const Real d = f.x * g.y - f.y * g.x;
  if (d.sign() == 0) return std::nullopt;
  const Real i = Real(1) / d;
  return Crossing{{{i * (f.c * g.y - g.c * f.y), i * (g.l * f.y - f.l * g.y)}, {i * (p.w * g.y - q.w * f.y)}},
                  {{i * (g.c * f.x - f.c * g.x), i * (f.l * g.x - g.l * f.x)}, {i * (q.w * f.x - p.w * g.x)}}};
}

/// The crossing on a third plane, or on a circle.
Bent on(const Crossing& at, const BentPlane& q) {
  const FrontPlane& p = q.plain;
  return {times(p.x, at.x.linear) + times(p.y, at.y.linear) + Polynomial{-p.c, p.l},
          times(p.x, at.x.bent) + times(p.y, at.y.bent) + Polynomial{-q.w}};
}

Bent on(const Crossing& at, const Front& ring, const Polynomial& t) {
  const Polynomial x = at.x.linear + Polynomial{-ring.a}, y = at.y.linear + Polynomial{-ring.b}, r{ring.c, ring.k};
  return {x * x + y * y + times(-1, r * r) + (at.x.bent * at.x.bent + at.y.bent * at.y.bent) * t,
          times(2, at.x.bent * x + at.y.bent * y)};
}

/// What passes through one point at a level; what is bent is so by one square root of T.
std::optional<Bent> together(std::span<const Front* const> fronts, const Polynomial& t) {
  std::vector<BentPlane> planes;
  std::vector<const Front*> rings;
  for (const Front* f : fronts)
    if (f->circle)
      rings.push_back(f);
    else
      planes.push_back(bent_plane(*f));
  if (rings.size() == 2) {
    const auto plane = radical(*rings[0], *rings[1]);
    if (!plane) return std::nullopt;
    planes.push_back({*plane, Real()});
  }
  auto at = crossing(planes[0], planes[1]);
  if (!rings.empty()) return at ? std::optional(on(*at, *rings[0], t)) : std::nullopt;
  if (at) return on(*at, planes[2]);
  at = crossing(planes[0], planes[2]);
  return at ? std::optional(on(*at, planes[1])) : std::nullopt;
}

bool is_same(const Bend& f, const Bend& g) { return f.t[0] == g.t[0] && f.t[1] == g.t[1] && f.t[2] == g.t[2]; }

}  // namespace

std::optional<Front> bent_front(const Front& edge, const Front& f, const Front& g, double near_x, double near_y) {
  const auto plane = g.circle ? radical(f, g) : plane_of(g);
  if (!plane) return std::nullopt;
  const Real &mx = plane->x, &my = plane->y, n = mx * mx + my * my;
  if (n.sign() == 0) return std::nullopt;
  // The corner is w + m * d / n +- turned m * sqrt(n * r^2 - d^2) / n, with d = d0 + d1 * level.
  const Real d0 = plane->c - mx * f.a - my * f.b, d1 = -plane->l;
  const Real along = (edge.a * mx + edge.b * my) / n, across = (edge.b * mx - edge.a * my) / n;
  Front out = Front::line(edge.a, edge.b, edge.a * f.a + edge.b * f.b + along * d0 - edge.c, along * d1);
  const double side = near_value(mx) * (near_y - near_value(f.b)) - near_value(my) * (near_x - near_value(f.a));
  const std::array<Real, 3> t{n * f.c * f.c - d0 * d0, Real(2) * (n * f.c * f.k - d0 * d1), n * f.k * f.k - d1 * d1};
  if (across.sign() != 0) out.bend = std::make_shared<Bend>(Bend{side > 0 ? across : -across, t});
  return out;
}

std::vector<Real> bent_levels(std::span<const Front* const> fronts, double low, double high) {
  const Front &f = *fronts[0], &g = *fronts[1];
  const Range range{Real::from_double(low), Real::from_double(high)};
  std::vector<Real> out;
  if (fronts.size() == 2) {
    if (!g.circle) add_coinciding(f, g, range, out);
    if (g.circle)
      for (const Bent& zero : touching_circle(f, g)) add_roots(zero, under(*f.bend), range, out);
    return out;
  }
  for (const Front* other : fronts)
    if (other->bend && !is_same(*f.bend, *other->bend)) return out;
  if (const auto zero = together(fronts, under(*f.bend))) add_roots(*zero, under(*f.bend), range, out);
  return out;
}

}  // namespace findspace::distance
