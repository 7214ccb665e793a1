// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Positions of contact of two surfaces (surface_contact.h) against depths, distances from fitting and farthest fits by
// convex parts: the same exact values, on lattices, where every contact is degenerate, and in general position, in
// slits and exact fits, at positions on and off the grid. And whether interiors meet there (real_overlap.h).
#include <gtest/gtest.h>

#include <cmath>

#include "differential/space_voxels.h"
#include "distance/solid/solid_pair.h"
#include "distance/surface/surface_contact.h"
#include "space/surface/real_overlap.h"
#include "unit/space_bodies.h"

namespace findspace::distance {
namespace distance_surface_contact {

using exact::Real;
using space::Cells;
using space::LinearMap;
using space::RealVector;
using space::SurfaceSet;
using space::TouchSide;

struct Both {
  Both(const Cells& cells, const LinearMap& map) : body(space::shared(space::body_of(cells, map))) {
    surface.add({space::RaySolid{space::surface(cells, map), {}, {}}}, 1);
  }
  SurfaceSet surface;
  std::shared_ptr<const space::Body> body;
};

struct Counts {
  int depths = 0, fits = 0, none = 0, farthest = 0, bounded = 0, apart = 0;
};

Real distance(const RealVector& p, const RealVector& q) {
  const RealVector way = space::minus(q, p);
  return sqrt(space::dot(way, way));
}

/// The values are equal where both are known exactly.
void expect_same(const SurfaceContact& found, const std::optional<Answer>& wanted, const RealVector& p, int sign,
                 int& count, Counts& counts) {
  ASSERT_TRUE(found.decided);
  ASSERT_EQ(found.place.has_value(), wanted.has_value());
  if (!wanted) {
    ++counts.none;
    return;
  }
  ASSERT_TRUE(wanted->proven);
  const Real value = sign < 0 ? -wanted->value : wanted->value;
  if (found.error > 0) {
    ++counts.bounded;
    ASSERT_NEAR(distance(p, *found.place).to_double(), value.to_double(), found.error * (1 + 0x1p-20));
  } else {
    ++count;
    ASSERT_EQ((distance(p, *found.place) - value).sign(), 0)
        << distance(p, *found.place).to_double() << " " << value.to_double();
  }
}

void compare(const Both& a, const Both& b, const RealVector& p, Counts& counts) {
  const PairDistances pair = solid_pair(b.body, a.body);
  const space::RealOverlap overlap(*a.surface.sheets()[0], *b.surface.sheets()[0], false),
      across(*a.surface.sheets()[0], *b.surface.sheets()[0], true);
  const auto depth = pair.value(Which::kGamma1, p);
  ASSERT_EQ(overlap.interiors_meet(p), depth->value.sign() < 0);
  counts.apart += depth->value.sign() >= 0;
  if (depth->value.sign() < 0) {
    const SurfaceContact found = SurfaceContacts(b.surface, a.surface, TouchSide::kOutside).nearest(p);
    expect_same(found, depth, p, -1, counts.depths, counts);
    if (::testing::Test::HasFatalFailure()) return;
    EXPECT_FALSE(overlap.interiors_meet(*found.place));
    EXPECT_EQ(pair.value(Which::kGamma1, *found.place)->value.sign(), 0);
  }
  const auto fit = pair.value(Which::kEta1, p);
  ASSERT_EQ(across.interiors_meet(p), !fit || fit->value.sign() > 0);
  if (fit && fit->value.sign() <= 0) return;
  expect_same(SurfaceContacts(b.surface, a.surface, TouchSide::kInside).nearest(p), fit, p, 1, counts.fits, counts);
  if (::testing::Test::HasFatalFailure()) return;
  expect_same(SurfaceContacts(b.surface, a.surface, TouchSide::kInside).farthest(p), pair.value(Which::kEta2, p), p, 1,
              counts.farthest, counts);
}

RealVector drawn(std::mt19937& random, int reach) {
  const auto pick = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  const int parts = pick(3) + 1;
  return space::place(pick(2 * reach) - reach, pick(2 * reach) - reach, pick(2 * reach) - reach, parts);
}

void compare_some(const Both& a, const Both& b, std::mt19937& random, int reach, int count, Counts& counts) {
  for (int k = 0; k < count; ++k) {
    compare(a, b, drawn(random, reach), counts);
    if (::testing::Test::HasFatalFailure()) return;
  }
}

TEST(SurfaceContact, BracketsOnALattice) {
  std::mt19937 random(3);
  Counts counts;
  const Both u(space::extruded({"#.#", "###"}, 2), space::stretch(10)),
      cube(space::extruded({"#"}, 1), space::stretch(10)), bracket(space::extruded({"##", "#."}, 1), space::stretch(5)),
      peg(space::extruded({"##", "#."}, 2), space::stretch(10)),
      room(space::around(space::extruded({"##", "#."}, 2), 1), space::stretch(10));
  for (const Both* a : {&u, &room}) {
    // The cube just fits into the slot and into the room, which is the peg's.
    for (const Both* b : {&cube, &bracket, &peg}) {
      compare_some(*a, *b, random, 30, 12, counts);
      if (HasFatalFailure()) return;
    }
  }
  // Where a solid lies in its own place every corner of the one is on the other, and none inside.
  compare_some(u, u, random, 3, 6, counts);
  if (HasFatalFailure()) return;
  compare_some(peg, peg, random, 3, 6, counts);
  if (HasFatalFailure()) return;
  EXPECT_GT(counts.depths, 42);
  EXPECT_GT(counts.fits, 36);
  EXPECT_GT(counts.farthest, 32);
  EXPECT_EQ(counts.bounded, 0);
}

TEST(SurfaceContact, GeneralPosition) {
  const LinearMap skew{{{100, 17, 3}, {-9, 90, 11}, {5, -13, 120}}}, tilt{{{50, 3, -8}, {7, 40, 9}, {-5, 2, 60}}},
      small{{{30, 3, -8}, {7, 20, 9}, {-5, 2, 27}}};
  std::mt19937 random(4);
  Counts counts;
  for (int k = 0; k < 6; ++k) {
    const Both a(space::random_cells(random, 6, 3), skew), b(space::random_cells(random, 3, 2), tilt),
        c(space::random_cells(random, 2, 2), small);
    compare_some(a, b, random, 200, 8, counts);
    if (HasFatalFailure()) return;
    compare_some(a, c, random, 200, 8, counts);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(counts.depths, 12);
  EXPECT_GT(counts.fits, 20);
  EXPECT_EQ(counts.bounded, 0);
}

/// Rounded to the grid, so that hardly any four corners lie in a plane; inside out for a hole.
space::Triangles torus(bool inside_out) {
  constexpr int kAround = 12, kAcross = 7;
  space::Triangles t;
  for (int i = 0; i < kAround; ++i) {
    for (int j = 0; j < kAcross; ++j) {
      const double u = 2 * M_PI * i / kAround, v = 2 * M_PI * j / kAcross, r = 2500 + 800 * std::cos(v);
      t.points.push_back({std::lround(r * std::cos(u)), std::lround(r * std::sin(u)), std::lround(800 * std::sin(v))});
    }
  }
  for (int i = 0; i < kAround; ++i) {
    for (int j = 0; j < kAcross; ++j) {
      const int p = i * kAcross + j, q = (i + 1) % kAround * kAcross + j,
                r = (i + 1) % kAround * kAcross + (j + 1) % kAcross, s = i * kAcross + (j + 1) % kAcross;
      t.faces.push_back({p, q, r});
      t.faces.push_back({p, r, s});
    }
  }
  return inside_out ? space::inside_out(std::move(t)) : t;
}

/// A torus fits into its own hole in a block in one position: every triangle touches there.
TEST(SurfaceContact, ExactFitOfManyFaces) {
  space::Triangles block = space::surface({{0, 0, 0}}, space::stretch(10000));
  block = space::moved(std::move(block), {-5000, -5000, -5000});
  const space::Triangles hole = torus(true);
  const int first = static_cast<int>(block.points.size());
  block.points.insert(block.points.end(), hole.points.begin(), hole.points.end());
  for (const auto& f : hole.faces) block.faces.push_back({f[0] + first, f[1] + first, f[2] + first});
  SurfaceSet a, b;
  a.add({space::RaySolid{block, {}, {}}}, 1);
  b.add({space::RaySolid{torus(false), {}, {}}}, 1);
  const SurfaceContacts contacts(b, a, TouchSide::kOutside);
  for (const RealVector& p : {space::place(100, 200, 300), space::place(-500, 41, 7, 3)}) {
    const SurfaceContact found = contacts.nearest(p);
    ASSERT_TRUE(found.decided && found.place);
    EXPECT_EQ(found.error, 0);
    EXPECT_EQ(*found.place, space::place(0, 0, 0));
  }
}

/// A bar that is longer than what it is to lie in.
TEST(SurfaceContact, NoFit) {
  const Both bar(space::extruded({"###", "#.."}, 1), space::stretch(10)),
      l(space::extruded({"##", "#."}, 2), space::LinearMap{{{10, 0, 0}, {0, 10, 0}, {0, 1, 10}}});
  for (const Both* b : {&bar, &l}) {
    const SurfaceContact found =
        SurfaceContacts(b->surface, l.surface, TouchSide::kInside).nearest(space::place(1, 2, 3));
    EXPECT_TRUE(found.decided);
    EXPECT_EQ(found.place.has_value(), b == &l);
  }
}

}  // namespace distance_surface_contact
}  // namespace findspace::distance
