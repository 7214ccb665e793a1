// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The greatest distance of a point of a solid to the nearest of some convex sets: a directed Hausdorff distance, or
// the radius of the largest ball among obstacles. Branch and bound over tetrahedra that fill the solid. Distances to
// convex sets are convex, so over a tetrahedron any weighted mean of them is bounded by its values at the corners; the
// best weights are a linear program, whose other side is a point of the tetrahedron to try. On ridges between flat
// walls both agree at once. A cell that a round solid fills in part is bounded by a plane that touches the solid, too:
// as no distance grows faster than a step, what a corner is beyond the plane may be taken off its distances. Guarantee:
// doubles; no point has more than `bound`, which is within 2^-41 of `value` (or the slack asked for) unless kMostCells
// cells were not enough (`complete` is false then). Keywords: largest empty ball, inscribed ball, branch and bound,
// linear program.
#pragma once

#include <array>
#include <functional>
#include <span>
#include <vector>

#include "space/polytope/extent.h"

namespace findspace::space {
class Polytope;
class ConvexRegion;
}  // namespace findspace::space

namespace findspace::distance {

inline constexpr int kMostCells = 200000;

using Tetrahedron = std::array<space::Vector, 4>;

/// The box in six, along the ways from its lowest to its highest corner.
std::vector<Tetrahedron> tetrahedra_of_box(const space::Extent& box);
/// The distance to a closed convex set, or another convex function of which no step changes more than its length.
using ConvexDistance = std::function<double(const space::Vector&)>;

/// Filling the polytope; empty for sets without interior.
std::vector<Tetrahedron> tetrahedra(const space::Polytope& polytope);
std::vector<Tetrahedron> tetrahedra(const space::ConvexRegion& region);

struct SolidMaxMin {
  double value = 0, bound = 0;
  space::Vector place;
  bool complete = true;
};

struct Solids;  // round_solid.h

/// Greatest distances of at most `slack` need not be decided from 0; of one that is more the value may lack `share` of
/// what it is more than the slack. At least one set; at most so many cells.
SolidMaxMin solid_max_min(const Solids& solids, std::span<const ConvexDistance> sets, double slack, double share = 0,
                          int most = kMostCells);

}  // namespace findspace::distance
