// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The boundary of the convex hull of points and circular arcs, as corners and the curves between them,
// counter-clockwise. Used by hull.cpp only. Guarantee: exact. Method: a line of support is rolled once round the set;
// from the element it rolls on, a point or an arc, the next is the one it meets after the least rotation.
#pragma once

#include <vector>

#include "plane/base/real_vector.h"

namespace findspace::plane {

/// A point (radius 0), or an arc of at most a half circle: the places center + radius * u for the directions u from
/// `low` counter-clockwise to `high` (vectors of any length).
struct HullElement {
  RealVector center;
  exact::Real radius{};
  RealVector low{}, high{};

  bool arc() const { return radius.sign() > 0; }
};

/// A curve of the boundary from a corner to the next: a part of the arc `element`, or (kSide) a straight side.
struct HullCurve {
  static constexpr std::size_t kSide = ~std::size_t{0};
  RealVector from;
  std::size_t element = kSide;
  RealVector direction{};  // of a side, any length
};

/// `elements`: the corners of the convex hull of all points and ends of arcs (the first the lexicographically smallest,
/// then counter-clockwise), `corners` of them, then arcs. No curve at all where there is one point only.
std::vector<HullCurve> wrap(const std::vector<HullElement>& elements, std::size_t corners);

}  // namespace findspace::plane
