// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Work that ends all searches that count there, those within others too (plane/base/search_work.h), so that no value
// of many takes seconds. Guarantee: what has no answer yet keeps its bound; a task that counts its own is not meant,
// so answers are the same for any number of threads. Keywords: budget, nested search.
#pragma once

#include <algorithm>

#include "plane/base/search_work.h"

namespace findspace::distance {

using ScopedStrictWork = plane::OfThread<const plane::SearchWork>;

inline bool strictly_limited() {
  const plane::SearchWork* const work = plane::ScopedSearchWork::now();
  return work != nullptr && work == ScopedStrictWork::now();
}
inline bool strictly_spent() { return strictly_limited() && plane::ScopedSearchWork::now()->spent(); }

/// What is asked ends when it has taken so many cells of those that are left to the question.
template <class Ask>
auto in_cells(long cells, const Ask& ask) {
  const long given = std::max(std::min(plane::cells_left(), cells), 1L);
  plane::SearchWork work{given};
  auto found = [&] {
    const plane::ScopedSearchWork here(&work);
    const ScopedStrictWork strict(&work);
    return ask();
  }();
  plane::count_cells(given - work.left);
  return found;
}

/// The same of so many usual cells: --work-limit gives more.
template <class Ask>
auto in_share(long share, const Ask& ask) {
  return in_cells(plane::allowed(share), ask);
}

/// One of so many lines that the cells which are left to a strict question are for; a question of its own elsewhere.
template <class Ask>
auto in_share_of_line(long lines, const Ask& ask) {
  if (strictly_limited()) return in_cells(std::max(plane::cells_left(), 0L) / lines, ask);
  const plane::SearchQuestion line_is_one;
  return ask();
}

}  // namespace findspace::distance
