// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "formula/language/parse.h"
#include "formula/language/text.h"
#include "io/write/write_position.h"

namespace findspace::io {
namespace io_write_position {

using exact::Real;
using nlohmann::json;

distance::SceneAnswer answer(Real value) {
  distance::SceneAnswer out;
  out.value = std::move(value);
  return out;
}

TEST(WritePosition, EnclosedValuesCarryTheirEnds) {
  distance::SceneAnswer third = answer(Real::ratio(1, 3));
  third.proven = false;
  third.enclosed = distance::Enclosure{Real::ratio(1, 3), Real::ratio(2, 3)};
  const json out =
      json::parse(measure_json({formula::distance_at("eta1(B, A)", third)}, {Real(1), Real(2), Real(3)}, "mm"));
  EXPECT_EQ(out.at("at"), (json{1, 2, 3}));
  // Rounded outwards.
  EXPECT_NEAR(out.at("lower").at("eta1(B, A)"), 1.0 / 3, 1e-15);
  EXPECT_NEAR(out.at("upper").at("eta1(B, A)"), 2.0 / 3, 1e-15);
  EXPECT_GE(Real::from_double(out.at("upper").at("eta1(B, A)")), Real::ratio(2, 3));
  EXPECT_LE(Real::from_double(out.at("lower").at("eta1(B, A)")), Real::ratio(1, 3));
  // margin is -eta1: the ends change places.
  EXPECT_EQ(out.at("lower").at("margin(B, A)"), -out.at("upper").at("eta1(B, A)").get<double>());
  EXPECT_FALSE(out.contains("closed_form"));
}

TEST(WritePosition, ExactValuesThatAreNoDecimalsCarryTheirClosedForm) {
  const json out = json::parse(measure_json({formula::distance_at("gamma1(B, A)", answer(sqrt(Real(2)))),
                                             formula::distance_at("gamma2(B, A)", answer(Real::ratio(1, 10)))},
                                            {Real(), Real()}, ""));
  EXPECT_EQ(out.at("closed_form").at("gap(B, A)"), "sqrt(2)");
  EXPECT_FALSE(out.at("closed_form").contains("gamma2(B, A)"));
  EXPECT_FALSE(out.contains("lower"));
}

TEST(WritePosition, UndefinedValuesAreNullAndRefusedOnesSayWhy) {
  formula::DistanceAt refused = formula::distance_at("eta1(B, A)", std::nullopt);
  refused.refused = "too round";
  const json out =
      json::parse(measure_json({formula::distance_at("gamma1(B, A)", std::nullopt), refused}, {Real(), Real()}, ""));
  EXPECT_TRUE(out.at("distances").at("gamma1(B, A)").is_null());
  EXPECT_TRUE(out.at("distances").at("eta1(B, A)").is_null());
  EXPECT_EQ(out.at("not_computed"), (json{{"eta1(B, A)", "too round"}, {"margin(B, A)", "too round"}}));
  const json all =
      json::parse(measure_json({formula::distance_at("gamma1(B, A)", std::nullopt)}, {Real(), Real()}, ""));
  EXPECT_FALSE(all.contains("not_computed"));
}

TEST(WritePosition, NoneAndNotComputedAreToldApart) {
  formula::Check check;
  const auto said = [&](const formula::AskedNearest& near) {
    return json::parse(check_json(check, {Real(), Real()}, "", {}, near));
  };
  EXPECT_FALSE(said({}).contains("nearest_feasible"));
  EXPECT_TRUE(said(std::optional<formula::NearestFeasible>()).at("nearest_feasible").is_null());
  const json refused = said(exact::Refusal("too round"));
  EXPECT_FALSE(refused.contains("nearest_feasible"));
  EXPECT_EQ(refused.at("not_computed"), (json{{"nearest_feasible", "too round"}}));
  const formula::NearestFeasible there{{Real(1), Real(2)}, Real(3), true};
  EXPECT_EQ(said(std::optional(there)).at("nearest_feasible"),
            (json{{"at", {1, 2}}, {"distance", 3}, {"attained", true}}));
}

/// The value of a sum stands under the sum alone, in the words and the sense in which it was written.
TEST(WritePosition, ASumIsNoDistanceOfItsOwn) {
  formula::Context scene;
  scene.shapes = {"A", "B", "C"};
  scene.moving = {"B"};
  scene.dimension = 2;
  const formula::Formula formula = formula::parse_formula("margin(B, A) + 2 * gap(B, C) <= 5", scene);
  const formula::Atom& atom = formula.atoms().front();
  formula::Check check;
  check.atoms.push_back(formula::atom_at(atom, formula::distance_at(formula::written_sum(atom), answer(Real(-9))), -1));
  const json out = json::parse(check_json(check, {Real(), Real()}, "", {}));
  EXPECT_EQ(out.at("atoms")[0].at("text"), "margin(B, A) + 2 * gap(B, C) <= 5");
  EXPECT_EQ(out.at("atoms")[0].at("value"), 9);
  EXPECT_EQ(out.at("distances"), (json{{"margin(B, A) + 2 * gap(B, C)", 9}}));
}

}  // namespace io_write_position
}  // namespace findspace::io
