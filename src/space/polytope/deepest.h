// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The deepest place of a convex polyhedron {x : every plane <= 0}: the centre of its largest ball, where the greatest
// signed distance to a plane is least. If the set is empty that is the place it misses by least.
// Guarantee: exact: doubles propose four planes, real numbers solve for them and check all others. Nothing where the
// place is not a single one, where there are more than kMostPlanes planes, or doubles do not find it. Cost: the sets of
// four planes. Keywords: Chebyshev centre, inscribed ball, linear programming.
#pragma once

#include <optional>
#include <span>

#include "space/polytope/real_vector.h"

namespace findspace::space {

inline constexpr std::size_t kMostPlanes = 64;

struct Deepest {
  RealVector at;
  exact::Real value;  // minus the radius of the ball
};

/// `low`, `high`: a box that holds the place.
std::optional<Deepest> deepest(std::span<const HalfSpace> planes, const RealVector& low, const RealVector& high);

}  // namespace findspace::space
