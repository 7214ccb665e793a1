// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What may be looked at for values of two solids that round ones are cut out of (csg_between.h), in cells of
// plane/base/search_work.h. A value takes thousands of them, so all that is asked has a share: it ends with what is
// known then. --work-limit raises it. Guarantee: counted, not timed. Keywords: budget, nested search.
#pragma once

#include <algorithm>
#include <cstddef>

#include "distance/search/strict_work.h"
#include "space/rays/ray_sources.h"

namespace findspace::distance {

/// What may be looked at for a least value, or the lines of a map together: some seconds.
inline constexpr long kMostCellsBetween = plane::kMostCellsOfQuestion / 20;
inline constexpr long kMostCellsOfValue = kMostCellsBetween / 4, kMostCellsOfBody = kMostCellsOfValue / 4;
/// Of a value that is asked for alone.
inline constexpr long kMostCellsOfOneValue = 2 * kMostCellsBetween;
inline constexpr long kLeastCellsOfLine = kMostCellsBetween / 64;

inline long share_of_line(const space::RayGrid& grid) {
  return std::max(kLeastCellsOfLine, kMostCellsBetween / (static_cast<long>(grid.nu) * grid.nv));
}

/// Values at most.
inline constexpr int kMostPlacesOfLine = 64, kMostPlacesOfLeast = 200;

/// Bodies of fewer cells tell less, and sooner.
enum class Cells { kCoarse, kFine };
inline constexpr std::size_t cells_across(Cells cells) { return cells == Cells::kFine ? 8 : 4; }

}  // namespace findspace::distance
