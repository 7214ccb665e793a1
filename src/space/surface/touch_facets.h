// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The sets t - S of touch_sets.h, and which of their facets can hold touching positions as far as the triangles next to
// t say. A facet comes from the face, edge or vertex of t that is farthest along its normal, and a face, edge or vertex
// of S. If a triangle with that feature reaches farther along the normal, its set covers the inside of the facet; a
// facet that several triangles have is counted for one of them. Guarantee: exact. Cost: the triangles about a vertex.
#pragma once

#include "space/convolution/ray_body.h"
#include "space/polytope/real_vector.h"

namespace findspace::space {

/// A triangle less a convex part, as an open set.
struct TouchSet {
  Polytope closed;
  std::vector<HalfSpace> planes;
};

enum class TouchSide { kOutside, kInside };

TouchSet touch_set(const RayBody& body, std::size_t triangle, const Polytope& part);

class TouchFacets {
 public:
  /// Keeps a reference. Positions that touch from this side are wanted.
  TouchFacets(const RayBody& body, TouchSide side);

  /// Of the facet with the outward normal n; the side is not decided where only a vertex of the triangle touches.
  bool may_touch(std::size_t triangle, const Wide3& n, const Approx3& n_approx) const;

 private:
  struct Seen;
  bool edge_may_touch(const Seen& seen, int k) const;
  bool vertex_may_touch(const Seen& seen, int v) const;

  const RayBody& body_;
  bool outside_;
  std::vector<std::vector<RayCorner>> about_;  // the corners at each point
};

}  // namespace findspace::space
