// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Closed surfaces on the grid. A mesh read from anywhere is cleaned first: equal vertices are joined (welding on the
// grid), faces without area dropped, edges split where a vertex lies on them (T-junctions), and faces turned so that
// normals point outward. A surface that is not closed then is refused, and the message lists its open edges, unless a
// repair (mesh_repair.h) was asked for and closes it. Guarantee: every decision is exact; without a repair the enclosed
// set does not change. Keywords: watertight, manifold, STL repair.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "space/mesh/mesh_repair.h"
#include "space/polytope/convex_polygon.h"
#include "space/polytope/polytope.h"
#include "space/polytope/solid.h"

namespace findspace::space {

/// An edge of a mesh, by its two vertices.
using MeshEdge = std::pair<int, int>;

/// Calls visit(from, to) for every edge about a face.
template <class Visit>
void each_edge(const std::vector<int>& face, Visit visit) {
  for (std::size_t i = 0; i < face.size(); ++i) visit(face[i], face[(i + 1) % face.size()]);
}

/// The circuit of a face from its least corner on: the same for faces that stand twice.
std::vector<int> from_least_corner(std::vector<int> face);

/// Cleans the mesh in place and says what was done. Throws Error(kGeometry). `step`: size of a grid step in messages.
/// A surface that is not closed then is repaired as `how` allows, and refused if that does not close it.
std::vector<std::string> clean(Mesh& mesh, double step, const MeshRepair& how = {});

/// Points joined by spaces, for messages: "(0, 1.5, 2) (3, 0, 0)" in steps of that size.
std::string places_text(std::span<const Point> points, double step);

/// The convex set that a clean mesh bounds; nothing of other meshes, also of one whose edges all bend outward but that
/// goes round more than once, as a star prism does.
std::optional<Polytope> convex_solid(const Mesh& mesh);
bool is_convex(const Mesh& mesh);

/// Six times the volume of a clean mesh, in cubic grid steps.
exact::Real six_volumes(const Mesh& mesh);

/// The sum of the cross products about the face: its outward normal times twice its area. Zero for a face without area.
Wide3 area_vector(const Mesh& mesh, const std::vector<int>& face);

/// The face seen along the longest component of its area vector n, counter-clockwise.
std::vector<Point2> projected(const Mesh& mesh, const std::vector<int>& face, const Wide3& n);

}  // namespace findspace::space
