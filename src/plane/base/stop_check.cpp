// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/base/stop_check.h"

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>

namespace findspace::plane {

void with_threads(unsigned threads, const std::function<void()>& task) {
  if (threads == 0) {
    task();
    return;
  }
  // oneTBB warns on standard error of an arena of more threads than it starts.
  const std::size_t most = tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  tbb::task_arena arena(static_cast<int>(std::min<std::size_t>(threads, most)));
  arena.execute(task);
}

}  // namespace findspace::plane
