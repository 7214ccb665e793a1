// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The cells of levels in small windows are those of the whole plane.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "distance/planar/shape_pair.h"
#include "distance/planar_features/near_parts.h"
#include "distance/planar_least/extremum.h"
#include "distance/planar_least/level_cover.h"
#include "distance/planar_least/level_probe.h"
#include "distance/planar_least/level_windows.h"
#include "distance_shapes.h"
#include "plane/query/topology.h"

namespace findspace::distance {
namespace distance_level_windows {

using namespace findspace::testing;
using exact::Real;
using plane::CellComplex;
using plane::Mark;
using plane::Region;

/// A star with uneven peaks.
Region star(int corners, double size) {
  plane::Contour c;
  for (int k = 0; k < corners; ++k) {
    const double radius = size * (k % 2 == 0 ? 0.8 : 0.9 + 0.1 * ((k * k * 7919 + k * 1047) % 1009) / 1009);
    const double angle = 2 * M_PI * (k + 0.2 * ((k * k * 523 + k * 31) % 503) / 503) / corners;
    c.push_back({.start = {std::llround(radius * std::cos(angle)), std::llround(radius * std::sin(angle))}});
  }
  return plane::region_of_rings({&c, 1});
}

/// Whether two complexes have one mark everywhere.
bool agree(const CellComplex& a, const CellComplex& b) {
  const std::array<const CellComplex*, 2> both{&a, &b};
  return plane::is_empty(plane::overlay(both, [](std::span<const Mark> m) { return Mark(m[0] != m[1]); }));
}

/// Levels around the best one, in windows and in the whole plane.
void expect_same(const TDistance& f, const Region& over, int rotation, const exact::RealPoint& start,
                 double part_of_level) {
  auto cover = LevelCover::of(f, over, rotation, start);
  ASSERT_TRUE(cover.has_value());
  const double size = std::max(std::abs(cover->low()), std::abs(cover->high()));
  ASSERT_TRUE(cover->narrow(size * part_of_level, size * part_of_level / 2));
  EXPECT_EQ(cover->is_passed(Real::from_double(rotation * (cover->high() + 1))), true);
  EXPECT_EQ(cover->is_passed(Real::from_double(rotation * (cover->low() - 1))), false);
  LevelWindows windows(f, over, rotation);
  windows.open(cover->boxes(), Real::from_double(rotation * cover->most()), cover->low());
  const double low = cover->low(), most = cover->most();
  bool held = false;
  for (const double part : {1.0, 0.5, 0.25, 0.75, 0.125, -0.5}) {
    const Real level = Real::from_double(rotation * (low + part * (most - low)));
    if (!windows.hold(level)) continue;
    const auto found = windows.probe(level, over);
    ASSERT_TRUE(found.has_value());
    held = true;
    EXPECT_TRUE(agree(*found, probe(f, level, over, rotation))) << part;
    if (part > 0 && part < 1 && !plane::is_empty(*found)) windows.shrink(*found, level, low);
  }
  EXPECT_TRUE(held) << low << " " << most;
}

TEST(LevelWindows, SameCellsAsTheWholePlane) {
  const Region whole = CellComplex::uniform(1);
  const ShapePair apart(star(20, 9000), star(24, 10000)), inside(star(20, 5000), star(24, 10000));
  for (const auto& f : {apart.distance(Which::kGamma1), inside.distance(Which::kEta1), inside.distance(Which::kMu)})
    expect_same(*f, whole, 1, f->seed(), 0x1p-6);
  const ShapePair alike(star(40, 100000), star(50, 100000));
  const auto f = alike.distance(Which::kHausdorff);
  expect_same(*f, whole, 1, f->seed(), 0x1p-10);
}

TEST(LevelWindows, OverASet) {
  const ShapePair apart(star(20, 2000), star(24, 10000));
  const Region over = polygon({{13000, 1000}, {16000, 2000}, {14000, 6000}});
  for (const int rotation : {1, -1})
    expect_same(*apart.distance(Which::kGamma1), over, rotation, at(13000, 1000), 0x1p-6);
  const ShapePair alike(star(40, 100000), star(50, 100000));
  const Region near = polygon({{-4000, -3000}, {4000, -4000}, {500, 6000}});
  expect_same(*alike.distance(Which::kHausdorff), near, 1, at(-4000, -3000), 0x1p-10);
}

TEST(LevelWindows, NotWhereItIsNotKnownHowFarToLook) {
  const ShapePair pair(star(90, 2000), star(120, 10000));
  const auto f = pair.distance(Which::kGamma1);
  EXPECT_FALSE(LevelCover::of(*f, CellComplex::uniform(1), -1, at(0, 0)).has_value());
  EXPECT_FALSE(LevelCover::of(*pair.distance(Which::kGamma2), CellComplex::uniform(1), 1, at(0, 0)).has_value());
}

/// Joined pair by pair until no two meet, boxes are the same whatever the order.
TEST(LevelWindows, BoxesThatMeetAreJoined) {
  const auto by_pairs = [](std::vector<plane::PieceBox> boxes) {
    for (std::size_t i = 0; i < boxes.size(); ++i)
      for (std::size_t k = 0; k < i; ++k)
        if (boxes[i].meets(boxes[k])) {
          boxes[k] = plane::joined(boxes[k], boxes[i]);
          boxes.erase(boxes.begin() + std::ptrdiff_t(i));
          i = k = 0;
        }
    return boxes.size();
  };
  for (int count : {0, 1, 7, 60, 200})
    for (int spread : {20, 60, 400}) {
      std::vector<plane::PieceBox> boxes;
      for (int k = 0; k < count; ++k) {
        const double x = k * k * 7919 % spread, y = k * 1047 % spread;
        boxes.push_back({x, y, x + k % 4, y + k % 3});
      }
      const auto apart = boxes_apart(boxes);
      EXPECT_EQ(apart.size(), by_pairs(boxes)) << count << " " << spread;
      for (std::size_t i = 0; i < apart.size(); ++i)
        for (std::size_t k = 0; k < i; ++k) EXPECT_TRUE(!apart[i].meets(apart[k]) && apart[k].x0 <= apart[i].x0);
      for (const plane::PieceBox& b : boxes)
        EXPECT_EQ(std::count_if(apart.begin(), apart.end(), [&](const plane::PieceBox& a) { return a.meets(b); }), 1);
    }
}

}  // namespace distance_level_windows
}  // namespace findspace::distance
