// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Which of many cones of directions meet a given one: the broad phase of convolutions on the sphere of normals.
// Guarantee: finds every cone that meets the query (angles are widened beyond their roundings), and some more.
// Cost: O(log n) and the answers for directions spread out. Keywords: bounding cone hierarchy, Gauss map, normal cone.
#pragma once

#include <cmath>
#include <span>
#include <vector>

#include "exact/solid/space_sign.h"

namespace findspace::space {

/// All unit vectors within `angle` of `axis` (a unit vector); an angle of pi or more holds them all.
struct Cone {
  exact::Approx3 axis{0, 0, 1};
  double angle = 0;
};

inline constexpr double kFullCone = 4;

/// A cone that holds the directions of the (unit) vectors and the short arcs between them; full if they fit in no cap
/// below a hemisphere.
Cone cone_of(std::span<const exact::Approx3> units);
exact::Approx3 unit(const exact::Approx3& v);

class ConeTree {
 public:
  explicit ConeTree(std::vector<Cone> cones);

  /// Calls visit(index) for every cone that may meet `query`.
  template <class Visit>
  void each_meeting(const Cone& query, Visit visit) const {
    if (nodes_.empty()) return;
    int stack[64], depth = 0;
    stack[depth++] = 0;
    while (depth > 0) {
      const Node& node = nodes_[stack[--depth]];
      if (!may_meet(node.cone, query)) continue;
      if (node.count > 0) {
        for (int i = node.first; i < node.first + node.count; ++i) {
          if (may_meet(cones_[i], query)) visit(order_[i]);
        }
      } else {
        stack[depth++] = node.first;
        stack[depth++] = node.first + 1;
      }
    }
  }

 private:
  struct Node {
    Cone cone;
    int first = 0, count = 0;  // items, or with count 0 the two children
  };
  static bool may_meet(const Cone& a, const Cone& b);
  void build(int node, int first, int count);

  std::vector<Cone> cones_;
  std::vector<int> order_;
  std::vector<Node> nodes_;
};

}  // namespace findspace::space
