// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Mistakes that are mistakes in one scene and not in another; limits; objectives. The first line of each message is
// compared.
#include <gtest/gtest.h>

#include "formula/language/text.h"
#include "unit/formula_mistakes.h"

namespace findspace::formula {
namespace formula_context {

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

TEST(FormulaErrors, Codes) {
  const auto code = [](std::string_view sentence) {
    try {
      parse_formula(sentence, scene());
    } catch (const Error& error) {
      return error.code();
    }
    return ErrorCode::kFile;
  };
  EXPECT_EQ(code("gamma1(chip, board"), ErrorCode::kSyntax);
  EXPECT_EQ(code("gamma1(chip, bord) > 1"), ErrorCode::kUnknownName);
  EXPECT_EQ(code("gama1(chip, board) > 1"), ErrorCode::kUnknownName);
  EXPECT_EQ(code("gamma1(chip, board) > 1ft"), ErrorCode::kUnknownName);
  EXPECT_EQ(code("gamma1(chip, board) > 1deg"), ErrorCode::kBadValue);
  EXPECT_EQ(code("gamma1(key, board) > 1"), ErrorCode::kBadValue);
  EXPECT_EQ(code("gamma1(chip, board) > 1e101"), ErrorCode::kOutOfRange);
}

TEST(FormulaErrors, TheContextDecidesWhatMayMove) {
  Context together = scene();
  together.moving = {"chip", "key"};
  EXPECT_EQ(first_line(message("gamma1(chip, key) > 0", together)),
            "1:8: 'chip' and 'key' move together, so their distance never changes");
  EXPECT_EQ(first_line(message("gamma1(board, screws) > 0", together)),
            "1:8: neither 'board' nor 'screws' moves; one of the two has to be a moving shape: 'chip', 'key'");
  Context apart = together;
  apart.independent = true;
  EXPECT_EQ(message("gamma1(chip, key) > 0", apart), "no error");
  EXPECT_EQ(first_line(message("gamma1(chip+key, board) > 0", apart)),
            "1:8: the parts of the union 'chip+key' move each on its own; take them one by one");
  Context still = scene();
  still.moving.clear();
  EXPECT_EQ(first_line(message("gamma1(chip, key) > 0", still)),
            "1:8: neither 'chip' nor 'key' moves; one of the two has to be a moving shape, and the scene has none");
}

TEST(FormulaErrors, UnitsNeedAUnitOfTheScene) {
  Context bare = scene();
  bare.unit.reset();
  EXPECT_EQ(first_line(message("gamma1(chip, key) > 1mm", bare)),
            "1:22: the scene has no unit, so numbers cannot carry one; give the scene a \"unit\"");
  EXPECT_EQ(message("gamma1(chip, key) > 1", bare), "no error");
  EXPECT_EQ(message("gamma1(chip, key, turning=(0, 0)) > 1deg", bare), "no error");
}

TEST(FormulaErrors, Dimensions) {
  Context solid = scene();
  solid.dimension = 3;
  EXPECT_EQ(first_line(message("gamma1(chip, key, along=(1, 0)) > 1", solid)),
            "1:26: 2 coordinates where the scene has 3 dimensions");
  EXPECT_EQ(first_line(message("gamma1(chip, key, turning=(1, 0, 0)) > 1", solid)),
            "1:19: a rotation is about a point of the plane; the scene has 3 dimensions");
}

TEST(FormulaErrors, DepthIsBounded) {
  const auto nested = [](int depth) { return std::string(depth, '(') + "true" + std::string(depth, ')'); };
  EXPECT_EQ(message(nested(kDeepest - 1), scene()), "no error");
  EXPECT_EQ(first_line(message(nested(kDeepest), scene())), "1:201: parentheses and negations nested too deeply");
  EXPECT_NE(message(nested(1000000), scene()), "no error");
  std::string negations;
  for (int i = 0; i < 100000; ++i) negations += "not ";
  EXPECT_NE(message(negations + "true", scene()), "no error");
}

TEST(ObjectiveErrors, SayWhatAnObjectiveIs) {
  const auto objective_message = [](std::string_view sentence) {
    try {
      parse_objective(sentence, scene());
    } catch (const Error& error) {
      return first_line(error.what());
    }
    return std::string("no error");
  };
  const std::string forms =
      "an objective is a distance such as gap(B, A), a sum of distances, x, y, z or distance to "
      "[x, y]; found ";
  for (const char* kept : {"gap(chip, board)", "-gap(chip, board)", "margin(chip, board)", "-margin(chip, board)",
                           "-hausdorff(chip, board)"}) {
    const Objective objective = parse_objective(kept, scene());
    EXPECT_EQ(text(objective), kept);
    EXPECT_EQ(parse_objective(text(objective), scene()), objective) << kept;
    EXPECT_EQ(parse_objective(text(objective, Script::kSymbols), scene()), objective) << kept;
  }
  EXPECT_EQ(text(parse_objective("-eta1(chip, board)", scene())), "margin(chip, board)");
  EXPECT_EQ(objective_message(""), "1:1: " + forms + "the end");
  EXPECT_EQ(objective_message("gamma1(chip, board) >= 1"), "1:21: " + forms + "'>='");
  EXPECT_EQ(objective_message("3"), "1:1: a number by itself does not change which position is best: leave it out");
  EXPECT_EQ(objective_message("gap(chip, board) - gap(chip, board)"),
            "1:1: these distances cancel: nothing is left of the sum");
  EXPECT_EQ(objective_message("z"), "1:1: 'z' is an objective in 3 dimensions; the scene has 2");
  EXPECT_EQ(objective_message("distance to (1, 2)"),
            "1:13: a point such as [1, 2] is meant after 'distance to', found '('");
  EXPECT_EQ(objective_message("distance to [1, 2, 3]"), "1:14: 3 coordinates where the scene has 2 dimensions");
  EXPECT_EQ(objective_message("overlaps(chip, board)"), "1:1: a distance is meant here, not the predicate 'overlaps'");
  EXPECT_EQ(objective_message("gama1(chip, board)"),
            "1:1: unknown distance or predicate 'gama1'; did you mean 'gamma1'?");
}

}  // namespace formula_context
}  // namespace findspace::formula
