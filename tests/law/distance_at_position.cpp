// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Values at a position against those of the families' maps, and what witnesses promise: their points lie on the shapes,
// as far from each other as the value says, on the cells they name; moved together, the shapes touch.

#include <gtest/gtest.h>

#include <cmath>

#include "distance/planar/at_position.h"
#include "distance_random.h"
#include "plane/query/nearest.h"

namespace findspace::distance {
namespace distance_at_position {

constexpr double kTolerance = 1e-11;

double number(const Real& r) { return r.to_double(); }
double apart(const RealPoint& p, const RealPoint& q) { return std::hypot(number(p.x - q.x), number(p.y - q.y)); }

/// In the coordinates of its own shape.
RealPoint at_home(const Feature& f, const RealPoint& p) {
  return f.of_moving ? RealPoint{f.at.x - p.x, f.at.y - p.y} : f.at;
}

void expect_on_its_cell(const Feature& f, const ShapePair& pair, const RealPoint& p) {
  const Region& r = f.of_moving ? pair.moving() : pair.fixed();
  RealPoint at = at_home(f, p);
  if (f.cell->dimension == 2) {
    EXPECT_GT(sign_at(r, at), 0);
  } else if (f.cell->dimension == 0) {
    EXPECT_LT(apart(r.geometry.exact(r.vertices[f.cell->index].point), at), kTolerance);
  } else {
    EXPECT_LT(edge_feature(r, f.cell->index).distance(number(at.x), number(at.y)), kTolerance);
  }
}

/// The distance whose witness is that of `which` where it is not cut off.
bool is_cut_off(Which which, double value) {
  return value == 0 && (which == Which::kH || which == Which::kHBack || which == Which::kDstar ||
                        which == Which::kDstarBack || which == Which::kPenetration || which == Which::kDiameter);
}

void expect_witness(const PlanarAnswer& m, Which which, const AtPosition& at, const RealPoint& p) {
  double value = number(m.value);
  if (is_cut_off(which, value)) return;
  ASSERT_EQ(m.witness.size(), 2u) << int(which);
  for (const Feature& f : m.witness) expect_on_its_cell(f, at.pair(), p);
  EXPECT_NEAR(apart(m.witness[0].at, m.witness[1].at), std::abs(value), kTolerance) << int(which);
  if (which != Which::kDiameter) {
    EXPECT_TRUE(m.witness[0].of_moving);
    EXPECT_FALSE(m.witness[1].of_moving);
  }
}

TEST(AtPosition, AgreesWithTheMapsAndShowsWhere) {
  Shapes random(21);
  for (int k = 0; k < 60; ++k) {
    auto pair = std::make_shared<ShapePair>(random.shape(), random.shape());
    AtPosition at(pair);
    for (int i = 0; i < 3; ++i) {
      RealPoint p = random.position();
      for (Which w : kAll) {
        auto m = at.measure(w, p);
        auto v = pair->distance(w)->value(p);
        ASSERT_EQ(m.has_value(), v.has_value()) << int(w);
        if (!m) continue;
        EXPECT_NEAR(number(m->value), number(v->value), kTolerance)
            << "trial " << k << " which " << int(w) << " at " << number(p.x) << ", " << number(p.y);
        expect_witness(*m, w, at, p);
      }
    }
  }
}

TEST(AtPosition, NearestPositionIsOne) {
  Shapes random(22);
  for (int k = 0; k < 40; ++k) {
    auto pair = std::make_shared<ShapePair>(random.shape(), random.shape());
    AtPosition at(pair);
    RealPoint p = random.position();
    for (Which w : {Which::kGamma1, Which::kEta1, Which::kDelta1}) {
      auto m = at.measure(w, p);
      if (!m || !m->nearest) continue;
      EXPECT_NEAR(apart(*m->nearest, p), std::abs(number(m->value)), kTolerance);
      EXPECT_EQ(sign_at(pair->distance(w)->sign_map(Real()), *m->nearest), 0) << int(w);
      // Moved there, the two points of the witness are one.
      RealPoint moved{m->witness[0].at.x + m->nearest->x - p.x, m->witness[0].at.y + m->nearest->y - p.y};
      EXPECT_LT(apart(moved, m->witness[1].at), kTolerance) << int(w);
    }
  }
}

TEST(AtPosition, ThinShapes) {
  Region cross = plane::region_of_points(std::vector<plane::GridPoint>{{0, 0}, {10, 0}});
  Region point = plane::region_of_points(std::vector<plane::GridPoint>{{0, 0}});
  auto pair = std::make_shared<ShapePair>(point, cross);
  AtPosition at(pair);
  for (Which w : kAll) {
    auto m = at.measure(w, {3, 4});
    auto v = pair->distance(w)->value({3, 4});
    ASSERT_EQ(m.has_value(), v.has_value()) << int(w);
    if (!m) continue;
    EXPECT_EQ(m->value, v->value) << int(w);
    expect_witness(*m, w, at, {3, 4});
  }
}

TEST(AtPosition, JaggedPolygons) {
  // Against the maps, with many vertices.
  std::mt19937 random(5);
  auto jagged = [&](int n) {
    plane::Contour c;
    for (int k = 0; k < n; ++k) {
      double r = std::uniform_real_distribution<>(300, 1000)(random), t = 2 * M_PI * k / n;
      c.push_back({.start = {std::int64_t(r * std::cos(t)), std::int64_t(r * std::sin(t))}});
    }
    return plane::region_of_rings(std::vector<plane::Contour>{c});
  };
  for (int k = 0; k < 6; ++k) {
    auto pair = std::make_shared<ShapePair>(jagged(24), jagged(40));
    AtPosition at(pair);
    for (RealPoint p :
         {RealPoint{2500, 100}, RealPoint{600, -300}, RealPoint{0, 0}, RealPoint{Real::ratio(1, 3), 1000}})
      for (Which w : {Which::kGamma1, Which::kGamma2, Which::kMu, Which::kMuBack, Which::kHausdorff, Which::kD1,
                      Which::kH, Which::kHBack}) {
        auto m = at.measure(w, p);
        EXPECT_NEAR(number(m->value), number(pair->distance(w)->value(p)->value), 1e-8) << int(w);
        expect_witness(*m, w, at, p);
      }
  }
}

}  // namespace distance_at_position
}  // namespace findspace::distance
