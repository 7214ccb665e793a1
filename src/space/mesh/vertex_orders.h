// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Some vertices of a mesh in ascending order of each coordinate, to look up those that may lie on an edge or near it.
// Guarantee: none that lies in the box about the edge, made wider all around, is left out. Cost: a search in each
// order, and the vertices of the slab with the fewest. Keywords: slab, sweep.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "space/polytope/solid.h"

namespace findspace::space {

class VertexOrders {
 public:
  VertexOrders(const Mesh& mesh, const std::vector<int>& vertices) : mesh_(mesh) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      order_[axis] = vertices;
      std::sort(order_[axis].begin(), order_[axis].end(), [&](int v, int w) { return at(axis, v) < at(axis, w); });
    }
  }

  /// Calls visit(v) for each vertex in the slab about the edge, wider by so many grid steps, that holds fewest of them.
  template <class Visit>
  void each_near(int a, int b, std::int64_t wider, Visit visit) const {
    std::span<const int> fewest = slab(0, a, b, wider);
    for (std::size_t axis = 1; axis < 3; ++axis) {
      if (const auto s = slab(axis, a, b, wider); s.size() < fewest.size()) fewest = s;
    }
    for (const int v : fewest) visit(v);
  }

 private:
  std::int64_t at(std::size_t axis, int v) const {
    const Point& p = mesh_.vertices[std::size_t(v)];
    return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
  }
  std::span<const int> slab(std::size_t axis, int a, int b, std::int64_t wider) const {
    const std::int64_t low = std::min(at(axis, a), at(axis, b)) - wider;
    const std::int64_t high = std::max(at(axis, a), at(axis, b)) + wider;
    const auto first =
        std::partition_point(order_[axis].begin(), order_[axis].end(), [&](int v) { return at(axis, v) < low; });
    const auto last = std::partition_point(first, order_[axis].end(), [&](int v) { return at(axis, v) <= high; });
    return {first, last};
  }

  const Mesh& mesh_;
  std::array<std::vector<int>, 3> order_;
};

}  // namespace findspace::space
