// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Phi-functions in closed form: discs and balls, rectangles, a rectangle and a disc. Positions are the vector from the
// centre of the first body to the centre of the second. Sizes are half sides and radii in any one unit.
// Guarantee: each value carries the roundings of its few operations; the forms are those of the source with the errata
// of docs/phi.md. Source: Stoyan et al., section 3; phi.md 7.
#pragma once

#include <algorithm>
#include <cmath>

namespace findspace::space {

/// Two balls of any dimension, R the sum of their radii and d the distance of their centres: d^2 - R^2, smooth but not
/// normalised; its minimum is -R^2.
constexpr double phi_balls_square(double d, double r1, double r2) { return d * d - (r1 + r2) * (r1 + r2); }
/// The normalised form d - R; inside it is minus the exact depth.
constexpr double phi_balls(double d, double r1, double r2) { return d - (r1 + r2); }

/// A rectangle by its half sides.
struct Rectangle {
  double a = 0, b = 0;
};

/// Two rectangles, max form: max(|x| - A, |y| - B).
inline double phi_rectangles(double x, double y, const Rectangle& p, const Rectangle& q) {
  return std::max(std::fabs(x) - (p.a + q.a), std::fabs(y) - (p.b + q.b));
}

/// A rectangle and a disc, piecewise: the distance to the corner in the closed corner regions, else the farther side.
/// Normalised, and minus the exact depth inside.
inline double phi_rectangle_disc(double x, double y, const Rectangle& p, double r) {
  const double s = std::fabs(x) - p.a, t = std::fabs(y) - p.b;
  return s >= 0 && t >= 0 ? std::sqrt(s * s + t * t) - r : std::max(s, t) - r;
}

/// The same function without cases, min(phi0, phi1 .. phi4): what a solver wants. phi0 is the greatest of four sides
/// and four diagonals, phi1 .. phi4 the distances to the corners, each less r.
inline double phi_rectangle_disc_case_free(double x, double y, const Rectangle& p, double r) {
  const double sides = std::max(std::fabs(x) - p.a - r, std::fabs(y) - p.b - r);
  const double diagonals = std::fabs(x) + std::fabs(y) - (p.a + p.b + r);
  double least = std::max(sides, diagonals);
  for (const double sx : {-p.a, p.a}) {
    for (const double sy : {-p.b, p.b}) least = std::min(least, std::hypot(x - sx, y - sy) - r);
  }
  return least;
}

/// Two rectangles, normalised: the rectangle of the summed half sides and a point.
inline double phi_rectangles_normalised(double x, double y, const Rectangle& p, const Rectangle& q) {
  return phi_rectangle_disc(x, y, {p.a + q.a, p.b + q.b}, 0);
}

}  // namespace findspace::space
