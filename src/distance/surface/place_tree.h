// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Places of a solid, each with a ball about it in the solid or none, in a tree of balls: for searches of the place that
// is deepest in another solid, or farthest from it. Guarantee: a ball holds its places, in doubles. Cost: a tree is
// divided where it is looked at, which takes linear time a level. Threads: one at a time. Keywords: bounding sphere
// hierarchy, ball tree, kd-tree.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "space/polytope/extent.h"

namespace findspace::distance {

class PlaceTree {
 public:
  struct Place {
    space::Vector at;
    double clearance = 0;      // the radius of a ball about it in the solid
    std::uint32_t number = 0;  // among those given
  };
  /// A ball about some of the places, and the least and the greatest of their clearances: a leaf holds one, others the
  /// two nodes from `first` on once they are divided.
  struct Node {
    space::Vector middle;
    double radius = 0, least = 0, most = 0;
    std::uint32_t begin = 0, end = 0;
    int first = -1;
    bool leaf() const { return end - begin == 1; }
  };

  /// At least one; they are numbered here.
  explicit PlaceTree(std::vector<Place> places);

  /// Node 0 holds all.
  const Node& node(int k) const { return nodes_[static_cast<std::size_t>(k)]; }
  /// The first one of a node, and all.
  const Place& place(int k) const { return places_[node(k).begin]; }
  std::span<const Place> places() const { return places_; }
  /// The two that the node is divided in, which is no leaf.
  std::array<int, 2> divided(int k);

 private:
  static space::Extent box_of(std::span<const Place> places);
  Node node_of(std::uint32_t begin, std::uint32_t end) const;

  std::vector<Place> places_;
  std::vector<Node> nodes_;  // those that were needed
};

}  // namespace findspace::distance
