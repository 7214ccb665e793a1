// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The point of a set B + p that is farthest from a closed set A, both bounded by segments: the directed Hausdorff
// distance h(B+p, A) = max over b of d(b, A), over the whole of B (its vertices, edges and inside), not over samples.
// Method: branch and bound with the best place known so far. Boxes around parts of B's boundary (d is 1-Lipschitz),
// then parts of edges (the distance to one part of A is convex along an edge, so its ends bound it), then boxes of the
// plane in which d has no direction to grow in, for places inside B: a matter of A alone, kept for the next position
// (max_min_boxes.h). Numbers choose the places; corners and places of edges that tie as numbers are compared exactly.
// Guarantee: as farthest_from_set.h, which also does arcs; on B's boundary no place is farther at all. A search ends
// after 100,000 steps and 100 for each feature, and says then what is still open; a step is a box, a part of an edge or
// a square. Cost: trees are given; a query mostly costs little more than some hundred nearest neighbours, and one for
// each corner that ties. Source: Taha, Hanbury 2015 for early breaks; Alt, Behrends, Blömer 1995 for where the maximum
// can lie. Keywords: directed Hausdorff distance, branch and bound, medial axis.
#pragma once

#include "distance/answer/answer.h"
#include "distance/planar/max_min_boxes.h"
#include "distance/planar_features/exact_pairs.h"

namespace findspace::distance {

struct FarthestPlace {
  exact::Real value;                     // d(at, A)
  exact::RealPoint at;                   // of B + p
  plane::Cell cell;                      // of B; dimension 2: inside
  std::optional<FeaturePair> nearest{};  // the nearest point of A, where it is known
  double open = 0;                       // no place is farther than this or the value
  double off = 0;                        // how far `at`, known in numbers only, may be from B

  /// The value as an answer: exact, or between what is certain and what is open.
  PlanarAnswer answer() const;
};

/// The farthest place if its value is more than `least_value`, or if the search ended early. No arcs; `boxes` are those
/// of A.
std::optional<FarthestPlace> farthest_place(const FeatureTree& b, const FeatureTree& a, const MaxMinBoxes& boxes,
                                            const exact::RealPoint& p, double least_value);

}  // namespace findspace::distance
