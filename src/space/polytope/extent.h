// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Boxes in doubles that hold a set, for filters: what boxes say is apart is apart. Guarantee: a box is no smaller than
// the set it is made of. Keywords: bounding box, AABB.
#pragma once

#include <algorithm>
#include <limits>
#include <span>
#include <utility>

#include "exact/margins/rounding.h"
#include "space/polytope/real_vector.h"

namespace findspace::space {

/// Sides may be infinite.
struct Extent {
  Vector low, high;
  bool holds(const Vector& p, double tolerance) const {
    return p.x >= low.x - tolerance && p.y >= low.y - tolerance && p.z >= low.z - tolerance &&
           p.x <= high.x + tolerance && p.y <= high.y + tolerance && p.z <= high.z + tolerance;
  }
  bool meets(const Extent& o) const {
    return low.x <= o.high.x && low.y <= o.high.y && low.z <= o.high.z && o.low.x <= high.x && o.low.y <= high.y &&
           o.low.z <= high.z;
  }
  bool bounded() const { return std::isfinite(size_of(low)) && std::isfinite(size_of(high)); }
  void add(const Extent& o) {
    low = {std::min(low.x, o.low.x), std::min(low.y, o.low.y), std::min(low.z, o.low.z)};
    high = {std::max(high.x, o.high.x), std::max(high.y, o.high.y), std::max(high.z, o.high.z)};
  }
  /// At least this far from p.
  double distance(const Vector& p) const {
    const auto gap = [](double c, double lo, double hi) { return std::max({lo - c, c - hi, 0.0}); };
    return length({gap(p.x, low.x, high.x), gap(p.y, low.y, high.y), gap(p.z, low.z, high.z)});
  }
  /// At most so far.
  double farthest(const Vector& p) const {
    const auto reach = [](double c, double lo, double hi) { return std::max(c - lo, hi - c); };
    return length({reach(p.x, low.x, high.x), reach(p.y, low.y, high.y), reach(p.z, low.z, high.z)});
  }
  Vector middle() const { return scaled(0.5, plus(low, high)); }
  /// One of the eight that it is divided into, number k below 8.
  Extent eighth(int k) const {
    const Vector m = middle();
    const auto half = [&](int bit, double from, double at, double to) {
      return (k & bit) != 0 ? std::pair(at, to) : std::pair(from, at);
    };
    const auto [x0, x1] = half(1, low.x, m.x, high.x);
    const auto [y0, y1] = half(2, low.y, m.y, high.y);
    const auto [z0, z1] = half(4, low.z, m.z, high.z);
    return {{x0, y0, z0}, {x1, y1, z1}};
  }
};

inline Extent everywhere() {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  return {{-kFar, -kFar, -kFar}, {kFar, kFar, kFar}};
}

/// A box around points that are known rounded: a hair larger than their doubles say.
inline Extent extent_of(std::span<const Vector> points) {
  Extent e{points[0], points[0]};
  double size = 1;
  for (const Vector& p : points) {
    e.add({p, p});
    size = std::max(size, size_of(p));
  }
  const double widened = margin::kRoundings32 * size;
  const Vector tolerance{widened, widened, widened};
  return {e.low - tolerance, plus(e.high, tolerance)};
}

/// Where the plane's value has one sign in the whole box, that sign; 0 where it has not, or doubles do not tell.
inline int side_of(const HalfSpace& h, const Extent& box) {
  if (!box.bounded()) return 0;
  const Vector middle = box.middle(), half = scaled(0.5, box.high - box.low);
  const double at = h.approx_value(middle), error = h.error(middle) + h.error(half);
  const double spread = std::fabs(h.unit.x) * half.x + std::fabs(h.unit.y) * half.y + std::fabs(h.unit.z) * half.z;
  return at - spread > error ? 1 : at + spread < -error ? -1 : 0;
}

/// {a - b}.
inline Extent difference(const Extent& a, const Extent& b) { return {a.low - b.high, a.high - b.low}; }

}  // namespace findspace::space
