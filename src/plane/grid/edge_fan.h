// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The edges of a face in the order of their directions, and their places among the edges of another face: which edges
// of the other a corner meets in a convolution (convolution.h) are those whose directions its turn sweeps. Guarantee:
// exact; of equal directions those of the first face come first, as if the second were turned by an infinitesimal.
// Cost: O(n log n + m log m). Keywords: circular order of directions.
#pragma once

#include <span>
#include <vector>

#include "plane/base/arena.h"
#include "plane/grid/grid_faces.h"

namespace findspace::plane {

class EdgeFan {
 public:
  /// Keeps references to what the face has.
  EdgeFan(const GridFace& face, Memory memory);

  /// Gives the edges of both faces their ranks.
  static void place(EdgeFan& first, EdgeFan& other);

  std::span<const GridCorner> corners;
  std::span<const EdgeRay> rays;  // by angle
  ArenaVector<Index> rank;        // corner -> rays of the other fan before its own

  /// Places among the rays of the other fan: first, first + 1, ..., end - 1, past the last one round to 0 if `wraps`.
  struct Sweep {
    Index first = 0, end = 0;
    bool wraps = false;
    std::size_t size(std::size_t all) const { return wraps ? all - first + end : end - first; }
    bool holds(Index place) const { return wraps ? place >= first || place < end : place >= first && place < end; }
  };
  /// The directions between the two edges of a corner, counter-clockwise whichever way it turns. Inline, as a caller
  /// would read its parts as one while they are still being written, which is slow.
  [[gnu::always_inline]] Sweep sweep(Index corner) const {
    const GridCorner& c = corners[corner];
    if (c.turn == 0) return {};
    const Index from = rank[c.turn > 0 ? c.before : corner], to = rank[c.turn > 0 ? corner : c.before];
    // It sweeps less than half a turn, which never holds all the edges of closed rings. So only what passes the
    // direction 0 ends at a lower place.
    return {from, to, to < from};
  }

 private:
  ArenaVector<EdgeRay> own_rays_;  // where the face has none
};

/// Makes the rays of faces that are added to many others.
void make_rays(std::span<GridFace> faces);

}  // namespace findspace::plane
