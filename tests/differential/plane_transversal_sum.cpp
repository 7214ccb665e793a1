// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Sums by walks along outer sides, without an arrangement, against the arrangement of the whole convolution, cell by
// cell, on polygons over few lattice points: their curves run along each other both ways, meet many at a point, and
// leave slots of no width and single points. Where the walks give nothing, the sum has a place that rings alone cannot
// state. The same with curves that overlap made one, walked and arranged.

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <random>
#include <set>

#include "differential/whole_sum.h"
#include "findspace/error.h"
#include "plane/contour/contour.h"
#include "plane/grid/grid_faces.h"
#include "plane/grid/merged_curves.h"
#include "plane/grid/prune_inside.h"
#include "plane/grid/transversal_sum.h"
#include "plane/query/topology.h"
#include "plane/sum/minkowski.h"
#include "plane/sum/pair_sums.h"
#include "plane/walk/meeting_curves.h"

namespace findspace::plane {
namespace plane_transversal_sum {

struct Count {
  int sums = 0, walked = 0;                       // without an arrangement
  int doubled = 0, doubled_and_walked = 0;        // with curves that run along each other the other way
  int degenerate = 0, degenerate_and_walked = 0;  // with places where inner sides surround a point
  int merged = 0;                                 // with curves that overlap with one inner side
};

/// Does every boundary vertex have two edges, so that rings that touch nowhere are the whole boundary?
bool is_rings(const SignMap& map) {
  return std::all_of(map.vertices.begin(), map.vertices.end(), [&](const Vertex& v) {
    return v.out != kNone && map.clockwise(v.out) != v.out && map.clockwise(map.clockwise(v.out)) == v.out;
  });
}

void compare(const Region& a, const Region& b, const std::string& what, Count& count) {
  const auto p = grid_faces(a, in, false), q = grid_faces(b, in, true);
  if (!p || !q || p->size() != 1 || q->size() != 1) return;
  const GridOperand x{*p, a.geometry}, y{*q, b.geometry};
  const Operand first{a, in}, second{b, in, true};
  const ConvolutionIndex index(x, y);
  ReducedConvolution curves = reduced_convolution(x, y), merged = merged_curves(reduced_convolution(x, y));
  DirectedCurves same = curves, arranged = merged;
  const MeetingCurves meeting(same, kHeap);
  const DegenerateVertices& degenerate_vertices = meeting.degenerate_vertices();
  bool doubled = !meeting.parts_with_two_inner_sides().empty(), degenerate = false;
  for (Index k = 0; k < degenerate_vertices.count(); ++k) degenerate |= degenerate_vertices.is_surrounded(k);
  count.merged += merged.pieces.size() < curves.pieces.size();
  const auto inside = [&]() -> InsideTest {  // for one geometry
    return [solid = std::make_shared<SolidSum>(first, second, index)](exact::Geometry& g, Index point) {
      return solid->holds(g, point);
    };
  };
  const auto sum = transversal_sum(curves, inside()), of_merged = transversal_sum(merged, inside());
  ++count.sums;
  count.walked += sum.has_value();
  count.doubled += doubled;
  count.doubled_and_walked += doubled && sum;
  count.degenerate += degenerate;
  count.degenerate_and_walked += degenerate && sum;
  const SignMap map = contact_map(a, b);
  const Region whole = whole_sum(a, in, b);
  expect_same(map, -1, whole, what);
  if (sum) expect_same(*sum, -1, whole, what + ", walked");
  EXPECT_EQ(sum.has_value(), is_rings(map)) << what;
  if (of_merged) expect_same(*of_merged, -1, whole, what + ", merged and walked");
  EXPECT_EQ(of_merged.has_value(), sum.has_value()) << what << ", merged";
  Arrangement cells = arrange(std::move(arranged.geometry), std::move(arranged.pieces));
  expect_same(labelled_sum(std::move(cells), arranged.sides, false, inside()), -1, whole,
              what + ", merged and arranged");
}

std::optional<Region> region_of(const std::vector<GridPoint>& points) {
  std::vector<Contour> rings(1);
  for (const GridPoint& p : points) rings[0].push_back({.start = p});
  try {
    return region_of_rings(make_rings(rings, 1).contours);
  } catch (const Error&) {
    return std::nullopt;  // it touches itself or is flat
  }
}

bool proper_crossing(GridPoint a, GridPoint b, GridPoint c, GridPoint d) {
  auto side = [](GridPoint p, GridPoint q, GridPoint r) {
    const std::int64_t s = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
    return (s > 0) - (s < 0);
  };
  return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

/// Corners from a small lattice in any order, uncrossed by rotating stretches round.
std::optional<Region> lattice_polygon(std::mt19937& rng, int side, int corners, std::int64_t step) {
  std::vector<GridPoint> points;
  for (std::int64_t x = 0; x < side; ++x)
    for (std::int64_t y = 0; y < side; ++y) points.push_back({x * step, y * step});
  std::shuffle(points.begin(), points.end(), rng);
  points.resize(std::size_t(corners));
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 0; i + 2 < points.size(); ++i)
      for (std::size_t j = i + 2; j < points.size(); ++j)
        if (proper_crossing(points[i], points[i + 1], points[j], points[(j + 1) % points.size()])) {
          std::reverse(points.begin() + std::ptrdiff_t(i) + 1, points.begin() + std::ptrdiff_t(j) + 1);
          changed = true;
        }
  }
  return region_of(points);
}

/// Triangles of the lattice of unit squares cut along one diagonal, joined edge to edge: three directions of edges
/// only.
Region grown_triangles(std::mt19937& rng, int count, std::int64_t step) {
  std::set<std::array<std::int64_t, 3>> cells{{0, 0, 0}};  // x, y, below the diagonal or above it
  std::vector<Region> parts;
  while (int(cells.size()) < count) {
    auto [x, y, above] = *std::next(cells.begin(), std::ptrdiff_t(rng() % cells.size()));
    switch (rng() % 3) {
      case 0:
        break;  // across the diagonal
      case 1:
        above ? --x : ++x;
        break;
      default:
        above ? ++y : --y;
    }
    cells.insert({x, y, 1 - above});
  }
  for (const auto& [x, y, above] : cells) {
    const GridPoint p{x * step, y * step}, q{(x + 1) * step, (y + 1) * step};
    parts.push_back(above ? ring({p, q, {p.x, q.y}}) : ring({p, {q.x, p.y}, q}));
  }
  return united(parts);
}

/// A frame round a hole of the shape of a set: no position but one lets the set into it.
Region framed_hole(const Region& a) {
  const Region frame = ring({{-100, -100}, {100, -100}, {100, 100}, {-100, 100}});
  const std::array<const CellComplex*, 2> both{&frame, &a};
  return closure(overlay(both, [](std::span<const Mark> marks) { return Mark(marks[0] > 0 && marks[1] <= 0); }));
}

TEST(TransversalSum, LatticePolygons) {
  Count count;
  for (unsigned seed = 0; seed < 4000; ++seed) {
    std::mt19937 rng(seed);
    const int side = 3 + int(seed % 3);
    auto a = lattice_polygon(rng, side, 4 + int(rng() % 6), 4), b = lattice_polygon(rng, side, 3 + int(rng() % 6), 4);
    if (a && b) compare(*a, *b, "seed " + std::to_string(seed), count);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(count.walked, 1000);
}

TEST(TransversalSum, ThreeDirections) {
  Count count;
  for (unsigned seed = 0; seed < 2500; ++seed) {
    std::mt19937 rng(seed);
    const Region a = grown_triangles(rng, 4 + int(rng() % 60), 4), b = grown_triangles(rng, 1 + int(rng() % 24), 4);
    compare(a, b, "seed " + std::to_string(seed), count);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(count.doubled_and_walked, 200);
  EXPECT_GT(count.degenerate_and_walked, 300);
  EXPECT_GT(count.sums - count.walked, 100);
  EXPECT_GT(count.merged, 1000);
}

TEST(TransversalSum, ExactFits) {
  Count count;
  for (unsigned seed = 0; seed < 300; ++seed) {
    std::mt19937 rng(seed);
    const Region a = grown_triangles(rng, 1 + int(rng() % 12), 4);
    compare(framed_hole(a), a, "seed " + std::to_string(seed), count);
    if (HasFatalFailure()) return;
  }
  EXPECT_EQ(count.walked, 0);
  EXPECT_GT(count.doubled, 100);
}

/// Teeth one or two steps wide and apart, so that those of one comb fit between those of another exactly.
Region lattice_comb(std::mt19937& rng, int teeth, std::int64_t step) {
  std::vector<GridPoint> points{{0, 0}};
  std::int64_t x = 0;
  for (int k = 0; k < teeth; ++k) {
    const std::int64_t width = step * std::int64_t(1 + rng() % 2), gap = step * std::int64_t(1 + rng() % 2);
    const std::int64_t height = step * std::int64_t(4 + rng() % 4);
    points.insert(points.end(), {{x, -height}, {x + width, -height}, {x + width, 0}, {x + width + gap, 0}});
    x += width + gap;
  }
  points.insert(points.end(), {{x, step}, {0, step}});
  points.erase(points.begin());
  return ring(points);
}

TEST(TransversalSum, CombsCutBack) {
  for (unsigned seed = 0; seed < 8; ++seed) {
    std::mt19937 rng(seed);
    const Region a = lattice_comb(rng, 12, 1000), b = lattice_comb(rng, 10, 1000);
    const auto p = grid_faces(a, in, false), q = grid_faces(b, in, true);
    const GridOperand x{*p, a.geometry}, y{*q, b.geometry};
    ASSERT_TRUE(mask_that_pays(reduced_convolution(x, y), x, y));
    expect_same(contact_map(a, b), -1, whole_sum(a, in, b), "seed " + std::to_string(seed));
    expect_same(contact_map(a, mirrored(b)), -1, whole_sum(a, in, mirrored(b)),
                "mirrored, seed " + std::to_string(seed));
    if (HasFatalFailure()) return;
  }
}

}  // namespace plane_transversal_sum
}  // namespace findspace::plane
