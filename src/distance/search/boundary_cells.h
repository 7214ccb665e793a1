// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Tetrahedra that searches divide (boundary_search.h, tetrahedral_max_min.h). Guarantee: doubles. Keywords: bisection.
#pragma once

#include <algorithm>
#include <cstddef>

#include "distance/search/solid_max_min.h"
#include "plane/base/stage_observer.h"
#include "space/polytope/extent.h"

namespace findspace::distance {

/// A box about the box. Cells whose faces lie in those of the sets would touch what is allowed and never be settled;
/// cells of this one stand askew.
space::Extent askew(const space::Extent& box);
inline space::Extent grown(const space::Extent& box, double by) {
  return {box.low - space::Vector{by, by, by}, space::plus(box.high, {by, by, by})};
}

/// What two boxes have in common; of two that are apart `low` is not below `high`.
inline space::Extent in_both(const space::Extent& a, const space::Extent& b) {
  return {{std::max(a.low.x, b.low.x), std::max(a.low.y, b.low.y), std::max(a.low.z, b.low.z)},
          {std::min(a.high.x, b.high.x), std::min(a.high.y, b.high.y), std::min(a.high.z, b.high.z)}};
}
/// Its length, and its ends.
double longest_edge(const Tetrahedron& t, std::size_t& a, std::size_t& b);

space::Vector centre(const Tetrahedron& t);

/// How far x is beyond the face that it is farthest beyond; numbers.
double beyond_faces(const Tetrahedron& t, const space::Vector& x);

/// Its two halves across the edge from corner a to corner b.
std::array<Tetrahedron, 2> halves(const Tetrahedron& t, std::size_t a, std::size_t b);

/// The mean of the corners by weights of sum 1.
space::Vector mean(const std::array<double, 4>& weights, const Tetrahedron& t);

/// What cells of a search have that are tetrahedra.
struct TetrahedralCell {
  Tetrahedron corner;
  void draw(plane::ObservedCells& seen) const;
};

}  // namespace findspace::distance
