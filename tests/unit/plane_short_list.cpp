// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Lists with room for one item: where items lie must not be seen.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "plane/base/short_list.h"

namespace findspace::plane {
namespace plane_short_list {

using Numbers = ShortList<std::uint32_t>;

Numbers counted(std::uint32_t count) {
  Numbers list;
  for (std::uint32_t k = 0; k < count; ++k) list.push_back(k);
  return list;
}

TEST(ShortList, GrowsInOrder) {
  for (const std::uint32_t count : {0u, 1u, 2u, 3u, 9u}) {
    const Numbers list = counted(count);
    ASSERT_EQ(list.size(), count);
    EXPECT_EQ(list.empty(), count == 0);
    std::vector<std::uint32_t> expected(count);
    std::iota(expected.begin(), expected.end(), 0u);
    EXPECT_TRUE(std::equal(list.begin(), list.end(), expected.begin(), expected.end()));
    EXPECT_EQ(Numbers(std::span<const std::uint32_t>(expected)), list);
  }
}

TEST(ShortList, CopiesAndMoves) {
  for (const std::uint32_t count : {0u, 1u, 2u, 5u}) {
    for (const std::uint32_t before : {0u, 1u, 4u}) {
      const Numbers list = counted(count);
      Numbers copy = counted(before);
      copy = list;
      EXPECT_EQ(copy, list);
      copy.push_back(7);
      EXPECT_EQ(list, counted(count));
      EXPECT_EQ(copy.size(), count + 1);
      Numbers moved = std::move(copy);
      EXPECT_EQ(moved.size(), count + 1);
      EXPECT_EQ(moved[count], 7u);
    }
  }
}

}  // namespace plane_short_list
}  // namespace findspace::plane
