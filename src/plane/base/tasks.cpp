// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/base/tasks.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <stdexcept>
#include <string>
#include <string_view>
#include <typeinfo>

#include "findspace/error.h"

namespace findspace::plane {
namespace {

/// What oneTBB throws where the system refuses a thread has no type of its own.
bool is_of_threads(const std::runtime_error& e) {
  return typeid(e) == typeid(std::runtime_error) && std::string_view(e.what()).starts_with("pthread_create");
}

}  // namespace

void run_tasks(std::size_t count, const std::function<void(std::size_t)>& task) {
  try {
    // A group of its own: else one that is under way in a task is left half done, without a word, where another task
    // throws, and its caller goes on with what there is.
    tbb::task_group_context group(tbb::task_group_context::isolated);
    // A thread that waits for these tasks takes up no other ones: it may hold what those wait for.
    tbb::this_task_arena::isolate([&] {
      tbb::parallel_for(
          std::size_t{0}, count, [&](std::size_t k) { task(k); }, tbb::simple_partitioner(), group);
    });
  } catch (const std::runtime_error& e) {
    if (!is_of_threads(e)) throw;
    throw Error(ErrorCode::kLimit,
                std::string("a thread cannot be started (") + e.what() + "); --threads 1 needs none");
  }
}

}  // namespace findspace::plane
