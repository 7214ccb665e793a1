// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Distances over all angles against those of shapes rotated by Pythagorean angles, which keep multiples of 65 on the
// grid: there the Minkowski machinery gives the sign independently. And laws: rotating a shape shifts its map,
// exchanging the shapes mirrors it.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "../unit/distance_shapes.h"
#include "distance/rotation/rotated_directional.h"
#include "distance/rotation/rotated_pair.h"
#include "distance/rotation/rotational_by_angle.h"
#include "distance/rotation/rotational_distance.h"
#include "plane/build/transform.h"

namespace findspace::distance {
namespace distance_rotated {

using exact::Angle;
using exact::ExactAngle;
using exact::Real;
using plane::GridPoint;
using plane::Region;
using plane::RotationMap;

constexpr std::int64_t kUnit = 65;  // 5 * 13

/// A ring, or a disc, on a lattice of 65 steps.
struct Figure {
  std::vector<GridPoint> corners, hole;
  std::int64_t radius = 0;

  Region region() const {
    if (radius > 0) return plane::region_of_disc(corners[0].x, corners[0].y, radius);
    std::vector<plane::Contour> rings(hole.empty() ? 1 : 2);
    for (const GridPoint& p : corners) rings[0].push_back({.start = p});
    for (const GridPoint& p : hole) rings[1].push_back({.start = p});
    return plane::region_of_rings(rings);
  }
  Figure scaled(std::int64_t by) const {
    Figure out = *this;
    for (auto* list : {&out.corners, &out.hole})
      for (GridPoint& p : *list) p = {by * p.x, by * p.y};
    out.radius *= by;
    return out;
  }
  /// By the angle of (c, s), a Pythagorean pair with c^2 + s^2 = n^2 and n a divisor of 65.
  Figure rotated(std::int64_t c, std::int64_t s, std::int64_t n) const {
    Figure out = *this;
    for (auto* list : {&out.corners, &out.hole}) {
      for (GridPoint& p : *list) p = {(c * p.x - s * p.y) / n, (s * p.x + c * p.y) / n};
    }
    return out;
  }
};

class Figures {
 public:
  explicit Figures(unsigned seed) : random_(seed) {}
  std::int64_t number(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }

  Figure figure() {
    const GridPoint by{number(-3, 3), number(-3, 3)};
    switch (number(0, 4)) {
      case 0:
        return at(by, {{0, 0}, {number(1, 6), 0}, {6, number(1, 4)}, {0, number(5, 6)}});
      case 1:
        return at(by, {{0, 0}, {number(3, 7), number(-2, 2)}, {number(0, 3), number(3, 7)}});
      case 2:
        return at(by, {{0, 0}, {6, 0}, {6, 5}, {4, 4}, {number(2, 3), 2}, {1, 5}, {0, 5}});
      case 3: {
        Figure f = at(by, {{-5, -5}, {5, -5}, {5, 5}, {-5, 5}});
        f.hole = at(by, {{-3, -3}, {-3, number(-1, 4)}, {number(-1, 4), -3}}).corners;
        return f;
      }
      default: {
        Figure f = at(by, {{0, 0}});
        f.radius = number(1, 5) * kUnit;
        return f;
      }
    }
  }

