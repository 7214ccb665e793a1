// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The pruned sum against the whole convolution, cell by cell, on shapes full of ties (lattice squares, with holes and
// slots), on random triangles and on stars whose convolution is really pruned.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "plane/overlay.h"
#include "plane/primitives.h"
#include "plane/pruned_sum.h"

namespace findspace::plane {
namespace {

Region ring(const std::vector<GridPoint>& points) {
  Contour c;
  for (auto& p : points) c.push_back({.start = p});
  return region_of_rings(std::array{c});
}

Region united(const std::vector<Region>& parts) {
  std::vector<const Region*> all;
  for (auto& r : parts) all.push_back(&r);
  return unite(all);
}

Region squares(std::mt19937& rng, int cells, int count, std::int64_t side) {
  std::vector<Region> parts;
  for (int k = 0; k < count; ++k) {
    std::int64_t x = side * std::int64_t(rng() % cells), y = side * std::int64_t(rng() % cells);
    parts.push_back(ring({{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}}));
  }
  return united(parts);
}

Region triangles(std::mt19937& rng, std::int64_t size, int count) {
  std::vector<Region> parts;
  while (int(parts.size()) < count) {
    GridPoint p[3];
    for (auto& v : p) v = {std::int64_t(rng() % 9) * size, std::int64_t(rng() % 9) * size};
    std::int64_t area = (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[1].y - p[0].y) * (p[2].x - p[0].x);
    if (area == 0) continue;
    if (area < 0) std::swap(p[1], p[2]);
    parts.push_back(ring({p[0], p[1], p[2]}));
  }
  return united(parts);
}

Region star(std::mt19937& rng, int n) {
  std::vector<GridPoint> points;
  for (int k = 0; k < n; ++k) {
    double r = (k % 2 ? 300 + rng() % 200 : 800 + rng() % 200) * 1000.0, angle = 6.283185307179586 * k / n;
    points.push_back({std::int64_t(r * std::cos(angle)), std::int64_t(r * std::sin(angle))});
  }
  return ring(points);
}

Outline outline(const Part& part) {
  Outline out;
  for (const Path& path : part.paths)
    for (const Step& s : path.steps)
      out.push_back({s.from.approx_x(), s.from.approx_y(), s.to.approx_x(), s.to.approx_y()});
  return out;
}

/// Both ways from the same convolution; holes bridged. The shapes must be made of grid segments.
void compare(const Region& a, const Region& b, const std::string& what) {
  auto in = [](Mark m) { return m > 0; };
  ConvolutionBuilder whole(true);
  std::vector<Outline> outlines;
  for (const Part& p : face_parts(a, in))
    for (const Part& q : face_parts(b, in)) {
      Part turned = mirrored(q);
      whole.add(bridged(p, 0), bridged(turned, 0));
      outlines.push_back(outline(p));
      outlines.push_back(outline(turned));
    }
  std::vector<InnerMask::Pair> pairs;
  for (std::size_t k = 0; k < outlines.size(); k += 2) pairs.push_back({&outlines[k], &outlines[k + 1]});
  for (const exact::Carrier& k : whole.curves.geometry.carriers)
    if (k.circle || !k.grid) return;  // a bridge left the grid
  SignMap pruned = pruned_open_sum(whole, 0, pairs);
  Arrangement arranged = arrange(whole.curves.geometry, whole.curves.pieces);
  Windings w = windings(arranged, whole.strands, whole.corners, 0);
  Marks m;
  for (auto k : w.faces) m.faces.push_back(k > 0);
  for (auto k : w.edges) m.edges.push_back(k > 0);
  for (auto k : w.vertices) m.vertices.push_back(k != kUnwanted && k > 0);
  Region expected = extract(arranged, m);
  std::array<const CellComplex*, 2> both{&pruned, &expected};
  Region difference = overlay(both, [](std::span<const Mark> marks) { return Mark((marks[0] < 0) != (marks[1] > 0)); });
  ASSERT_TRUE(difference.faces.size() == 1 && difference.faces[0].mark == 0 && difference.edges.empty() &&
              difference.vertices.empty())
      << what;
}

TEST(PrunedSum, SquaresWithSlotsAndHoles) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    std::mt19937 rng(seed);
    std::int64_t side = seed % 2 ? 4 : 1000;
    compare(squares(rng, 5, 3 + rng() % 14, side), squares(rng, 3, 1 + rng() % 6, side),
            "seed " + std::to_string(seed));
    if (HasFatalFailure()) return;
  }
}

TEST(PrunedSum, Triangles) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    std::mt19937 rng(seed);
    std::int64_t size = seed % 2 ? 60 : 1000;
    compare(triangles(rng, size, 1), triangles(rng, size, 1), "seed " + std::to_string(seed));
    if (HasFatalFailure()) return;
  }
}

TEST(PrunedSum, Stars) {
  for (unsigned seed = 0; seed < 12; ++seed) {
    std::mt19937 rng(seed);
    compare(star(rng, 12 + 4 * int(seed)), star(rng, 40 - 2 * int(seed)), "seed " + std::to_string(seed));
    if (HasFatalFailure()) return;
  }
}

}  // namespace
}  // namespace findspace::plane
