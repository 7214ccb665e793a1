// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Some vertices of a mesh, to look up those that may lie on an edge or near it. Guarantee: none that lies in the box
// about the edge, made wider all around, is left out. Cost: the logarithm of their number, and the vertices of the box.
// Keywords: range search, k-d tree.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

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

  /// Calls visit(v) for each vertex in the box about the edge, wider by so many grid steps.
  template <class Visit>
  void each_near(int a, int b, std::int64_t wider, Visit visit) const {
    Extent box{at(a), at(a)};
    box.add({at(b), at(b)});
    const auto by = double(wider);
    const Extent all{{box.low.x - by, box.low.y - by, box.low.z - by},
                     {box.high.x + by, box.high.y + by, box.high.z + by}};
    tree_.each([&](const Extent& e) { return e.meets(all); }, [&](std::size_t k) { visit(vertices_[k]); });
  }

 private:
  /// Exact, as coordinates of meshes are below 2^40.
  Vector at(int v) const {
    const Point& p = mesh_.vertices[std::size_t(v)];
    return {double(p.x), double(p.y), double(p.z)};
  }

  const Mesh& mesh_;
  std::vector<int> vertices_;
  ExtentTree tree_;
};

}  // namespace findspace::space
