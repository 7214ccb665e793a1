// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The units of work that the asker allows to what a question counts one by one (work_budget.h), where the limit of
// searches (search_work.h) is that of the thread. Guarantee: the usual ones where none is set. Cost: none.
// Keywords: budget, quota.
#pragma once

#include "plane/base/search_work.h"
#include "plane/base/work_budget.h"

namespace findspace::plane {

inline WorkBudget allowed_work() {
  const SearchLimit* const limit = ScopedSearchLimit::now();
  return WorkBudget(limit != nullptr ? limit->units : kUsualWorkBudget);
}

}  // namespace findspace::plane
