// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Expressions in the cosine and sine of an angle as exact polynomials in u = tan(half of what the angle is beyond a
// whole number of quarters), over a power of 1 + u^2; and the angles at which they are 0. Guarantee: exact; no angle is
// missed, multiple ones come once. Cost: polynomial_root.h. Keywords: Weierstrass substitution, trigonometric
// polynomial.
#pragma once

#include "exact/number/polynomial_root.h"
#include "exact/planar/angle.h"

namespace findspace::exact {

class RotationPolynomial {
 public:
  RotationPolynomial() = default;  // 0
  /// constant + cosine * cos + sine * sin of an angle near that many quarters.
  static RotationPolynomial linear(const Real& constant, const Real& cosine, const Real& sine, int quarters);
  static RotationPolynomial constant(const Real& value) { return {{value}, 0}; }

  friend RotationPolynomial operator+(const RotationPolynomial& a, const RotationPolynomial& b);
  friend RotationPolynomial operator-(const RotationPolynomial& a, const RotationPolynomial& b) {
    return a + Real(-1) * b;
  }
  friend RotationPolynomial operator*(const RotationPolynomial& a, const RotationPolynomial& b);
  friend RotationPolynomial operator*(const Real& s, const RotationPolynomial& a);

  bool is_zero() const;
  bool is_rational() const;  // each coefficient
  bool is_closed() const;
  /// The rotations at which it is 0, in the radians from - to, which lie within an eighth of a circle and a little more
  /// of `quarters`.
  std::vector<ExactAngle> rotations_between(double from, double to, int quarters) const;

 private:
  RotationPolynomial(Polynomial c, int raise) : c_(std::move(c)), raise_(raise) {}
  RotationPolynomial raised(int to) const;

  Polynomial c_;
  int raise_ = 0;  // the power of 1 + u^2 below
};

}  // namespace findspace::exact
