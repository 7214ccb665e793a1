// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A bounded closed convex set {x : every plane <= 0} of any dimension, by its vertices: points and segments left by
// exact fits as well as bodies. It is made by cutting a box, one half space after another. Guarantee: exact;
// coordinates are those in which three planes meet. Each vertex knows the planes it lies on; two vertices share an edge
// if no third one lies on all planes common to both. Cost of a cut: the vertices, and the pairs of those on either
// side; of a circuit of n corners n log n. Source:
// Motzkin, Raiffa, Thompson, Thrall 1953 (double description); Fukuda, Prodon 1996 (the adjacency test). Keywords:
// vertex enumeration, clipping, H-representation to V-representation.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "space/polytope/real_vector.h"

namespace findspace::space {

class ConvexRegion {
 public:
  struct Vertex {
    RealVector at;
    Vector near;
    std::vector<int> tight;  // the planes it lies on, ascending
  };

  /// The box; low <= high in every coordinate.
  ConvexRegion(const RealVector& low, const RealVector& high);

  /// Keeps what satisfies the half space. True if anything was cut off.
  bool cut(const HalfSpace& plane);
  /// The sign of each vertex: whether the half space would cut off all, some or nothing.
  struct Sides {
    bool inside = false, on = false, outside = false;
  };
  Sides sides(const HalfSpace& plane) const;

  bool empty() const { return vertices_.empty(); }
  std::span<const Vertex> vertices() const { return vertices_; }
  std::span<const HalfSpace> planes() const { return planes_; }
  /// All planes on which at least three vertices lie: of a set with interior, its facets.
  std::vector<int> facets() const;
  /// The vertices of plane k in circular order, counter-clockwise seen from outside.
  std::vector<int> circuit(int k) const;
  /// Those of the facets, in their order.
  std::vector<std::vector<int>> circuits() const;
  std::vector<std::pair<int, int>> edges() const;
  /// -1 if empty.
  int dimension() const;
  exact::Real six_volumes() const;

 private:
  std::vector<std::vector<int>> on_planes() const;
  std::vector<int> in_circuit(std::vector<int> on, int k) const;
  bool adjacent(int v, int w) const;

  std::vector<HalfSpace> planes_;
  std::vector<Vertex> vertices_;
};

}  // namespace findspace::space
