// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Boxes about the triangles of a body, in a binary tree: which triangles of two bodies, one of them moved, can meet.
// Guarantee: integers, so no pair that meets (also in a point) is missed. Cost: O(n log n) to build.
// Keywords: bounding volume hierarchy, AABB tree, broad phase.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "space/convolution/ray_body.h"

namespace findspace::space {

struct GridBox {
  Point low, high;

  bool meets(const GridBox& b) const {
    return low.x <= b.high.x && b.low.x <= high.x && low.y <= b.high.y && b.low.y <= high.y && low.z <= b.high.z &&
           b.low.z <= high.z;
  }
  GridBox moved(const Point& by, const Point& beyond) const { return {low + by, high + by + beyond}; }
};

class BoxTree {
 public:
  explicit BoxTree(const RayBody& body);

  struct Node {
    GridBox box;
    int first = 0, count = 0;  // faces, or with count 0 the two children
  };
  const std::vector<Node>& nodes() const { return nodes_; }
  int face(int i) const { return order_[i]; }
  const GridBox& box(int i) const { return boxes_[i]; }

  /// Calls visit(face) for every face whose box meets `query`; stops where visit returns true, and says so.
  template <class Visit>
  bool any_meeting(const GridBox& query, Visit visit) const {
    int stack[64], depth = 0;
    stack[depth++] = 0;
    while (depth > 0) {
      const Node& node = nodes_[stack[--depth]];
      if (!node.box.meets(query)) continue;
      if (node.count == 0) {
        stack[depth++] = node.first;
        stack[depth++] = node.first + 1;
        continue;
      }
      for (int i = node.first; i < node.first + node.count; ++i) {
        if (boxes_[i].meets(query) && visit(order_[i])) return true;
      }
    }
    return false;
  }

  /// visit(k), which is box(k) of face(k), for the boxes that are worth(gap(box)), of two nodes the one of the lesser
  /// gap first; stops where visit returns false. `gap` grows with distance, `worth` may ask for less and less.
  template <class Gap, class Worth, class Visit>
  void nearest_first(Gap gap, Worth worth, Visit visit) const {
    struct Task {
      int node;
      double gap;
    };
    Task stack[128];
    int depth = 0;
    const auto task = [&](int k) { return Task{k, gap(nodes_[static_cast<std::size_t>(k)].box)}; };
    stack[depth++] = task(0);
    while (depth > 0) {
      const Task top = stack[--depth];
      if (!worth(top.gap)) continue;
      const Node& node = nodes_[static_cast<std::size_t>(top.node)];
      if (node.count == 0) {
        Task one = task(node.first), two = task(node.first + 1);
        if (one.gap < two.gap) std::swap(one, two);
        stack[depth++] = one;
        stack[depth++] = two;
        continue;
      }
      for (int k = node.first; k < node.first + node.count; ++k) {
        if (worth(gap(boxes_[static_cast<std::size_t>(k)])) && !visit(k)) return;
      }
    }
  }

 private:
  class Builder;

  std::vector<Node> nodes_;
  std::vector<int> order_;
  std::vector<GridBox> boxes_;  // in the order of `order_`
};

/// Calls visit(face of a, face of b) for every two faces whose boxes meet when b is moved by `by`, and by up to
/// `beyond` more; stops where visit returns true, and says so.
template <class Visit>
bool any_pair(const BoxTree& a, const BoxTree& b, const Point& by, const Point& beyond, Visit visit) {
  struct Task {
    int p, q;
  };
  Task stack[192];
  int depth = 0;
  stack[depth++] = {0, 0};
  while (depth > 0) {
    const auto [p, q] = stack[--depth];
    const BoxTree::Node &x = a.nodes()[p], &y = b.nodes()[q];
    if (!x.box.meets(y.box.moved(by, beyond))) continue;
    if (x.count == 0 && (y.count > 0 || x.box.high.x - x.box.low.x >= y.box.high.x - y.box.low.x)) {
      stack[depth++] = {x.first, q};
      stack[depth++] = {x.first + 1, q};
      continue;
    }
    if (y.count == 0) {
      stack[depth++] = {p, y.first};
      stack[depth++] = {p, y.first + 1};
      continue;
    }
    for (int j = y.first; j < y.first + y.count; ++j) {
      const GridBox box = b.box(j).moved(by, beyond);
      for (int i = x.first; i < x.first + x.count; ++i) {
        if (a.box(i).meets(box) && visit(a.face(i), b.face(j))) return true;
      }
    }
  }
  return false;
}

/// A closed surface with its edges and its tree: what every question about it needs, made once.
struct RaySheet {
  RayBody body;
  BoxTree tree;
  double longest = 0;  // edge

  explicit RaySheet(Triangles surface) : RaySheet(RayBody(std::move(surface))) {}
  explicit RaySheet(RayBody made);
};

}  // namespace findspace::space
