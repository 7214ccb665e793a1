// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The best positions of distances in rotation, and of shapes that rotate in time, enclose what a lattice of positions
// finds.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "distance/planar_least/best_position.h"
#include "distance/rotation/rotation_in_time.h"
#include "distance/rotation/rotation_motion.h"
#include "law/plane_random.h"
#include "plane/complex/overlay.h"
#include "plane/complex/primitives.h"
#include "plane/query/topology.h"

namespace findspace::distance {
namespace distance_best_position {

using exact::Real;
using exact::RealPoint;
using plane::Random;
using plane::Region;

constexpr std::int64_t kUnit = 1000;
constexpr double kNone = std::numeric_limits<double>::infinity();

Region box(std::int64_t x0, std::int64_t y0, std::int64_t x1, std::int64_t y1) {
  plane::Contour ring;
  for (const plane::GridPoint p : {plane::GridPoint{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}})
    ring.push_back({{p.x * kUnit, p.y * kUnit}});
  return plane::region_of_rings({&ring, 1});
}

/// How far a disc at p rotates about the origin until it meets one at (arm, 0); r is the sum of the radii.
double rotation_to_contact(double x, double y, double directed_edge, double r) {
  const double d = std::hypot(x, y), cosine = (d * d + directed_edge * directed_edge - r * r) / (2 * d * directed_edge);
  if (cosine > 1) return kNone;
  if (cosine < -1) return -kNone;
  return (std::abs(std::atan2(y, x)) - std::acos(cosine)) * 180 / std::numbers::pi;
}

/// The best of f over a lattice of the box, rotated so that less is better.
template <class F>
double of_lattice(const F& f, std::int64_t x0, std::int64_t y0, std::int64_t x1, std::int64_t y1, int rotation) {
  constexpr int kSteps = 60;
  double best = kNone;
  for (int i = 0; i <= kSteps; ++i)
    for (int k = 0; k <= kSteps; ++k)
      best = std::min(best, rotation * f(double(x0) + double(i) / kSteps * double(x1 - x0),
                                         double(y0) + double(k) / kSteps * double(y1 - y0)));
  return best;
}

TEST(BestPosition, OfRotationEnclosesALattice) {
  int finite = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    Random random(seed);
    const std::int64_t directed_edge = random.pick(3, 6), x = random.pick(-6, 3), y = random.pick(-6, 3),
                       w = random.pick(1, 3);
    const Sense sense = seed % 2 == 0 ? Sense::kMinimum : Sense::kMaximum;
    const int rotation = sense == Sense::kMinimum ? 1 : -1;
    const RotationInTime f(plane::region_of_disc(Real(0), Real(0), Real(kUnit)),
                           plane::region_of_disc(Real(directed_edge * kUnit), Real(0), Real(kUnit)), Which::kGamma1, {},
                           {}, {RotatingPose{}});
    const Region s = box(x, y, x + w, y + w);
    const DiscRange range = [&](const RealPoint& p, double r) { return f.around(p, r).extremum(sense); };
    const double far = 20.0 * kUnit;
    const Extremum e = best_position(range, {s, s}, sense, {{-far, -far, far, far}, false, 1e-6, 120});
    const auto truth = [&](double px, double py) { return rotation_to_contact(px, py, double(directed_edge), 2); };
    const double lattice = of_lattice(truth, x, y, x + w, y + w, rotation);
    if (std::isinf(lattice) && lattice < 0) {
      EXPECT_TRUE(e.unbounded) << "seed " << seed;
      continue;
    }
    if (e.unbounded) continue;  // between the lattice's positions
    if (!e.exists()) {
      EXPECT_EQ(lattice, kNone) << "seed " << seed;
      continue;
    }
    ++finite;
    EXPECT_LE(rotation * e.bound()->to_double(), lattice + 1e-7) << "seed " << seed;
    EXPECT_LE(rotation * near_value(e.answer->value), lattice + 1) << "seed " << seed;
    const auto& p = e.at.point(0);
    EXPECT_NEAR(truth(p.x / kUnit, p.y / kUnit), near_value(e.answer->value), 1e-5) << "seed " << seed;
  }
  EXPECT_GE(finite, 3);
}

TEST(BestPosition, OfAShapeThatTurnsInTimeIsItsNearestCorner) {
  // A bar of half sides 2 and 1 rotates by 90 degrees; its corner comes as far as sqrt(5) towards (4, 0).
  const Region a = box(-2, -1, 2, 1);
  const RotatingMotion f(plane::region_of_disc(Real(0), Real(0), Real(kUnit)), a, Which::kGamma1,
                         {RotatingPose{}, RotatingPose{{}, {}, Real(90)}});
  const DiscRange range = [&](const RealPoint& p, double r) {
    const auto v = f.extremum(p, Sense::kMinimum, r / 4);
    return ValueRange{v->low - r, v->high + r};
  };
  const Region s = box(4, -3, 8, 3);
  const double far = 40.0 * kUnit;
  const Extremum e = best_position(range, {s, s}, Sense::kMinimum, {{-far, -far, far, far}, true, 1, 80});
  const double truth = 4 - std::sqrt(5) - 1;
  ASSERT_TRUE(e.exists());
  EXPECT_LE(e.bound()->to_double() / kUnit, truth + 1e-6);
  EXPECT_GE(near_value(e.answer->value) / kUnit, truth - 1e-6);
  EXPECT_LE((near_value(e.answer->value) - e.bound()->to_double()) / kUnit, 0.2);
}

TEST(BestPosition, OfASetBetweenTwoTakesCertainPositionsOnly) {
  const DiscRange x = [](const RealPoint& p, double r) { return ValueRange{near_value(p.x) - r, near_value(p.x) + r}; };
  const Region certain = box(2, 0, 4, 1), possible = box(1, 0, 5, 1);
  const Extremum least = best_position(x, {certain, possible}, Sense::kMinimum, {{}, true, 1e-3, 400});
  EXPECT_NEAR(near_value(least.answer->value), 2 * kUnit, 1);
  EXPECT_LE(least.bound()->to_double(), 1 * kUnit);
  EXPECT_GE(least.bound()->to_double(), 1 * kUnit - 3.0);  // boxes are not halved below a grid step
  const Region none = Region::uniform(0);
  EXPECT_FALSE(best_position(x, {none, possible}, Sense::kMinimum, {{}, true, 1e-3, 40}).exists());
  const Extremum all =
      best_position(x, {Region::uniform(1), Region::uniform(1)}, Sense::kMaximum, {{-9, -9, 9, 9}, true});
  EXPECT_TRUE(all.unbounded);
}

}  // namespace distance_best_position
}  // namespace findspace::distance
