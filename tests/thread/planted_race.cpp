// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Two tasks of plane::parallel_for write the same numbers without a lock, one forwards and one backwards. Built and run
// with ThreadSanitizer, which must find this: the test that it does shows that the order told to it
// (order_of_tasks.cpp) hides no race. Many numbers: where both write one at the same moment the sanitizer may miss it,
// and it does not look at that number again.
#include <array>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdio>

#include "plane/base/parallel.h"

int main() {
  static std::array<int, 10'000> numbers = {};
  std::atomic<int> begun = 0;
  const auto latest = std::chrono::steady_clock::now() + std::chrono::seconds(10);
  findspace::plane::parallel_for(2, [&](std::size_t task) {
    begun.fetch_add(1, std::memory_order_relaxed);  // relaxed: both run at once, and no order follows
    while (begun.load(std::memory_order_relaxed) < 2 && std::chrono::steady_clock::now() < latest) continue;
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      int& number = numbers[task == 0 ? k : numbers.size() - 1 - k];
      number = number + 1;
    }
  });
  std::printf("%d\n", numbers.front());
}
