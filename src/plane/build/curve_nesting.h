// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Which way round closed curves run and which of them lie in which, told by rings of arcs near them.
// Guarantee: what is told is so for every set of curves that do not cross and are so near to the rings, edge by edge
// (plane/curve/curve_arcs.h):
//   * the areas of a curve and of its ring differ by loops beside the edges, so by 2 bound (length + 2 bound) an edge
//   at
//     most: a larger area of the ring has the sign of the curve's;
//   * a corner of one ring that is farther from another one than both bounds lies in both or in none of the other curve
//     and its ring, with all of its own curve that is as near.
// Rings that are too thin or too near to others to tell are asked for again, nearer to their curves. Cost: as
// nesting_depths.h, and a look at all edges of the outer one for each pair. Keywords: even-odd nesting, tolerance.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "plane/build/ring_sketch.h"

namespace findspace::plane {

/// A ring within a bound of a closed curve, in grid steps; bound 0: the ring itself.
struct NearRing {
  Contour ring;
  double bound = 0;
};

class CurveNesting {
 public:
  /// `nearer`: one within the least bound, asked for once at most of each ring that has one.
  CurveNesting(std::vector<NearRing> rings, std::function<NearRing(std::size_t)> nearer);

  /// +1 counter-clockwise, -1 clockwise; nothing where the curve is too thin to tell.
  std::optional<int> orientation(std::size_t k);
  /// Which of the others go round each; nothing where some are too near to each other to tell.
  std::optional<std::vector<std::vector<std::size_t>>> around();

 private:
  struct Known {
    NearRing near;
    RingSketch sketch;
    bool refined;
  };

  bool refine(std::size_t k);
  std::optional<bool> goes_round(std::size_t outer, std::size_t inner) const;

  std::vector<Known> rings_;
  std::function<NearRing(std::size_t)> nearer_;
};

}  // namespace findspace::plane
