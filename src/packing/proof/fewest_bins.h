// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// How few sheets or containers can hold all parts, by area or volume alone: a number below which no packing is.
// It is the greater of two: the largest bins that make up the sum, and for equal bins as large as the largest one the
// bound in which two items of more than half a bin never share one. Guarantee: certain, exact arithmetic. Cost:
// sorting. Source: Martello & Toth, "Lower bounds and reduction procedures for the bin packing problem" (1990), L2.
// Keywords: bin packing, cutting stock.
#pragma once

#include <cstddef>
#include <vector>

#include "exact/number/real.h"

namespace findspace::packing {

/// So many that are alike: bins that hold at most that size, or items that take at least that size.
struct Alike {
  exact::Real size;
  std::size_t count = 0;
};

/// All bins where they are too few. An item larger than every bin counts as one that fills a bin.
std::size_t fewest_bins(std::vector<Alike> bins, std::vector<Alike> items);

}  // namespace findspace::packing
