// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The positions of a body among polyhedra as a box less finitely many open convex sets: those at which its interior
// meets that of an obstacle (clear(B, A)), or at which it leaves a container (inside(B, A)). Where the formula asks for
// such alone, joined by `and`, with a container at least, and all shapes have flat faces. Slits and exact fits are
// positions as others are. Guarantee: exact, wherever the shapes stand. Cost: the pairs of convex parts, a set made
// when it is first needed. Source: distances.md 1.4.
#pragma once

#include <memory>
#include <optional>

#include "planning/solid/space_stage.h"
#include "space/body/open_union.h"
#include "space/rays/ray_sources.h"

namespace findspace::planning {

struct FlatPositions {
  space::OpenUnion covered;     // no position is in these sets, in grid steps
  space::RealVector low, high;  // all positions are in this box; high < low in a coordinate: there are none

  bool empty_box() const;
  bool holds(const space::RealVector& p) const;
  /// At most 0 in the set.
  space::RaySourcePointer rays(const space::RayGrid& grid) const;
};

/// Nothing where the formula asks for something else, or a shape is not such.
std::optional<FlatPositions> flat_positions(const SpaceStage& stage);

}  // namespace findspace::planning
