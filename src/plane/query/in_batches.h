// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Sums, offsets and sweeps of a large bounded set, or of its complement, part by part: what lies so far apart that the
// results lie apart is computed in batches, and the results are written side by side. Guarantee: the same set; boxes
// only choose, and results whose boxes meet are made together. Cost: that of the parts; memory for some batches at a
// time, beside the set and the result. Batches run on all threads, and the result does not depend on how many there
// are. Keywords: locality, tiling, divide and conquer, working set.
#pragma once

#include <functional>
#include <optional>

#include "plane/complex/broad_phase.h"
#include "plane/complex/cell_complex.h"

namespace findspace::plane {

struct BatchSizes {
  std::size_t least = 16384;  // edges of a set that is worth it
  std::size_t each = 1024;    // edges of a batch, or the first beyond them
};

inline bool is_worth_batches(const CellComplex& set, const BatchSizes& sizes = {}) {
  return set.edges.size() >= sizes.least;
}

/// `make` of the whole set, of which parts that lie apart are made by themselves. Each part has the set's unbounded
/// face; so has each result one mark there. `reach`: how far a result may stand out of its part's box on each side (x0
/// and y0 downwards). Nothing where the set is small or of one part, or is observed.
std::optional<CellComplex> made_in_batches(const CellComplex& set, const PieceBox& reach,
                                           const std::function<CellComplex(const CellComplex&)>& make,
                                           const BatchSizes& sizes = {});

}  // namespace findspace::plane
