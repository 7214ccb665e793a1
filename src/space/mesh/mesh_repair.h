// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Changes to a mesh that is not closed, none of them made unless it is asked for. At edges with an odd number of faces:
// vertices within a width are joined, the edge is led over vertices within that width of it, and circuits that fit into
// a ball of a diameter are closed by triangles of the least area in all. Faces that stand twice are taken once.
// Guarantee: no vertex moves farther than the width, decided exactly; each change is counted in the notes, with the
// farthest move and the widest hole. Whether the surface is closed then, and sound, others decide. Cost: sorts, and
// n^3 steps for a hole of n edges. Source: Barequet and Sharir, Filling gaps in the boundary of a polyhedron, 1995.
// Keywords: mesh repair, welding, stitching, hole filling, T-junctions.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "space/polytope/solid.h"

namespace findspace::space {

/// In grid steps; 0: not at all.
struct MeshRepair {
  std::int64_t width = 0;  // of vertices from others, and from edges
  std::int64_t hole = 0;   // the greatest distance of two of its vertices

  bool asked() const { return width > 0 || hole > 0; }
};

/// `step`: size of a grid step in notes. Leaves faces without area.
void repair(Mesh& mesh, const MeshRepair& how, double step, std::vector<std::string>& notes);

}  // namespace findspace::space
