// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The open sets of positions behind the signed distances of a moving body B and a fixed body A (distances.md 1.4), as
// covers:
//   overlap   U = {p : the interiors of A and B + p meet}, the union over pairs of parts of int(T - S);
//   outside   the complement of E = {p : B + p in A}, the union of int(T - S) with T over the cells outside A.
// Guarantee: exact. T - S of two polytopes has the planes of its contact surface; of a cell outside A, whose vertices
// need not lie on any grid, planes along the facets of both and along pairs of edges, some of which may touch the sum
// only: they change neither the set nor a distance. Cost: sets are made when first needed; those of a cell are known by
// doubles sooner, unless edges are nearly parallel. Keywords: configuration
// space obstacle.
#pragma once

#include "space/body/body.h"
#include "space/body/open_union.h"
#include "space/body/outside_cells.h"

namespace findspace::space {

/// {a - b}: planes, none of two points, and a box around it.
std::vector<HalfSpace> difference_planes(const BodyPart& a, const BodyPart& b);
std::vector<HalfSpace> difference_planes(const OutsideCell& a, const BodyPart& b);
Extent difference_extent(const BodyPart& a, const BodyPart& b);

/// Neither body has a radius (nor is one `outside`). The bodies have to outlive the cover.
OpenUnion overlap_cover(const Body& b, const Body& a);
/// A has no radius; B may, if A is convex (else only its points without a radius count). Cells and B have to outlive
/// the cover.
OpenUnion outside_cover(const Body& b, std::span<const OutsideCell> outside_a);

}  // namespace findspace::space
