// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/base/work_limit.h"

#include <tbb/task_arena.h>

namespace findspace::plane {
namespace {

thread_local WorkLimit* of_thread = nullptr;

}  // namespace

WorkLimit* work_limit() { return of_thread; }

LimitWork::LimitWork(WorkLimit* limit) : before_(of_thread) { of_thread = limit; }
LimitWork::~LimitWork() { of_thread = before_; }

void with_threads(unsigned threads, const std::function<void()>& task) {
  if (threads == 0) {
    task();
    return;
  }
  tbb::task_arena arena(static_cast<int>(threads));
  arena.execute(task);
}

}  // namespace findspace::plane
