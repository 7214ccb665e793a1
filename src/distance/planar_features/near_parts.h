// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The parts of shapes that decide a distance at the positions of a small window. A distance is 1-Lipschitz in the
// position, so what is farther off, by more than the window is wide, from taking a level in its middle never takes it.
// Of mu(B+p, A) = max over b in B of d(b+p, A), for levels above 0: the places b with about the greatest distance,
// and the edges of A that are near to these. Guarantee: what is left out certainly does not count; what is kept is
// exact, a part of the shape as a closed set. Cost: squares over B, halved where the distance may be as great; a
// nearest neighbour each. Keywords: culling, locality, branch and bound.
#pragma once

#include <optional>
#include <span>

#include "distance/planar_features/feature_tree.h"
#include "plane/complex/broad_phase.h"
#include "plane/query/locate.h"

namespace findspace::distance {

/// The disc around a window of positions, at least.
struct PlacedWindow {
  double x, y, radius;

  explicit PlacedWindow(const plane::PieceBox& box);
  /// What distances of about that size, measured from there, may be off by rounding.
  double noise(double distance) const;
};

/// These vertices and edges with their ends alone have the mark `in`, all else has `out`.
plane::CellComplex boundary_alone(const plane::CellComplex& c, std::span<const plane::Cell> chosen, plane::Mark in,
                                  plane::Mark out);

struct NearParts {
  plane::Region b, a;  // closed; b may be empty
};
/// At each position of the window, mu of the parts and of the whole compare alike with every level from low > 0 to
/// high. Nothing where there are arcs, or too many places.
std::optional<NearParts> near_parts(const FeatureTree& b, const FeatureTree& a, const PlacedWindow& window, double low,
                                    double high);

/// At least the distance of every point of a bounded set from the origin.
double reach(const FeatureTree& set);

/// Closed; boxes of whole grid steps that do not meet.
plane::Region region_of_boxes(std::span<const plane::PieceBox> boxes);

/// Boxes that hold these and do not meet, from left to right.
std::vector<plane::PieceBox> boxes_apart(std::vector<plane::PieceBox> boxes);

}  // namespace findspace::distance
