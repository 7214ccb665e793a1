// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Halves sides of the triangles of faces, the same side in both faces at an edge, until no promise is above the
// tolerance; before that diagonals are changed where this is enough. Ends with a Problem where the tolerance asks for
// more triangles than `most`, or cannot be had. Cost: passes over all triangles, as many as halvings of the longest.
// Keywords: adaptive refinement, edge flip.
#pragma once

#include <vector>

#include "face_mesh.h"

namespace findspace::cad {

void refine_faces(std::vector<FaceMesh>& faces, SolidCorners& corners, double tolerance, std::size_t most);

}  // namespace findspace::cad
