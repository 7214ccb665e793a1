// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Distances to solids that balls are cut out of or that are cut off by them, against their formulas: the witnesses
// belong to the shapes and are as far from each other as the value says, and no sampled place is nearer (farther).
#include <findspace/error.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "distance/csg/csg_pair.h"
#include "plane/base/search_work.h"
#include "unit/cut_cases.h"
#include "unit/space_bodies.h"

namespace findspace::distance {
namespace distance_cut_values {

using exact::Real;
using plane::Shape;
using space::ball;
using space::Body;
using space::CsgSolid;
using space::node;
using space::Point;
using space::RealVector;
using Kind = Shape::Kind;

RealVector on_grid(const Vector& v) {
  const auto c = [](double x) { return Real::ratio(static_cast<std::int64_t>(std::floor(x * 8)), 8); };
  return {c(v.x), c(v.y), c(v.z)};
}

constexpr double kHalf = 3;  // of the cube that moves

/// A cube against the solid, or against its mirror image.
std::shared_ptr<const CsgSide> side_of(const Case& c, bool mirrored = false) {
  const CsgSolid solid = space::csg_solid(*c.shape);
  return std::make_shared<const CsgSide>(space::shared(space::box_body({{{{-3, -3, -3}, {3, 3, 3}}}})),
                                         std::make_shared<const CsgSolid>(mirrored ? space::mirrored(solid) : solid));
}

PairDistances pair_of(const Case& c, bool cut_moves = false) { return csg_pair(side_of(c), cut_moves); }

double to_cube(const Vector& x, const Vector& p) {
  return to_box(x, p - Vector{kHalf, kHalf, kHalf}, space::plus(p, {kHalf, kHalf, kHalf}));
}

/// No sampled place of the solid is nearer to the cube, or farther from its corners, and samples meet the interiors of
/// both only where the value says so.
TEST(CutValues, AreThoseOfSamples) {
  std::mt19937 random(7);
  int apart = 0, meeting = 0;
  for (const Case& c : cases()) {
    const auto side = side_of(c);
    const PairDistances pair = csg_pair(side, false);
    std::vector<Vector> solid;
    while (solid.size() < 60000) {
      const Vector x = any(random, 30);
      if (c.level(x) < 0) solid.push_back(x);
    }
    for (int k = 0; k < 25; ++k) {
      const RealVector p = on_grid(any(random, 28));
      const Vector near = space::rounded(p);
      double least = exact::kInfinity, most = 0;
      for (const Vector& x : solid) {
        least = std::min(least, to_cube(x, near));
        const Vector off{std::fabs(x.x - near.x) + kHalf, std::fabs(x.y - near.y) + kHalf,
                         std::fabs(x.z - near.z) + kHalf};
        most = std::max(most, space::length(off));
      }
      const double far = pair.value(Which::kGamma2, p)->value.to_double();
      EXPECT_GE(far, most) << c.name;
      EXPECT_LE(far, most + 2) << c.name;
      const Answer d1 = *pair.value(Which::kD1, p);
      EXPECT_LE(d1.value.to_double(), std::max(0.0, least) + 1e-9) << c.name;
      EXPECT_GE(d1.value.to_double(), least - 2) << c.name;
      if (least < 0) {
        ++meeting;
        EXPECT_LT(between(side, Which::kGamma1, Real(), p).or_throw()->high, 0) << c.name;
        continue;
      }
      if (d1.witness.empty() || d1.value.sign() == 0) continue;
      ++apart;
      const Vector b = space::rounded(d1.witness[0].at), a = space::rounded(d1.witness[1].at);
      EXPECT_NEAR(space::length(a - b), d1.value.to_double(), 1e-9) << c.name;
      EXPECT_LT(c.level(a), 1e-9) << c.name;
      EXPECT_LT(to_cube(b, near), 1e-9) << c.name;
    }
  }
  EXPECT_GT(apart, 40);
  EXPECT_GT(meeting, 20);
}

/// No point of the cube is farther from the solid than the protrusion says, and its witness is as far; on lines it has
/// the sign of the value.
TEST(CutValues, ProtrusionIsThatOfSamples) {
  std::mt19937 random(11);
  int out = 0;
  for (const Case& c : cases()) {
    const auto side = side_of(c);
    const PairDistances pair = csg_pair(side, false);
    const auto solid = std::make_shared<const CsgSolid>(space::csg_solid(*c.shape));
    const auto gap = [&](const RealVector& x) {
      Body point;
      point.parts.emplace_back();
      return CsgSide(space::shared(std::move(point)), solid)
          .gap(x, PairSide::Depth::kSign)
          .or_throw()
          ->value.to_double();
    };
    for (int k = 0; k < 4; ++k) {
      const RealVector p = on_grid(any(random, 24));
      const Answer v = *pair.value(Which::kMu, p);
      if (v.value.sign() <= 0) continue;
      ++out;
      const double low = v.bounds().lower->to_double(), high = v.bounds().upper->to_double();
      EXPECT_LT(high - low, 0.25) << c.name;
      ASSERT_EQ(v.witness.size(), 2u) << c.name;
      EXPECT_LT(to_cube(space::rounded(v.witness[0].at), space::rounded(p)), 1e-9) << c.name;  // no sign: test
      EXPECT_GE(gap(v.witness[0].at), low - 0.001) << c.name;
      for (int i = 0; i < 40; ++i) EXPECT_LE(gap(space::plus(p, on_grid(any(random, kHalf)))), high + 1e-6) << c.name;
      for (const double level : {low / 2, high * 2}) {
        const Between at = **between(side, Which::kMu, Real::from_double(level), p);
        EXPECT_TRUE(level < low ? at.low > 0 : at.high < 0) << c.name;
      }
    }
  }
  EXPECT_GT(out, 10);
}

/// A point protrudes by its gap, also above a pit: there the bottom may be nearer than the rim.
TEST(CutValues, APointProtrudesByItsGap) {
  std::mt19937 random(13);
  const Shape::Kind without = Kind::kDifference;
  std::vector<plane::ShapePtr> shapes{
      node(without, {box({-20, -20, -20}, {20, 20, 20}), ball({0, 0, 28}, 15)}),
      node(without, {box({-20, -20, -20}, {20, 20, 20}), ball({3, 1, 12}, 15)}),
      node(without, {ball({0, 0, 0}, 20), ball({4, 2, 26}, 15)}),
      node(without, {ball({0, 0, 0}, 20), ball({4, 2, 10}, 15)}),
  };
  for (const Case& c : cases()) shapes.push_back(c.shape);
  const auto point = std::make_shared<Body>();
  point->parts.emplace_back();
  int out = 0;
  for (const plane::ShapePtr& shape : shapes) {
    const PairDistances pair = csg_pair(
        std::make_shared<const CsgSide>(point, std::make_shared<const CsgSolid>(space::csg_solid(*shape))), false);
    for (int k = 0; k < 60; ++k) {
      const RealVector p = on_grid(k % 2 == 0 ? any(random, 28) : space::plus(any(random, 4), {1, 1, 22}));
      const double gap = pair.value(Which::kGamma1, p)->value.to_double();
      if (gap < 0.01) continue;
      ++out;
      const Answer v = *pair.value(Which::kMu, p);
      EXPECT_LE(v.bounds().lower->to_double(), gap + 1e-9) << space::rounded(p).x << " " << space::rounded(p).z;
      EXPECT_GE(v.bounds().upper->to_double(), gap - 1e-9) << space::rounded(p).x << " " << space::rounded(p).z;
      EXPECT_NEAR(v.value.to_double(), gap, 0.01);
    }
  }
  EXPECT_GT(out, 200);
}

/// The cube is in the solid where its corners and no place of what is cut out are: E is known by formula.
TEST(CutValues, SayHowFarTheCubeIsFromFitting) {
  std::mt19937 random(8);
  const auto fits = [](const Case& c, const Vector& p) {
    // Convex solids hold it by its corners; what is cut out is decided by the place of the cube nearest to its centre.
    for (int i = 0; i < 8; ++i) {
      const Vector corner{p.x + (i & 1 ? kHalf : -kHalf), p.y + (i & 2 ? kHalf : -kHalf),
                          p.z + (i & 4 ? kHalf : -kHalf)};
      if (c.level(corner) > 0) return false;
    }
    const auto out = [&](const Vector& center, double r) { return to_cube(center, p) >= r; };
    const std::string name = c.name;
    if (name == "bowl") return out({0, 0, 20}, 15);
    if (name == "block with two pockets") return out({-20, -20, 0}, 17) && out({20, 20, 0}, 17);
    return true;
  };
  for (const Case& c : cases()) {
    if (std::string(c.name).find("shell") != std::string::npos) continue;
    const PairDistances pair = pair_of(c);
    std::vector<Vector> all;
    for (int k = 0; k < 400000; ++k) {
      const Vector q = any(random, 20);
      if (fits(c, q)) all.push_back(q);
    }
    ASSERT_GT(all.size(), 100u) << c.name;
    for (int k = 0; k < 12; ++k) {
      const RealVector p = on_grid(any(random, 30));
      const Vector near = space::rounded(p);
      double least = exact::kInfinity, most = 0;
      for (const Vector& q : all) {
        const double d = space::length(q - near);
        least = std::min(least, d);
        most = std::max(most, d);
      }
      const Answer v = *pair.value(Which::kEta1, p);
      EXPECT_EQ(v.value.sign() <= 0, fits(c, near)) << c.name;
      if (v.value.sign() > 0) {
        EXPECT_LE(v.value.to_double(), least + 1e-9) << c.name;
        EXPECT_GE(v.value.to_double(), least - 2.5) << c.name;
        ASSERT_TRUE(v.nearest);
        const Vector q = space::rounded(*v.nearest);
        EXPECT_NEAR(space::length(q - near), v.value.to_double(), 1e-9) << c.name;
      }
      const Answer far = *pair.value(Which::kEta2, p);
      EXPECT_GE(far.value.to_double(), most - 1e-9) << c.name;
      EXPECT_LE(far.value.to_double(), most + 3.5) << c.name;
    }
  }
}

/// A cut solid that moves is seen from the other side.
TEST(CutValues, AreTheSameWhicheverShapeMoves) {
  std::mt19937 random(9);
  for (const Case& c : cases()) {
    const PairDistances forth = pair_of(c), back = pair_of(c, true);
    for (int k = 0; k < 4; ++k) {
      const RealVector p = on_grid(any(random, 30));
      for (const auto& [one, other] :
           {std::pair{Which::kD1, Which::kD1}, {Which::kGamma2, Which::kGamma2}, {Which::kMuBack, Which::kMu}}) {
        EXPECT_EQ(forth.value(one, p)->value, back.value(other, space::negated(p))->value) << c.name;
      }
    }
  }
}

/// A cube that is cut in two is the same set: how the solid fits into it, and protrudes from it, is the same.
TEST(CutValues, OfUnionsAreThoseOfTheirSets) {
  std::mt19937 random(12);
  int out = 0, inside = 0;
  for (const Case& c : cases()) {
    for (const std::int64_t half : {9, 40}) {
      const auto solid = std::make_shared<const CsgSolid>(space::csg_solid(*c.shape));
      const auto pair = [&](const std::vector<space::Corners>& boxes) {
        return csg_pair(std::make_shared<const CsgSide>(space::shared(space::box_body(boxes)), solid), false);
      };
      const PairDistances whole = pair({{{{-half, -half, -half}, {half, half, half}}}}),
                          cut = pair(
                              {{{{-half, -half, -half}, {2, half, half}}}, {{{2, -half, -half}, {half, half, half}}}});
      for (int k = 0; k < 3; ++k) {
        const RealVector p = on_grid(any(random, 12));
        const Answer one = *whole.value(Which::kMuBack, p), other = *cut.value(Which::kHBack, p);
        EXPECT_NEAR(std::max(0.0, one.value.to_double()), other.value.to_double(), 1e-9) << c.name;
        one.value.sign() > 0 ? ++out : ++inside;
        EXPECT_NEAR(cut.value(Which::kMuBack, p)->value.to_double(), one.value.to_double(), 1e-9) << c.name;
        for (const Which which : {Which::kDelta1, Which::kDelta2}) {
          if (which == Which::kDelta2 && k > 0) continue;  // it takes longer
          const auto fit = whole.value(which, p), of_cut = cut.value(which, p);
          ASSERT_EQ(fit.has_value(), of_cut.has_value()) << c.name;
          if (fit)
            EXPECT_NEAR(fit->value.to_double(), of_cut->value.to_double(), 1e-9 + fit->slack() + of_cut->slack());
        }
      }
    }
  }
  EXPECT_GT(out, 10);
  EXPECT_GT(inside, 2);
}

/// Of the solid alone: no two samples are farther apart.
TEST(CutValues, HaveDiameters) {
  std::mt19937 random(14);
  for (const Case& c : cases()) {
    const Answer v = **side_of(c)->own_diameter();
    const double low = v.bounds().lower->to_double(), high = v.bounds().upper->to_double();
    EXPECT_LT(high - low, 0.01) << c.name;
    std::vector<Vector> solid;
    while (solid.size() < 3000) {
      const Vector x = any(random, 30);
      if (c.level(x) < 0) solid.push_back(x);
    }
    double most = 0;
    for (const Vector& x : solid) {
      for (const Vector& y : solid) most = std::max(most, space::length(x - y));
    }
    EXPECT_GE(high, most) << c.name;
    EXPECT_LE(low, most + 4) << c.name;
  }
  const std::vector<Case> all = cases();
  const auto exact = [](const Case& c) { return **side_of(c)->own_diameter(); };
  EXPECT_TRUE(exact(all[0]).proven);
  EXPECT_EQ(exact(all[0]).value, sqrt(Real(4800)));
  EXPECT_TRUE(exact(all[3]).proven);
  EXPECT_EQ(exact(all[3]).value, Real(48));
  // The rim of the lens: two spheres, 409 apart by squares.
  const double ahead = (409 + 400 - 361) / (2 * std::sqrt(409.0));
  EXPECT_NEAR(exact(all[2]).value.to_double(), 2 * std::sqrt(400 - ahead * ahead), 1e-9);
  // Of both shapes together.
  EXPECT_EQ(pair_of(all[3]).value(Which::kDiameter, {})->value, Real(48));
  EXPECT_EQ(pair_of(all[3]).value(Which::kDiameter, space::place(90, 0, 0))->value,
            pair_of(all[3]).value(Which::kGamma2, space::place(90, 0, 0))->value);
}

/// Of a ball and a lens with a rim of radius 12 about the origin, whose height is 12.
TEST(CutValues, HaveLeastOnes) {
  const auto lens = std::make_shared<const CsgSolid>(
      space::csg_solid(*node(Kind::kIntersection, {ball({0, 0, -9}, 15), ball({0, 0, 9}, 15)})));
  const auto least_of = [&](Which which, const plane::ShapePtr& other, bool cut_moves) {
    const auto side = std::make_shared<const CsgSide>(space::shared(space::body(*other)), lens);
    const Answer v = *csg_least(cut_moves ? exchanged(which) : which, side, cut_moves).or_throw();
    const TriedAnswer there = csg_pair(side, cut_moves).try_value(cut_moves ? exchanged(which) : which, v.at);
    EXPECT_EQ((*there)->value, v.value);
    return v;
  };
  const auto least = [&](Which which, std::int64_t radius, bool cut_moves = false) {
    return least_of(which, ball({1, 0, 0}, radius), cut_moves);
  };
  const auto is = [](const Answer& v, double value, double wide) {
    const double low = v.bounds().lower->to_double(), high = v.bounds().upper->to_double();
    EXPECT_LE(low, value + 1e-9);
    EXPECT_GE(high, value - 1e-9);
    EXPECT_LE(high - low, wide);
  };
  for (const bool moves : {false, true}) {
    is(least(Which::kGamma2, 4, moves), 16, 1e-8);
    is(least(Which::kDiameter, 4, moves), 24, 1e-8);
    is(least(Which::kEta1, 2, moves), -4, 1e-8);
    is(least(Which::kMu, 2, moves), -4, 1e-8);
    is(least(Which::kH, 2, moves), 0, 0);
    is(least(Which::kEta2, 2, moves), std::sqrt(88.0), 0.1);
    is(least(Which::kD1, 2, moves), 0, 0);
    is(least(Which::kPenetration, 2, moves), 0, 0);
    is(least(Which::kMuBack, 20, moves), -8, 1);  // of a rim that is as far everywhere
    is(least_of(Which::kMuBack, box({-20, -16, -17}, {20, 16, 17}), moves), -4, 3);
    is(least_of(Which::kDelta1, box({-20, -16, -17}, {20, 16, 17}), moves), -4, 3);
  }
  is(least(Which::kGamma1, 4), -10, 3);
}

/// Where its question has few cells a search is cut short, and tells between which numbers the least gap is: of a box
/// in a plate with two dimples, which it is as deep in beside them.
TEST(CutValues, LeastGapsEndWithTheWorkOfTheirQuestion) {
  const auto plate = std::make_shared<const CsgSolid>(space::csg_solid(
      *node(Kind::kDifference, {box({0, 0, 0}, {40, 10, 4}), ball({12, 5, 4}, 3), ball({20, 5, 4}, 3)})));
  const auto side = std::make_shared<const CsgSide>(space::shared(space::body(*box({0, 0, 0}, {3, 3, 3}))), plate);
  for (const long cells : {1L, 30000L}) {
    plane::SearchWork work{cells};
    const plane::ScopedSearchWork here(&work);
    const TriedAnswer v = csg_least(Which::kGamma1, side, false);
    ASSERT_TRUE(v && *v);
    EXPECT_LE((*v)->bounds().lower->to_double(), -3.5 + 1e-9);
    EXPECT_GE((*v)->bounds().upper->to_double(), -3.5 - 1e-9);
    EXPECT_GT(work.left, -400000);
  }
}

/// A ball out of which a piece is cut that no plane along the axes touches fits where the ball does.
TEST(CutValues, FitIntoPolyhedra) {
  const auto solid = std::make_shared<const CsgSolid>(
      space::csg_solid(*node(Kind::kDifference, {ball({0, 0, 0}, 5), ball({4, 4, 4}, 3)})));
  const auto room = space::shared(space::box_body({{{{-8, -9, -10}, {8, 9, 10}}}}));
  const PairDistances pair = csg_pair(std::make_shared<const CsgSide>(room, solid), true);
  const RealVector p = space::place(6, 2, 9);
  EXPECT_NEAR(pair.value(Which::kEta1, p)->value.to_double(), 5, 1e-9);
  EXPECT_LE(*pair.value(Which::kEta1, p)->bounds().lower, Real(5));
  EXPECT_NEAR(pair.value(Which::kEta2, p)->value.to_double(), std::sqrt(81.0 + 36 + 196), 1e-9);
  EXPECT_NEAR(pair.value(Which::kEta1, space::place(1, 1, 1))->value.to_double(), -2, 1e-9);
  // From where the room moves: A fits in B + p.
  const PairDistances back = csg_pair(std::make_shared<const CsgSide>(room, solid), false);
  EXPECT_NEAR(back.value(Which::kDelta1, space::negated(p))->value.to_double(), 5, 1e-9);
  const auto small = space::shared(space::box_body({{{{-8, -9, -4}, {8, 9, 4}}}}));
  EXPECT_FALSE(csg_pair(std::make_shared<const CsgSide>(small, solid), true).value(Which::kEta1, p));
}

/// Lines say the signs that values have.
TEST(CutValues, AreThoseOfLines) {
  std::mt19937 random(10);
  const space::RayGrid grid{2, 1, -17, -13, 11, 9, 4, 4};
  int certain = 0;
  const std::vector<Case> all = cases();
  for (const Case& c : {all[0], all[1], all[5]}) {
    const auto side = side_of(c);
    const PairDistances pair = csg_pair(side, false);
    for (const std::int64_t level : {0, 4}) {
      const auto map = cut_map(Which::kGamma1, Real(level), side, 1, grid);
      for (const int j : {1, 2}) {
        const space::RayRow row = map->row(j);
        for (int k = 0; k < 30; ++k) {
          const int i = static_cast<int>(random() % 4);
          const RealVector p{Real(grid.u_at(i)), Real(grid.v_at(j)), on_grid(any(random, 30))[2]};
          const int sign = space::sign_at(row, i, p[2]);
          const double over = pair.value(Which::kD1, p)->value.to_double() - static_cast<double>(level);
          if (sign != 0) ++certain;
          if (over > 0.01) {
            EXPECT_EQ(sign, 1) << c.name;
          } else if (over <= 0) {
            EXPECT_LE(sign, 0) << c.name;
          }
        }
      }
    }
  }
  EXPECT_GT(certain, 200);
}

/// Along x, on lines along z: B touches the solid on its way, or does so beyond the level.
TEST(CutValues, AreThoseOfLinesAlongADirection) {
  std::mt19937 random(15);
  const space::RayGrid grid{2, 1, -6, -13, 9, 9, 2, 2};
  int certain = 0;
  const std::vector<Case> all = cases();
  for (const Case& c : {all[0], all[3]}) {
    const auto side = side_of(c);
    const PairDistances pair = csg_pair(side, false);
    for (const bool both : {true, false}) {
      const AlongWay way{space::place(2, 0, 0), both};
      const auto gap = cut_map_along(Which::kGamma1, Real(5), way, side, 1, grid),
                 reach = cut_map_along(Which::kGamma2, Real(5), way, side, 1, grid);
      EXPECT_EQ(cut_map_along(Which::kGamma1, Real(-5), way, side, 1, grid), nullptr);
      const space::RayRow gaps = gap->row(1), reaches = reach->row(1);
      for (int k = 0; k < 4; ++k) {
        const int i = k % 2;
        const RealVector p{Real(grid.u_at(i)), Real(grid.v_at(1)), on_grid(any(random, 30))[2]};
        bool near = false, far = false;
        for (int t = both ? -99 : 1; t <= 99; t += 2) {
          if (pair.value(Which::kD1, space::plus(p, space::place(t, 0, 0, 2)))->value.sign() > 0) continue;
          (std::abs(t) < 10 ? near : far) = true;
        }
        const int of_gap = space::sign_at(gaps, i, p[2]), of_reach = space::sign_at(reaches, i, p[2]);
        if (of_gap != 0) ++certain;
        if (near) EXPECT_LE(of_gap, 0) << c.name;
        if (far || !near) EXPECT_GE(of_reach, 0) << c.name;
        if (near && !far) {
          EXPECT_LE(of_reach, 0) << c.name;
        }
      }
    }
  }
  EXPECT_GT(certain, 8);
}

/// Where a line's sign changes the value is the level, whichever shape moves.
TEST(CutValues, AreLevelsWhereLinesEnd) {
  const space::RayGrid grid{2, 1, -17, -14, 13, 11, 2, 3};
  int ends = 0;
  const std::vector<Case> all = cases();
  for (const Case& c : {all[0], all[1]}) {
    for (const bool cut_moves : {false, true}) {
      const PairDistances pair = pair_of(c, cut_moves);
      for (const std::int64_t level : {-2, 0, 4}) {
        const auto map = cut_map(Which::kGamma1, Real(level), side_of(c, cut_moves), 1, grid);
        const space::RayRow row = map->row(cut_moves ? 1 : 2);
        for (int i = 0; i < grid.nu; ++i) {
          for (int k = row.first[std::size_t(i)]; k < row.first[std::size_t(i) + 1]; ++k) {
            const RealVector p{Real(grid.u_at(i)), Real(grid.v_at(cut_moves ? 1 : 2)),
                               row.events[std::size_t(k)].at.to_real()};
            EXPECT_NEAR(pair.value(Which::kGamma1, p)->value.to_double(), static_cast<double>(level), 1e-6) << c.name;
            ++ends;
          }
        }
      }
    }
  }
  EXPECT_GT(ends, 40);
}

/// A cube beside a block slides along it: one stretch of 0, by one search.
TEST(CutValues, HaveLinesAlongFaces) {
  const Case bowl = cases()[0];
  for (const std::int64_t level : {0, 4}) {
    const space::RayGrid grid{2, 1, 23 + level, 1, 1, 1, 1, 1};
    const space::RayRow row = cut_map(Which::kGamma1, Real(level), side_of(bowl), 1, grid)->row(0);
    for (const int z : {-22, 0, 22}) EXPECT_EQ(space::sign_at(row, 0, Real(z)), 0) << level;
    for (const int z : {-30, 30}) EXPECT_EQ(space::sign_at(row, 0, Real(z)), 1) << level;
  }
}

/// The exact values of places that square roots name.
TEST(CutValues, AreNamed) {
  const std::vector<Case> all = cases();
  // In the bowl, below its centre: 15 less the way to the lower corners.
  const Answer in_bowl = *pair_of(all[0]).value(Which::kGamma1, space::place(0, 0, 17));
  EXPECT_TRUE(in_bowl.proven);
  EXPECT_EQ(in_bowl.value, Real(15) - sqrt(Real(54)));
  // It touches the bowl with four corners at once: 9 + 9 + 207 = 225.
  const CsgSide touching(space::shared(space::box_body({{{{-3, -3, 0}, {3, 3, 3}}}})),
                         std::make_shared<const CsgSolid>(space::csg_solid(*all[0].shape)));
  const Answer zero = **touching.gap({Real(), Real(), Real(20) - sqrt(Real(207))}, PairSide::Depth::kValue);
  EXPECT_TRUE(zero.proven);
  EXPECT_EQ(zero.value.sign(), 0);
  // Outside the block: as the block's own.
  const Answer beside = *pair_of(all[0]).value(Which::kGamma1, space::place(30, 0, 0));
  EXPECT_TRUE(beside.proven);
  EXPECT_EQ(beside.value, Real(7));
  // Above the pocket the rim is nearest: the circle of radius 15 at height 20.
  const Answer above = *pair_of(all[0]).value(Which::kGamma1, space::place(0, 0, 33));
  EXPECT_TRUE(above.proven);
  EXPECT_EQ(above.value, sqrt(Real(100) + (Real(15) - sqrt(Real(18))) * (Real(15) - sqrt(Real(18)))));
  // It is too large for the cube, and protrudes from it by its lower corners.
  EXPECT_FALSE(pair_of(all[0]).value(Which::kDelta1, space::place(0, 0, 17)));
  EXPECT_FALSE(pair_of(all[0]).value(Which::kDelta2, space::place(0, 0, 17)));
  EXPECT_EQ(pair_of(all[0]).value(Which::kHausdorff, space::place(0, 0, 17))->value, sqrt(Real(17 * 17 * 2 + 34 * 34)));
  // What is left of a block in which a ball fills all but corners is nothing if it fills these, too.
  const Case none{"none", node(Kind::kIntersection, {ball({0, 0, -10}, 10), ball({0, 0, 10}, 10)}), {}};
  EXPECT_THROW(pair_of(none).value(Which::kGamma1, space::place(0, 0, 33)), Error);
}

}  // namespace distance_cut_values
}  // namespace findspace::distance
