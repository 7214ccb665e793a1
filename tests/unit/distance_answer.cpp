// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <gtest/gtest.h>

#include <memory>

#include "distance/answer/optimum.h"
#include "distance/planar_least/distance_sum.h"

namespace findspace::distance {
namespace distance_answer {

using exact::Real;

TEST(Answer, ExactValuesAreTheirOwnBounds) {
  const PlanarAnswer a = exact_answer(sqrt(Real(2)), Way::kMap);
  EXPECT_EQ(*a.bounds().lower, sqrt(Real(2)));
  EXPECT_EQ(*a.bounds().upper, sqrt(Real(2)));
  EXPECT_EQ(a.slack(), 0);
}

TEST(Answer, ErrorsReachToBothSides) {
  Answer a;
  a.value = Real(5);
  a.set_unproven();
  a.error = 0.25;
  EXPECT_EQ(*a.bounds().lower, Real::ratio(19, 4));
  EXPECT_EQ(*a.bounds().upper, Real::ratio(21, 4));
  EXPECT_EQ(a.side, Side::kMixed);
}

TEST(Answer, MinusTurnsTheEnclosure) {
  const PlanarAnswer a = minus(enclosed_answer(Real(2), Real(3), Real(1)));
  EXPECT_EQ(a.value, Real(-2));
  EXPECT_EQ(*a.bounds().lower, Real(-3));
  EXPECT_EQ(*a.bounds().upper, Real(-1));
}

TEST(Answer, CutOffAtZero) {
  const auto deep = cut_off(enclosed_answer(Real(-2), Real(-3), Real(1)), false);
  EXPECT_EQ(deep->value, Real());
  EXPECT_EQ(*deep->bounds().lower, Real());
  EXPECT_EQ(*deep->bounds().upper, Real(1));
  EXPECT_FALSE(cut_off(std::optional<PlanarAnswer>(), false));
  EXPECT_EQ(cut_off(std::optional<PlanarAnswer>(), true)->value, Real());
  EXPECT_EQ(cut_off(lowest_answer(Way::kMap), false)->value, Real());
  EXPECT_FALSE(cut_off(lowest_answer(Way::kMap), true));
}

TEST(Answer, TheGreaterOfTwoEnclosures) {
  const PlanarAnswer a =
      greater(enclosed_answer(Real(2), Real(1), Real(6)), enclosed_answer(Real(4), Real(3), Real(5)));
  EXPECT_EQ(a.value, Real(4));
  EXPECT_EQ(*a.bounds().lower, Real(3));
  EXPECT_EQ(*a.bounds().upper, Real(6));
  EXPECT_EQ(a.error, 3);
  EXPECT_EQ(greater(exact_answer(Real(4), Way::kMap), enclosed_answer(Real(3), Real(3), Real(5))).error, 1);
  EXPECT_EQ(greater(lowest_answer(Way::kMap), exact_answer(Real(-7), Way::kMap)).value, Real(-7));
}

/// From 1 to 3 everywhere.
class Between : public TDistance {
 public:
  bool defined() const override { return true; }
  plane::SignMap sign_map(const Real&) const override { return plane::CellComplex::uniform(1); }
  std::optional<PlanarAnswer> value(const exact::RealPoint&) const override {
    return enclosed_answer(Real(2), Real(1), Real(3));
  }
  exact::RealPoint seed() const override { return {}; }
  std::vector<NearLevelCurve> level_curves(const exact::RealPoint&, double) const override { return {}; }
};

TEST(Answer, ErrorsOfASumAreThoseOfItsEnclosure) {
  const auto f = std::make_shared<Between>();
  const auto a = DistanceSum({{f, Real(1)}, {f, Real(-2)}}).answer({});
  ASSERT_TRUE(a);
  EXPECT_EQ(a->value, Real(-2));
  EXPECT_EQ(*a->bounds().lower, Real(-5));
  EXPECT_EQ(*a->bounds().upper, Real(1));
  EXPECT_EQ(a->error, 6);
}

TEST(Answer, InAnotherUnitEverythingIsScaled) {
  PlanarAnswer a = enclosed_answer(Real(2), Real(1), Real(3));
  a.nearest = exact::RealPoint{Real(4), Real(6)};
  a.witness = {{true, plane::Cell{0, 1}, {Real(8), Real(10)}}};
  const SceneAnswer s = in_scene(a, Real::ratio(1, 2));
  EXPECT_EQ(s.value, Real(1));
  EXPECT_EQ(*s.bounds().lower, Real::ratio(1, 2));
  EXPECT_EQ(*s.bounds().upper, Real::ratio(3, 2));
  EXPECT_EQ(*s.nearest, (Coordinates{Real(2), Real(3)}));
  EXPECT_EQ(s.witness.at(0).at, (Coordinates{Real(4), Real(5)}));
  EXPECT_EQ(s.way, Way::kSearch);
}

TEST(Answer, LeastValuesLieAboveTheirBound) {
  const Answer a = least_answer(Real(3), Real(2), false, {});
  EXPECT_EQ(*a.bounds().lower, Real(2));
  EXPECT_EQ(*a.bounds().upper, Real(3));
  EXPECT_EQ(a.way, Way::kSearch);
  EXPECT_EQ(a.side, Side::kInner);
  const Answer exact = least_answer(Real(3), Real(3), true, {}, Way::kBoxes);
  EXPECT_EQ(exact.way, Way::kBoxes);
  EXPECT_EQ(exact.side, Side::kExact);
}

TEST(Optimum, SaysOnWhichSideItsValueIsCertain) {
  OptimalValue best;
  best.set_exact(Real(2), Way::kMap);
  EXPECT_EQ(best.answer->side, Side::kExact);
  EXPECT_FALSE(best.bound());
  best.set_enclosed(Real(3), Real(2), Way::kMap);
  EXPECT_EQ(best.answer->side, Side::kInner);
  EXPECT_EQ(*best.value(), Real(3));
  EXPECT_EQ(*best.bound(), Real(2));
  best.set_enclosed(std::nullopt, Real(2), Way::kSearch);
  EXPECT_EQ(best.answer->side, Side::kOuter);
  EXPECT_FALSE(best.exists());
  EXPECT_EQ(*best.bound(), Real(2));
  best.set_nearby(Real(5), std::nullopt, Way::kLines);
  EXPECT_EQ(best.answer->side, Side::kNone);
  EXPECT_EQ(*best.value(), Real(5));
  EXPECT_FALSE(best.bound());
  EXPECT_EQ(best.answer->way, Way::kLines);
}

TEST(Optimum, KeepsWhatASearchHasFound) {
  Answer least = least_answer(Real(3), Real(2), false, {Real(1), Real(2), Real(3)});
  least.way = Way::kSurfaces;
  least.witness = point_pair({Real(1), Real(), Real()}, {Real(), Real(), Real()});
  OptimalValue best;
  best.set_found(in_scene(least, Real(2)));
  EXPECT_TRUE(best.attained);
  EXPECT_EQ(*best.value(), Real(6));
  EXPECT_EQ(*best.bound(), Real(4));
  EXPECT_EQ(best.answer->way, Way::kSurfaces);
  EXPECT_EQ(best.answer->witness.size(), 2u);
  EXPECT_EQ(best.answer->at, (Coordinates{Real(2), Real(4), Real(6)}));
}

}  // namespace distance_answer
}  // namespace findspace::distance
