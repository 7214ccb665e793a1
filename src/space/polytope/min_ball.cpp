// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/polytope/min_ball.h"

#include <algorithm>
#include <array>
#include <optional>

namespace findspace::space {

using exact::Real;

namespace {

Real square(const RealVector& a, const RealVector& b) {
  const RealVector e = minus(a, b);
  return dot(e, e);
}

/// The point of the affine hull of one to four points that is equally far from all; nothing where they are dependent.
std::optional<RealVector> circumcenter(const std::vector<const RealVector*>& points) {
  const std::size_t n = points.size() - 1;
  std::array<RealVector, 3> e;
  std::array<std::array<Real, 4>, 3> g;
  for (std::size_t i = 0; i < n; ++i) e[i] = minus(*points[i + 1], *points[0]);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) g[i][j] = dot(e[i], e[j]);
    g[i][3] = g[i][i] / Real(2);
  }
  RealVector center = *points[0];
  // Elimination on the Gram matrix, which is positive definite unless the points are dependent.
  for (std::size_t k = 0; k < n; ++k) {
    if (g[k][k].sign() == 0) return std::nullopt;
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k) continue;
      const Real factor = g[i][k] / g[k][k];
      for (std::size_t j = 0; j < 4; ++j) g[i][j] -= factor * g[k][j];
    }
  }
  for (std::size_t i = 0; i < n; ++i) center = along(center, g[i][3] / g[i][i], e[i]);
  return center;
}

}  // namespace

EnclosingBall min_ball(const std::vector<RealVector>& points) {
  std::vector<std::size_t> basis{0};
  EnclosingBall ball{points[0], Real()};
  while (true) {
    std::size_t out = 0;
    Real most = ball.square;
    bool found = false;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Real d = square(points[i], ball.center);
      if (most < d) {
        most = d;
        out = i;
        found = true;
      }
    }
    if (!found) return ball;
    std::vector<std::size_t> few = basis;
    few.push_back(out);
    std::optional<EnclosingBall> best;
    for (unsigned set = 1; set < (1u << few.size()); ++set) {
      std::vector<std::size_t> on;
      std::vector<const RealVector*> corners;
      for (std::size_t i = 0; i < few.size(); ++i) {
        if (set >> i & 1) {
          on.push_back(few[i]);
          corners.push_back(&points[few[i]]);
        }
      }
      if (on.size() > 4) continue;
      const auto center = circumcenter(corners);
      if (!center) continue;
      const Real r = square(*corners[0], *center);
      if (best && !(r < best->square)) continue;
      if (std::any_of(few.begin(), few.end(), [&](std::size_t i) { return r < square(points[i], *center); })) continue;
      best = EnclosingBall{*center, r};
      basis = on;
    }
    ball = *best;
  }
}

}  // namespace findspace::space
