// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/planar_features/curved_level_curve.h"

#include "distance/planar_features/boundary_features.h"
#include "distance/planar_features/level_curve_planes.h"

namespace findspace::distance {

using exact::Real;

namespace {

/// start + level * along + sqrt(T) * across.
struct Corner {
  std::array<Real, 2> start, along, across;
  std::array<Real, 3> t;
};

/// Where two lines cross.
std::optional<Corner> curve_crossing(const LevelCurve& f, const LevelCurve& g) {
  const Real d = f.a * g.b - f.b * g.a;
  if (d.sign() == 0) return std::nullopt;
  return Corner{{(f.c * g.b - g.c * f.b) / d, (f.a * g.c - g.a * f.c) / d},
                {(f.k * g.b - g.k * f.b) / d, (f.a * g.k - g.a * f.k) / d},
                {},
                {}};
}

/// Where a circle meets a line or circle.
std::optional<Corner> meeting(const LevelCurve& f, const LevelCurve& g, double near_x, double near_y) {
  const auto plane = g.circle ? radical(f, g) : plane_of(g);
  if (!plane) return std::nullopt;
  const Real &mx = plane->x, &my = plane->y, n = mx * mx + my * my;
  if (n.sign() == 0) return std::nullopt;
  // The corner is w + m * d / n +- turned m * sqrt(n * r^2 - d^2) / n, with d = d0 + d1 * level.
  const Real d0 = plane->c - mx * f.a - my * f.b, d1 = -plane->l;
  const double side = near_value(mx) * (near_y - near_value(f.b)) - near_value(my) * (near_x - near_value(f.a));
  const Real turn = Real(side > 0 ? 1 : -1) / n;
  return Corner{{f.a + mx * d0 / n, f.b + my * d0 / n},
                {mx * d1 / n, my * d1 / n},
                {-my * turn, mx * turn},
                {n * f.c * f.c - d0 * d0, Real(2) * (n * f.c * f.k - d0 * d1), n * f.k * f.k - d1 * d1}};
}

}  // namespace

std::optional<LevelCurve> corner_level_curve(const LevelCurve& edge, const LevelCurve& f, const LevelCurve& g,
                                             double near_x, double near_y) {
  const LevelCurve &first = f.circle ? f : g, &second = f.circle ? g : f;
  const auto c = first.circle ? meeting(first, second, near_x, near_y) : curve_crossing(f, g);
  if (!c) return std::nullopt;
  if (edge.circle) {
    LevelCurve out = LevelCurve::ring(c->start[0] - edge.a, c->start[1] - edge.b, edge.c, edge.k);
    out.bend = std::make_shared<Bend>(Bend{{}, c->t, c->along, c->across});
    return out;
  }
  const auto of = [&](const std::array<Real, 2>& v) { return edge.a * v[0] + edge.b * v[1]; };
  LevelCurve out = LevelCurve::line(edge.a, edge.b, of(c->start) - edge.c, of(c->along));
  const Real weight = of(c->across);
  if (weight.sign() != 0) out.bend = std::make_shared<Bend>(Bend{weight, c->t, {}, {}});
  return out;
}

}  // namespace findspace::distance
