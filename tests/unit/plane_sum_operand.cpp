// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Sums of sets that were prepared: the bytes of those of sets that were not.
#include <gtest/gtest.h>

#include <deque>
#include <string>
#include <vector>

#include "plane/complex/cell_bytes.h"
#include "plane/complex/primitives.h"
#include "plane/contour/contour.h"
#include "plane/sum/minkowski.h"

namespace findspace::plane {
namespace {

Region region(const std::vector<std::vector<GridPoint>>& rings) {
  std::vector<Contour> contours;
  for (const auto& ring : rings) {
    Contour& contour = contours.emplace_back();
    for (const GridPoint& p : ring) contour.push_back({.start = p});
  }
  return region_of_rings(make_rings(std::move(contours), 1).contours);
}

std::string bytes(const SignMap& map) {
  ByteWriter out;
  EXPECT_TRUE(put_cells(map, out));
  return std::move(out).take();
}

TEST(SumOperand, GivesTheSameSums) {
  std::vector<Region> sets;
  sets.push_back(Region::uniform(0));
  sets.push_back(region({{{0, 0}, {7, 0}, {0, 5}}}));
  sets.push_back(region({{{0, 0}, {9, 0}, {9, 8}, {5, 3}, {0, 8}}}));
  sets.push_back(region({{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{3, 3}, {3, 6}, {6, 6}, {6, 3}}}));
  sets.push_back(region_of_disc(1, 2, 3));  // with no grid polygon
  const std::vector<GridPoint> two{{0, 0}, {4, 1}};
  sets.push_back(region_of_points(two));
  std::vector<GridPoint> saw;
  for (std::int64_t k = 0; k < 20; ++k) saw.push_back({k * 10, k % 2 == 0 ? 0 : 7 + k});
  saw.push_back({100, 300});
  sets.push_back(region({saw}));
  std::deque<SumOperand> prepared;
  for (const Region& set : sets) prepared.emplace_back(set);
  for (std::size_t i = 0; i < sets.size(); ++i)
    for (std::size_t k = 0; k < sets.size(); ++k)
      EXPECT_EQ(bytes(contact_map(prepared[i], prepared[k])), bytes(contact_map(sets[i], sets[k]))) << i << " " << k;
}

}  // namespace
}  // namespace findspace::plane
