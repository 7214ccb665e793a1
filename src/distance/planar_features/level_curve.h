// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The curve of positions at which one elementary distance (to a vertex, a line, a circle) equals a level, as a function
// of that level: a line that moves, or a circle that grows or shrinks about its centre. A distance is a minimum and
// maximum of elementary ones, so its extreme levels are among those where level curves meet:
//   one circle:   its radius becomes 0;
//   two level curves:   they touch (centres on one line, circle and line tangent, parallel lines coincide);
//   three level curves: they pass through one point (Apollonius' problem, with lines and circles that keep still
//   admitted).
// Guarantee: all results are exact reals; every proper event of a pair is found, of a triple every one that square
// roots can express (all, unless circles that move and circles that keep still are mixed). Cost: microseconds. Source:
// Apollonius' problem by elimination; distances.md 3.5. Keywords: medial axis, Voronoi vertex, inscribed circle.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "exact/planar/geometry.h"

namespace findspace::distance {

/// With T = t[0] + t[1]*level + t[2]*level^2: a line's offset has weight * sqrt(T) more, a circle's centre is moved by
/// along * level + across * sqrt(T).
struct Bend {
  exact::Real weight;
  std::array<exact::Real, 3> t;
  std::array<exact::Real, 2> along, across;
};

/// Line: a*x + b*y = c + k*level. Circle: centre (a, b), signed radius c + k*level. A bend perhaps
/// (curved_level_curve.h).
struct LevelCurve {
  bool circle = false;
  exact::Real a, b, c, k;
  std::shared_ptr<const Bend> bend{};

  static LevelCurve line(exact::Real a, exact::Real b, exact::Real c, exact::Real k) {
    return {false, std::move(a), std::move(b), std::move(c), std::move(k), {}};
  }
  static LevelCurve ring(exact::Real x, exact::Real y, exact::Real radius, exact::Real k) {
    return {true, std::move(x), std::move(y), std::move(radius), std::move(k), {}};
  }
  /// The level curve of the moved elementary distance: f(p + by).
  LevelCurve moved(const exact::RealPoint& by) const;
  /// Of f(-p).
  LevelCurve reflected() const;
  /// About how far (x, y) is from the level curve at a level.
  double gap(double x, double y, double level) const;
};

/// A level curve that passes near a position: at the position's own level it is `gap` away from it.
struct NearLevelCurve {
  LevelCurve curve;
  double gap;
};

struct Event {
  exact::Real level;
  std::optional<exact::RealPoint> at;  // where it happens, if that is one point
};

/// Of level curves that are not bent.
std::vector<Event> events(const LevelCurve& f);
std::vector<Event> events(const LevelCurve& f, const LevelCurve& g);
std::vector<Event> events(const LevelCurve& f, const LevelCurve& g, const LevelCurve& h);

}  // namespace findspace::distance
