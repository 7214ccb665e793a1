// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Boxes in a tree: those that hold a point or meet a box, and all by their distance from a point. Guarantee: as of the
// boxes; no box is left out. Cost: building O(n log n); a query looks at about log n nodes and what it finds.
// Keywords: bounding volume hierarchy, AABB tree, nearest neighbour.
#pragma once

#include <cstddef>
#include <vector>

#include "plane/base/subdivide.h"
#include "space/polytope/extent.h"

namespace findspace::space {

class ExtentTree {
 public:
  ExtentTree() = default;
  explicit ExtentTree(std::vector<Extent> extents);

  const Extent& extent(std::size_t k) const { return extents_[k]; }

  /// visit(k) for each box that `takes` says true of, which has to be true of every box around one that it is true of.
  template <class Takes, class Visit>
  void each(Takes takes, Visit visit) const {
    for (const std::size_t k : unbounded_) {
      if (takes(extents_[k])) visit(k);
    }
    if (nodes_.empty()) return;
    std::vector<std::size_t> stack{0};
    while (!stack.empty()) {
      const std::size_t at = stack.back();
      stack.pop_back();
      const Node& node = nodes_[at];
      if (!takes(node.around)) continue;
      if (node.right != 0) {
        stack.push_back(node.right);
        stack.push_back(at + 1);
        continue;
      }
      for (std::size_t i = node.first; i < node.last; ++i) {
        if (takes(extents_[order_[i]])) visit(order_[i]);
      }
    }
  }

  /// visit(k, its distance) by growing distance of the boxes from p, until it returns false.
  template <class Visit>
  void nearest_first(const Vector& p, Visit visit) const {
    struct Entry {
      double distance;
      std::size_t index;
      bool leaf;
      bool operator<(const Entry& o) const {
        return distance != o.distance ? distance > o.distance : leaf != o.leaf ? leaf > o.leaf : index > o.index;
      }
    };
    plane::Subdivision<Entry> queue;
    for (const std::size_t k : unbounded_) queue.push({extents_[k].distance(p), k, true});
    if (!nodes_.empty()) queue.push({nodes_[0].around.distance(p), 0, false});
    bool more = true;
    queue.run([&](const Entry&) { return !more; },
              [&](const Entry& top) {
                if (top.leaf) {
                  more = visit(top.index, top.distance);
                  return;
                }
                const Node& node = nodes_[top.index];
                if (node.right != 0) {
                  for (const std::size_t child : {top.index + 1, node.right})
                    queue.push({nodes_[child].around.distance(p), child, false});
                  return;
                }
                for (std::size_t i = node.first; i < node.last; ++i)
                  queue.push({extents_[order_[i]].distance(p), order_[i], true});
              });
  }

 private:
  struct Node {
    Extent around;
    std::size_t first = 0, last = 0;
    std::size_t right = 0;  // the second child; the first one follows its parent. 0: a leaf
  };
  void build(std::size_t first, std::size_t last);

  std::vector<Extent> extents_;
  std::vector<std::size_t> unbounded_, order_;
  std::vector<Node> nodes_;
};

}  // namespace findspace::space
