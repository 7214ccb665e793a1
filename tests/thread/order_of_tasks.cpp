// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Tells ThreadSanitizer the order that plane::run_tasks keeps: the caller's work before the call comes before every
// task, and every task before its work after the call. Two tasks are in no order. libtbb keeps this order by means that
// ThreadSanitizer does not see, since the library is not instrumented. The linker puts this function in the place of
// run_tasks (--wrap) where FINDSPACE_SANITIZE is thread.
#include <sanitizer/tsan_interface.h>

#include <cstddef>
#include <functional>

namespace {

using Task = std::function<void(std::size_t)>;

/// Marks a place of the order when it goes, also where a task throws.
struct AtEnd {
  void (*mark)(void*);
  void* place;
  ~AtEnd() { mark(place); }
};

}  // namespace

extern "C" {
// findspace::plane::run_tasks(unsigned long, std::function<void(unsigned long)> const&)
void __real__ZN9findspace5plane9run_tasksEmRKSt8functionIFvmEE(std::size_t count, const Task& task);

void __wrap__ZN9findspace5plane9run_tasksEmRKSt8functionIFvmEE(std::size_t count, const Task& task) {
  char begin = 0;
  char end = 0;
  __tsan_release(&begin);
  const AtEnd after{__tsan_acquire, &end};
  __real__ZN9findspace5plane9run_tasksEmRKSt8functionIFvmEE(count, [&](std::size_t k) {
    __tsan_acquire(&begin);
    const AtEnd done{__tsan_release, &end};
    task(k);
  });
}
}
