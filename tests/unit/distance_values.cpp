// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <tuple>
#include <vector>

#include "distance/planar/at_position.h"
#include "distance/planar/farthest.h"
#include "distance/planar/shape_pair.h"
#include "distance/planar_features/feature_pair_search.h"
#include "distance/planar_features/point_set.h"
#include "distance_shapes.h"
#include "plane/complex/overlay.h"
#include "plane/query/nearest.h"
#include "plane/query/topology.h"
#include "plane/walk/unite.h"

// Values and sign maps of every distance against the closed forms of distances.md 3.11.
namespace findspace::distance {
namespace distance_values {

using namespace findspace::testing;
using exact::Real;
using plane::Region;

double value(const ShapePair& pair, Which which, const exact::RealPoint& p) {
  auto v = pair.distance(which)->value(p);
  return v ? v->value.to_double() : INFINITY;
}

/// The sign map agrees with the value: at the value's own level, a little above and below.
void expect_signs(const ShapePair& pair, Which which, const exact::RealPoint& p) {
  auto f = pair.distance(which);
  auto v = f->value(p);
  ASSERT_TRUE(v);
  EXPECT_EQ(sign_at(f->sign_map(v->value), p), 0) << int(which);
  EXPECT_EQ(sign_at(f->sign_map(v->value + Real::ratio(1, 1000)), p), -1) << int(which);
  EXPECT_EQ(sign_at(f->sign_map(v->value - Real::ratio(1, 1000)), p), 1) << int(which);
}

TEST(Values, TwoDiscs) {
  Region a = plane::region_of_disc(0, 0, 5), b = plane::region_of_disc(0, 0, 2);
  ShapePair pair(b, a);
  for (int d : {0, 1, 3, 4, 7, 11}) {
    exact::RealPoint p = at(d, 0);
    EXPECT_DOUBLE_EQ(value(pair, Which::kGamma1, p), d - 7);
    EXPECT_DOUBLE_EQ(value(pair, Which::kGamma2, p), d + 7);
    EXPECT_DOUBLE_EQ(value(pair, Which::kEta1, p), d - 3);
    EXPECT_DOUBLE_EQ(value(pair, Which::kEta2, p), d + 3);
    EXPECT_EQ(value(pair, Which::kDelta1, p), INFINITY);
    EXPECT_NEAR(value(pair, Which::kMu, p), d - 3, 1e-12);
    EXPECT_NEAR(value(pair, Which::kMuBack, p), d + 3, 1e-12);
    EXPECT_NEAR(value(pair, Which::kHausdorff, p), d + 3, 1e-12);
    EXPECT_DOUBLE_EQ(value(pair, Which::kDiameter, p), std::max(10, d + 7));
  }
}

TEST(Values, AskedAgainAreWhatTheyWere) {
  const Region a = plane::region_of_disc(0, 0, 5), b = plane::region_of_disc(0, 0, 2);
  const AtPosition pair(std::make_shared<ShapePair>(b, a));
  const exact::RealPoint near{Real::ratio(1, 3), Real()}, far = at(11, 0), rough{sqrt(Real(2)), Real()};
  for (const auto& [which, p, expected] :
       std::vector<std::tuple<Which, exact::RealPoint, double>>{{Which::kGamma1, near, 1.0 / 3 - 7},
                                                                {Which::kGamma1, near, 1.0 / 3 - 7},
                                                                {Which::kGamma2, near, 1.0 / 3 + 7},
                                                                {Which::kGamma1, far, 4},
                                                                {Which::kGamma1, rough, sqrt(2) - 7},
                                                                {Which::kGamma1, far, 4},
                                                                {Which::kGamma1, near, 1.0 / 3 - 7}})
    EXPECT_DOUBLE_EQ(pair.measure(which, p)->value.to_double(), expected);
}

/// From 2^27 steps on a distance and one that is farther by a step to the side are one double.
TEST(Values, ClosedFormsOfOneDoubleAreComparedExactly) {
  const std::int64_t far = std::int64_t{1} << 27;
  const Real beyond = sqrt(Real(far) * Real(far) + Real(1));
  ASSERT_EQ(beyond.to_double(), double(far));
  const auto inside = [](plane::Mark mark) { return mark > 0; };
  const std::array<exact::RealPoint, 2> near_is_last{at(-far, 1), at(far, 0)}, near_is_first{at(-far, 0), at(far, 1)};
  for (const auto& points : {near_is_last, near_is_first}) {
    EXPECT_EQ(plane::nearest(point_set(points), inside, at(0, 0))->distance, Real(far));
    EXPECT_EQ(Farthest(point_set(points, 0, 1)).value(at(0, 0))->value, beyond);
  }
}

TEST(Values, BoxInABox) {
  ShapePair pair(box(-1, -1, 1, 1), box(-4, -3, 4, 3));
  exact::RealPoint p = at(6, 5);
  EXPECT_DOUBLE_EQ(value(pair, Which::kGamma1, p), std::hypot(1, 1));
  EXPECT_DOUBLE_EQ(value(pair, Which::kGamma2, p), std::hypot(11, 9));
  EXPECT_DOUBLE_EQ(value(pair, Which::kEta1, p), std::hypot(3, 3));
  EXPECT_DOUBLE_EQ(value(pair, Which::kEta2, p), std::hypot(9, 7));
  EXPECT_DOUBLE_EQ(value(pair, Which::kMu, p), std::hypot(3, 3));
  EXPECT_DOUBLE_EQ(value(pair, Which::kMuBack, p), std::hypot(9, 7));
  EXPECT_EQ(value(pair, Which::kDstarBack, p), 0);
  EXPECT_EQ(value(pair, Which::kDstar, p), 0);
  EXPECT_EQ(value(pair, Which::kDstarBack, at(0, 0)), 2);
  for (Which w :
       {Which::kGamma1, Which::kGamma2, Which::kEta1, Which::kEta2, Which::kMu, Which::kMuBack, Which::kHausdorff}) {
    expect_signs(pair, w, p);
    expect_signs(pair, w, at(1, 0));
  }
}

TEST(Values, HoleCoveredByB) {
  // A square ring and the full square: mu = max(1, |p|) near the origin (distances.md 3.6).
  Region a = polygon({{-3, -3}, {3, -3}, {3, 3}, {-3, 3}}, {{{-1, -1}, {-1, 1}, {1, 1}, {1, -1}}});
  ShapePair pair(box(-3, -3, 3, 3), a);
  EXPECT_DOUBLE_EQ(value(pair, Which::kMu, {Real::ratio(1, 2), Real()}), 1);
  EXPECT_DOUBLE_EQ(value(pair, Which::kMu, at(2, 0)), 2);
  auto m = pair.distance(Which::kMu)->sign_map(1);
  EXPECT_EQ(sign_at(m, {Real::ratio(1, 2), Real::ratio(1, 3)}), 0);
  EXPECT_EQ(sign_at(m, at(2, 0)), 1);
}

TEST(Values, HausdorffInsideABayIsFoundBetweenEdges) {
  // The middle of B's long edge hangs over the mouth of a deep bay, equally far from its two corners.
  Region a = polygon({{-9, -9}, {9, -9}, {9, 1}, {4, 1}, {4, -8}, {-4, -8}, {-4, 1}, {-9, 1}});
  Region b = polygon({{-9, 5}, {9, 5}, {9, 6}, {-9, 6}});
  ShapePair pair(b, a);
  EXPECT_NEAR(value(pair, Which::kMu, at(0, 0)), std::hypot(4, 5), 1e-12);
  expect_signs(pair, Which::kMu, at(0, 0));
}

/// By the shapes' boundaries, as there are many corners.
TEST(Values, NoPositionIsFarthestWhereTheRoomHasNoEnd) {
  const auto star = [](int corners, double inner, double outer) {
    plane::Contour c;
    for (int k = 0; k < corners; ++k) {
      const double r = k % 2 == 0 ? outer : inner, angle = 2 * M_PI * k / corners;
      c.push_back({.start = {std::llround(r * std::cos(angle)), std::llround(r * std::sin(angle))}});
    }
    return plane::region_of_rings(std::array{c});
  };
  const Region small = star(440, 2000, 9000), room = plane::complement(star(440, 5000, 30000));
  EXPECT_FALSE(AtPosition(std::make_shared<ShapePair>(small, room)).measure(Which::kEta2, at(60000, 0)));
  EXPECT_FALSE(AtPosition(std::make_shared<ShapePair>(room, small)).measure(Which::kDelta2, at(60000, 0)));
}

TEST(Values, PointsAndChains) {
  Region a = plane::region_of_points(std::vector<plane::GridPoint>{{0, 0}, {10, 0}});
  Region b = plane::region_of_points(std::vector<plane::GridPoint>{{0, 0}});
  ShapePair pair(b, a);
  EXPECT_DOUBLE_EQ(value(pair, Which::kGamma1, at(3, 4)), 5);
  EXPECT_DOUBLE_EQ(value(pair, Which::kGamma2, at(3, 4)), std::hypot(7, 4));
  EXPECT_DOUBLE_EQ(value(pair, Which::kMu, at(3, 4)), 5);
  EXPECT_DOUBLE_EQ(value(pair, Which::kMuBack, at(3, 4)), std::hypot(7, 4));
  EXPECT_DOUBLE_EQ(value(pair, Which::kEta1, at(10, 1)), 1);
  EXPECT_DOUBLE_EQ(value(pair, Which::kDiameter, at(3, 4)), 10);
}

TEST(Values, InsideARoomOfTwoParts) {
  // The room is what x + 2 y = 200 leaves of a disc of radius 1000 on the origin's side: its largest circle is exact.
  const Region disc = plane::region_of_disc(0, 0, 1000), frame = box(-1500, -1500, 1500, 1500);
  const Region wall = polygon({{-1800, 1000}, {1400, -600}, {2000, 2000}, {-1800, 2000}});
  const std::array<const Region*, 2> hollow{&frame, &disc};
  const Region ring = plane::closure(plane::subtract(hollow));
  const std::array<const Region*, 2> both{&ring, &wall};
  const ShapePair pair(frame, plane::unite(both));
  const auto v = pair.distance(Which::kMu)->value(at(0, 0));
  ASSERT_TRUE(v);
  EXPECT_EQ(v->value, (Real(1000) + Real(200) / sqrt(Real(5))) / Real(2));
}

TEST(FarthestPair, DiameterIsNotTwiceTheRadius) {
  Region t = polygon({{0, 0}, {8, 1}, {4, 7}});
  auto d = farthest_pair(FeatureTree(t), FeatureTree(t), at(0, 0));
  EXPECT_EQ(d.distance * d.distance, Real(65));
}

TEST(FarthestPair, Arcs) {
  Region a = plane::region_of_disc(0, 0, 3), b = plane::region_of_disc(1, 0, 2);
  auto d = farthest_pair(FeatureTree(a), FeatureTree(b), at(9, 0));
  EXPECT_EQ(d.distance, Real(15));
  EXPECT_EQ(d.first.x, Real(-3));
  EXPECT_EQ(d.second.x, Real(12));
  EXPECT_EQ(farthest_pair(FeatureTree(a), FeatureTree(a), at(0, 0)).distance, Real(6));
}

/// Where doubles put a place upon a corner, all features beside the corner are compared exactly.
TEST(FeaturePairs, NextToACornerTheNearestIsExact) {
  const plane::Contour ring{{{75, -93}}, {{9, -62}}, {{-32, 8}}, {{-11, 46}}, {{-68, 75}}, {{-78, 46}}};
  const Region region = plane::region_of_rings({&ring, 1});
  const FeatureTree tree(region);
  const Region point = plane::region_of_points(std::array{plane::GridPoint{0, 0}});
  const FeatureTree moving(point);
  int edges = 0;
  for (const plane::ContourEdge& corner : ring)
    for (int x = -6; x <= 6; x += 3)
      for (int y = -7; y <= 7; ++y) {
        const auto beside = [](std::int64_t at, int by) { return Real(at) + Real::ratio(by, 10'000'000'000'000'000); };
        const exact::RealPoint at{beside(corner.start.x, x), beside(corner.start.y, y)};
        std::optional<Real> least;
        const auto take = [&](plane::Cell cell) {
          if (const auto pair = exact_pair(region, cell, at))
            if (!least || pair->distance < *least) least = pair->distance;
        };
        for (plane::Index k = 0; k < region.vertices.size(); ++k) take({0, k});
        for (plane::Index k = 0; k < region.edges.size(); ++k) take({1, k});
        const FeaturePair nearest = nearest_point(tree, at);
        EXPECT_EQ(compare(nearest.distance, *least), 0) << x << " " << y;
        EXPECT_EQ(compare(closest_pair(tree, moving, at).distance, *least), 0) << x << " " << y;
        const auto boundary = [](plane::Mark mark) { return mark > 0; };
        EXPECT_DOUBLE_EQ(plane::nearest(region, boundary, at)->distance.to_double(), least->to_double());
        edges += nearest.first_cell.dimension;
      }
  EXPECT_GT(edges, 100);
}

/// The exact distance of a cell's nearest point; of an arc by where the foot is, nothing where that is not on it.
std::optional<Real> distance_of(const Region& r, plane::Cell cell, const exact::RealPoint& from) {
  if (cell.dimension == 0 || !r.is_arc(cell.index)) {
    const auto pair = exact_pair(r, cell, from);
    return pair ? std::optional(pair->distance) : std::nullopt;
  }
  const plane::Edge& e = r.edges[cell.index];
  const exact::SupportingCurve& k = r.supporting_curve(cell.index);
  const Real dx = from.x - k.center_x(), dy = from.y - k.center_y(), size = sqrt(dx * dx + dy * dy);
  const Real foot = k.center_x() + dx * k.w() / size;
  const auto x_of = [&](plane::Index v) { return r.geometry.exact(r.vertices[v].point).x; };
  if (dy.sign() * e.half < 0 || foot < x_of(e.v0) || foot > x_of(e.v1)) return std::nullopt;
  return abs(size - k.w());
}

/// The same beside the ends of arcs, also where the arc is vertical and its foot, rounded, is far from where it is.
TEST(FeaturePairs, NextToTheEndOfAnArcTheNearestIsExact) {
  const auto cut = [](std::int64_t x, std::int64_t y, std::int64_t radius, std::int64_t above) {
    const Region disc = plane::region_of_disc(x, y, radius),
                 window = box(x - 2 * radius, y + above, x + 2 * radius, y + 2 * radius);
    return plane::intersect(std::array{&disc, &window});
  };
  const Region point = plane::region_of_points(std::array{plane::GridPoint{0, 0}});
  const FeatureTree moving(point);
  int arcs = 0;
  for (const Region& region : {cut(1000, 1000, 5, 0), cut(1000, 1000, 5, 3), cut(777, -333, 1000000, 1)}) {
    const FeatureTree tree(region);
    for (plane::Index v = 0; v < region.vertices.size(); ++v)
      for (const std::int64_t unit : {std::int64_t{1'000'000'000}, std::int64_t{10'000'000'000'000'000}})
        for (int x = -2; x <= 2; x += 2)
          for (int y = -3; y <= 3; ++y) {
            const exact::Point& near = region.point(v);
            const exact::RealPoint at{Real::from_double(near.x) + Real::ratio(x, unit),
                                      Real::from_double(near.y) + Real::ratio(y, unit)};
            std::optional<Real> least;
            const auto take = [&](plane::Cell cell) {
              if (const auto d = distance_of(region, cell, at))
                if (!least || *d < *least) least = *d;
            };
            for (plane::Index k = 0; k < region.vertices.size(); ++k) take({0, k});
            for (plane::Index k = 0; k < region.edges.size(); ++k) take({1, k});
            const FeaturePair nearest = nearest_point(tree, at);
            EXPECT_EQ(compare(nearest.distance, *least), 0) << v << " " << unit << " " << x << " " << y;
            EXPECT_EQ(compare(closest_pair(tree, moving, at).distance, *least), 0) << v << " " << x << " " << y;
            const auto boundary = [](plane::Mark mark) { return mark > 0; };
            EXPECT_DOUBLE_EQ(plane::nearest(region, boundary, at)->distance.to_double(), least->to_double());
            arcs += nearest.first_cell.dimension == 1 && region.is_arc(nearest.first_cell.index);
          }
  }
  EXPECT_GT(arcs, 50);
}

}  // namespace distance_values
}  // namespace findspace::distance
