// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What is known of a place changes no distance to a surface (surface_field.h), and known distances nearby bound it
// (field_samples.h). Planes that bound a set in a ball, the farthest of many planes (plane_tree.h), and places in a
// tree (place_tree.h).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "distance/surface/field_samples.h"
#include "distance/surface/place_tree.h"
#include "distance/surface/surface_field.h"
#include "space/polytope/plane_tree.h"

namespace findspace::distance {
namespace distance_surface_field {

using space::Vector;

space::Triangles tetrahedron(std::int64_t size, const space::Point& at) {
  return space::moved(
      {{{0, 0, 0}, {size, 0, 0}, {0, size, 0}, {0, 0, size}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}}, at);
}

/// One solid; two that are apart; one and a ball.
space::SurfaceSet solids(int which) {
  std::vector<space::RaySolid> all{space::RaySolid{tetrahedron(1000, {0, 0, 0}), {}}};
  if (which == 1) all.push_back(space::RaySolid{tetrahedron(500, {600, 600, 600}), {}});
  if (which == 2) all.push_back({{}, {900, 900, 900}, exact::Real(300)});
  space::SurfaceSet out;
  EXPECT_TRUE(out.add(all, 1));
  return out;
}

TEST(SurfaceField, WhatIsKnownChangesNoDistance) {
  std::mt19937 rng(3);
  std::uniform_real_distribution<double> coordinate(-300, 1300);
  for (int which = 0; which < 3; ++which) {
    const space::SurfaceSet set = solids(which);
    const SurfaceField field(set, {});
    const FieldSamples samples(set);
    int inside = 0;
    for (int k = 0; k < 500; ++k) {
      const Vector x{coordinate(rng), coordinate(rng), coordinate(rng)};
      const SurfaceField::Signed at = field.at(x);
      inside += at.value < 0;
      for (int part = -1; part < static_cast<int>(field.parts()); ++part) {
        const SurfaceField::Signed again = field.at(x, {part, at.value < 0 ? -1 : 1});
        EXPECT_EQ(again.value, at.value);
        EXPECT_EQ(again.distance, at.distance);
        EXPECT_TRUE(again.certain);
        EXPECT_NEAR(std::fabs(field.distance(again.part, x)), at.distance, 1e-9);
      }
      samples.ask(x, 1, [&](const exact::Interval& known) {
        EXPECT_LE(known.lo, at.value + 1e-9);
        EXPECT_GE(known.hi, at.value - 1e-9);
        return known.hi - known.lo < 1e-9;
      });
    }
    EXPECT_GT(inside, 5);
  }
}

/// Two tetrahedra that touch face to face, in one surface.
space::SurfaceSet two_that_touch() {
  space::Triangles all = tetrahedron(1000, {0, 0, 0});
  const auto first = static_cast<int>(all.points.size());
  for (const space::Point& v : tetrahedron(1000, {0, 0, 0}).points) all.points.push_back({v.x, v.y, -v.z});
  for (const auto& f : tetrahedron(1000, {0, 0, 0}).faces)
    all.faces.push_back({first + f[0], first + f[2], first + f[1]});
  space::SurfaceSet out;
  EXPECT_TRUE(out.add({space::RaySolid{std::move(all), {}, {}, nullptr, true}}, 1));
  return out;
}

/// How many planes bound the part of a set in a ball: no place of it is beyond.
int bounding_planes(const space::SurfaceSet& set) {
  std::mt19937 rng(5);
  std::uniform_real_distribution<double> coordinate(-200, 1200), unit(-1, 1);
  const SurfaceField field(set, {});
  int found = 0;
  for (int k = 0; k < 2000; ++k) {
    const Vector x{coordinate(rng), coordinate(rng), coordinate(rng)};
    const double reach = 100;
    const auto plane = field.bounding_plane(x, reach);
    EXPECT_FALSE(plane && field.at(x).distance > reach * 1.01);
    if (!plane) continue;
    ++found;
    for (int other = 0; other < 50; ++other) {
      const Vector y = space::plus(x, {unit(rng) * reach, unit(rng) * reach, unit(rng) * reach});
      if (space::length(y - x) <= reach && field.at(y).value < 0) {
        EXPECT_LT(plane->beyond(y), 1e-6);
      }
    }
  }
  return found;
}

TEST(SurfaceField, APlaneBoundsAllOfTheSetNearby) { EXPECT_GT(bounding_planes(solids(0)), 100); }

/// The solid is on both sides of the wall.
TEST(SurfaceField, NoPlaneOfAWallWithinBoundsTheSet) { EXPECT_EQ(bounding_planes(two_that_touch()), 0); }

TEST(PlaneTree, TellsTheHalfSpaceThatAPlaceIsFarthestBeyond) {
  std::mt19937 rng(7);
  std::uniform_real_distribution<double> coordinate(-100, 100);
  std::uniform_int_distribution<int> step(-9, 9);
  for (const int count : {1, 4, 5, 300}) {
    std::vector<space::HalfSpace> planes;
    while (static_cast<int>(planes.size()) < count) {
      const space::Wide3 normal{step(rng), step(rng), step(rng)};
      if (!exact::is_zero(normal)) planes.emplace_back(space::Plane{normal, step(rng) * 100});
    }
    const space::PlaneTree tree(planes);
    for (int k = 0; k < 200; ++k) {
      const Vector x{coordinate(rng), coordinate(rng), coordinate(rng)};
      double most = -exact::kInfinity;
      for (const space::HalfSpace& h : planes) most = std::max(most, h.approx_value(x));
      EXPECT_EQ(tree.farthest_beyond(x).beyond(x), most);
    }
  }
}

TEST(PlaceTree, DividesAllPlacesAndItsBallsHoldThem) {
  std::mt19937 rng(9);
  std::uniform_real_distribution<double> coordinate(-100, 100);
  std::vector<PlaceTree::Place> places;
  for (int k = 0; k < 100; ++k)
    places.push_back({{coordinate(rng), coordinate(rng), coordinate(rng)}, coordinate(rng)});
  PlaceTree tree(places);
  std::vector<int> seen(places.size(), 0), left{0};
  while (!left.empty()) {
    const int k = left.back();
    left.pop_back();
    const PlaceTree::Node node = tree.node(k);
    if (node.leaf()) {
      const PlaceTree::Place& place = tree.place(k);
      ++seen[place.number];
      EXPECT_EQ(space::length(place.at - places[place.number].at), 0);
      continue;
    }
    for (const int part : tree.divided(k)) {
      left.push_back(part);
      const PlaceTree::Node half = tree.node(part);
      EXPECT_LE(half.most, node.most);
      EXPECT_GE(half.least, node.least);
      for (std::uint32_t p = half.begin; p < half.end; ++p) {
        EXPECT_LE(space::length(tree.places()[p].at - half.middle), half.radius * (1 + 1e-12));
      }
    }
  }
  EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), 100);
}

