// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/base/stop_check.h"

#include <tbb/task_arena.h>

namespace findspace::plane {
namespace {

thread_local StopCheck* of_thread = nullptr;

}  // namespace

StopCheck* stop_check() { return of_thread; }

ScopedStopCheck::ScopedStopCheck(StopCheck* limit) : before_(of_thread) { of_thread = limit; }
ScopedStopCheck::~ScopedStopCheck() { of_thread = before_; }

void with_threads(unsigned threads, const std::function<void()>& task) {
  if (threads == 0) {
    task();
    return;
  }
  tbb::task_arena arena(static_cast<int>(threads));
  arena.execute(task);
}

}  // namespace findspace::plane
