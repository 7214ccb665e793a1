// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/base/parallel.h"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include "plane/base/stage_observer.h"
#include "plane/base/work_limit.h"

namespace findspace::plane {

void parallel_for(std::size_t count, const std::function<void(std::size_t)>& task) {
  WorkLimit* const limit = work_limit();
  const auto run = [&](std::size_t k) {
    const LimitWork here(limit);  // another thread's task, perhaps, that this one took over
    if (limit != nullptr) limit->poll();
    task(k);
  };
  if (count == 1 || stage_observer() != nullptr) {
    for (std::size_t k = 0; k < count; ++k) run(k);
    return;
  }
  tbb::parallel_for(std::size_t{0}, count, run, tbb::simple_partitioner());
}

struct ThreadLimit::Control {
  tbb::global_control limit;
};

ThreadLimit::ThreadLimit(unsigned threads) {
  if (threads > 0) control_.reset(new Control{{tbb::global_control::max_allowed_parallelism, threads}});
}

ThreadLimit::~ThreadLimit() = default;

}  // namespace findspace::plane
