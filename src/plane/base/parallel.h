// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The one place where work is spread over threads. Every task writes only its own result, so results are the same bytes
// for any number of threads. An exception in a task reaches the caller. Keywords: parallel for, oneTBB.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>

#include "plane/base/stop_check.h"

namespace findspace::plane {

/// Calls task(0) ... task(count - 1), in any order, possibly at once; in this order where stages are observed
/// (stage_observer.h).
void parallel_for(std::size_t count, const std::function<void(std::size_t)>& task);

/// Some of the numbers 0, 1, ...: `first` and those up to `end`, which is not among them.
struct IndexRange {
  std::size_t first, end;
  std::size_t size() const { return end - first; }
};

/// In how many ranges work of so many items is divided: one where they are fewer than `many`, where one thread is all
/// there is and where stages are observed, else always the same number. The result must not depend on it.
std::size_t range_count(std::size_t items, std::size_t many);
inline constexpr std::size_t kRanges = 16;
/// The k-th of `ranges`.
inline IndexRange range(std::size_t k, std::size_t ranges, std::size_t items) {
  return {k * items / ranges, (k + 1) * items / ranges};
}
/// Calls task(k) for each of `ranges`, possibly at once; a single one here.
template <class Task>
void each_range(std::size_t ranges, Task&& task) {
  if (ranges == 1) return task(std::size_t{0});
  parallel_for(ranges, std::ref(task));
}
/// Calls task(range) for the ranges of so many items, possibly at once.
template <class Task>
void in_ranges(std::size_t items, std::size_t many, Task&& task) {
  const std::size_t count = range_count(items, many);
  each_range(count, [&](std::size_t k) { task(range(k, count, items)); });
}

/// Calls task(0) ... task(count - 1), possibly at once where they work on `many` items or more in all.
template <class Task>
void at_once(std::size_t count, std::size_t items, std::size_t many, Task&& task) {
  if (range_count(items, many) > 1) return parallel_for(count, std::ref(task));
  StopCheck* const limit = stop_check();
  for (std::size_t k = 0; k < count; ++k) {
    if (limit != nullptr) limit->poll();
    task(k);
  }
}

/// While it lives, at most `threads` tasks of the process run at once (0: one for each core).
class ThreadLimit {
 public:
  explicit ThreadLimit(unsigned threads);
  ~ThreadLimit();
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;

 private:
  struct Control;
  std::unique_ptr<Control> control_;
};

}  // namespace findspace::plane
