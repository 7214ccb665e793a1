// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The two points of closed sets A and B + p that are nearest to each other, min |a - b|, or farthest from each other,
// max |a - b|, with the vertices, edges or arcs they lie on; of the boundaries, so for nearest ones that are apart.
// Method: both trees are walked together, nearer (farther) boxes first; the few pairs that doubles cannot tell apart
// are computed and compared exactly. Guarantee: the value is exact, the points are exact. Cost: about (n + m) log(n +
// m) at worst for shapes that are not interlocked, mostly far less. Keywords: closest pair, farthest pair, diameter,
// dual tree traversal, branch and bound.
#pragma once

#include "distance/planar_features/exact_pairs.h"
#include "distance/planar_features/feature_pairs.h"
#include "distance/planar_features/feature_tree.h"

namespace findspace::distance {

/// The pair of nearest boundary points. Nothing where the boundaries meet or numbers do not exclude it.
std::optional<FeaturePair> nearest_pair(const FeatureTree& a, const FeatureTree& b, const exact::RealPoint& p);
/// The same of sets whose interiors do not meet: the distance may be 0.
FeaturePair closest_pair(const FeatureTree& a, const FeatureTree& b, const exact::RealPoint& p);
/// A point where straight edges of the two boundaries cross, for certain.
std::optional<FeaturePair> crossing_pair(const FeatureTree& a, const FeatureTree& b, const exact::RealPoint& p);
/// A search that may be cut short: whether it found something, and how many pairs of boxes it looked at.
struct CutSearch {
  bool found = false, cut = false;
  std::size_t looks = 0;
};
/// Two edges cross, and still do when one is moved so far, for certain; `most`: looks until the search is cut.
CutSearch certainly_cross(const FeatureTree& a, const FeatureTree& b, double x, double y, const Moves& by,
                          std::size_t most);
/// The boundaries are farther than the margin from each other, for certain.
bool certainly_apart(const FeatureTree& a, const FeatureTree& b, double x, double y, double margin);
/// A point of both boundaries, which meet; on arcs as good as numbers tell.
FeaturePair common_point(const FeatureTree& a, const FeatureTree& b, const exact::RealPoint& p);
/// A pair of boundary points that are as near as numbers can tell: where shapes touch, the place.
FeaturePair touching_pair(const FeatureTree& a, const FeatureTree& b, const exact::RealPoint& p);
/// The pair of farthest points of two bounded sets.
FeaturePair farthest_pair(const FeatureTree& a, const FeatureTree& b, const exact::RealPoint& p);

/// The boundary point of A nearest to a place (`second`).
FeaturePair nearest_point(const FeatureTree& a, const exact::RealPoint& at);

}  // namespace findspace::distance
