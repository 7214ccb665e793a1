// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What ends work early: a check belongs to the thread that installs it and to the tasks that parallel_for() makes of
// that thread's work. It is asked before each task and in every search (subdivide.h), and throws where the work shall
// end. Guarantee: results that are given do not depend on it; what is half made is thrown away. Cost: one call a task.
// Keywords: cancellation, timeout, deadline, interruption.
#pragma once

#include <functional>

namespace findspace::plane {

class StopCheck {
 public:
  virtual ~StopCheck() = default;
  /// Throws where the work shall end. Called from several threads at once.
  virtual void poll() = 0;
};

/// The one of this thread, or null.
StopCheck* stop_check();

/// While it lives, the thread has this check; null: none.
class ScopedStopCheck {
 public:
  explicit ScopedStopCheck(StopCheck* limit);
  ~ScopedStopCheck();
  ScopedStopCheck(const ScopedStopCheck&) = delete;
  ScopedStopCheck& operator=(const ScopedStopCheck&) = delete;

 private:
  StopCheck* before_;
};

/// task(), whose parallel work is done by at most so many threads (0: one for each core).
void with_threads(unsigned threads, const std::function<void()>& task);

}  // namespace findspace::plane
