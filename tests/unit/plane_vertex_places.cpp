// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "exact/planar/geometry_signs.h"
#include "plane/query/measure_cells_places.h"

namespace findspace::plane {
namespace plane_vertex_places {

using exact::Geometry;
using exact::Real;
using exact::SupportingCurve;

/// Lines, displaced lines and circles with grid data up to `reach`, and all their meetings.
Geometry crossings(std::mt19937& random, std::int64_t reach, int count) {
  std::uniform_int_distribution<std::int64_t> number(-reach, reach);
  Geometry g;
  for (int k = 0; k < count; ++k) {
    std::int64_t a = number(random), b = number(random);
    if (k % 3 == 2) {
      g.add(SupportingCurve::circle_at(a, b, Real::ratio(1 + std::abs(number(random)), 1 + k % 4)));
      continue;
    }
    if (a == 0 && b == 0) b = 1;
    exact::make_primitive(a, b);
    const exact::int128 c = exact::int128(a) * number(random) + exact::int128(b) * number(random);
    g.add(k % 3 == 0 ? SupportingCurve::line(a, b, c)
                     : SupportingCurve::displaced_line(a, b, c, Real::ratio(1 + k, 3)));
  }
  for (Index i = 0; i < g.supporting_curves.size(); ++i) {
    for (Index j = i + 1; j < g.supporting_curves.size(); ++j) {
      if (same_supporting_curve(g.supporting_curves[i], g.supporting_curves[j])) continue;
      const exact::Meeting m = meet(g, i, j);
      for (int k = 0; k < m.count; ++k) g.add_crossing(i, j, m.root[std::size_t(k)]);
    }
  }
  return g;
}

double error(const Twofold& found, const Real& exact) {
  return std::abs((exact - Real::from_double(found.hi) - Real::from_double(found.lo)).to_double()) /
         std::max(std::abs(found.hi), 1.0);
}

void expect_near(const Geometry& g) {
  VertexPlaces places(g);
  for (Index p = 0; p < g.points.size(); ++p) {
    const auto [x, y] = places.at(p);
    const exact::RealPoint q = g.exact(p);
    ASSERT_LE(std::max(error(x, q.x), error(y, q.y)), 0x1p-94) << p << " at " << x.hi << " " << y.hi;
  }
}

TEST(VertexPlaces, NearTheExactOnes) {
  std::mt19937 random(17);
  for (const std::int64_t reach : {3, 100, 100'000, 100'000'000}) {
    for (int k = 0; k < 5; ++k) expect_near(crossings(random, reach, 12));
  }
}

TEST(VertexPlaces, OfTangencies) {
  Geometry g;
  const auto big = g.add(SupportingCurve::circle_at(0, 0, Real(500'000)));
  const auto line = g.add_line(3, 4, 2'500'000);
  const auto inside = g.add(SupportingCurve::circle_at(1, 0, Real(499'999)));
  for (const auto other : {line, inside}) {
    const exact::Meeting m = meet(g, big, other);
    ASSERT_EQ(m.count, 1);
    g.add_crossing(big, other, m.root[0]);
  }
  expect_near(g);
  VertexPlaces places(g);
  EXPECT_EQ(places.at(0)[0].value(), 300'000.0);
  EXPECT_EQ(places.at(0)[1].value(), 400'000.0);
}

TEST(VertexPlaces, OfCrossingsUnderSmallAngles) {
  Geometry g;
  const auto first = g.add(SupportingCurve::displaced_line(1'000'000, 1'000'001, 1'000'000, Real::ratio(1, 3)));
  const auto second = g.add(SupportingCurve::displaced_line(999'999, 1'000'000, 999'999, Real::ratio(1, 3)));
  g.add_crossing(first, second, 0);  // the sines: 10^-12
  const auto circle = g.add(SupportingCurve::circle_at(0, 0, Real(7)));
  const Real low = Real(7) - Real::ratio(1, std::int64_t(1) << 40);
  const auto grazing = g.add(SupportingCurve::displaced_line(0, 1, 0, low));
  const auto near =
      g.add(SupportingCurve::circle_at(Real(), Real(14) - Real::ratio(1, std::int64_t(1) << 40), Real(7)));
  for (const auto other : {grazing, near}) {
    const exact::Meeting m = meet(g, circle, other);
    ASSERT_EQ(m.count, 2);
    for (const int root : m.root) g.add_crossing(circle, other, root);
  }
  expect_near(g);
}

}  // namespace plane_vertex_places
}  // namespace findspace::plane
