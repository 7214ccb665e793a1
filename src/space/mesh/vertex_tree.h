// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Some vertices of a mesh, to look up those that may lie on an edge or near it. Guarantee: none that lies
// so near is left out. Cost: about as many nodes of a tree as the edge passes. Keywords: range search, k-d tree.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "exact/margins/rounding.h"
#include "space/polytope/extent_tree.h"
#include "space/polytope/solid.h"

namespace findspace::space {

class VertexTree {
 public:
  VertexTree(const Mesh& mesh, const std::vector<int>& vertices) : mesh_(mesh), vertices_(vertices) {
    std::vector<Extent> places;
    places.reserve(vertices_.size());
    for (const int v : vertices_) places.push_back({at(v), at(v)});
    tree_ = ExtentTree(std::move(places));
  }

  /// Calls visit(v) for each vertex that may be so near the edge, in grid steps along each axis.
  template <class Visit>
  void each_near(int a, int b, std::int64_t wider, Visit visit) const {
    const Vector from = at(a), to = at(b);
    const auto by = double(wider);
    tree_.each([&](const Extent& e) { return may_meet(from, to, wide(e, by)); },
               [&](std::size_t k) { visit(vertices_[k]); });
  }

 private:
  /// Exact, as coordinates of meshes are below 2^40.
  Vector at(int v) const {
    const Point& p = mesh_.vertices[std::size_t(v)];
    return {double(p.x), double(p.y), double(p.z)};
  }

  static Extent wide(const Extent& e, double by) {
    return {{e.low.x - by, e.low.y - by, e.low.z - by}, {e.high.x + by, e.high.y + by, e.high.z + by}};
  }

  /// False only where they are apart: along an axis, or seen along one.
  static bool may_meet(const Vector& from, const Vector& to, const Extent& box) {
    Extent ends{from, from};
    ends.add({to, to});
    if (!box.meets(ends)) return false;
    const Vector way = to - from, half = scaled(0.5, box.high - box.low), off = box.middle() - from;
    const auto seen = [](double u, double v, double half_u, double half_v, double off_u, double off_v) {
      const double sum = std::abs(u * off_v) + std::abs(v * off_u) + half_u * std::abs(v) + half_v * std::abs(u);
      return std::abs(u * off_v - v * off_u) <= half_u * std::abs(v) + half_v * std::abs(u) + margin::kRoundings8 * sum;
    };
    return seen(way.x, way.y, half.x, half.y, off.x, off.y) && seen(way.y, way.z, half.y, half.z, off.y, off.z) &&
           seen(way.z, way.x, half.z, half.x, off.z, off.x);
  }

  const Mesh& mesh_;
  std::vector<int> vertices_;
  ExtentTree tree_;
};

}  // namespace findspace::space
