// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What ends work early: a check belongs to the thread that installs it and to the tasks that parallel_for() makes of
// that thread's work. It is asked before each task and in every search (subdivide.h), and throws where the work shall
// end. Guarantee: results that are given do not depend on it; what is half made is thrown away. Cost: one call a task.
// Keywords: cancellation, timeout, deadline, interruption.
#pragma once

#include <functional>

#include "plane/base/of_thread.h"

namespace findspace::plane {

class StopCheck {
 public:
  virtual ~StopCheck() = default;
  /// Throws where the work shall end. Called from several threads at once.
  virtual void poll() = 0;
};

/// While it lives, the thread has this check; null: none.
using ScopedStopCheck = OfThread<StopCheck>;
/// The one of this thread, or null.
inline StopCheck* stop_check() { return ScopedStopCheck::now(); }

/// task(), whose parallel work is done by at most so many threads (0: one for each core).
void with_threads(unsigned threads, const std::function<void()>& task);

}  // namespace findspace::plane
