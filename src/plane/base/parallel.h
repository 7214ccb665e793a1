// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The one place where work is spread over threads. Every task writes only its own result, so results are the same bytes
// for any number of threads. An exception in a task reaches the caller. Keywords: parallel for, oneTBB.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>

namespace findspace::plane {

/// Calls task(0) ... task(count - 1), in any order, possibly at once; in this order where stages are observed
/// (stage_observer.h).
void parallel_for(std::size_t count, const std::function<void(std::size_t)>& task);

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
