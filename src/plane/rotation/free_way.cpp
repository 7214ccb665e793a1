// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/rotation/free_way.h"

#include <cmath>

namespace findspace::plane {

using exact::Real;

RealVector FreeWay::at(const Real& distance) const { return distance / sqrt(plane::dot(along, along)) * along; }

RoughPoint FreeWay::rough_unit(double angle) const {
  const RoughPoint u(plane::rough(along.x), plane::rough(along.y));
  return u / length(u) * (rotations ? std::polar(1.0, angle) : 1.0);
}

RoughCurve FreeWay::rough(double angle, double reach) const {
  const RoughPoint u = rough_unit(angle);
  RoughCurve c;
  c.line = true;
  c.normal = RoughPoint(0, 1) * u;
  c.p = both_ways ? -reach * u : RoughPoint();
  c.q = reach * u;
  return c;
}

ExactCurve FreeWay::exact(const exact::ExactAngle& rotation) const {
  ExactCurve c;
  c.line = true;
  c.normal = left_normal(rotations ? rotation(along) : along);
  return c;
}

SectorCurve FreeWay::sector(double middle) const {
  const RoughPoint n = RoughPoint(0, 1) * rough_unit(middle);
  SectorCurve c;
  c.line = true;
  c.nx = rotations ? HalfAngle::linear(0, n.real(), -n.imag()) : HalfAngle::linear(n.real(), 0, 0);
  c.ny = rotations ? HalfAngle::linear(0, n.imag(), n.real()) : HalfAngle::linear(n.imag(), 0, 0);
  c.h = HalfAngle::linear(0, 0, 0);
  return c;
}

ExactSectorCurve FreeWay::exact_sector(int quarters) const {
  using exact::RotationPolynomial;
  const RealVector n = left_normal(along);
  const RotationPolynomial none = RotationPolynomial::constant(Real());
  if (!rotations) return {true, RotationPolynomial::constant(n.x), RotationPolynomial::constant(n.y), none, {}};
  return {true,
          RotationPolynomial::linear(Real(), n.x, -n.y, quarters),
          RotationPolynomial::linear(Real(), n.y, n.x, quarters),
          none,
          {}};
}

}  // namespace findspace::plane
