// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Exact angles. A ExactAngle is a rotation about the origin given by its cosine and sine as exact reals with cos^2 +
// sin^2 = 1; an Angle is a turn plus a rational number of degrees, so that "the angle of that contact, and 12.5 degrees
// more" is a value too. Angles live on the circle: their place is in [0, 360).
//
// Guarantee: the order of two angles is exact. One with degrees added is first compared by enclosures of 180 bits;
// where these leave it open, d = 360 k / n in lowest terms is the angle of a turn exactly if that turn n times is no
// turn at all, which is decided among the turn's own numbers. Angles closer than that and different are refused with
// Error(kUnsupported). Cost: a comparison of doubles where the angles are not within 1e-9 degrees of each other.
// Keywords: rotation, root of unity, circular order.
#pragma once

#include <vector>

#include "exact/planar/geometry.h"

namespace findspace::exact {

struct ExactAngle {
  Real cos = 1, sin = 0;

  /// A turn of rational cosine and sine within about 2^-bits of the one given in degrees.
  static ExactAngle near(double degrees, int bits);
  /// In [0, 360), correct to about 1e-13.
  double degrees() const;
  ExactAngle operator-() const { return {cos, -sin}; }
  /// One after the other.
  friend ExactAngle operator+(const ExactAngle& p, const ExactAngle& q) {
    return {p.cos * q.cos - p.sin * q.sin, p.sin * q.cos + p.cos * q.sin};
  }
  RealPoint operator()(const RealPoint& p) const { return {cos * p.x - sin * p.y, sin * p.x + cos * p.y}; }
};

/// A number of degrees in double precision. Of more than a circle the remainder is rounded, not the number.
double rounded_degrees(const Real& degrees);

/// The rotations with a*cos + b*sin = c: none, one (a double root) or two. None as well where a = b = 0.
std::vector<ExactAngle> rotations_where(const Real& a, const Real& b, const Real& c);

struct Angle {
  ExactAngle rotation;
  Real more;  // degrees, rational

  static Angle of_degrees(const Real& degrees) { return {{}, degrees}; }
  /// In [0, 360); the order of angles near 0 and 360 is decided exactly before it is rounded.
  double degrees() const;
  Angle operator+(const Real& degrees) const { return {rotation, more + degrees}; }
  Angle operator-(const Real& degrees) const { return {rotation, more - degrees}; }
};

/// By place in [0, 360): exact.
int compare(const Angle& p, const Angle& q);
/// Degrees counter-clockwise from one angle to another, in [0, 360]: 0 for equal ones. Rounded, but the least way is
/// never taken for the whole circle, nor the other way round.
double way(const Angle& from, const Angle& to);
/// A turn of rational cosine and sine (where doubles find one) strictly between two different angles without degrees
/// added, counter-clockwise from the first. Of two equal ones: somewhere on the rest of the circle.
ExactAngle between(const ExactAngle& from, const ExactAngle& to);

}  // namespace findspace::exact
