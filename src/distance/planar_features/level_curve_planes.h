// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Level curves as sets of the space of (x, y, level): lines are planes there, and so is the difference of two circles'
// equations. Guarantee: exact. Internal to the meetings of level curves (level_curve.cpp, curved_level_curve.cpp).
#pragma once

#include <optional>

#include "distance/planar_features/level_curve.h"

namespace findspace::distance {

/// x*px + y*py + l*level = c.
struct LevelCurvePlane {
  exact::Real x, y, l, c;
};

inline LevelCurvePlane plane_of(const LevelCurve& line) { return {line.a, line.b, -line.k, line.c}; }

/// The difference of two circle equations, linear where the squares of k agree.
inline std::optional<LevelCurvePlane> radical(const LevelCurve& f, const LevelCurve& g) {
  using exact::Real;
  if (compare(f.k * f.k, g.k * g.k) != 0) return std::nullopt;
  auto power = [](const LevelCurve& h) { return h.a * h.a + h.b * h.b - h.c * h.c; };
  return LevelCurvePlane{Real(2) * (g.a - f.a), Real(2) * (g.b - f.b), Real(2) * (g.c * g.k - f.c * f.k),
                         power(g) - power(f)};
}

}  // namespace findspace::distance
