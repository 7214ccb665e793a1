// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Sorting of many items in several threads: ranges are sorted at once and then merged, two by two. Guarantee: the
// order is that of std::sort where no two items are equal, for any number of threads. Cost: O(n log n).
// Keywords: parallel merge sort.
#pragma once

#include <algorithm>

#include "plane/base/parallel.h"

namespace findspace::plane {

/// Sorts from `first` to `last`, in several threads from `many` items on. No two items may be equal.
template <class Iterator, class Less>
void sort_at_once(Iterator first, Iterator last, std::size_t many, const Less& less) {
  const auto items = static_cast<std::size_t>(last - first);
  const std::size_t ranges = range_count(items, many);
  const auto begin = [&](std::size_t k) {
    return first + static_cast<std::ptrdiff_t>(range(std::min(k, ranges), ranges, items).first);
  };
  each_range(ranges, [&](std::size_t k) { std::sort(begin(k), begin(k + 1), less); });
  for (std::size_t merged = 1; merged < ranges; merged *= 2) {
    parallel_for((ranges + 2 * merged - 1) / (2 * merged), [&](std::size_t k) {
      const std::size_t from = 2 * merged * k;
      std::inplace_merge(begin(from), begin(from + merged), begin(from + 2 * merged), less);
    });
  }
}

}  // namespace findspace::plane
