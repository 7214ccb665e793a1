// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Vectors of exact reals, where a construction is too rare for the fixed-width stages of exact::Geometry.
#pragma once

#include "exact/planar/geometry.h"

namespace findspace::plane {

using RealVector = exact::RealPoint;

inline RealVector operator+(const RealVector& p, const RealVector& q) { return {p.x + q.x, p.y + q.y}; }
inline RealVector operator-(const RealVector& p, const RealVector& q) { return {p.x - q.x, p.y - q.y}; }
inline RealVector operator-(const RealVector& p) { return {-p.x, -p.y}; }
inline RealVector operator*(const exact::Real& s, const RealVector& p) { return {s * p.x, s * p.y}; }
inline bool operator==(const RealVector& p, const RealVector& q) { return p.x == q.x && p.y == q.y; }
inline exact::Real dot(const RealVector& p, const RealVector& q) { return p.x * q.x + p.y * q.y; }
inline exact::Real cross(const RealVector& p, const RealVector& q) { return p.x * q.y - p.y * q.x; }
inline RealVector left_normal(const RealVector& p) { return {-p.y, p.x}; }
inline RealVector right_normal(const RealVector& p) { return {p.y, -p.x}; }

}  // namespace findspace::plane
