// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Which faces of a mesh run along which edge, in either sense. Cost: linear, and sorts of the few edges at a vertex.
// Keywords: edge table, adjacency.
#pragma once

#include <span>
#include <vector>

#include "space/mesh/mesh.h"

namespace findspace::space {

class MeshEdges {
 public:
  struct Use {
    int to;    // the greater vertex of the edge
    int face;  // that runs along it
    bool rising;
  };

  explicit MeshEdges(const Mesh& mesh);

  /// The uses of an edge, in the order of the faces.
  std::span<const Use> at(int a, int b) const;
  /// Calls visit(edge, uses) for every edge, in ascending order; the lesser vertex of an edge comes first.
  template <class Visit>
  void each(Visit visit) const {
    for (std::size_t v = 0; v + 1 < first_.size(); ++v)
      for (std::size_t i = first_[v]; i < first_[v + 1];) {
        std::size_t end = i + 1;
        while (end < first_[v + 1] && uses_[end].to == uses_[i].to) ++end;
        visit(MeshEdge{static_cast<int>(v), uses_[i].to}, std::span<const Use>(uses_).subspan(i, end - i));
        i = end;
      }
  }

 private:
  std::vector<std::size_t> first_;  // of each lesser vertex, in the uses
  std::vector<Use> uses_;
};

/// The faces that run along an edge upwards, less those that run along it downwards.
int balance(std::span<const MeshEdges::Use> uses);

}  // namespace findspace::space
