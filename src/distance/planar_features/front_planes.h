// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Fronts as sets of the space of (x, y, level): lines are planes there, and so is the difference of two circles'
// equations. Guarantee: exact. Internal to the meetings of fronts (front.cpp, bent_front.cpp).
#pragma once

#include <optional>

#include "distance/planar_features/front.h"

namespace findspace::distance {

/// x*px + y*py + l*level = c.
struct FrontPlane {
  exact::Real x, y, l, c;
};

inline FrontPlane plane_of(const Front& line) { return {line.a, line.b, -line.k, line.c}; }

/// The difference of two circle equations, linear where the squares of k agree.
inline std::optional<FrontPlane> radical(const Front& f, const Front& g) {
  using exact::Real;
  if (compare(f.k * f.k, g.k * g.k) != 0) return std::nullopt;
  auto power = [](const Front& h) { return h.a * h.a + h.b * h.b - h.c * h.c; };
  return FrontPlane{Real(2) * (g.a - f.a), Real(2) * (g.b - f.b), Real(2) * (g.c * g.k - f.c * f.k),
                    power(g) - power(f)};
}

}  // namespace findspace::distance
