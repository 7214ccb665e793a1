// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A 3D primitive as the scene states it, on the grid. It hangs in a node of the shape tree (plane::Shape::solid) whose
// constructive nodes both dimensions share. Nothing is computed here; convex_parts.h turns trees into polytopes.
#pragma once

#include <memory>
#include <vector>

#include "exact/number/real.h"
#include "plane/contour/shape.h"
#include "space/polytope/polytope.h"

namespace findspace::space {

/// A surface as a list of faces, each a circuit of vertices. Fit for use after `clean` and `check_closed` (mesh.h).
struct Mesh {
  std::vector<Point> vertices;
  std::vector<std::vector<int>> faces;
};

struct Solid {
  enum class Form {
    kPolytope,  // the hull of mesh.vertices
    kBall,      // the closed ball about mesh.vertices[0] with radius `radius`
    kPrism,     // contours (outer ring, then holes; validated) times [low, high]
    kMesh       // what the closed surface `mesh` encloses
  };
  Form form = Form::kPolytope;
  bool simple = false;  // of a mesh: it is known that no face crosses another or lies on it
  Mesh mesh;
  exact::Real radius{};
  std::vector<plane::Contour> contours;
  std::int64_t low = 0, high = 0;
  double step = 1;  // the size of a grid step, for messages
};

/// The 3D primitive of a node, or null.
inline const Solid* solid_of(const plane::Shape& shape) { return static_cast<const Solid*>(shape.solid.get()); }

}  // namespace findspace::space
