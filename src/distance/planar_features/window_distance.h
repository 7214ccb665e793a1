// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The sign of d(p, C) - radius for the positions p of a small window, where C is a set of some edges and points far
// away: each edge has a map of its own, cut at the window, and the nearest one decides. So the curves around the edges,
// which are large beside the window, meet there alone. Guarantee: exact in the window. Cost: a small map for each edge
// whose curve passes through the window. Keywords: locality, lower envelope, parallel curve.
#pragma once

#include <vector>

#include "distance/planar_features/near_parts.h"

namespace findspace::distance {

class WindowDistance {
 public:
  /// How many edges show more than an end in the window; their maps are the costly ones.
  static std::size_t edges_seen(const plane::Region& edges, const plane::PieceBox& window);
  /// C is a set without faces; the corners of the window are on the grid.
  WindowDistance(const plane::Region& edges, const plane::PieceBox& window);

  /// -1, 0, +1 in the window; elsewhere nothing is said.
  plane::SignMap map(const exact::Real& radius) const;

 private:
  struct Part {
    plane::Region alone;  // an edge with its ends, or a point
    double distance;      // from the middle of the window
  };

  PlacedWindow window_;
  plane::Region filled_;
  std::vector<Part> parts_;
};

}  // namespace findspace::distance
