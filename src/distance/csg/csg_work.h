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
inline constexpr long kLeastCellsOfLine = kMostCellsBetween / 16;

/// What is asked ends when it has taken so many cells of those that are left to the question.
template <class Ask>
auto in_share(long share, const Ask& ask) {
  const long given = std::max(std::min(plane::cells_left(), plane::allowed(share)), 1L);
  plane::SearchWork work{given};
  auto found = [&] {
    const plane::ScopedSearchWork here(&work);
    const ScopedStrictWork strict(&work);
    return ask();
  }();
  plane::count_cells(given - work.left);
  return found;
}

inline long share_of_line(const space::RayGrid& grid) {
  return std::max(kLeastCellsOfLine, kMostCellsBetween / (static_cast<long>(grid.nu) * grid.nv));
}

/// Values at most.
inline constexpr int kMostPlacesOfLine = 64, kMostPlacesOfLeast = 200;

/// Bodies of fewer cells tell less, and sooner.
enum class Cells { kCoarse, kFine };
inline constexpr std::size_t cells_across(Cells cells) { return cells == Cells::kFine ? 8 : 4; }

}  // namespace findspace::distance
