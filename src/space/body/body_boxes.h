// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Boxes of bodies and of the positions at which bodies can meet. Guarantee: exact; in doubles rounded. Keywords: AABB,
// Minkowski difference of boxes.
#pragma once

#include <algorithm>
#include <optional>

#include "space/body/body.h"
#include "space/polytope/extent.h"

namespace findspace::space {

inline Body body_of_part(const BodyPart& part) {
  Body one;
  one.parts.push_back(part);
  return one;
}

inline Extent rounded(const Bounds3& box) { return {rounded(box.low), rounded(box.high)}; }
inline Extent moved(const Extent& box, const Vector& by) { return {plus(box.low, by), plus(box.high, by)}; }

/// How far two boxes are from each other.
inline double distance(const Extent& a, const Extent& b) { return Extent{a.low - b.high, a.high - b.low}.distance({}); }

/// The positions of b at which the boxes meet.
inline Bounds3 meeting(const Bounds3& b, const Bounds3& a) { return {minus(a.low, b.high), minus(a.high, b.low)}; }
/// At which b lies in a; nothing where it never does.
inline std::optional<Bounds3> fitting(const Bounds3& b, const Bounds3& a) {
  Bounds3 out{minus(a.low, b.low), minus(a.high, b.high)};
  for (std::size_t k = 0; k < 3; ++k) {
    if (out.high[k] < out.low[k]) return std::nullopt;
  }
  return out;
}

/// What both have in common; may be no box.
inline Bounds3 in_both(Bounds3 a, const Bounds3& b) {
  for (std::size_t k = 0; k < 3; ++k) {
    a.low[k] = std::max(a.low[k], b.low[k]);
    a.high[k] = std::min(a.high[k], b.high[k]);
  }
  return a;
}
/// Whether such a box may hold a place, or have interior.
inline bool holds_places(const Bounds3& box) {
  return box.low[0] <= box.high[0] && box.low[1] <= box.high[1] && box.low[2] <= box.high[2];
}
inline bool bulky(const Bounds3& box) {
  return box.low[0] < box.high[0] && box.low[1] < box.high[1] && box.low[2] < box.high[2];
}
/// Whether the interior of one may hold a place of the other.
inline bool open_meet(const Bounds3& a, const Bounds3& b) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (a.high[k] <= b.low[k] || b.high[k] <= a.low[k]) return false;
  }
  return true;
}
inline bool meet_or_touch(const Bounds3& a, const Bounds3& b) { return holds_places(in_both(a, b)); }

/// The half spaces that it is made of.
inline std::vector<HalfSpace> walls(const Bounds3& box) {
  std::vector<HalfSpace> out;
  for (std::size_t k = 0; k < 3; ++k) {
    RealVector n;
    n[k] = exact::Real(1);
    out.emplace_back(n, -box.high[k]);
    out.emplace_back(negated(n), box.low[k]);
  }
  return out;
}

/// Those of a point: no place is within all of them.
inline std::vector<HalfSpace> walls_about(const Point& p) { return walls({real(p), real(p)}); }

}  // namespace findspace::space
