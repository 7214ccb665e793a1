// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Drops what is not used from a list where it stands: no second list, and the rest keeps its order. Cost: linear. Used
// for the geometry of a complex, most of its memory. Keywords: compaction, renumbering.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "plane/base/arena.h"
#include "plane/complex/cell_complex.h"

namespace findspace::plane {

/// Numbers what is used (not 0) in its order, the rest kNone, and drops the rest of the things.
template <class Thing>
void keep_used(std::pmr::vector<Index>& used, std::vector<Thing>& things) {
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
  things.erase(things.begin() + std::ptrdiff_t(count), things.end());
  if (2 * count < things.capacity() && things.capacity() * sizeof(Thing) > kLittle) things.shrink_to_fit();
}

}  // namespace findspace::plane
