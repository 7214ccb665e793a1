// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Drops what is not used from a list where it stands: no second list, and the rest keeps its order. Cost: linear. Used
// for the geometry of a complex, most of its memory. Keywords: compaction, renumbering.
#pragma once

#include <cstddef>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "plane/base/arena.h"
#include "plane/base/parallel.h"
#include "plane/complex/cell_complex.h"

namespace findspace::plane {

/// What the things hold is given back, of ranges at once where there are many.
template <class Thing>
void empty_all(std::span<Thing> things) {
  constexpr std::size_t kMany = 4000;
  if (range_count(things.size(), kMany) == 1) return;  // as well when they are dropped
  in_ranges(things.size(), kMany, [&](IndexRange some) {
    for (Thing& t : things.subspan(some.first, some.size())) t = {};
  });
}

/// Numbers what is used (not 0) in its order, the rest kNone, and drops the rest of the things.
template <class Thing>
void keep_used(ArenaVector<Index>& used, std::vector<Thing>& things) {
  constexpr std::size_t kLittle = 8192;  // bytes that may lie idle
  Index count = 0;
  for (Index k = 0; k < used.size(); ++k) {
    if (used[k] == 0) {
      used[k] = kNone;
      continue;
    }
    if (count != k) things[count] = std::move(things[k]);
    used[k] = count++;
  }
  // Of a curve only a pointer is given back, which costs less than to wake another thread.
  if constexpr (std::is_same_v<Thing, exact::RealPoint>) empty_all(std::span(things).subspan(count));
  things.erase(things.begin() + std::ptrdiff_t(count), things.end());
  if (2 * count < things.capacity() && things.capacity() * sizeof(Thing) > kLittle) things.shrink_to_fit();
}

}  // namespace findspace::plane
