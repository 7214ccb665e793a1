// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/base/counted_tasks.h"

#include <numeric>
#include <vector>

#include "plane/base/parallel.h"
#include "plane/base/search_work.h"

namespace findspace::plane {

void counted_tasks(std::size_t count, const std::function<void(std::size_t)>& task) {
  std::vector<long> cells(count);
  parallel_for(count, [&](std::size_t k) {
    SearchWork own;
    const long most = own.left;
    const ScopedSearchWork here(&own);
    task(k);
    cells[k] = most - own.left;
  });
  count_cells(std::accumulate(cells.begin(), cells.end(), 0L));
}

}  // namespace findspace::plane
