// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Points and directions in doubles, as the filters of this street take them: a complex number, so that a product is a
// rotation. Guarantee: none beyond the rounding of each operation; no sign is decided by them.
#pragma once

#include <cmath>
#include <complex>
#include <numbers>

namespace findspace::plane {

inline constexpr double kPi = std::numbers::pi;

using RoughPoint = std::complex<double>;
inline double length(RoughPoint p) { return std::sqrt(std::norm(p)); }  // coordinates are far from overflow
inline double dot(RoughPoint a, RoughPoint b) { return a.real() * b.real() + a.imag() * b.imag(); }
inline double cross(RoughPoint a, RoughPoint b) { return a.real() * b.imag() - a.imag() * b.real(); }

}  // namespace findspace::plane
