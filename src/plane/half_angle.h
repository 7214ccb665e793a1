// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Polynomials in u = tan(angle / 2), in doubles: what expressions in the cosine and sine of a turn become when
// multiplied by (1 + u^2) often enough. They find the angles at which moving curves meet in one point, roots of degree
// up to 12, in a narrow sector around angle 0. Guarantee: none; a root is right to about 1e-14 where it is simple, and
// places where the polynomial nearly touches 0 are found too. Keywords: Weierstrass substitution, real roots.
#pragma once

#include <array>
#include <vector>

namespace findspace::plane {

struct HalfAngle {
  std::array<double, 13> c{};  // of 1, u, u^2, ...
  int degree = 0;

  /// constant + cosine * cos + sine * sin, times 1 + u^2.
  static HalfAngle linear(double constant, double cosine, double sine);
  double at(double u) const;
  HalfAngle derivative() const;
};

HalfAngle operator+(const HalfAngle& a, const HalfAngle& b);
HalfAngle operator-(const HalfAngle& a, const HalfAngle& b);
HalfAngle operator*(const HalfAngle& a, const HalfAngle& b);
HalfAngle operator*(double s, const HalfAngle& a);
/// Times 1 + u^2.
HalfAngle raised(const HalfAngle& a);

/// The roots in [-span, span] and the places where the polynomial comes as near to 0 as rounding, `scale` being the
/// size of what it was made of.
std::vector<double> roots(const HalfAngle& a, double span, double scale);

}  // namespace findspace::plane
