// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What ends work early: a limit belongs to the thread that installs it and to the tasks that parallel_for() makes of
// that thread's work. It is asked before each task and at poll_work(), and throws where the work shall end. Guarantee:
// results that are given do not depend on it; what is half made is thrown away. Cost: one call a task. Keywords:
// cancellation, timeout, deadline, interruption.
#pragma once

#include <functional>

namespace findspace::plane {

class WorkLimit {
 public:
  virtual ~WorkLimit() = default;
  /// Throws where the work shall end. Called from several threads at once.
  virtual void poll() = 0;
};

/// The one of this thread, or null.
WorkLimit* work_limit();

/// While it lives, the thread has this limit; null: none.
class LimitWork {
 public:
  explicit LimitWork(WorkLimit* limit);
  ~LimitWork();
  LimitWork(const LimitWork&) = delete;
  LimitWork& operator=(const LimitWork&) = delete;

 private:
  WorkLimit* before_;
};

/// For long loops.
inline void poll_work() {
  if (WorkLimit* const limit = work_limit()) limit->poll();
}

/// task(), whose parallel work is done by at most so many threads (0: one for each core).
void with_threads(unsigned threads, const std::function<void()>& task);

}  // namespace findspace::plane
