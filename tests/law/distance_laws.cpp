// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The laws of distances.md section 2 on random shapes, each against the program's own results. Shapes: polygons with
// and without a hole, discs, unions of two boxes, points; small coordinates, so that ties and exact fits are common.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <random>

#include "../unit/distance_shapes.h"
#include "distance/planar/shape_pair.h"
#include "distance/planar_least/extremum.h"
#include "distance_random.h"
#include "plane/query/topology.h"

namespace findspace::distance {
namespace distance_laws {

using namespace findspace::testing;
using exact::Real;
using exact::RealPoint;
using plane::Region;

constexpr int kTrials = 40;

double value(const ShapePair& pair, Which which, const RealPoint& p) {
  auto v = pair.distance(which)->value(p);
  return v ? v->value.to_double() : INFINITY;
}

void expect_equal(double a, double b) {
  if (std::isinf(a) || std::isinf(b))
    EXPECT_EQ(a, b);
  else
    EXPECT_NEAR(a, b, 1e-12 * (1 + std::abs(a)));
}

TEST(DistanceLaws, OrderOfTheDistances) {
  Shapes random(1);
  for (int k = 0; k < kTrials; ++k) {
    ShapePair pair(random.shape(), random.shape());
    RealPoint p = random.position();
    double gamma1 = value(pair, Which::kGamma1, p), gamma2 = value(pair, Which::kGamma2, p),
           eta1 = value(pair, Which::kEta1, p);
    double delta1 = value(pair, Which::kDelta1, p), mu = value(pair, Which::kMu, p),
           back = value(pair, Which::kMuBack, p);
    double slack = 1e-12 * gamma2;
    EXPECT_LE(gamma1, mu + slack);
    EXPECT_LE(mu, eta1 + slack);
    EXPECT_LE(gamma1, back + slack);
    EXPECT_LE(back, delta1 + slack);
    EXPECT_LE(value(pair, Which::kHausdorff, p), gamma2 + slack);
    EXPECT_GE(value(pair, Which::kHausdorff, p), -slack);
    EXPECT_LE(std::abs(gamma1), gamma2 + slack);
    EXPECT_LE(std::abs(eta1), value(pair, Which::kEta2, p) + slack);
    EXPECT_LE(std::abs(delta1), value(pair, Which::kDelta2, p) + slack);
    if (eta1 <= 0) expect_equal(mu, eta1);
    if (delta1 <= 0) expect_equal(back, delta1);
    EXPECT_EQ(mu <= 0, eta1 <= 0);
    EXPECT_EQ(back <= 0, delta1 <= 0);
  }
}

TEST(DistanceLaws, ExchangeOfTheShapes) {
  Shapes random(2);
  constexpr std::array kPartner{
      std::pair{Which::kGamma1, Which::kGamma1},  std::pair{Which::kGamma2, Which::kGamma2},
      std::pair{Which::kEta1, Which::kDelta1},    std::pair{Which::kEta2, Which::kDelta2},
      std::pair{Which::kMu, Which::kMuBack},      std::pair{Which::kHausdorff, Which::kHausdorff},
      std::pair{Which::kDstar, Which::kDstarBack}};
  for (int k = 0; k < kTrials; ++k) {
    Region a = random.shape(), b = random.shape();
    ShapePair forth(b, a), back(a, b);
    RealPoint p = random.position();
    for (auto [f, g] : kPartner) expect_equal(value(forth, f, p), value(back, g, {-p.x, -p.y}));
  }
}

TEST(DistanceLaws, OnlyTheRelativePositionMatters) {
  Shapes random(3);
  for (int k = 0; k < kTrials; ++k) {
    Region a = random.shape(), b = random.shape();
    RealPoint p = random.position(), q{random.number(-5, 5), random.number(-5, 5)};
    ShapePair here(b, a), there(plane::moved(b, q), a);
    for (Which w : kAll) expect_equal(value(here, w, {p.x + q.x, p.y + q.y}), value(there, w, p));
  }
}

TEST(DistanceLaws, ContainmentIsContactWithTheComplement) {
  Shapes random(4);
  for (int k = 0; k < kTrials; ++k) {
    Region a = random.shape(), b = random.shape();
    if (!plane::is_regular(a)) continue;
    RealPoint p = random.position();
    ShapePair pair(b, a), dual(b, plane::closure(plane::complement(a)));
    double eta1 = value(pair, Which::kEta1, p);
    if (!std::isinf(eta1)) expect_equal(eta1, -value(dual, Which::kGamma1, p));
  }
}

TEST(DistanceLaws, ChangesNoFasterThanThePosition) {
  Shapes random(5);
  for (int k = 0; k < kTrials; ++k) {
    ShapePair pair(random.shape(), random.shape());
    RealPoint p = random.position(), q = random.position();
    double apart = std::hypot((p.x - q.x).to_double(), (p.y - q.y).to_double());
    for (Which w : kAll) {
      double f = value(pair, w, p), g = value(pair, w, q);
      if (!std::isinf(f)) {
        EXPECT_LE(std::abs(f - g), apart * (1 + 1e-12) + 1e-12) << int(w);
      }
    }
  }
}

TEST(DistanceLaws, SignMapsAgreeWithValues) {
  Shapes random(6);
  for (int k = 0; k < kTrials; ++k) {
    ShapePair pair(random.shape(), random.shape());
    RealPoint p = random.position();
    Real level = Real::ratio(random.number(-6, 24), 2);
    for (Which w : kAll) {
      auto v = pair.distance(w)->value(p);
      int sign = v ? compare(v->value, level) : 1;
      EXPECT_EQ(sign_at(pair.distance(w)->sign_map(level), p), sign) << int(w) << " level " << level.text();
    }
  }
}

TEST(DistanceLaws, SublevelSetsGrow) {
  Shapes random(7);
  for (int k = 0; k < kTrials / 4; ++k) {
    ShapePair pair(random.shape(), random.shape());
    Real low = Real::ratio(random.number(-4, 12), 2), high = low + Real::ratio(random.number(1, 4), 2);
    for (Which w : kAll) {
      auto f = pair.distance(w);
      plane::SignMap at_low = f->sign_map(low), at_high = f->sign_map(high);
      std::array<const plane::CellComplex*, 2> both{&at_low, &at_high};
      // {<= low} lies in {< high}.
      EXPECT_TRUE(plane::is_empty(plane::overlay(both, [](std::span<const plane::Mark> m) {
        return plane::Mark(m[0] <= 0 && m[1] >= 0);
      }))) << int(w);
    }
  }
}

TEST(DistanceLaws, LeastLevelsAreLeast) {
  Shapes random(8);
  for (int k = 0; k < kTrials / 4; ++k) {
    ShapePair pair(random.shape(), random.shape());
    for (Which w : kAll) {
      auto f = pair.distance(w);
      Extremum e = least(*f);
      EXPECT_EQ(e.exists(), f->defined());
      if (!e.exists()) continue;
      for (int i = 0; i < 10; ++i) EXPECT_GE(value(pair, w, random.position()), e.answer->value.to_double() - 1e-11);
      ASSERT_TRUE(!plane::is_empty(e.at));
      if (e.at.vertices.empty()) continue;
      double there = value(pair, w, e.at.geometry.exact(e.at.vertices[0].point));
      EXPECT_NEAR(there, e.answer->value.to_double(), 1e-11) << int(w);
    }
  }
}

TEST(DistanceLaws, TheSmallestCircleIsTheOnlyPlaceOfTheLeastLevel) {
  Shapes random(10);
  int decided = 0, defined = 0;
  for (int k = 0; k < 5 * kTrials; ++k) {
    ShapePair pair(random.shape(), random.shape());
    for (Which w : {Which::kGamma2, Which::kEta2, Which::kDelta2}) {
      auto f = pair.distance(w);
      const auto lowest = f->lowest();
      defined += f->defined();
      decided += lowest.has_value();
      if (!lowest) continue;
      const plane::SignMap map = f->sign_map(lowest->level);
      const auto above = [](const auto& cell) { return cell.mark > 0; };
      EXPECT_TRUE(std::all_of(map.faces.begin(), map.faces.end(), above)) << int(w);
      EXPECT_TRUE(std::all_of(map.edges.begin(), map.edges.end(), above)) << int(w);
      EXPECT_EQ(std::count_if(map.vertices.begin(), map.vertices.end(), std::not_fn(above)), 1) << int(w);
      EXPECT_EQ(sign_at(map, lowest->at), 0) << int(w);
    }
  }
  EXPECT_EQ(decided, defined);
}

TEST(DistanceLaws, LeastOfMuIsMinusTheInradiusOrPositive) {
  Shapes random(9);
  for (int k = 0; k < kTrials / 4; ++k) {
    ShapePair pair(random.shape(), random.shape());
    auto eta1 = pair.distance(Which::kEta1);
    Extremum mu = least(*pair.distance(Which::kMu));
    if (eta1->defined())
      EXPECT_NEAR(mu.answer->value.to_double(), least(*eta1).answer->value.to_double(), 1e-12);
    else
      EXPECT_GT(mu.answer->value.sign(), 0);
  }
}

}  // namespace distance_laws
}  // namespace findspace::distance
