// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Truth from signs, and which sign maps a formula has.
#include <gtest/gtest.h>

#include "formula/language/evaluate.h"
#include "formula/language/level_truth.h"
#include "formula/language/parse.h"
#include "formula/language/text.h"

namespace findspace::formula {
namespace formula_evaluate {

Formula read(std::string_view text) {
  return parse_formula(text, {.shapes = {"A", "B", "C"},
                              .moving = {"B"},
                              .extra = {},
                              .independent = false,
                              .motion = false,
                              .unit = Unit::kMillimetre,
                              .dimension = 2});
}

bool truth(const Formula& formula, std::initializer_list<std::int8_t> signs) {
  const std::vector<std::int8_t> vector(signs);
  return evaluate(formula, vector);
}

TEST(Evaluate, Constants) {
  EXPECT_TRUE(truth(Formula(), {}));
  EXPECT_TRUE(truth(read("true"), {}));
  EXPECT_FALSE(truth(read("false"), {}));
  EXPECT_FALSE(truth(read("not true"), {}));
  EXPECT_TRUE(truth(read("false or not false and true"), {}));
  EXPECT_TRUE(read("true").sign_maps().empty());
  EXPECT_TRUE(truth(conjunction({}), {}));
  EXPECT_FALSE(truth(disjunction({}), {}));
}

TEST(Evaluate, TheSixRelations) {
  const struct {
    const char* relation;
    bool minus, zero, plus;
  } table[] = {{"<", true, false, false}, {"<=", true, true, false}, {"=", false, true, false},
               {"!=", true, false, true}, {">=", false, true, true}, {">", false, false, true}};
  for (const auto& row : table) {
    const Formula formula = read("gamma1(B, A) " + std::string(row.relation) + " 1");
    EXPECT_EQ(truth(formula, {-1}), row.minus) << row.relation;
    EXPECT_EQ(truth(formula, {0}), row.zero) << row.relation;
    EXPECT_EQ(truth(formula, {+1}), row.plus) << row.relation;
    EXPECT_EQ(holds(formula.atoms()[0], 0), row.zero) << row.relation;
  }
}

TEST(Evaluate, MinimumIsTheZeroSet) {
  const Formula formula = read("gamma2(B, A) -> min");
  EXPECT_TRUE(truth(formula, {0}));
  EXPECT_FALSE(truth(formula, {+1}));
}

TEST(SignMaps, EqualPairsShareOne) {
  const Formula formula = read("gap(B, A) < 1cm or gamma1(B, A) > 10 or gamma1(B, A) < 1 or gamma1(A, B) < 1");
  ASSERT_EQ(formula.sign_maps().size(), 3u);
  EXPECT_EQ(formula.sign_map_of(0), 0u);
  EXPECT_EQ(formula.sign_map_of(1), 0u);
  EXPECT_EQ(formula.sign_map_of(2), 1u);
  EXPECT_EQ(formula.sign_map_of(3), 2u);
}

TEST(SignMaps, MinimumModeAndPrefixDistinguish) {
  EXPECT_EQ(read("gamma1(B, A) -> min or gamma1(B, A) = 0").sign_maps().size(), 2u);
  EXPECT_EQ(read("gamma1(B, A) -> min or argmin(gap(B, A))").sign_maps().size(), 1u);
  EXPECT_EQ(read("gamma1(B, A) = 0 or gamma1(B, A, along=(1, 0)) = 0 or gamma1(B, A, along=(0, 1)) = 0 or "
                 "gamma1(B, A, toward=(1, 0)) = 0 or gamma1(B, A, along=(1.0, 0)) = 0")
                .sign_maps()
                .size(),
            4u);
}

TEST(Evaluate, ChainIsABand) {
  const Formula formula = read("0 <= gamma1(B, A) < 2");
  EXPECT_TRUE(truth(formula, {0, -1}));
  EXPECT_TRUE(truth(formula, {+1, -1}));
  EXPECT_FALSE(truth(formula, {-1, -1}));
  EXPECT_FALSE(truth(formula, {+1, 0}));
}

/// The definition, on the tree.
bool by_definition(const Formula& formula, const Node& node, std::span<const std::int8_t> signs) {
  switch (node.op) {
    case Node::Op::kTrue:
      return true;
    case Node::Op::kFalse:
      return false;
    case Node::Op::kAtom:
      return holds(formula.atoms()[node.atom], signs[formula.sign_map_of(node.atom)]);
    case Node::Op::kNot:
      return !by_definition(formula, node.operands[0], signs);
    case Node::Op::kAnd:
      for (const Node& operand : node.operands) {
        if (!by_definition(formula, operand, signs)) return false;
      }
      return true;
    case Node::Op::kOr:
      for (const Node& operand : node.operands) {
        if (by_definition(formula, operand, signs)) return true;
      }
      return false;
  }
  return false;
}

TEST(Evaluate, AgreesWithTheTreeOnAllSigns) {
  for (const char* text :
       {"gamma1(B, A) < 1 and (gamma2(B, A) >= 2 or not eta1(B, A) = 0)",
        "not (gamma1(B, A) < 1 or gamma2(B, A) > 2) and not (eta1(B, A) = 0 and gamma1(B, A) >= 1)",
        "gamma1(B, A) < 1 or false and gamma2(B, A) = 0 or true and not (eta1(B, A) != 0 or false)",
        "not not (gamma1(B, A) < 1 and not (gamma2(B, A) = 0 and (eta1(B, A) > 0 or gamma1(B, A) = 1)))"}) {
    const Formula formula = read(text);
    ASSERT_EQ(formula.sign_maps().size(), 3u);
    for (int code = 0; code < 27; ++code) {
      const std::int8_t signs[3] = {static_cast<std::int8_t>(code % 3 - 1), static_cast<std::int8_t>(code / 3 % 3 - 1),
                                    static_cast<std::int8_t>(code / 9 - 1)};
      EXPECT_EQ(evaluate(formula, signs), by_definition(formula, formula.root(), signs)) << text << " at " << code;
    }
  }
}

TEST(Formula, CombinationsFlatten) {
  const Formula a = read("gamma1(B, A) < 1"), b = read("gamma1(B, C) < 1 and gamma2(B, C) > 1");
  const Formula both[] = {a, b};
  EXPECT_EQ(conjunction(both), read("gamma1(B, A) < 1 and gamma1(B, C) < 1 and gamma2(B, C) > 1"));
  EXPECT_EQ(disjunction(both), read("gamma1(B, A) < 1 or (gamma1(B, C) < 1 and gamma2(B, C) > 1)"));
  EXPECT_EQ(negation(b), read("not (gamma1(B, C) < 1 and gamma2(B, C) > 1)"));
  EXPECT_EQ(conjunction({both, 1}), a);
  EXPECT_FALSE(a == b);
  EXPECT_EQ(constant(false), read("false"));
}

TEST(Formula, AtomsMadeByHandAreTheParsedOnes) {
  Distance distance;
  distance.first = {"B"};
  distance.second = {"A"};
  EXPECT_EQ(Formula(compare(distance, Relation::kLess, exact::Real::ratio(1, 8))), read("gamma1(B, A) < 0.125"));
  EXPECT_EQ(text(compare(distance, Relation::kLess, exact::Real::ratio(-1, 8))), "gamma1(B, A) < -0.125");
  EXPECT_EQ(Formula(minimisers(distance)), read("gamma1(B, A) -> min"));
}

TEST(Text, Decimals) {
  using exact::Real;
  EXPECT_EQ(decimal_text(Real(0)), "0");
  EXPECT_EQ(decimal_text(Real(-7)), "-7");
  EXPECT_EQ(decimal_text(Real::ratio(-1, 1000)), "-0.001");
  EXPECT_EQ(decimal_text(Real::ratio(1234567, 1000)), "1234.567");
  EXPECT_EQ(decimal_text(Real::ratio(1, 3)), "");
  EXPECT_EQ(decimal_text(sqrt(Real(2))), "");
}

/// Of the formula where every sign is open.
std::int8_t certainty_of_none(const Formula& formula) {
  std::vector<std::int8_t> bounds;
  for (std::size_t k = 0; k < formula.sign_maps().size(); ++k) bounds.insert(bounds.end(), {-1, 1});
  return certainty(formula, bounds);
}

TEST(Evaluate, CertaintyOfManyOpenSigns) {
  std::string sentence = "gap(B, A) >= 1";
  for (int level = 2; level <= 40; ++level) sentence += " and gap(B, A) >= " + std::to_string(level);
  const Formula all = read(sentence);
  EXPECT_EQ(certainty_of_none(all), 1);
  std::vector<std::int8_t> bounds;
  for (int k = 0; k < 40; ++k) bounds.insert(bounds.end(), {-1, 1});
  bounds[50] = bounds[51] = -1;
  EXPECT_EQ(certainty(all, bounds), 0);
  EXPECT_EQ(certainty(negation(all), bounds), 2);
  EXPECT_EQ(certainty_of_none(read("(" + sentence + ") or true")), 2);
  EXPECT_EQ(certainty_of_none(read("(" + sentence + ") and false")), 0);
}

TEST(Evaluate, CertaintyOfFewOpenSignsIsExact) {
  EXPECT_EQ(certainty_of_none(read("gap(B, A) >= 1 or gap(B, A) < 1")), 2);
  EXPECT_EQ(certainty_of_none(read("gap(B, A) >= 1 and gap(B, A) < 1")), 0);
  EXPECT_EQ(certainty_of_none(read("gap(B, A) >= 1 or gap(B, A) < 2")), 1);  // signs, not values
}

TEST(LevelTruth, IsTheFormulaAtEveryValue) {
  for (const char* text :
       {"0 <= gap(B, A) < 2 or gap(B, A) = 5 or gap(B, A) >= 7 and gap(B, A) != 8", "gap(B, A) >= 3 and gap(B, A) >= 1",
        "gap(B, A) > 4 or gap(B, A) < 4 or gap(B, A) = 6", "gap(B, A) < 1 or gap(B, A) >= 1 or gap(B, A) > 2",
        "gap(B, A) < 1 and gap(B, A) > 2", "not (gap(B, A) <= 6 and (gap(B, A) > 2 or gap(B, A) = 1))"}) {
    const Formula formula = read(text);
    const std::optional<LevelTruth> truth = level_truth(formula);
    ASSERT_TRUE(truth) << text;
    for (int twice = -2; twice <= 20; ++twice) {
      std::vector<std::int8_t> signs;
      for (const SignMap& m : formula.sign_maps())
        signs.push_back(static_cast<std::int8_t>((exact::Real(twice) - m.level * exact::Real(2)).sign()));
      std::int32_t sum = truth->sum.first;
      for (std::size_t k = 0; k < truth->sign_maps.size(); ++k) sum += truth->sum.of(k, signs[truth->sign_maps[k]]);
      EXPECT_EQ(sum, evaluate(formula, signs) ? 1 : 0) << text << " at " << twice;
    }
  }
}

TEST(LevelTruth, NamesTheLevelsThatTellSomething) {
  EXPECT_EQ(level_truth(read("gap(B, A) >= 3 and gap(B, A) >= 1"))->sign_maps, std::vector<std::size_t>{0});
  EXPECT_EQ(level_truth(read("gap(B, A) > 1 or gap(B, A) <= 2"))->sign_maps, std::vector<std::size_t>{});
  EXPECT_FALSE(level_truth(read("gap(B, A) >= 3")));
  EXPECT_FALSE(level_truth(read("gap(B, A) >= 3 and gap(B, C) >= 1")));
  EXPECT_FALSE(level_truth(read("gap(B, A) >= 3 or gap(B, A) -> min")));
}

TEST(Units, FactorsAreExact) {
  using exact::Real;
  EXPECT_EQ(factor(Unit::kInch, Unit::kMillimetre), Real::ratio(254, 10));
  EXPECT_EQ(factor(Unit::kMil, Unit::kInch), Real::ratio(1, 1000));
  EXPECT_EQ(factor(Unit::kMetre, Unit::kMicrometre), Real(1000000));
  for (std::size_t i = 0; i < kUnitNames.size(); ++i) {
    EXPECT_EQ(name(*find_unit(kUnitNames[i])), kUnitNames[i]);
    EXPECT_EQ(factor(static_cast<Unit>(i), Unit::kMil) * factor(Unit::kMil, static_cast<Unit>(i)), Real(1));
  }
  EXPECT_FALSE(find_unit("ft"));
}

TEST(Names, Nearest) {
  const std::vector<std::string> names{"board", "key", "screws"};
  EXPECT_EQ(nearest("bord", names), "board");
  EXPECT_EQ(nearest("BOARD", names), "board");
  EXPECT_EQ(nearest("baord", names), "board");
  EXPECT_EQ(nearest("kye", names), "key");
  EXPECT_EQ(nearest("zebra", names), "");
  EXPECT_EQ(nearest("", names), "");
  const std::vector<std::string> letters{"A"};
  EXPECT_EQ(nearest("C", letters), "");
}

}  // namespace formula_evaluate
}  // namespace findspace::formula
