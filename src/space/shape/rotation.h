// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A rotation of space about a point: x -> R x + by, R an orthogonal matrix of determinant 1 with rational entries.
// Guarantee: a quaternion and a matrix are taken exactly. So is an angle of 0, 60, 90, 120 or 180 degrees about an axis
// where its matrix is rational, as of 120 degrees about (1, 1, 1). Other angles become the nearest of a rational
// matrix: the axis stays exact, the angle is off by less than 2^-48 of itself. Source: Euler and Rodrigues' formula.
// Keywords: orientation, quaternion, rotation matrix, axis and angle, SO(3).
#pragma once

#include <array>

#include "space/polytope/real_vector.h"

namespace findspace::space {

struct Rotation {
  using Matrix = std::array<RealVector, 3>;  // rows

  Matrix rows{RealVector{1, 0, 0}, RealVector{0, 1, 0}, RealVector{0, 0, 1}};
  RealVector by;
  bool rounded = false;  // the angle was not one of a rational matrix

  /// Counter-clockwise seen from the axis' positive end (0 x, 1 y, 2 z), about the line through `about`.
  static Rotation about_axis(int axis, const exact::Real& degrees, const Point& about);
  /// The same about any direction of rational numbers; throws Error(kBadValue) for a zero one.
  static Rotation about_direction(const RealVector& axis, const exact::Real& degrees, const Point& about);
  /// (w, x, y, z) of any length but 0; throws Error(kBadValue).
  static Rotation of_quaternion(const std::array<exact::Real, 4>& q, const Point& about);
  /// Throws Error(kBadValue), saying what is wrong, unless the matrix is exactly a rotation.
  static Rotation of_matrix(const Matrix& rows, const Point& about);

  /// Whether every axis is taken to an axis; and the z axis to itself.
  bool keeps_axes() const;
  bool keeps_z() const;
  RealVector linear(const RealVector& x) const { return {dot(rows[0], x), dot(rows[1], x), dot(rows[2], x)}; }
  RealVector operator()(const RealVector& x) const { return plus(linear(x), by); }
};

}  // namespace findspace::space
