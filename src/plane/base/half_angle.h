// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Polynomials in u = tan(angle / 2), in doubles: what expressions in the cosine and sine of a turn become when
// multiplied by (1 + u^2) often enough. They filter the angles at which moving curves meet in one point, roots of
// degree up to 12, in a narrow sector around angle 0; rotation_polynomial.h decides. Guarantee: for polynomials made
// with at most 1e-12 of their size lost (some thousand roundings) no root lies outside the places. Keywords:
// Weierstrass substitution, real roots.
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

/// Where a polynomial may be 0: within `tolerance` of u.
struct RootPlace {
  double u = 0, tolerance = 0;
};

/// All the places in [-span, span] where a polynomial can have roots that was rounded to these coefficients; `scale`
/// is the size of what it was made of. The whole of the interval, as one place, where nothing is known but rounding.
std::vector<RootPlace> root_places(const HalfAngle& a, double span, double scale);

}  // namespace findspace::plane