 private:
  static Figure at(const GridPoint& by, std::vector<GridPoint> corners) {
    for (GridPoint& p : corners) p = {(p.x + by.x) * kUnit, (p.y + by.y) * kUnit};
    return {std::move(corners), {}, 0};
  }
  std::mt19937 random_;
};

struct Pythagorean {
  std::int64_t c, s, n;
  Angle angle() const { return {{Real::ratio(c, n), Real::ratio(s, n)}, Real()}; }
};

std::vector<Pythagorean> angles() {
  std::vector<Pythagorean> out;
  for (const auto& [c, s, n] : {Pythagorean{1, 0, 1}, {3, 4, 5}, {4, 3, 5}, {5, 12, 13}, {12, 5, 13}}) {
    out.push_back({c, s, n});
    out.push_back({-s, c, n});
    out.push_back({-c, -s, n});
    out.push_back({s, -c, n});
  }
  return out;
}

constexpr std::array kAll{Which::kGamma1, Which::kGamma2,    Which::kEta1,      Which::kDelta1,
                          Which::kMu,     Which::kMuBack,    Which::kHausdorff, Which::kD1,
                          Which::kH,      Which::kDstarBack, Which::kDiameter};

plane::Mark expected(const Figure& b, const Figure& a, const Pythagorean& p, Which which, const Real& level) {
  const ShapePair pair(b.rotated(p.c, p.s, p.n).region(), a.region());
  return testing::sign_at(pair.distance(which)->sign_map(level), testing::at(0, 0));
}

TEST(RotatedPair, AgreesWithRotatedShapes) {
  Figures figures(7);
  for (int trial = 0; trial < 66; ++trial) {
    const Figure b = figures.figure(), a = figures.figure();
    const Which which = kAll[std::size_t(trial) % kAll.size()];
    const bool containment = which == Which::kEta1 || which == Which::kDelta1;
    const Real level(figures.number(0, 3) * kUnit * (containment ? -1 : 1));
    const RotationMap map = RotatedPair(b.region(), a.region(), {}, {}).sign_map(which, level);
    for (const Pythagorean& p : angles()) {
      EXPECT_EQ(mark_at(map, p.angle()), expected(b, a, p, which, level))
          << "trial " << trial << " which " << int(which) << " level " << level.text() << " angle " << p.c << ","
          << p.s;
    }
  }
}

void expect_same(const RotationMap& f, const RotationMap& g) {
  ASSERT_EQ(f.at.size(), g.at.size());
  EXPECT_EQ(f.here, g.here);
  EXPECT_EQ(f.after, g.after);
  for (std::size_t k = 0; k < f.at.size(); ++k) EXPECT_EQ(compare(f.at[k], g.at[k]), 0);
  if (f.at.empty()) {
    EXPECT_EQ(f.everywhere, g.everywhere);
  }
}

TEST(RotatedPair, ARotatedShapeShiftsTheMap) {
  Figures figures(11);
  for (int trial = 0; trial < 6; ++trial) {
    const Figure b = figures.figure(), a = figures.figure();
    const Which which = kAll[std::size_t(trial)];
    const Real level =
        Real(figures.number(-1, 1) <= 0 ? 0 : kUnit) * Real(which == Which::kEta1 || which == Which::kDelta1 ? -1 : 1);
    const RotationMap map = RotatedPair(b.region(), a.region(), {}, {}).sign_map(which, level);
    expect_same(shifted(map, Real(-90)),
                RotatedPair(b.rotated(0, 1, 1).region(), a.region(), {}, {}).sign_map(which, level));
    expect_same(shifted(map, Real(90)),
                RotatedPair(b.region(), a.rotated(0, 1, 1).region(), {}, {}).sign_map(which, level));
  }
}

TEST(RotatedPair, ExchangeMirrors) {
  Figures figures(13);
  for (int trial = 0; trial < 4; ++trial) {
    const Figure b = figures.figure(), a = figures.figure();
    const RotatedPair there(b.region(), a.region(), {}, {}), back(a.region(), b.region(), {}, {});
    expect_same(there.sign_map(Which::kGamma1, 0), mirrored(back.sign_map(Which::kGamma1, 0)));
    expect_same(there.sign_map(Which::kDelta1, 0), mirrored(back.sign_map(Which::kEta1, 0)));
  }
}

/// Depths, containment above 0, inner touchings: also where rotated Pythagorean shapes fit exactly.
TEST(RotatedPair, FreePositionsAgreeWithRotatedShapes) {
  Figures figures(17);
  constexpr std::array kinds{Which::kGamma1, Which::kEta1,   Which::kDelta1,
                             Which::kEta2,   Which::kDelta2, Which::kPenetration};
  std::array<int, 3> seen{};
  for (int trial = 0; trial < 36; ++trial) {
    const Figure b = figures.figure(), a = figures.figure();
    const Which which = kinds[std::size_t(trial) % kinds.size()];
    const std::int64_t tall = which == Which::kEta2 || which == Which::kDelta2 ? 6 : 3;
    const Real level = Real(figures.number(1, int(tall)) * kUnit) * Real(which == Which::kGamma1 ? -1 : 1);
    const RotationMap map = RotatedPair(b.region(), a.region(), {}, {}).sign_map(which, level);
    for (const Pythagorean& p : angles()) {
      const plane::Mark sign = expected(b, a, p, which, level);
      ++seen[std::size_t(sign + 1)];
      EXPECT_EQ(mark_at(map, p.angle()), sign) << "trial " << trial << " which " << int(which) << " level "
                                               << level.text() << " angle " << p.c << "," << p.s;
    }
  }
  EXPECT_GT(seen[0], 20);
  EXPECT_GT(seen[1], 4);
}

bool is_eta(Which w) { return w == Which::kEta1 || w == Which::kEta2; }
bool is_delta(Which w) { return w == Which::kDelta1 || w == Which::kDelta2; }

PositionFunctionPointer directional(const Figure& b, const Figure& a, Which which,
                                    const TranslationDirection& direction) {
  const ShapePair pair(b.region(), a.region());
  const Which signed_base = is_eta(which) ? Which::kEta1 : is_delta(which) ? Which::kDelta1 : Which::kGamma1;
  plane::SignMap base = pair.distance(signed_base)->sign_map(Real());
  if (which == Which::kGamma2 || which == Which::kEta2 || which == Which::kDelta2)
    return std::make_shared<DirectionalFarthest>(std::move(base), direction);
  return std::make_shared<DirectionalSigned>(std::move(base), direction);
}

struct DirectionalKind {
  Which which;
  int side;  // of the level
};

/// Along a direction, both ways and one way: the sign maps of rotated shapes at the same position. The level is the
/// value at one of the angles, where there is one.
TEST(RotatedPair, DirectionalAgreesWithRotatedShapes) {
  Figures figures(23);
  constexpr std::array<DirectionalKind, 9> kinds{{{Which::kGamma1, 1},
                                                  {Which::kGamma1, -1},
                                                  {Which::kGamma2, 1},
                                                  {Which::kEta1, 1},
                                                  {Which::kEta1, -1},
                                                  {Which::kEta2, 1},
                                                  {Which::kDelta1, 1},
                                                  {Which::kDelta1, -1},
                                                  {Which::kDelta2, 1}}};
  constexpr std::array<GridPoint, 5> kWays{{{1, 0}, {0, 1}, {3, 4}, {-2, 1}, {-1, -3}}};
  std::array<std::array<int, 3>, kinds.size()> seen{};
  for (std::size_t trial = 0; trial < 14 * kinds.size(); ++trial) {
    const auto [which, side] = kinds[trial % kinds.size()];
    Figure b = figures.figure(), a = figures.figure();
    if (is_eta(which)) a = a.scaled(3);
    if (is_delta(which)) b = b.scaled(3);
    const GridPoint way = kWays[trial % kWays.size()];
    const TranslationDirection direction{way.x, way.y, trial % 2 == 0};
    Real level = Real(side * figures.number(1, 3) * kUnit);
    for (const Pythagorean& one : angles()) {
      const auto value = directional(b.rotated(one.c, one.s, one.n), a, which, direction)->value({});
      if (!value || value->minus_infinity || value->value.sign() != side) continue;
      level = value->value;
      if (figures.number(0, 2) == 0) break;
    }
    const Region rotating = b.region(), fixed = a.region();
    const RotationMap map = rotated_directional({rotating, fixed, {}, {}}, which, direction, level);
    for (const Pythagorean& p : angles()) {
      const plane::Mark sign = testing::sign_at(
          directional(b.rotated(p.c, p.s, p.n), a, which, direction)->sign_map(level), testing::at(0, 0));
      ++seen[trial % kinds.size()][std::size_t(sign + 1)];
      EXPECT_EQ(mark_at(map, p.angle()), sign) << "trial " << trial << " which " << int(which) << " level "
                                               << level.text() << " angle " << p.c << "," << p.s;
    }
  }
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    std::printf("%zu: %d %d %d\n", k, seen[k][0], seen[k][1], seen[k][2]);
  }
}

/// An end that is a root of high degree lies between angles a thousandth apart at which rotated shapes, on a lattice
/// fine enough for these angles, have the signs of its two sides.
TEST(RotatedPair, EndsAreWhereTheSignChanges) {
  Figures figures(29);
  constexpr std::array kinds{Which::kGamma1, Which::kEta1, Which::kDelta1, Which::kEta2};
  int ends = 0;
  for (int trial = 0; trial < 24; ++trial) {
    const Figure b = figures.figure(), a = figures.figure();
    if (b.radius > 0 || a.radius > 0) continue;
    const Which which = kinds[std::size_t(trial) % kinds.size()];
    const std::int64_t steps = figures.number(2, 4) * kUnit * (which == Which::kGamma1 ? -1 : 1);
    const RotationMap map = RotatedPair(b.region(), a.region(), {}, {}).sign_map(which, Real(steps));
    for (std::size_t k = 0; k < map.at.size(); ++k) {
      for (const int side : {-1, 1}) {
        // tan of half the angle is p / q; beyond its neighbours nothing is said.
        constexpr std::int64_t q = 1009;
        const double t = std::tan(map.at[k].degrees() * M_PI / 360);
        if (std::abs(t) > 1) continue;
        const auto p = std::int64_t(side < 0 ? std::floor(t * q - 0.01) : std::ceil(t * q + 0.01));
        const Pythagorean near{q * q - p * p, 2 * p * q, q * q + p * p};
        const std::size_t next = side < 0 ? (k + map.at.size() - 1) % map.at.size() : (k + 1) % map.at.size();
        if (map.at.size() > 1 && std::abs(std::remainder(map.at[next].degrees() - map.at[k].degrees(), 360)) < 0.3)
          continue;
        Figure fine = b, other = a;
        for (Figure* f : {&fine, &other}) {
          for (auto* list : {&f->corners, &f->hole})
            for (GridPoint& g : *list) g = {g.x * near.n, g.y * near.n};
        }
        ++ends;
        EXPECT_EQ(mark_at(map, near.angle()), expected(fine, other, near, which, Real(steps) * Real(near.n)))
            << "trial " << trial << " which " << int(which) << " end " << map.at[k].degrees() << " side " << side;
      }
    }
  }
  EXPECT_GT(ends, 12);
}

/// The first of the kinds, and whether the second was asked for.
Which first_kind(Which which) {
  if (which == Which::kGamma2) return Which::kGamma1;
  return which == Which::kEta2 ? Which::kEta1 : which == Which::kDelta2 ? Which::kDelta1 : which;
}

TEST(RotationAngles, BoundWhatShapesRotatedFirstAreAway) {
  Figures figures(11);
  constexpr std::int64_t kFine = 1000 * kUnit;
  int decided = 0, asked = 0, above = 0, below = 0;
  for (const auto& [which, level] : {std::pair{Which::kGamma1, 25}, {Which::kGamma2, 160}, {Which::kEta1, -5}}) {
    Figure b = figures.figure().scaled(1000), a = figures.figure().scaled(1000);
    const bool gamma = plain_of(which) == Which::kGamma1;
    if (!gamma) a = a.scaled(3);
    const std::int64_t away = gamma ? figures.number(0, 6) : 0;
    const exact::RealPoint about{Real(kFine), Real()}, to{Real((1 + away) * kFine), Real()},
        centre{Real(2 * kFine), Real(kFine)};
    const Region still = b.region(), fixed = a.region();
    const BoundedRotations maps = rotation_angle_maps({still, fixed, about, to}, which, centre, Real(level));
    for (const Pythagorean& p : angles()) {
      // B stands rotated about `about`; then only the turn about the centre is left.
      const Region rotated = b.rotated(p.c, p.s, p.n).region();
      const exact::RealPoint pole{(Real(p.c) * about.x - Real(p.s) * about.y) / Real(p.n),
                                  (Real(p.s) * about.x + Real(p.c) * about.y) / Real(p.n)};
      const exact::RealPoint own{centre.x - to.x + pole.x, centre.y - to.y + pole.y};
      const RotationMap base = RotatedPair(rotated, fixed, own, centre).sign_map(first_kind(which), Real());
      const RotationMap exact =
          is_second_kind(which) ? farthest_rotation_sign_map(base, Real(level)) : rotation_sign_map(base, Real(level));
      const int sign = mark_at(exact, Angle{}), low = mark_at(maps.low, p.angle()),
                high = mark_at(maps.high, p.angle());
      EXPECT_LE(low, sign) << "which " << int(which) << " level " << level << " angle " << p.c << "," << p.s;
      EXPECT_GE(high, sign) << "which " << int(which) << " level " << level << " angle " << p.c << "," << p.s;
      ++asked;
      decided += low == high;
      above += sign > 0;
      below += sign < 0;
    }
  }
  EXPECT_GT(decided, asked * 9 / 10);
  EXPECT_GT(above, asked / 10);
  EXPECT_GT(below, asked / 10);
}

}  // namespace distance_rotated
}  // namespace findspace::distance
