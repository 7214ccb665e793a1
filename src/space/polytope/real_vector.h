// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Vectors of three exact reals, and half spaces with real coefficients beside their doubles. A half space is
// {x : normal . x + offset <= 0}; its approx, divided by the length of the normal, serves filters and searches.
// Guarantee: what is Real is exact; approx carry at most four roundings.
#pragma once

#include <array>

#include "exact/margins/rounding.h"
#include "exact/number/real.h"
#include "space/polytope/polytope.h"
#include "space/polytope/vector.h"

namespace findspace::space {

/// A position or a direction in grid steps.
using RealVector = std::array<exact::Real, 3>;

inline exact::Real dot(const RealVector& a, const RealVector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline RealVector plus(const RealVector& a, const RealVector& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline RealVector minus(const RealVector& a, const RealVector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline RealVector negated(const RealVector& a) { return {-a[0], -a[1], -a[2]}; }
inline RealVector scaled(const exact::Real& s, const RealVector& a) { return {s * a[0], s * a[1], s * a[2]}; }
/// p + t * e.
inline RealVector along(const RealVector& p, const exact::Real& t, const RealVector& e) {
  return plus(p, scaled(t, e));
}
inline RealVector cross(const RealVector& a, const RealVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline RealVector real(const Point& p) { return {exact::Real(p.x), exact::Real(p.y), exact::Real(p.z)}; }
inline RealVector real(const Wide3& n) { return {exact::Real(n.x), exact::Real(n.y), exact::Real(n.z)}; }
inline RealVector real(const Vector& v) {
  return {exact::Real::from_double(v.x), exact::Real::from_double(v.y), exact::Real::from_double(v.z)};
}
inline bool is_zero(const RealVector& a) { return a[0].sign() == 0 && a[1].sign() == 0 && a[2].sign() == 0; }
inline Vector rounded(const RealVector& u) { return {u[0].to_double(), u[1].to_double(), u[2].to_double()}; }

struct HalfSpace {
  RealVector normal;  // not zero
  exact::Real offset;
  Vector unit;
  double shift = 0;

  HalfSpace(RealVector n, exact::Real d) : normal(std::move(n)), offset(std::move(d)), unit(space::rounded(normal)) {
    const double size = length(unit);
    unit = scaled(1 / size, unit);
    shift = offset.to_double() / size;
  }
  explicit HalfSpace(const Plane& p) : HalfSpace(real(p.normal), exact::Real(p.offset)) {}

  /// normal . x + offset.
  exact::Real value(const RealVector& x) const { return dot(normal, x) + offset; }
  /// The same over the length of the normal, in doubles; `error` of it.
  double approx_value(const Vector& x) const { return dot(unit, x) + shift; }
  double error(const Vector& x) const { return margin::kRoundings32 * (size_of(x) + std::fabs(shift)); }
  /// The exact sign of value(x); `near` is x rounded.
  int sign(const RealVector& x, const Vector& near) const {
    const double v = approx_value(near), e = error(near);
    return v > e ? 1 : v < -e ? -1 : value(x).sign();
  }
  /// The half space on the other side of the same plane.
  HalfSpace opposite() const { return HalfSpace(negated(normal), -offset); }
};

}  // namespace findspace::space
