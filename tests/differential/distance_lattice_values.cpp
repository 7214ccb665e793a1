// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Values of gamma1 (depths too), eta1, delta1 and of gamma2, eta2, delta2 against their definitions, by looking at
// every position that can decide. Shapes are sets of unit cells, so the sets X, E, D of positions (the shapes meet, B
// in A, A in B) and their interiors are made of cells of the integer lattice; the nearest position of such a set has
// each coordinate from p or whole, the farthest has whole ones. Exact, with slits, exact fits and single positions.
#include <gtest/gtest.h>

#include <array>
#include <optional>
#include <random>
#include <set>

#include "distance/planar/at_position.h"
#include "plane/walk/unite.h"
#include "unit/distance_shapes.h"

namespace findspace::distance {
namespace distance_lattice_values {

using exact::Real;
using exact::RealPoint;
using Cell = std::array<int, 2>;
using Cells = std::set<Cell>;
using Quarters = std::array<int, 2>;  // a position, in quarters

constexpr int kSide = 4, kFar = 2 * kSide + 2;

/// Whether a cell of `cells` and one with `other` meet when the cells of B are moved by q; `sense` is +1 where `cells`
/// are those of A, -1 where they are those of B. Reach 4: their insides meet; 5: they meet.
template <class Other>
bool any_meet(const Cells& cells, Other other, const Quarters& q, int sense, int reach) {
  for (const Cell& x : cells) {
    for (int dx = -kFar; dx <= kFar; ++dx) {
      if (std::abs(4 * dx + sense * q[0]) >= reach) continue;
      for (int dy = -kFar; dy <= kFar; ++dy) {
        if (std::abs(4 * dy + sense * q[1]) < reach && other({x[0] + dx, x[1] + dy})) return true;
      }
    }
  }
  return false;
}

/// The open and the closed set of positions of one family (distances.md 3.1), decided by cells.
struct Family {
  Cells a, b;
  Which which;

  /// Of gamma1: the shapes meet; else B reaches out of A, or A out of B.
  bool meet(const Quarters& q, int reach) const {
    const auto in_b = [&](const Cell& c) { return b.contains(c); };
    const auto not_a = [&](const Cell& c) { return !a.contains(c); };
    const auto not_b = [&](const Cell& c) { return !b.contains(c); };
    if (which == Which::kGamma1) return any_meet(a, in_b, q, 1, reach);
    return which == Which::kEta1 ? any_meet(b, not_a, q, -1, reach) : any_meet(a, not_b, q, 1, reach);
  }
  bool in_closed(const Quarters& q) const { return which == Which::kGamma1 ? meet(q, 5) : !meet(q, 4); }
  bool in_open(const Quarters& q) const { return which == Which::kGamma1 ? meet(q, 4) : !meet(q, 5); }
};

struct Wanted {
  std::optional<Real> squared_signed;  // sign times the square of the value; nothing if undefined
  int squared_farthest = -1;           // in sixteenths; -1: undefined
};

Wanted wanted(const Family& f, const Quarters& p) {
  const bool inside = f.in_open(p), member = inside || f.in_closed(p);
  int nearest = -1;
  Wanted out;
  for (int x = -4 * kFar - 4; x <= 4 * kFar; x += 4) {
    for (int y = -4 * kFar - 4; y <= 4 * kFar; y += 4) {
      // The least column and row stand for p's own coordinates.
      const Quarters q{x < -4 * kFar ? p[0] : x, y < -4 * kFar ? p[1] : y};
      const int square = (q[0] - p[0]) * (q[0] - p[0]) + (q[1] - p[1]) * (q[1] - p[1]);
      const bool closed = f.in_closed(q);
      if (closed) out.squared_farthest = std::max(out.squared_farthest, square);
      const bool wanted = inside ? !f.in_open(q) : closed;
      if (wanted && (nearest < 0 || square < nearest)) nearest = square;
    }
  }
  if (out.squared_farthest < 0) return out;
  const int sign = inside ? -1 : member ? 0 : 1;
  out.squared_signed = Real::ratio(sign * nearest, 16);
  return out;
}

class Polyominoes {
 public:
  explicit Polyominoes(unsigned seed) : random_(seed) {}
  int number(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }
  Quarters position() { return {number(-4 * kSide, 4 * kSide), number(-4 * kSide, 4 * kSide)}; }
  /// Up to `side` cells wide and high, most or few of them filled.
  Cells cells(int side, int percent) {
    Cells out{{number(0, side - 1), number(0, side - 1)}};
    for (int x = 0; x < side; ++x) {
      for (int y = 0; y < side; ++y) {
        if (number(0, 99) < percent) out.insert({x, y});
      }
    }
    return out;
  }

 private:
  std::mt19937 random_;
};

plane::Region region(const Cells& cells) {
  std::vector<plane::Region> boxes;
  for (const Cell& c : cells) boxes.push_back(testing::box(c[0], c[1], c[0] + 1, c[1] + 1));
  std::vector<const plane::Region*> all;
  for (const plane::Region& b : boxes) all.push_back(&b);
  return plane::unite(all);
}

void compare_values(const AtPosition& pair, const Family& family, Which farthest, const Quarters& p) {
  const RealPoint at{Real::ratio(p[0], 4), Real::ratio(p[1], 4)};
  const Wanted want = wanted(family, p);
  for (const bool by_map : {false, true}) {
    std::optional<Real> near, far;
    if (by_map) {
      if (const auto v = pair.pair().distance(family.which)->value(at)) near = v->value;
      if (const auto v = pair.pair().distance(farthest)->value(at)) far = v->value;
    } else {
      if (const auto m = pair.measure(family.which, at)) near = m->value;
      if (const auto m = pair.measure(farthest, at)) far = m->value;
    }
    ASSERT_EQ(near.has_value(), want.squared_signed.has_value());
    ASSERT_EQ(far.has_value(), want.squared_farthest >= 0);
    if (!near) return;
    ASSERT_EQ(Real(near->sign()) * *near * *near, *want.squared_signed) << near->text();
    ASSERT_EQ(*far * *far, Real::ratio(want.squared_farthest, 16)) << far->text();
  }
}

TEST(LatticeValues, AreThoseOfTheDefinitions) {
  Polyominoes random(9);
  int depths = 0, margins = 0;
  for (int round = 0; round < 60; ++round) {
    // A large full shape and a small one: containment is common, with slits and single positions.
    const bool roomy = round % 2 == 1, swap = round % 4 == 3;
    Cells a = random.cells(kSide, roomy ? 88 : 50), b = random.cells(roomy ? 2 : kSide, roomy ? 40 : 50);
    if (swap) std::swap(a, b);
    const AtPosition pair(std::make_shared<ShapePair>(region(b), region(a)));
    for (int i = 0; i < 6; ++i) {
      const Quarters p = random.position();
      for (const auto& [which, farthest] : {std::pair{Which::kGamma1, Which::kGamma2},
                                            {Which::kEta1, Which::kEta2},
                                            {Which::kDelta1, Which::kDelta2}}) {
        const Family family{a, b, which};
        compare_values(pair, family, farthest, p);
        if (HasFatalFailure()) FAIL() << "round " << round << ", which " << static_cast<int>(which);
        (which == Which::kGamma1 ? depths : margins) += family.in_open(p);
      }
    }
  }
  EXPECT_GT(depths, 60);
  EXPECT_GT(margins, 5);
}

}  // namespace distance_lattice_values
}  // namespace findspace::distance
