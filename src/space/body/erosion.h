// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The Minkowski difference of bodies, the intersection of a + q over all q of b; of a and a ball about the origin a
// shrunk by its radius. It is what all of `containers` (convex bodies) have in common less the interiors of the parts
// of `obstacles`: a facet of a convex body moves in as far as b reaches, a corner or edge with a radius becomes as many
// copies as b has corners, and what is outside a body that is not convex keeps b from it. Guarantee: exact, sheets and
// single points included, but for vertices of containers that do not come to lie on the grid, which are rounded once
// and counted (convex_parts.h). Cost: of a cut for each plane of a, and of outside_cells.h. Source: distances.md 1.3;
// Serra 1982 (erosion). Keywords: erosion, inner offset, shrink, inset.
#pragma once

#include <span>
#include <vector>

#include "exact/number/tried.h"
#include "space/body/body.h"

namespace findspace::space {

struct Erosion {
  std::vector<Body> containers;     // at least one
  std::optional<Body> obstacles{};  // with parts
};

/// Of a complement a complement, as the only container. Refuses a union with round parts as a, a complement as b;
/// throws Error(kGeometry) if nothing with interior is left of a container.
exact::Tried<Erosion> erosion(const Body& a, const Body& b);
exact::Refusal shrunk_by_complement();
exact::Refusal thin_left_over();

/// As a body. Refuses, besides, where no union of convex parts is one, as where a slot is as wide as b. `lacking`:
/// closed sets of which a holds nothing, though they may meet its closure.
exact::Tried<Body> eroded(const Body& a, const Body& b, std::span<const Body> lacking = {});

/// A ball about the origin, in grid steps.
Body ball(const exact::Real& radius);

/// A sum moves every corner of one operand by every corner of the other, and seeks the hulls of all these `corners`, in
/// so many `pairs` of parts. Throws Error(kLimit) where they are too many: a few levels of sums of sums are.
void require_few_corners(const plane::Shape& sum, double corners, double pairs);

}  // namespace findspace::space
