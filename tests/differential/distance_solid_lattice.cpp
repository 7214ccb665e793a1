// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Box unions against the definition on a lattice: shapes are sets of half-unit cells, so whether interiors meet,
// whether the shapes meet, and whether one lies in the other (or in its interior) is decided by looking at every cell.
#include <gtest/gtest.h>

#include <set>

#include "distance/solid/box_maps.h"
#include "distance/solid/solid_pair.h"
#include "unit/space_bodies.h"

namespace findspace::distance {
namespace distance_solid_lattice {

using Cell = std::array<std::int64_t, 3>;
using Cells = std::set<Cell>;

/// Half-unit cells (by their lower corners in half units) of boxes moved by `by` half units.
Cells cells_of(const std::vector<space::Corners>& boxes, const Cell& by) {
  Cells out;
  for (const space::Corners& c : boxes) {
    for (std::int64_t x = 2 * c[0][0]; x < 2 * c[1][0]; ++x) {
      for (std::int64_t y = 2 * c[0][1]; y < 2 * c[1][1]; ++y) {
        for (std::int64_t z = 2 * c[0][2]; z < 2 * c[1][2]; ++z) out.insert({x + by[0], y + by[1], z + by[2]});
      }
    }
  }
  return out;
}

template <class Visit>
void around(const Cell& c, Visit visit) {
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = -1; z <= 1; ++z) visit(Cell{c[0] + x, c[1] + y, c[2] + z});
    }
  }
}

int overlap_sign(const Cells& b, const Cells& a) {
  int sign = 1;
  for (const Cell& c : b) {
    if (a.contains(c)) return -1;
    around(c, [&](const Cell& n) {
      if (a.contains(n)) sign = 0;
    });
  }
  return sign;
}

int inside_sign(const Cells& b, const Cells& a) {
  int sign = -1;
  for (const Cell& c : b) {
    if (!a.contains(c)) return 1;
    around(c, [&](const Cell& n) {
      if (!a.contains(n)) sign = 0;
    });
  }
  return sign;
}

int sign_of(const std::optional<Answer>& v) { return v ? v->value.sign() : 1; }

TEST(SolidLattice, SignsByTheDefinition) {
  std::mt19937 random(51);
  const auto pick = [&](int a, int b) { return std::uniform_int_distribution<int>(a, b)(random); };
  int contacts = 0, fits = 0;
  for (int round = 0; round < 250; ++round) {
    const auto a = space::random_boxes(random, 4, 5), b = space::random_boxes(random, 2, 2);
    const PairDistances bodies = solid_pair(shared(space::box_body(b)), shared(space::box_body(a)));
    const BoxMaps boxes(space::box_set(b), space::box_set(a));
    const Cells fixed = cells_of(a, {0, 0, 0});
    for (int i = 0; i < 12; ++i) {
      const Cell by{pick(-4, 10), pick(-4, 10), pick(-4, 10)};
      const space::RealVector p = space::place(by[0], by[1], by[2], 2);
      const Cells moved = cells_of(b, by);
      const int gamma1 = overlap_sign(moved, fixed), eta1 = inside_sign(moved, fixed),
                delta1 = inside_sign(fixed, moved);
      contacts += gamma1 == 0;
      fits += eta1 <= 0;
      ASSERT_EQ(sign_of(bodies.value(Which::kGamma1, p)), gamma1);
      ASSERT_EQ(boxes.sign_map(Which::kGamma1, 0)->mark(p), gamma1);
      ASSERT_EQ(boxes.sign_map(Which::kEta1, 0)->mark(p), eta1);
      ASSERT_EQ(boxes.sign_map(Which::kDelta1, 0)->mark(p), delta1);
      ASSERT_EQ(sign_of(bodies.value(Which::kEta1, p)), eta1);
      ASSERT_EQ(sign_of(bodies.value(Which::kDelta1, p)), delta1);
    }
  }
  EXPECT_GT(contacts, 20);
  EXPECT_GT(fits, 20);
}

/// mu by the definition: the farthest of the points of a fine lattice of B + p from the nearest of A's boxes.
TEST(SolidLattice, DirectedHausdorffDistance) {
  std::mt19937 random(52);
  const auto pick = [&](int a, int b) { return std::uniform_int_distribution<int>(a, b)(random); };
  constexpr int kFine = 6;
  for (int round = 0; round < 12; ++round) {
    const auto a = space::random_boxes(random, 4, 5), b = space::random_boxes(random, 2, 4);
    const PairDistances bodies = solid_pair(shared(space::box_body(b)), shared(space::box_body(a)));
    const Cell by{pick(-3, 5), pick(-3, 5), pick(-3, 5)};
    double most = 0;
    for (const space::Corners& c : b) {
      for (std::int64_t x = kFine * c[0][0]; x <= kFine * c[1][0]; ++x) {
        for (std::int64_t y = kFine * c[0][1]; y <= kFine * c[1][1]; ++y) {
          for (std::int64_t z = kFine * c[0][2]; z <= kFine * c[1][2]; ++z) {
            const std::array<double, 3> q{double(x) / kFine + double(by[0]), double(y) / kFine + double(by[1]),
                                          double(z) / kFine + double(by[2])};
            double least = 1e9;
            for (const space::Corners& t : a) {
              double square = 0;
              for (std::size_t k = 0; k < 3; ++k) {
                const double gap = std::max({double(t[0][k]) - q[k], q[k] - double(t[1][k]), 0.0});
                square += gap * gap;
              }
              least = std::min(least, square);
            }
            most = std::max(most, least);
          }
        }
      }
    }
    most = std::sqrt(most);
    const double mu = bodies.value(Which::kMu, space::place(by[0], by[1], by[2]))->value.to_double();
    if (most == 0) {
      ASSERT_LE(mu, 0.87 / kFine);
      continue;
    }
    // The lattice comes within half a cell's diagonal of every point of B.
    ASSERT_GE(mu, most * (1 - 0x1p-36));
    ASSERT_LE(mu, most + 0.87 / kFine);
  }
}

}  // namespace distance_solid_lattice
}  // namespace findspace::distance
