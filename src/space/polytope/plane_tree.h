// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Half spaces in a tree: the one that a place is farthest beyond, as the planes of the hull of a large mesh are asked
// for it at each cell of a search. Half spaces whose normals and distances differ little are together. Guarantee: the
// same as the first of the greatest values in doubles, but for roundings between equal ones. Cost: building O(n log n);
// a question looks at some ten half spaces where the place is not deep inside. Keywords: bounding volume hierarchy,
// support function, upper envelope of planes.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "space/polytope/real_vector.h"

namespace findspace::space {

class PlaneTree {
 public:
  PlaneTree() = default;
  explicit PlaneTree(std::span<const HalfSpace> planes);

  bool empty() const { return planes_.empty(); }
  /// unit . x + shift <= 0 is the half space.
  struct Plane {
    Vector unit;
    double shift = 0;
    double beyond(const Vector& x) const { return dot(unit, x) + shift; }
  };
  /// The one that x is farthest beyond; there is one.
  const Plane& farthest_beyond(const Vector& x) const;

 private:
  using Four = std::array<double, 4>;  // of a normal, and the shift
  struct Node {
    Four low, high;
    std::size_t first = 0, last = 0;
    std::size_t right = 0;  // the second child; the first one follows its parent. 0: a leaf
    double most(const Vector& x) const;
  };
  void build(std::size_t first, std::size_t last);

  std::vector<Plane> planes_;
  std::vector<Node> nodes_;
};

}  // namespace findspace::space
