// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The sense of a mesh's faces. A mesh is one or more shells, pieces joined over edges of two faces. Neighbours are made
// to agree; a shell that lies in no other points outward, and what lies in it turns with it where all its faces
// pointed inward. Shells inside others keep their sense where faces agreed as they were stated, so that cavities stay
// cavities; where they did not, the number of shells about one says whether it is a cavity or an island. Guarantee:
// exact; which shell lies in which is decided by crossings of a line that misses all edges (moved aside symbolically).
// Cost: linear in the faces for one shell; for k of them k * k boxes, and for each box about a shell the faces in it.
// Keywords: normal orientation, shells, nesting, inverted normals.
#pragma once

#include <string>
#include <vector>

#include "space/polytope/solid.h"

namespace findspace::space {

/// Turns faces as above, and says how many. Throws Error(kGeometry) for a shell in another that has the same sense:
/// neither a cavity nor an island; Error(kLimit) where shells in each other cost more units than the asker allows.
/// `step`: size of a grid step in messages.
void orient(Mesh& mesh, double step, std::vector<std::string>& notes);

}  // namespace findspace::space
