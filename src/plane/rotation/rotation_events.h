// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The angles at which a rotating net of vertices, segments and arcs can change how it lies over one that stands still:
// a vertex of one on an edge or a vertex of the other, a segment or arc tangent to an arc. Guarantee: all of them,
// exact and ascending, each once; some may be contacts of lines and circles only beside the edges. Cost: a few floating
// point operations a pair of edges, exact work for those at like distances from the centre.
#pragma once

#include <vector>

#include "plane/rotation/rotated_edges.h"

namespace findspace::plane {

/// Both nets relative to the centre of rotation.
std::vector<exact::ExactAngle> contact_rotations(const RotatedNet& rotating, const RotatedNet& fixed);

}  // namespace findspace::plane
