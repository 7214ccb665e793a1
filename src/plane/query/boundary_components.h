// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A bounded set as its boundary_components: the connected pieces of its boundary in the unbounded face, each with all
// that lies inside it. What is near a box is then taken without looking at, or copying, the rest. Guarantee: the cells
// and marks are those of the whole, exactly; boxes only choose. Cost: linear once; a box test a component and what is
// chosen, for each question. Keywords: collection, locality, connected component, culling.
#pragma once

#include <span>
#include <vector>

#include "plane/complex/broad_phase.h"
#include "plane/complex/cell_complex.h"

namespace findspace::plane {

class BoundaryComponents {
 public:
  /// Of a bounded complex. near() has to be given the same one.
  explicit BoundaryComponents(const CellComplex& a);

  std::size_t size() const { return boundary_components_.size(); }
  const PieceBox& box(Index k) const { return boundary_components_[k].box; }
  std::size_t edge_count(Index k) const;
  /// The complex of these boundary_components alone, in ascending order.
  CellComplex of(const CellComplex& a, std::span<const Index> chosen) const;
  /// The boundary_components that may meet the window: the complex as it is there.
  CellComplex near(const CellComplex& a, const PieceBox& window) const;

 private:
  struct BoundaryComponent {
    PieceBox box;
    Index start;                                     // the half-edge on its outer cycle, or its isolated vertex
    std::size_t edges_end, faces_end, vertices_end;  // in the lists below; they begin where those before end
  };
  class Flood;
  BoundaryComponent before(Index k) const {
    return k == 0 ? BoundaryComponent{{}, 0, 0, 0, 0} : boundary_components_[k - 1];
  }

  std::vector<BoundaryComponent> boundary_components_;
  std::vector<Index> edges_, faces_, vertices_;
};

/// The bounded faces, edges and isolated vertices of a closed bounded set that may meet the window, each with its
/// boundary; of what is connected, only the part that is near.
Region within(const Region& a, const PieceBox& window);

}  // namespace findspace::plane
