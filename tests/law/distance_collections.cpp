// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// How distances of unions follow from those of their parts (the table of distances.md 5), where they do; and the
// symmetries of distances.md 2.5 that are not in distance_laws.cpp. +infinity where a distance is undefined.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "distance_random.h"
#include "plane/walk/unite.h"

namespace findspace::distance {
namespace distance_collections {

constexpr int kTrials = 25;
constexpr double kSlack = 1e-11;

double value(const ShapePair& pair, Which which, const RealPoint& p) {
  auto v = pair.distance(which)->value(p);
  return v ? v->value.to_double() : INFINITY;
}

Region united(const Region& a, const Region& b) {
  std::array<const Region*, 2> both{&a, &b};
  return plane::unite(both);
}

/// f of the union, and f of both parts.
struct Three {
  double f, f1, f2;
  double least() const { return std::min(f1, f2); }
  double greatest() const { return std::max(f1, f2); }
};

void expect_equal(double a, double b) {
  if (std::isinf(a) || std::isinf(b)) {
    EXPECT_EQ(a, b);
  } else {
    EXPECT_NEAR(a, b, kSlack);
  }
}

/// Of a distance whose sublevel sets are unions of those of the parts, at levels >= 0 at least.
void expect_gap(const Three& t) {
  EXPECT_LE(t.f, t.least() + kSlack);
  if (t.least() >= 0) expect_equal(t.f, t.least());
}

/// Of a signed distance to the intersection of the parts' sets.
void expect_all(const Three& t) {
  EXPECT_GE(t.f, t.greatest() - kSlack);
  if (t.greatest() <= 0) expect_equal(t.f, t.greatest());
}

TEST(Collections, OverPartsOfTheFixedShape) {
  Shapes random(31);
  for (int k = 0; k < kTrials; ++k) {
    Region a1 = random.shape(), a2 = random.shape(), b = random.shape();
    ShapePair pair(b, united(a1, a2)), first(b, a1), second(b, a2);
    RealPoint p = random.position();
    auto three = [&](Which w) { return Three{value(pair, w, p), value(first, w, p), value(second, w, p)}; };
    expect_gap(three(Which::kGamma1));
    expect_equal(three(Which::kD1).f, three(Which::kD1).least());
    expect_equal(three(Which::kGamma2).f, three(Which::kGamma2).greatest());
    EXPECT_LE(three(Which::kEta1).f, three(Which::kEta1).least() + kSlack);
    Three eta2 = three(Which::kEta2);
    for (double part : {eta2.f1, eta2.f2})
      if (!std::isinf(part)) {
        EXPECT_GE(eta2.f, part - kSlack);
      }
    expect_all(three(Which::kDelta1));
    Three delta2 = three(Which::kDelta2);
    if (!std::isinf(delta2.f)) {
      EXPECT_LE(delta2.f, delta2.least() + kSlack);
    }
    EXPECT_LE(three(Which::kMu).f, three(Which::kMu).least() + kSlack);
    expect_equal(three(Which::kMuBack).f, three(Which::kMuBack).greatest());
    EXPECT_LE(three(Which::kHausdorff).f, three(Which::kHausdorff).greatest() + kSlack);
    EXPECT_GE(three(Which::kDstarBack).f, three(Which::kDstarBack).greatest() - kSlack);
  }
}

TEST(Collections, OverPartsOfTheMovingShape) {
  Shapes random(32);
  for (int k = 0; k < kTrials; ++k) {
    Region a = random.shape(), b1 = random.shape(), b2 = random.shape();
    ShapePair pair(united(b1, b2), a), first(b1, a), second(b2, a);
    RealPoint p = random.position();
    auto three = [&](Which w) { return Three{value(pair, w, p), value(first, w, p), value(second, w, p)}; };
    expect_gap(three(Which::kGamma1));
    expect_equal(three(Which::kD1).f, three(Which::kD1).least());
    expect_equal(three(Which::kGamma2).f, three(Which::kGamma2).greatest());
    expect_all(three(Which::kEta1));
    Three eta2 = three(Which::kEta2);
    if (!std::isinf(eta2.f)) {
      EXPECT_LE(eta2.f, eta2.least() + kSlack);
    }
    EXPECT_LE(three(Which::kDelta1).f, three(Which::kDelta1).least() + kSlack);
    Three delta2 = three(Which::kDelta2);
    for (double part : {delta2.f1, delta2.f2})
      if (!std::isinf(part)) {
        EXPECT_GE(delta2.f, part - kSlack);
      }
    expect_equal(three(Which::kMu).f, three(Which::kMu).greatest());
    EXPECT_LE(three(Which::kMuBack).f, three(Which::kMuBack).least() + kSlack);
    EXPECT_LE(three(Which::kHausdorff).f, three(Which::kHausdorff).greatest() + kSlack);
    expect_equal(three(Which::kDstarBack).f, three(Which::kDstarBack).least());
  }
}

TEST(Collections, ACommonHalfRotationChangesNothing) {
  Shapes random(33);
  for (int k = 0; k < kTrials; ++k) {
    Region a = random.shape(), b = random.shape();
    ShapePair pair(b, a), rotated(plane::mirrored(b), plane::mirrored(a));
    RealPoint p = random.position();
    for (Which w : kAll) expect_equal(value(pair, w, p), value(rotated, w, {-p.x, -p.y}));
  }
}

TEST(Collections, GrowingBothTwofoldDoublesEveryDistance) {
  Shapes random(34);
  for (int k = 0; k < kTrials; ++k) {
    // Convex shapes: S (+) S is twice S.
    Region a = random.rectangle(), b = random.rectangle();
    ShapePair pair(b, a), twice(plane::minkowski_sum(b, b), plane::minkowski_sum(a, a));
    RealPoint p = random.position();
    for (Which w : kAll) expect_equal(2 * value(pair, w, p), value(twice, w, {p.x + p.x, p.y + p.y}));
  }
}

}  // namespace distance_collections
}  // namespace findspace::distance
