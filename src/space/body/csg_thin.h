// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What a solid that round sets are cut out of may have without interior: sheets, lines and points between polytopes,
// and where a round set only touches. Guarantee: what is passed over is held by the rest, or not there; what is found
// may be less where more than one round set takes part of it. Cost: the parts near a piece. Keywords: dangling face,
// regularised set operation.
#pragma once

#include <span>
#include <vector>

#include "space/body/csg_solid.h"
#include "space/polytope/convex_region.h"

namespace findspace::space {

/// A polytope.
bool flat_sided(const BodyPart& set);

/// The box about the places of the set that are farthest along n.
Bounds3 face_box(const BodyPart& set, const RealVector& n);

/// What has interior of that which all of `kept` have in common, less the sets that are taken away.
std::vector<ConvexRegion> cells_between(std::span<const Polytope> kept, std::span<const Polytope> taken);

/// Whether the round sets of the part leave nothing of the piece; false where that is not found out.
bool round_sets_remove(const CsgPart& part, const ConvexRegion& piece);

/// Whether the solid, which lies without open sets, keeps a piece without interior of which something is left where the
/// sets are taken away, with their surfaces, that `whole` lies without besides.
bool keeps_thin(const CsgSolid& solid, const CsgSolid& whole);

/// Of the parts leaves those with interior. False where one without may have a piece that no other part holds.
bool drop_thin(std::vector<CsgPart>& parts);

}  // namespace findspace::space
