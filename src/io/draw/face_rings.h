// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The faces of a region as formats of rings have them: each face the rings of its boundary, the outer one first, none
// passing a vertex twice, without cracks; beside them the curves that bound no face of the set. Guarantee: every edge
// with the set on one side only is on one ring. Cost: linear, but for sorting. Keywords: polygon with holes.
#pragma once

#include <vector>

#include "plane/query/curve_net.h"

namespace findspace::io {

class FaceRings {
 public:
  /// Keeps a reference to the net.
  explicit FaceRings(const plane::CurveNet& net) : net_(net), s_(net.complex()) {}

  /// Each ring begins at its lexicographically smallest vertex.
  std::vector<plane::CurveNet::Ring> of(const plane::Face& face) const;
  /// A curve of the set with none of its faces beside it.
  bool is_free(const plane::CurveNet::Curve& curve) const;

 private:
  bool is_filled(plane::Index half_edge) const { return s_.faces[s_.face(half_edge)].mark != 0; }
  /// Cracks have the face on both sides: a polygon does not know them.
  bool is_crack(plane::Index h) const { return s_.face(h) == s_.face(h ^ 1u); }
  plane::Index next_on_boundary(plane::Index h) const;
  std::vector<std::vector<plane::Index>> simple_loops(const plane::Face& f) const;
  plane::CurveNet::Ring from_the_left(plane::CurveNet::Ring ring) const;
  double size(const plane::CurveNet::Ring& ring) const;

  const plane::CurveNet& net_;
  const plane::CellComplex& s_;
};

}  // namespace findspace::io
