// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Shapes that rotate in time, against a closed form: a disc that is off its own origin by R goes along an arc of radius
// R, and its distance to a disc about the origin is that of a point to an arc. Values, their bounds, and both bounds of
// the regions.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "distance/rotation/motion_maps.h"
#include "distance/rotation/rotation_in_time.h"
#include "distance/rotation/rotational_by_position.h"
#include "law/plane_random.h"
#include "plane/complex/primitives.h"
#include "plane/query/locate.h"

namespace findspace::distance {
namespace distance_rotating {

using exact::Real;
using plane::Random;

struct ExactAngle {
  double directed_edge, from, to, reach;  // degrees; sum of the radii
  std::vector<RotatingPose> poses;
};

/// gamma1 at the angle, for p.
double at_angle(const ExactAngle& t, double x, double y, double degrees) {
  const double a = degrees * std::numbers::pi / 180;
  return std::hypot(x + t.directed_edge * std::cos(a), y + t.directed_edge * std::sin(a)) - t.reach;
}

/// Its least and greatest value: the nearest and farthest angles are that of -p, the opposite one, or an end.
std::pair<double, double> extremes(const ExactAngle& t, double x, double y) {
  double least = at_angle(t, x, y, t.from), most = least;
  auto take = [&](double degrees) {
    least = std::min(least, at_angle(t, x, y, degrees));
    most = std::max(most, at_angle(t, x, y, degrees));
  };
  take(t.to);
  const double toward = std::atan2(-y, -x) * 180 / std::numbers::pi;
  for (int k = -6; k <= 6; ++k) {
    const double degrees = toward + 180 * k;
    if (degrees > std::min(t.from, t.to) && degrees < std::max(t.from, t.to)) take(degrees);
  }
  return {least, most};
}

TEST(Rotation, ValuesAndBoundsOfADiscOnAnArm) {
  constexpr std::int64_t kUnit = 1000000;  // grid steps
  int decided = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    Random random(seed);
    const std::int64_t directed_edge = random.pick(1, 5), r = random.pick(1, 2), a = random.pick(1, 2);
    const std::int64_t from = random.pick(-90, 90), to = from + random.pick(20, 150);
    ExactAngle t{double(directed_edge), double(from), double(to), double(r + a), {}};
    t.poses = {{{}, Real(from), Real()}, {{}, Real(to), Real()}};
    const plane::Region b = plane::region_of_disc(Real(directed_edge * kUnit), Real(0), Real(r * kUnit));
    const plane::Region fixed = plane::region_of_disc(Real(0), Real(0), Real(a * kUnit));
    const RotatingMotion f(b, fixed, Which::kGamma1, t.poses);
    const std::int64_t level = random.pick(-1, 2);
    const BoundedMaps low = motion_maps(b, fixed, Which::kGamma1, t.poses, Sense::kMinimum, Real(level * kUnit));
    const BoundedMaps high = motion_maps(b, fixed, Which::kGamma1, t.poses, Sense::kMaximum, Real(level * kUnit));
    for (int k = 0; k < 12; ++k) {
      const std::int64_t x = random.pick(-7 * kUnit, 7 * kUnit), y = random.pick(-7 * kUnit, 7 * kUnit);
      const auto [least, most] = extremes(t, double(x) / kUnit, double(y) / kUnit);
      const exact::RealPoint p{Real(x), Real(y)};
      for (const auto& [maps, truth, sense] :
           {std::tuple{&low, least, Sense::kMinimum}, std::tuple{&high, most, Sense::kMaximum}}) {
        const int sign = truth > level ? 1 : -1, under = mark_of(maps->low, locate(maps->low, p)),
                  over = mark_of(maps->high, locate(maps->high, p));
        ASSERT_LE(under, sign) << "seed " << seed;
        ASSERT_GE(over, sign) << "seed " << seed;
        decided += under == over;
        if (k > 1) continue;
        const auto v = f.extremum(p, sense);
        ASSERT_TRUE(v.has_value());
        ASSERT_NEAR((sense == Sense::kMinimum ? v->high : v->low) / kUnit, truth, 1e-8) << "seed " << seed;
        ASSERT_LE(v->low / kUnit, truth + 1e-12) << "seed " << seed;
        ASSERT_GE(v->high / kUnit, truth - 1e-12) << "seed " << seed;
        ASSERT_LT((v->high - v->low) / kUnit, 0.02) << "seed " << seed;
      }
    }
  }
  EXPECT_GT(decided, 8 * 12 * 2 * 8 / 10);
}

/// How far a disc has to turn about a point to meet another disc, in degrees; far: the greatest such angle.
double angle_to_contact(double px, double py, double ax, double ay, double reach, bool far) {
  const double b = std::hypot(px, py), a = std::hypot(ax, ay), cosine = (a * a + b * b - reach * reach) / (2 * a * b);
  const double none = std::numeric_limits<double>::infinity(), degree = std::numbers::pi / 180;
  if (cosine > 1) return none;
  if (cosine < -1) return far ? 180 : -none;
  const double width = std::acos(cosine) / degree;
  double gap = std::abs(std::atan2(ay, ax) - std::atan2(py, px)) / degree;
  gap = std::min(gap, 360 - gap);
  return far ? std::min(180.0, gap + width) : gap - width;
}

TEST(Rotation, PositionsOfADiscThatTurnsToAnother) {
  constexpr std::int64_t kUnit = 1000000;
  Random random(5);
  int decided = 0, asked = 0;
  for (const auto& [which, level] :
       {std::pair{Which::kGamma1, 20}, {Which::kGamma1, -10}, {Which::kGamma2, 60}, {Which::kGamma1, 150}}) {
    const plane::Region b = plane::region_of_disc(Real(0), Real(0), Real(kUnit));
    const plane::Region a = plane::region_of_disc(Real(6 * kUnit), Real(2 * kUnit), Real(kUnit));
    const BoundedMaps maps = rotation_position_maps(b, a, which, {Real(kUnit), Real(-kUnit)}, Real(level));
    for (int k = 0; k < 40; ++k) {
      const std::int64_t x = random.pick(-8 * kUnit, 10 * kUnit), y = random.pick(-8 * kUnit, 9 * kUnit);
      const double f = angle_to_contact(double(x) / kUnit - 1, double(y) / kUnit + 1, 5, 3, 2, which == Which::kGamma2);
      const int sign = f > level ? 1 : -1;
      const exact::RealPoint p{Real(x), Real(y)};
      const int low = mark_of(maps.low, locate(maps.low, p)), high = mark_of(maps.high, locate(maps.high, p));
      EXPECT_LE(low, sign) << "level " << level << " at " << x << ", " << y;
      EXPECT_GE(high, sign) << "level " << level << " at " << x << ", " << y;
      ++asked;
      decided += low == high;
    }
  }
  EXPECT_GT(decided, asked * 8 / 10);
}

/// Of a disc at p to one that goes from a to a2, both rotated about (1, -1): the least or greatest over many instants.
double over_instants(double px, double py, const std::array<double, 4>& way, double reach, bool far, Sense sense) {
  constexpr int kInstants = 2000;
  double best = angle_to_contact(px - 1, py + 1, way[0] - 1, way[1] + 1, reach, far);
  for (int k = 1; k <= kInstants; ++k) {
    const double t = double(k) / kInstants;
    const double ax = way[0] + t * (way[2] - way[0]), ay = way[1] + t * (way[3] - way[1]);
    const double f = angle_to_contact(px - 1, py + 1, ax - 1, ay + 1, reach, far);
    best = sense == Sense::kMinimum ? std::min(best, f) : std::max(best, f);
  }
  return best;
}

TEST(Rotation, RotationToADiscThatMoves) {
  constexpr std::int64_t kUnit = 1000000;
  constexpr double kSlack = 0.01;  // instants between those looked at, as a part of the radii
  Random random(7);
  int decided = 0, asked = 0;
  struct Ask {
    Which which;
    int level;
    Sense sense;
  };
  for (const Ask& ask : {Ask{Which::kGamma1, 20, Sense::kMinimum},
                         {Which::kGamma1, 20, Sense::kMaximum},
                         {Which::kGamma1, -6, Sense::kMinimum},
                         {Which::kGamma1, -6, Sense::kMaximum},
                         {Which::kGamma2, 70, Sense::kMinimum},
                         {Which::kGamma2, 70, Sense::kMaximum}}) {
    const bool far = ask.which == Which::kGamma2, least = ask.sense == Sense::kMinimum;
    const plane::Region b = plane::region_of_disc(Real(0), Real(0), Real(kUnit)),
                        a = plane::region_of_disc(Real(2 * kUnit), Real(0), Real(kUnit));
    const std::array<double, 4> way{6, 2, 3, 5};
    const auto at = [](std::int64_t x, std::int64_t y) { return exact::RealPoint{Real(x * kUnit), Real(y * kUnit)}; };
    // A is drawn at (2, 0) and goes by (4, 2), then by (1, 5); B stands still.
    const std::vector<RotatingPose> poses{{at(-4, -2), {}, {}, at(4, 2)}, {at(-1, -5), {}, {}, at(1, 5)}};
    const exact::RealPoint centre = at(1, -1);
    const BoundedMaps maps = rotation_position_maps(b, a, ask.which, centre, Real(ask.level), poses, ask.sense);
    for (int k = 0; k < 40; ++k) {
      const std::int64_t x = random.pick(-8 * kUnit, 10 * kUnit), y = random.pick(-8 * kUnit, 9 * kUnit);
      const double px = double(x) / kUnit, py = double(y) / kUnit;
      const double f = over_instants(px, py, way, 2, far, ask.sense),
                   below = over_instants(px, py, way, 2 + (far ? -kSlack : kSlack), far, ask.sense),
                   above = over_instants(px, py, way, 2 - (far ? -kSlack : kSlack), far, ask.sense);
      const exact::RealPoint p{Real(x), Real(y)};
      const int low = mark_of(maps.low, locate(maps.low, p)), high = mark_of(maps.high, locate(maps.high, p));
      // Instants that were looked at refute strictly, the others only beyond the slack.
      if (low > 0) {
        EXPECT_GT(least ? f : above, ask.level) << "at " << px << ", " << py;
      }
      if (high < 0) {
        EXPECT_LT(least ? below : f, ask.level) << "at " << px << ", " << py;
      }
      ++asked;
      decided += low == high;
      if (k > 0) continue;
      const auto v = RotationInTime(b, a, ask.which, centre, p, poses).extremum(ask.sense);
      if (std::isinf(f)) continue;
      EXPECT_LE(v.low, above + 0.2) << "at " << px << ", " << py;
      EXPECT_GE(v.high, below - 0.2) << "at " << px << ", " << py;
      EXPECT_LT(v.high - v.low, 0.5);
    }
  }
  EXPECT_GT(decided, asked * 6 / 10);
}

}  // namespace distance_rotating
}  // namespace findspace::distance
