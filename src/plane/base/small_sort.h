// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Sorting where nearly all ranges have a handful of items: by insertion up to eight, else std::sort.
#pragma once

#include <algorithm>
#include <utility>

namespace findspace::plane {

/// By insertion, however many there are; those that are equal keep their order.
template <class Iterator, class Less>
void insert_all(Iterator first, Iterator last, const Less& less) {
  if (first == last) return;
  for (Iterator k = first + 1; k != last; ++k) {
    auto item = std::move(*k);
    Iterator at = k;
    for (; at != first && less(item, *(at - 1)); --at) *at = std::move(*(at - 1));
    *at = std::move(item);
  }
}

template <class Iterator, class Less>
void small_sort(Iterator first, Iterator last, const Less& less) {
  constexpr auto kFew = 8;
  if (last - first > kFew) return std::sort(first, last, less);
  insert_all(first, last, less);
}

}  // namespace findspace::plane
