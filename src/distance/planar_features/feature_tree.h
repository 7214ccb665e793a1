// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A closed set's boundary as a tree of boxes over its closed edges and isolated vertices, taken in the order of the
// boundary walks, and walks in that of halvings across, so that neighbours in the tree are neighbours in the plane.
// Prepared once, asked at many positions: the nearest part to a place, and whether a place that is not too close to the
// boundary lies in the set. Guarantee: distances are right to `slack`; membership is certain where it is given. Cost:
// building O(n + k log k) of k pieces; a query about log n boxes. Keywords: bounding volume hierarchy, AABB tree,
// branch and bound, closest feature.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "distance/planar_features/boundary_features.h"

namespace findspace::distance {

struct FeatureBox {
  double x0, y0, x1, y1;

  void add(const FeatureBox& o);
  /// The least distance of a point of the box to (x, y), squared.
  double nearest_squared(double x, double y) const {
    const double dx = std::max(std::max(x0 - x, 0.0), x - x1), dy = std::max(std::max(y0 - y, 0.0), y - y1);
    return dx * dx + dy * dy;
  }
  /// The least and the greatest distance of points of two boxes, the second moved by (px, py), squared.
  double nearest_squared(const FeatureBox& o, double px, double py) const;
  double farthest_squared(const FeatureBox& o, double px, double py) const;
};

class FeatureTree {
 public:
  struct Node {
    FeatureBox box;
    plane::Index first = 0, last = 0;   // features [first, last)
    plane::Index right = plane::kNone;  // the second child; the first one follows its parent. kNone: a leaf
  };
  /// How far one feature of a node reaches along x and along y, at most.
  struct Reach {
    double x, y;
  };
  struct Near {
    double distance;
    plane::Index feature = plane::kNone;
  };

  /// Of the cells with mark > 0; keeps a reference.
  explicit FeatureTree(const plane::Region& region);

  const plane::Region& region() const { return region_; }
  bool empty() const { return features_.empty(); }
  bool has_arcs() const { return arcs_; }
  std::span<const BoundaryFeature> features() const { return features_; }
  std::span<const Node> nodes() const { return nodes_; }
  /// Of each node.
  std::span<const Reach> reaches() const { return reaches_; }
  /// A vertex of every connected piece of the boundary, from left to right.
  std::span<const plane::Index> representatives() const { return representatives_; }
  /// Those that may lie in the set when moved by (dx, dy): the others are certainly outside. Cost: O(log n).
  std::span<const plane::Index> representatives_in(const FeatureTree& set, double dx, double dy) const;
  /// The size of the coordinates.
  double scale() const { return scale_; }

  struct Extreme {
    plane::Index vertex;
    double x, y, height;  // of the vertex, along the direction
  };
  /// A vertex farthest in a direction, of a set that is not empty; no arcs.
  Extreme extreme(double ux, double uy) const;
  /// The feature nearest to the place; one that is known to be near makes it quicker.
  Near nearest(double x, double y, plane::Index guess = plane::kNone) const;
  /// visit(feature) for the features within `reach` of the place, until it returns false.
  template <class Visit>
  void for_near(double x, double y, double reach, Visit&& visit) const;
  /// Whether the place lies in the set; nothing where the numbers do not decide. `near`: its nearest feature.
  std::optional<bool> contains(double x, double y, const Near& near) const;

 private:
  void collect();
  void add_walk(plane::Index half_edge, std::vector<char>& known);
  /// Walks, each as it is, in an order in which neighbours are near each other.
  void order_by_place(std::span<const plane::Index> walks);
  plane::Index build(plane::Index first, plane::Index last);
  std::optional<plane::Index> face_around(plane::Index vertex, double x, double y) const;

  const plane::Region& region_;
  std::vector<BoundaryFeature> features_;
  std::vector<Node> nodes_;
  std::vector<Reach> reaches_;
  std::vector<plane::Index> representatives_;
  double scale_ = 1;
  bool arcs_ = false;
};

template <class Visit>
void FeatureTree::for_near(double x, double y, double reach, Visit&& visit) const {
  std::array<plane::Index, 64> stack;
  std::size_t size = 0;
  if (!nodes_.empty()) stack[size++] = 0;
  while (size > 0) {
    const plane::Index at = stack[--size];
    const Node& n = nodes_[at];
    if (n.box.nearest_squared(x, y) > reach * reach) continue;
    if (n.right != plane::kNone) {
      stack[size++] = n.right;
      stack[size++] = at + 1;
      continue;
    }
    for (plane::Index k = n.first; k < n.last; ++k)
      if (features_[k].distance(x, y) <= reach && !visit(k)) return;
  }
}

/// The box around a feature, a little larger than the truth.
FeatureBox box_of(const BoundaryFeature& s);

}  // namespace findspace::distance
