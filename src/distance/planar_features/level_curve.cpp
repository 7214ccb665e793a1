// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/planar_features/level_curve.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "distance/planar_features/level_curve_planes.h"

namespace findspace::distance {

using exact::Real;
using exact::RealPoint;
using Plane = LevelCurvePlane;

namespace {

/// The points (x, y, level) = base + t * along.
struct Ray {
  std::array<Real, 3> base, along;
};

std::optional<Ray> meet(const Plane& p, const Plane& q) {
  Ray r;
  r.along = {p.y * q.l - p.l * q.y, p.l * q.x - p.x * q.l, p.x * q.y - p.y * q.x};
  // Solve for two coordinates with the third put to 0, where their determinant does not vanish.
  if (r.along[2].sign() != 0) {
    r.base = {(p.c * q.y - q.c * p.y) / r.along[2], (p.x * q.c - q.x * p.c) / r.along[2], Real()};
  } else if (r.along[0].sign() != 0) {
    r.base = {Real(), (p.c * q.l - q.c * p.l) / r.along[0], (p.y * q.c - q.y * p.c) / r.along[0]};
  } else if (r.along[1].sign() != 0) {
    r.base = {(q.c * p.l - p.c * q.l) / r.along[1], Real(), (q.x * p.c - p.x * q.c) / r.along[1]};
  } else {
    return std::nullopt;
  }
  return r;
}

Event event_on(const Ray& r, const Real& t) {
  return {r.base[2] + t * r.along[2], RealPoint{r.base[0] + t * r.along[0], r.base[1] + t * r.along[1]}};
}

/// The points of a ray on a circle level curve: a quadratic equation in t.
std::vector<Event> on_circle(const Ray& r, const LevelCurve& f) {
  Real u = r.base[0] - f.a, v = r.base[1] - f.b, w = f.c + f.k * r.base[2], z = f.k * r.along[2];
  Real a = r.along[0] * r.along[0] + r.along[1] * r.along[1] - z * z;
  Real b = u * r.along[0] + v * r.along[1] - w * z;
  Real c = u * u + v * v - w * w;
  if (a.sign() == 0) {
    if (b.sign() == 0) return {};
    return {event_on(r, -c / (Real(2) * b))};
  }
  Real d = b * b - a * c;
  int real = d.sign();
  if (real < 0) return {};
  if (real == 0) return {event_on(r, -b / a)};
  Real root = sqrt(d);
  return {event_on(r, (-b - root) / a), event_on(r, (-b + root) / a)};
}

Real length(const Real& x, const Real& y) { return sqrt(x * x + y * y); }

/// Two circles touch: |centres| = +-r +- s.
std::vector<Event> circles_touch(const LevelCurve& f, const LevelCurve& g) {
  Real dx = g.a - f.a, dy = g.b - f.b, d = length(dx, dy);
  std::vector<Event> out;
  bool concentric = d.sign() == 0;
  for (int side : {-1, 1})
    for (int other : {-1, 1}) {
      // side * (f.c + f.k l) + other * (g.c + g.k l) = d
      Real k = Real(side) * f.k + Real(other) * g.k;
      if (k.sign() == 0) continue;
      Real level = (d - Real(side) * f.c - Real(other) * g.c) / k;
      if (concentric) {
        out.push_back({level, std::nullopt});
        continue;
      }
      Real t = Real(side) * (f.c + f.k * level) / d;
      out.push_back({level, RealPoint{f.a + t * dx, f.b + t * dy}});
    }
  return out;
}

/// A line touches a circle: signed distance of the centre = +-r.
std::vector<Event> line_touches(const LevelCurve& line, const LevelCurve& circle) {
  Real n2 = line.a * line.a + line.b * line.b, n = sqrt(n2);
  std::vector<Event> out;
  for (int side : {-1, 1}) {
    Real k = Real(side) * n * circle.k + line.k;
    if (k.sign() == 0) continue;
    Real level = (line.a * circle.a + line.b * circle.b - line.c - Real(side) * n * circle.c) / k;
    Real h = (line.a * circle.a + line.b * circle.b - line.c - line.k * level) / n2;
    out.push_back({level, RealPoint{circle.a - h * line.a, circle.b - h * line.b}});
  }
  return out;
}

std::vector<Event> lines_coincide(const LevelCurve& f, const LevelCurve& g) {
  if ((f.a * g.b - f.b * g.a).sign() != 0) return {};
  Real n = f.a * f.a + f.b * f.b, m = f.a * g.a + f.b * g.b;  // g's normal is m/n times f's
  Real k = g.k * n - f.k * m;
  if (k.sign() == 0) return {};
  return {{(f.c * m - g.c * n) / k, std::nullopt}};
}

/// Of three circles two have a radical plane; where that stands upright (two vertices) and the third circle keeps
/// still.
std::vector<Event> still_and_two(const LevelCurve& f, const LevelCurve& g, const LevelCurve& h, const Plane& upright) {
  const LevelCurve* still = f.k.sign() == 0 ? &f : g.k.sign() == 0 ? &g : &h;
  const LevelCurve& moves = still == &f ? g : f;
  if (still->k.sign() != 0 || moves.k.sign() == 0 || upright.l.sign() != 0) return {};
  Real n2 = upright.x * upright.x + upright.y * upright.y;
  if (n2.sign() == 0) return {};
  Real x = upright.x * upright.c / n2, y = upright.y * upright.c / n2;
  std::vector<Event> out;
  for (const Event& e : on_circle({{x, y, Real()}, {upright.y, -upright.x, Real()}}, *still)) {
    Real d = length(e.at->x - moves.a, e.at->y - moves.b);
    for (int side : {-1, 1}) out.push_back({(Real(side) * d - moves.c) / moves.k, e.at});
  }
  return out;
}

}  // namespace

LevelCurve LevelCurve::moved(const RealPoint& by) const {
  LevelCurve out = *this;
  if (circle) {
    out.a -= by.x;
    out.b -= by.y;
  } else
    out.c -= a * by.x + b * by.y;
  return out;
}

LevelCurve LevelCurve::reflected() const {
  LevelCurve out = *this;
  out.a = -a;
  out.b = -b;
  if (!circle || !bend) return out;
  Bend rotated = *bend;
  for (auto* v : {&rotated.along, &rotated.across})
    for (Real& c : *v) c = -c;
  out.bend = std::make_shared<Bend>(std::move(rotated));
  return out;
}

double LevelCurve::gap(double x, double y, double level) const {
  const auto number = [](const Real& r) { return r.interval().lo; };
  double root = 0, px = number(a), py = number(b), offset = number(c) + number(k) * level;
  if (bend) {
    const double t = number(bend->t[0]) + level * (number(bend->t[1]) + level * number(bend->t[2]));
    root = std::sqrt(std::max(0.0, t));
  }
  if (!circle) {
    if (bend) offset += number(bend->weight) * root;
    return std::abs(px * x + py * y - offset) / std::sqrt(px * px + py * py);
  }
  if (bend) {
    px += level * number(bend->along[0]) + root * number(bend->across[0]);
    py += level * number(bend->along[1]) + root * number(bend->across[1]);
  }
  return std::abs(std::sqrt((x - px) * (x - px) + (y - py) * (y - py)) - std::abs(offset));
}

std::vector<Event> events(const LevelCurve& f) {
  if (!f.circle || f.k.sign() == 0) return {};
  return {{-f.c / f.k, RealPoint{f.a, f.b}}};
}

std::vector<Event> events(const LevelCurve& f, const LevelCurve& g) {
  if (f.circle && g.circle) return circles_touch(f, g);
  if (f.circle) return line_touches(g, f);
  return g.circle ? line_touches(f, g) : lines_coincide(f, g);
}

std::vector<Event> events(const LevelCurve& f, const LevelCurve& g, const LevelCurve& h) {
  std::vector<const LevelCurve*> circles, lines;
  for (const LevelCurve* k : {&f, &g, &h}) (k->circle ? circles : lines).push_back(k);
  std::vector<Plane> planes;
  for (const LevelCurve* k : lines) planes.push_back(plane_of(*k));
  for (std::size_t k = 1; k < circles.size(); ++k)
    if (auto p = radical(*circles[0], *circles[k])) planes.push_back(*p);
  if (circles.size() == 3 && planes.empty())
    if (auto p = radical(*circles[1], *circles[2])) planes.push_back(*p);
  if (circles.size() == 3 && planes.size() == 1) return still_and_two(*circles[0], *circles[1], *circles[2], planes[0]);
  if (planes.size() < 2) return {};
  auto ray = meet(planes[0], planes[1]);
  if (!ray) return {};
  if (!circles.empty()) return on_circle(*ray, *circles[0]);
  // Three lines: the point of the ray on the third plane.
  const Plane& p = planes[2];
  Real slope = p.x * ray->along[0] + p.y * ray->along[1] + p.l * ray->along[2];
  if (slope.sign() == 0) return {};
  return {event_on(*ray, (p.c - p.x * ray->base[0] - p.y * ray->base[1] - p.l * ray->base[2]) / slope)};
}

}  // namespace findspace::distance
