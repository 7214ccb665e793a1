// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Where a feature of a set can be the nearest one: an intersection of half planes, the slab of a segment, the sector of
// an arc, the cone of a vertex. The closed features of a set overlap (an edge is as near as its end wherever the end is
// the nearest); with their reaches they divide the plane, so that a small disc keeps few features. Guarantee: a feature
// that is out of reach of a disc may be dropped there: what stays is as near, up to rounding. A vertex where its edges
// leave no cone with an inside, at a smooth joint or a cusp, is out of reach everywhere. Cost: linear; a question takes
// nanoseconds. Keywords: Voronoi cell, cone of influence.
#pragma once

#include <span>
#include <vector>

#include "distance/planar_features/boundary_features.h"

namespace findspace::distance {

class VoronoiCells {
 public:
  /// Of all vertices and edges of a closed set, as features() lists them.
  VoronoiCells(const plane::CellComplex& set, std::span<const BoundaryFeature> features);

  /// The feature is not needed within `radius` of (x, y).
  bool out_of_reach(plane::Index feature, double x, double y, double radius) const;
  /// An end of edges that needs no place of its own anywhere.
  bool nowhere(plane::Index feature) const { return reach_[feature].empty; }

 private:
  struct HalfPlane {
    double nx, ny, c;  // nx * x + ny * y >= c; unit normal
  };
  struct Reach {
    std::vector<HalfPlane> bounds;
    bool empty = false;
  };
  static std::vector<HalfPlane> of_edge(const BoundaryFeature& s);
  static bool has_inside(const std::vector<HalfPlane>& cone);

  std::vector<Reach> reach_;
};

}  // namespace findspace::distance
