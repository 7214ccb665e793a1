// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Lists in the memory of one computation: what does not fit, and copies, lie on the heap.
#include <gtest/gtest.h>

#include <cstdint>
#include <numeric>

#include "plane/base/arena.h"

namespace findspace::plane {
namespace plane_arena {

TEST(Arena, FullBlockGoesToTheHeap) {
  Arena arena(1);
  const Memory memory = arena.memory();
  ASSERT_NE(memory, kHeap);
  ArenaVector<std::uint64_t> few(10, 1, memory), many(100'000, 2, memory);
  EXPECT_TRUE(memory->holds(few.data()));
  EXPECT_FALSE(memory->holds(many.data()));
  ArenaVector<char> odd(3, 'a', memory);
  ArenaVector<double> aligned(1, 3, memory);
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(aligned.data()) % alignof(double), 0u);
  many.push_back(3);
  EXPECT_EQ(std::accumulate(many.begin(), many.end(), std::uint64_t(0)), 200'003u);
  EXPECT_EQ(Arena(1'000'000).memory(), kHeap);
}

TEST(Arena, CopiesUseTheHeap) {
  Arena arena(1);
  const ArenaVector<int> list(5, 4, arena.memory());
  const ArenaVector<int> copy = list;
  EXPECT_TRUE(arena.memory()->holds(list.data()));
  EXPECT_FALSE(arena.memory()->holds(copy.data()));
  EXPECT_EQ(copy, ArenaVector<int>(5, 4));
}

}  // namespace plane_arena
}  // namespace findspace::plane
