// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The points and the distance of a pair of boundary features, exactly. Guarantee: exact reals. Cost: microseconds.
// Keywords: closest features, elementary distances.
#pragma once

#include <optional>

#include "plane/complex/cell_complex.h"
#include "plane/query/locate.h"

namespace findspace::distance {

struct FeaturePair {
  exact::Real distance;
  exact::RealPoint first, second;       // the points, of A and of B + p
  plane::Cell first_cell, second_cell;  // vertices or edges of A and of B
};

/// Two features and their distance in numbers.
struct Candidate {
  double value;
  plane::Cell first, second;
};

/// The nearest (or farthest, if `far`) points of two features, of B moved by p. Nothing where a projection is not on
/// its edge.
std::optional<FeaturePair> exact_pair(const plane::Region& a, const plane::Region& b, const exact::RealPoint& p,
                                      const Candidate& k, bool far);
/// The point of a vertex or an edge of A nearest to a place (`second`); on an arc in the direction of the place.
/// Nothing where the projection is not on the edge.
std::optional<FeaturePair> exact_pair(const plane::Region& a, plane::Cell cell, const exact::RealPoint& at);
/// The common point of two straight edges that cross.
FeaturePair crossing(const plane::Region& a, const plane::Region& b, plane::Cell s, plane::Cell t,
                     const exact::RealPoint& p);

}  // namespace findspace::distance