Vector somewhere(const Tetrahedron& t, std::mt19937& rng) {
  Vector sum;
  double weights = 0;
  for (const Vector& v : t) {
    const double w = -std::log(std::uniform_real_distribution<double>(1e-9, 1)(rng));
    sum = space::plus(sum, space::scaled(w, v));
    weights += w;
  }
  return space::scaled(1 / weights, sum);
}

TEST(FieldSamples, WhatIsSaidToBeWithinIs) {
  for (int which = 0; which < 3; ++which) {
    const space::SurfaceSet set = solids(which);
    const SurfaceField field(set, {});
    const FieldSamples samples(set);
    std::mt19937 rng(3);
    const auto pick = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(rng); };
    int decided = 0, clear = 0;
    for (int round = 0; round < 1000; ++round) {
      const Vector at{pick(-200, 1200), pick(-200, 1200), pick(-200, 1200)};
      Tetrahedron t;
      for (Vector& v : t) v = space::plus(at, {pick(-60, 60), pick(-60, 60), round % 5 == 0 ? 0 : pick(-60, 60)});
      const double most = pick(-100, 300);
      double greatest = -1e9;
      for (int k = 0; k < 50; ++k) greatest = std::max(greatest, field.at(somewhere(t, rng)).value);
      for (const Vector& v : t) greatest = std::max(greatest, field.at(v).value);
      const bool within = samples.within(t, most);
      ASSERT_TRUE(!within || greatest <= most + 1e-9) << round;
      decided += within;
      clear += greatest < most - 60;
    }
    EXPECT_GT(decided, 100);
    EXPECT_GE(decided, clear);
    EXPECT_FALSE(samples.within({Vector{900, 0, 0}, {1000, 0, 0}, {1000, 100, 0}, {1000, 0, 40000}}, 1e9));  // beyond
  }
}

TEST(FieldSamples, APlaceHasNoMoreThanIsSaid) {
  const space::SurfaceSet set = solids(0);
  const SurfaceField field(set, {});
  const FieldSamples samples(set);
  std::mt19937 rng(5);
  std::uniform_real_distribution<double> coordinate(-400, 1400);
  for (int round = 0; round < 1000; ++round) {
    const Vector at{coordinate(rng), coordinate(rng), coordinate(rng)};
    const double off = std::ldexp(64.0, -(round % 5)), most = samples.most_at(at, off), value = field.at(at).value;
    ASSERT_GE(most, value - 1e-9) << round;
    ASSERT_LE(most, value + 4 * off) << round;
  }
}

}  // namespace distance_surface_field
}  // namespace findspace::distance
