// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What all searches in space that answer one question do together. A search may search within each look at a cell, and
// so may what it asks. Each has a limit of its own, but thousands of them would add up to minutes. So cells are counted
// for the question, too. Where it may look at no more, its outermost search ends with what it knows: bounds of a value,
// or a refusal. A search within that one goes on to its own end. Guarantee: work is counted, not timed, and each task
// counts its own: the same answer for any number of threads. Keywords: budget, nested search.
#pragma once

#include "plane/base/of_thread.h"

namespace findspace::distance {

/// Half a minute. The more is cut out of a solid, the longer a cell takes: with twenty round shapes twice as long.
inline constexpr long kMostCellsOfQuestion = 1'500'000;
/// Of the cells that are left to a question, what one of many searches for it may take.
inline constexpr long kShareOfSearch = 8;

struct SearchWork {
  long left = kMostCellsOfQuestion;  // cells that may still be looked at
  bool spent() const { return left <= 0; }
};

/// While it lives, the searches of the thread count there; null: nowhere.
using ScopedSearchWork = plane::OfThread<SearchWork>;

/// A question, unless it is asked within another.
class SearchQuestion {
 public:
  SearchQuestion() : work_(ScopedSearchWork::now() ? ScopedSearchWork::now() : &own_), here_(work_) {}
  SearchWork& work() const { return *work_; }

 private:
  SearchWork own_;
  SearchWork* work_;
  ScopedSearchWork here_;
};

/// Cells that the question of this thread may still look at.
inline long cells_left() { return ScopedSearchWork::now() ? ScopedSearchWork::now()->left : kMostCellsOfQuestion; }
/// A search looks at a cell.
inline void count_cell() {
  if (SearchWork* const work = ScopedSearchWork::now()) --work->left;
}

}  // namespace findspace::distance
