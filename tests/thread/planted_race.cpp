// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Two tasks of plane::parallel_for write the same number without a lock. Built and run with ThreadSanitizer, which must
// find this: the test that it does shows that the order told to it (order_of_tasks.cpp) hides no race.
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdio>

#include "plane/base/parallel.h"

int main() {
  volatile int number = 0;  // each addition is one of its own
  std::atomic<int> begun = 0;
  const auto latest = std::chrono::steady_clock::now() + std::chrono::seconds(10);
  findspace::plane::parallel_for(2, [&](std::size_t) {
    begun.fetch_add(1, std::memory_order_relaxed);  // relaxed: both run at once, and no order follows
    while (begun.load(std::memory_order_relaxed) < 2 && std::chrono::steady_clock::now() < latest) continue;
    for (int k = 0; k < 10'000; ++k) number = number + 1;  // of a single pair, now and then none is seen
  });
  std::printf("%d\n", static_cast<int>(number));
}
