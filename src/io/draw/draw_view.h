// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The view in which pictures of space are drawn: orthogonal, x to the lower left, y to the right, z up, as in a text
// book. The three directions are perpendicular unit vectors.
#pragma once

#include <array>

namespace findspace::io {

inline constexpr double kViewSize = 720;  // of the drawn part, in pixels
inline constexpr std::array<double, 3> kRight{-0.5, 0.8660254037844386, 0};
inline constexpr std::array<double, 3> kUp{-0.3535533905932738, -0.2041241452319315, 0.9128709291752769};
inline constexpr std::array<double, 3> kTowards{0.7905694150420949, 0.4564354645876384, 0.408248290463863};

inline double dot(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

}  // namespace findspace::io
