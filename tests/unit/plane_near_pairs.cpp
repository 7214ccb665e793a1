// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The pairs of curves of an offset that may meet, against all pairs of boxes: on round shapes, whose curves go on in
// one quadrant for long, and on stars, where they do not; from outside and from inside. And their order.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "plane/complex/primitives.h"
#include "plane/complex/sequence_boxes.h"
#include "plane/contour/contour.h"
#include "plane/offset/near_pairs.h"
#include "plane/query/topology.h"

namespace findspace::plane {
namespace plane_near_pairs {

template <class Distance>
Region around_origin(int corners, Distance distance) {
  std::vector<Contour> rings(1);
  for (int k = 0; k < corners; ++k) {
    const double angle = 6.283185307179586 * k / corners, r = distance(k, angle);
    rings[0].push_back({.start = {std::llround(r * std::cos(angle)), std::llround(r * std::sin(angle))}});
  }
  return region_of_rings(make_rings(std::move(rings), 1).contours);
}

Region lobes(int corners) {
  return around_origin(corners, [](int k, double angle) {
    return 1e6 * (0.7 + 0.2 * std::cos(3 * angle) + 0.03 * std::cos(11 * angle)) + k * 7919 % 100;
  });
}

Region star(int corners) {
  return around_origin(corners, [](int k, double) { return (k % 2 ? 6e5 : 1e6) + k * 7919 % 1000; });
}

Region cross() {
  std::vector<Contour> rings(1);
  for (const auto& [x, y] : {std::pair{1, 3},
                             {-1, 3},
                             {-1, 1},
                             {-3, 1},
                             {-3, -1},
                             {-1, -1},
                             {-1, -3},
                             {1, -3},
                             {1, -1},
                             {3, -1},
                             {3, 1},
                             {1, 1}})
    rings[0].push_back({.start = {x * 1000, y * 1000}});
  return region_of_rings(make_rings(std::move(rings), 1).contours);
}

/// The place of each pair in a tree over all pieces.
std::map<std::pair<Index, Index>, std::size_t> order_in_tree(std::size_t pieces) {
  std::map<std::pair<Index, Index>, std::size_t> order;
  SequenceBoxes(std::vector<PieceBox>(pieces, PieceBox{0, 0, 1, 1})).meeting_pairs([&](Index i, Index j) {
    order.emplace(std::pair{i, j}, order.size());
  });
  return order;
}

/// How many pairs of boxes meet.
void expect_all_in_order(const Region& set, std::int64_t r, int& count) {
  const exact::Real radius(r);
  const GridCorners corners = all_corners(*grid_faces(set, is_in, false));
  OffsetEdges edges(corners, radius);
  const OffsetCurves curves = offset_curves(corners, set.geometry, radius, edges);
  const std::vector<PiecePair> pairs = near_pairs(curves);
  const auto order = order_in_tree(curves.pieces.size());
  std::size_t last = 0;
  std::vector<std::size_t> found;
  for (const auto& [i, j] : pairs) {
    found.push_back(order.at({i, j}));
    ASSERT_TRUE(found.size() == 1 || last < found.back());
    last = found.back();
  }
  const auto follows = [&](Index i, Index j) { return curves.origins[i].next == j || curves.origins[j].next == i; };
  for (Index i = 0; i < curves.pieces.size(); ++i) {
    bool one_row = true;
    const PieceBox box = box_of(curves.geometry, curves.pieces[i], 0);
    for (Index j = i + 1; j < curves.pieces.size(); ++j) {
      one_row = one_row && curves.origins[j - 1].next == j && curves.origins[j - 1].right == curves.origins[j].right;
      if (one_row || follows(i, j) || !box.meets(box_of(curves.geometry, curves.pieces[j], 0))) continue;
      ++count;
      ASSERT_TRUE(std::binary_search(found.begin(), found.end(), order.at({i, j}))) << i << ' ' << j;
    }
  }
}

TEST(NearPairs, HoldAllInTheOrderOfATree) {
  int of_lobes = 0, of_stars = 0, of_cross = 0;
  for (const int corners : {40, 400}) {
    expect_all_in_order(lobes(corners), 20000, of_lobes);
    expect_all_in_order(closure(complement(lobes(corners))), 200000, of_lobes);
    expect_all_in_order(star(corners), 20000, of_stars);
    expect_all_in_order(closure(complement(star(corners))), 20000, of_stars);
  }
  expect_all_in_order(cross(), 900, of_cross);
  expect_all_in_order(closure(complement(cross())), 1100, of_cross);
  EXPECT_GT(of_lobes, 100);
  EXPECT_GT(of_stars, 100);
  EXPECT_GT(of_cross, 0);
}

}  // namespace plane_near_pairs
}  // namespace findspace::plane
