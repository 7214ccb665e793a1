// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The planes on which positions lie at which two surfaces begin to overlap, within a box of positions: of a corner of B
// and a face of A, a face of B and a corner of A, and two edges, where the solids are on the two sides of the plane
// that both touch. The frontier of U = {p : the interiors of A and B + p meet} within the box lies on them, and each of
// its vertices, edges and faces is where some of them meet; there are planes that hold none of it. Guarantee: none is
// missed; each comes once, exactly. Cost: the pairs of triangles whose boxes meet at some position of the box, less
// than a microsecond each. Keywords: Minkowski sum, signed convolution, contact features.
#pragma once

#include <optional>
#include <vector>

#include "space/convolution/ray_boxes.h"
#include "space/polytope/real_vector.h"

namespace findspace::space {

class ContactPlanes {
 public:
  /// Keeps references; A may be a surface turned inside out. The trees are those of the bodies.
  ContactPlanes(const RayBody& a, const BoxTree& a_tree, const RayBody& b, const BoxTree& b_tree);

  /// Those that pass the ball of positions, overlap being where they are below 0. Nothing where there are more than
  /// `most`, or more pairs of triangles than `most_pairs`.
  std::optional<std::vector<Plane>> near(const Vector& middle, double reach, std::size_t most,
                                         std::size_t most_pairs) const;

 private:
  /// Of a convex edge its way, and those from it to the corners of its faces.
  struct EdgeWays {
    int edge = 0;
    Vector way, left, right;
  };
  /// A body and what of its corners and convex edges each face stands for: each feature has one such face.
  struct Featured {
    const RayBody& body;
    std::vector<std::vector<int>> vertices;  // of each face
    std::vector<std::vector<EdgeWays>> edges;
    explicit Featured(const RayBody& of);
  };
  class Collector;

  Featured a_, b_;
  const BoxTree& a_tree_;
  const BoxTree& b_tree_;
};

}  // namespace findspace::space
