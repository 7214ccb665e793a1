// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Work spread over threads within work spread over threads: where a task throws, what others have begun is done whole.

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <string>
#include <thread>

#include "plane/base/parallel.h"

namespace findspace::plane {
namespace plane_parallel {

/// Until it is true, or for long enough where one thread is all there is.
void wait_for(const std::atomic<bool>& flag) {
  for (int k = 0; k < 200 && !flag; ++k) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

TEST(Parallel, WorkWithinATaskIsDoneWholeWhereAnotherTaskThrows) {
  constexpr std::size_t kTasks = 100;
  std::atomic<bool> begun{false}, thrown{false};
  std::atomic<std::size_t> done{0}, done_at_return{kTasks};
  const auto inner = [&](std::size_t) {
    if (!begun.exchange(true)) {
      wait_for(thrown);
      std::this_thread::sleep_for(std::chrono::milliseconds(20));  // until the others have been told
    }
    ++done;
  };
  const auto outer = [&](std::size_t k) {
    if (k == 0) {
      parallel_for(kTasks, inner);
      done_at_return = done.load();
      return;
    }
    wait_for(begun);
    thrown = true;
    throw std::invalid_argument("no");
  };
  EXPECT_THROW(parallel_for(2, outer), std::invalid_argument);
  EXPECT_EQ(done_at_return, kTasks);
}

TEST(Parallel, TheFirstTaskThatThrowsIsTheOneThatIsHeard) {
  for (int round = 0; round < 20; ++round) {
    std::atomic<bool> thrown{false};
    const auto task = [&](std::size_t k) {
      if (k < 3) return;
      if (k == 3) wait_for(thrown);
      thrown = true;
      throw std::invalid_argument(std::to_string(k));
    };
    try {
      parallel_for(64, task);
      FAIL();
    } catch (const std::invalid_argument& e) {
      EXPECT_STREQ(e.what(), "3");
    }
  }
}

}  // namespace plane_parallel
}  // namespace findspace::plane
