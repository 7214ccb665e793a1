// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Vectors of three doubles: positions and directions in grid steps, for values, filters and searches. Guarantee: none
// beyond the rounding of each operation; signs are decided by src/exact.
#pragma once

#include <cmath>

#include "exact/solid/space_sign.h"

namespace findspace::space {

/// A position or a direction in grid steps.
using Vector = exact::Approx3;

inline double dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vector cross(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Vector plus(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vector scaled(double s, const Vector& a) { return {s * a.x, s * a.y, s * a.z}; }
inline double length(const Vector& a) { return std::sqrt(dot(a, a)); }
inline double size_of(const Vector& a) { return std::fabs(a.x) + std::fabs(a.y) + std::fabs(a.z); }

}  // namespace findspace::space
