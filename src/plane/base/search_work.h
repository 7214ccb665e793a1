// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What all searches in space that answer one question do together. A search may search within each look at a cell, and
// so may what it asks. Each has a limit of its own, but thousands of them would add up to minutes. So cells are counted
// for the question, too. Where it may look at no more, its outermost search ends with what it knows: bounds of a value,
// or a refusal. A search within that one goes on to its own end. These limits grow with the units of work that the
// asker allows (work_budget.h), but not those of a search within another: a longer one there would leave less to the
// others. Guarantee: work is counted, not timed, and each task counts its own: the same answer for any number of
// threads. Keywords: budget, nested search.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>

#include "exact/number/tried.h"
#include "plane/base/of_thread.h"
#include "plane/base/work_budget.h"

namespace findspace::plane {

/// Half a minute. The more is cut out of a solid, the longer a cell takes: with twenty round shapes twice as long.
inline constexpr long kMostCellsOfQuestion = 1'500'000;
/// Of the cells that are left to a question, what one of many searches for it may take.
inline constexpr long kShareOfSearch = 8;

/// The units of work that the asker allows.
struct SearchLimit {
  std::uint64_t units = kUsualWorkBudget;
};

/// While it lives, that of the thread, and of the tasks that parallel_for() makes of its work; null: the usual one.
using ScopedSearchLimit = OfThread<const SearchLimit>;

/// What a search may do at most, where it is `usual` of the usual units.
inline long allowed(long usual) {
  const SearchLimit* const limit = ScopedSearchLimit::now();
  if (limit == nullptr || limit->units == kUsualWorkBudget) return usual;
  const double share = static_cast<double>(limit->units) / static_cast<double>(kUsualWorkBudget);
  constexpr double kLargest = 1e18;
  return static_cast<long>(std::clamp(static_cast<double>(usual) * share, 1.0, kLargest));
}

/// Why a search has no answer; `what` was not found, and says so.
inline exact::Refusal search_spent(const std::string& what) {
  return exact::Refusal(what + " within the limit of the search, which --work-limit raises");
}

struct SearchWork {
  long left = allowed(kMostCellsOfQuestion);  // cells that may still be looked at
  bool spent() const { return left <= 0; }
};

/// While it lives, the searches of the thread count there; null: nowhere.
using ScopedSearchWork = OfThread<SearchWork>;

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
inline long cells_left() {
  const SearchWork* const work = ScopedSearchWork::now();
  return work ? work->left : allowed(kMostCellsOfQuestion);
}
/// A search looks at a cell, or does what costs as much as so many.
inline void count_cells(long cells) {
  if (SearchWork* const work = ScopedSearchWork::now()) work->left -= cells;
}
inline void count_cell() { count_cells(1); }

}  // namespace findspace::plane
