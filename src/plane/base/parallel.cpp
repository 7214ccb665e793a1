// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/base/parallel.h"

#include <tbb/global_control.h>

#include <atomic>
#include <exception>
#include <functional>
#include <mutex>
#include <utility>

#include "plane/base/result_store.h"
#include "plane/base/search_work.h"
#include "plane/base/stage_observer.h"
#include "plane/base/stop_check.h"
#include "plane/base/tasks.h"

namespace findspace::plane {
namespace {

/// What the first of some tasks throws, in their order. Those after one that threw need not run.
class FirstError {
 public:
  explicit FirstError(std::size_t count) : task_(count) {}
  bool is_before(std::size_t task) const { return task_ < task; }
  void add(std::size_t task, std::exception_ptr error) {
    const std::lock_guard lock(guard_);
    if (is_before(task)) return;
    task_ = task;
    error_ = std::move(error);
  }
  void rethrow() const {
    if (error_) std::rethrow_exception(error_);
  }

 private:
  std::atomic<std::size_t> task_;
  std::mutex guard_;
  std::exception_ptr error_;
};

}  // namespace

void parallel_for(std::size_t count, const std::function<void(std::size_t)>& task) {
  StopCheck* const limit = stop_check();
  ResultStore* const store = result_store();
  const SearchLimit* const most = ScopedSearchLimit::now();
  const auto run = [&](std::size_t k) {
    const ScopedStopCheck here(limit);  // another thread's task, perhaps, that this one took over
    const ScopedResultStore kept(store);
    const ScopedSearchLimit allowed_work(most);
    const ScopedSearchWork own_work(nullptr);
    if (limit != nullptr) limit->poll();
    task(k);
  };
  if (count == 1 || stage_observer() != nullptr) {
    for (std::size_t k = 0; k < count; ++k) run(k);
    return;
  }
  FirstError error(count);
  run_tasks(count, [&](std::size_t k) {
    if (error.is_before(k)) return;
    try {
      run(k);
    } catch (...) {
      error.add(k, std::current_exception());
    }
  });
  error.rethrow();
}

std::size_t range_count(std::size_t items, std::size_t many) {
  if (items < many || stage_observer() != nullptr) return 1;
  return tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism) > 1 ? kRanges : 1;
}

struct ThreadLimit::Control {
  tbb::global_control limit;
};

ThreadLimit::ThreadLimit(unsigned threads) {
  if (threads > 0) control_.reset(new Control{{tbb::global_control::max_allowed_parallelism, threads}});
}

ThreadLimit::~ThreadLimit() = default;

}  // namespace findspace::plane
