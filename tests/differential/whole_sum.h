// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// For tests of sums: the sum by arranging the whole convolution, cell by cell, to compare with; sums by pairs of parts,
// with and without a mask; and sets full of ties, unions of lattice squares.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "plane/complex/boundary.h"
#include "plane/complex/overlay.h"
#include "plane/complex/primitives.h"
#include "plane/sum/convolution.h"
#include "plane/sum/pair_sums.h"
#include "plane/walk/unite.h"

namespace findspace::plane {

inline bool in(Mark m) { return m > 0; }
inline bool out(Mark m) { return m <= 0; }

inline Region ring(const std::vector<GridPoint>& points) {
  Contour c;
  for (auto& p : points) c.push_back({.start = p});
  return region_of_rings(std::array{c});
}

inline Region united(const std::vector<Region>& parts) {
  std::vector<const Region*> all;
  for (auto& r : parts) all.push_back(&r);
  return unite(all);
}

inline Region squares(std::mt19937& rng, int cells, int count, std::int64_t side) {
  std::vector<Region> parts;
  for (int k = 0; k < count; ++k) {
    std::int64_t x = side * std::int64_t(rng() % cells), y = side * std::int64_t(rng() % cells);
    parts.push_back(ring({{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}}));
  }
  return united(parts);
}

/// The open sum of the faces of A with the given marks and of -B, by arranging the whole convolution; holes bridged.
inline Region whole_sum(const Region& a, bool (*wanted)(Mark), const Region& b) {
  ConvolutionBuilder whole(true);
  std::int32_t base = 0;
  for (const Part& p : face_parts(a, wanted))
    for (const Part& q : face_parts(b, in)) {
      whole.add(bridged(p, 1 << 24), bridged(mirrored(q), 0));
      base += p.unbounded;
    }
  Arrangement arranged = arrange(whole.curves.geometry, whole.curves.pieces);
  Windings w = windings(arranged, whole.chains, whole.corners, base);
  Marks m;
  for (auto k : w.faces) m.faces.push_back(k > 0);
  for (auto k : w.edges) m.edges.push_back(k > 0);
  for (auto k : w.vertices) m.vertices.push_back(k != kUnwanted && k > 0);
  return extract(std::move(arranged), m);
}

/// The open sum by pairs of parts, of all curves, or only of those that a mask leaves.
inline SignMap sum_of_parts(const Operand& a, const Operand& b, const InnerMask* mask) {
  SumOfPairs sum(true);
  const std::vector<Part> p = a.solid_parts(), q = b.solid_parts();
  for (const Part& x : p) {
    for (const Part& y : q) sum.add(x, y);
    for (const Part& y : b.flat_parts()) sum.add(x, y);
  }
  for (const Part& x : a.flat_parts())
    for (const Part& y : q) sum.add(x, y);
  if (mask != nullptr) sum.prune(*mask);
  return std::move(sum).open_sum();
}

inline bool same_marks(const SignMap& p, const SignMap& q) {
  std::array<const CellComplex*, 2> both{&p, &q};
  const Region other = overlay(both, [](std::span<const Mark> m) { return Mark(m[0] != m[1]); });
  return other.faces.size() == 1 && other.faces[0].mark == 0 && other.edges.empty() && other.vertices.empty();
}

inline void expect_same(const SignMap& found, Mark inside, const Region& expected, const std::string& what) {
  std::array<const CellComplex*, 2> both{&found, &expected};
  Region difference =
      overlay(both, [&](std::span<const Mark> marks) { return Mark((marks[0] == inside) != (marks[1] > 0)); });
  ASSERT_TRUE(difference.faces.size() == 1 && difference.faces[0].mark == 0 && difference.edges.empty() &&
              difference.vertices.empty())
      << what;
}

}  // namespace findspace::plane
