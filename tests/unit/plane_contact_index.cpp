// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The contact curves found in a box, and the box around all, against all pairs looked at one by one: combs, stars with
// holes, discs, and the complement of one as what stands still.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "plane/complex/overlay.h"
#include "plane/complex/primitives.h"
#include "plane/contour/contour.h"
#include "plane/query/topology.h"
#include "plane/rotation/contact_index.h"

namespace findspace::plane {
namespace plane_contact_index {

constexpr double kTolerance = 1e-3;

Region comb(int teeth, std::int64_t width) {
  Contour c{{.start = {0, -10}}, {.start = {2 * teeth * width, -10}}};
  for (int k = 2 * teeth - 1; k >= 0; --k) {
    const bool up = k % 2 != 0;
    for (const std::int64_t x : {std::int64_t(k + 1), std::int64_t(k)})
      c.push_back({.start = {x * width, up ? 50 : 0}});
  }
  return region_of_rings(std::array{c});
}

/// With a round hole.
Region star(std::mt19937& rng, int n, double size) {
  Contour c;
  for (int k = 0; k < n; ++k) {
    const double r = (0.5 + double(rng() % 500) / 1000) * size, angle = 2 * kPi * k / n;
    c.push_back({.start = {std::llround(r * std::cos(angle)), std::llround(r * std::sin(angle))}});
  }
  const Region all = region_of_rings(std::array{c}), hole = region_of_disc(0, 0, exact::Real(std::int64_t(size / 5)));
  const std::array<const Region*, 2> both{&all, &hole};
  return closure(subtract(both));
}

RoughBox joined(const RoughBox& a, const RoughBox& b) {
  return {std::min(a.x0, b.x0), std::min(a.y0, b.y0), std::max(a.x1, b.x1), std::max(a.y1, b.y1)};
}

void compare(const Region& a, const Region& b, bool outside, std::mt19937& rng) {
  const ContactCurves curves(contact_features(b, {}, [](Mark m) { return m > 0; }),
                             contact_features(a, {}, [&](Mark m) { return (m > 0) != outside; }));
  const ContactIndex index(curves, kTolerance);
  const std::vector<ContactPair> all = curves.pairs(0, 0);
  ASSERT_FALSE(all.empty());
  RoughBox whole = index.box(all[0]);
  for (const ContactPair& k : all) whole = joined(whole, index.box(k));
  const auto bounds = index.bounds();
  ASSERT_TRUE(bounds);
  const auto sides = [](const RoughBox& box) { return std::array{box.x0, box.y0, box.x1, box.y1}; };
  EXPECT_EQ(sides(*bounds), sides(whole));
  for (int t = 0; t < 12; ++t) {
    const auto place = [&](double low, double high) { return low + (high - low) * double(rng() % 1000) / 999; };
    const double x = std::round(place(whole.x0, whole.x1)), y = std::round(place(whole.y0, whole.y1)),
                 half = (whole.x1 - whole.x0) / double(1 << (t % 8));
    const RoughBox box = t == 0 ? whole : RoughBox{x - half, y - half, x + half, y + half};
    std::vector<ContactPair> wanted, found;
    for (const ContactPair& k : all)
      if (!box.apart(index.box(k))) wanted.push_back(k);
    index.visit(box, [&](const ContactPair& k) {
      found.push_back(k);
      return true;
    });
    std::sort(found.begin(), found.end());
    EXPECT_EQ(found, wanted);
  }
}

TEST(ContactIndex, FindsThePairsOfABox) {
  std::mt19937 rng(7);
  const Region large = comb(12, 16), small = comb(9, 3), disc = region_of_disc(3, 4, 40);
  for (const bool outside : {false, true}) {
    compare(large, small, outside, rng);
    compare(small, large, outside, rng);
    compare(large, disc, outside, rng);
    for (int k = 0; k < 6; ++k) compare(star(rng, 5 + 6 * k, 300), star(rng, 30 - 4 * k, 100), outside, rng);
  }
}

TEST(ContactIndex, EndsWhereTheVisitorDoes) {
  const Region a = comb(30, 4);
  const ContactCurves curves(contact_features(a, {}, [](Mark m) { return m > 0; }),
                             contact_features(a, {}, [](Mark m) { return m > 0; }));
  const ContactIndex index(curves, kTolerance);
  int seen = 0;
  index.visit({-1e9, -1e9, 1e9, 1e9}, [&](const ContactPair&) { return ++seen < 10; });
  EXPECT_EQ(seen, 10);
}

}  // namespace plane_contact_index
}  // namespace findspace::plane
