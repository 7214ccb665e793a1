// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What formulas mean: every sentence is compared with the canonical text of the formula it has to become.
#include <gtest/gtest.h>

#include "formula/language/parse.h"
#include "formula/language/text.h"

namespace findspace::formula {
namespace formula_parse {

using exact::Real;

Context scene() {
  return {.shapes = {"A", "A1", "A2", "B", "C", "board", "my part", "mm", "and"},
          .moving = {"B"},
          .extra = {},
          .independent = false,
          .motion = true,
          .unit = Unit::kMillimetre,
          .dimension = 2};
}

std::string canonical(std::string_view sentence, const Context& context = scene()) {
  return text(parse_formula(sentence, context));
}

TEST(Parse, Comparisons) {
  for (const char* relation : {"<", "<=", "=", "!=", ">=", ">"}) {
    const std::string sentence = "gamma1(B, A) " + std::string(relation) + " 0.5";
    EXPECT_EQ(canonical(sentence), sentence);
  }
  EXPECT_EQ(canonical("gamma1(B,A)>=-1"), "gamma1(B, A) >= -1");
  EXPECT_EQ(canonical("gamma1(B,A)<-.5"), "gamma1(B, A) < -0.5");
  EXPECT_EQ(canonical("gamma1(B,A)=+2e3"), "gamma1(B, A) = 2000");
  EXPECT_EQ(canonical("gamma1(B,A) >= -0"), "gamma1(B, A) >= 0");
}

TEST(Parse, NumberFirst) {
  EXPECT_EQ(canonical("0.5 < gamma2(B, A)"), "gamma2(B, A) > 0.5");
  EXPECT_EQ(canonical("0.5 >= gamma2(B, A)"), "gamma2(B, A) <= 0.5");
  EXPECT_EQ(canonical("-1 = eta1(B, A)"), "eta1(B, A) = -1");
  EXPECT_EQ(canonical("1 != eta1(B, A)"), "eta1(B, A) != 1");
}

TEST(Parse, Chains) {
  EXPECT_EQ(canonical("0.5 <= gap(B, A) <= 2"), "gamma1(B, A) >= 0.5 and gamma1(B, A) <= 2");
  EXPECT_EQ(canonical("2 > gamma1(B, A) != 1"), "gamma1(B, A) < 2 and gamma1(B, A) != 1");
  EXPECT_EQ(canonical("not 0 <= gamma1(B, A) <= 2"), "not (gamma1(B, A) >= 0 and gamma1(B, A) <= 2)");
  EXPECT_EQ(canonical("1 <= margin(B, A) < 2"), "eta1(B, A) <= -1 and eta1(B, A) > -2");
}

TEST(Parse, LeastOfADistanceTimesAFactor) {
  EXPECT_EQ(canonical("2 * reach(B, A) -> min"), "gamma2(B, A) -> min");
  EXPECT_EQ(canonical("-margin(B, A) -> min"), "eta1(B, A) -> min");
}

TEST(Parse, SumsAndComparisonsOfDistances) {
  Context still = scene();
  still.motion = false;
  const auto sum = [&](const char* sentence) { return canonical(sentence, still); };
  EXPECT_EQ(sum("gap(B, A) <= gap(B, C)"), "gamma1(B, A) - gamma1(B, C) <= 0");
  EXPECT_EQ(sum("gap(B, A) + 2*gap(B, C) <= 5mm"), "gamma1(B, A) + 2 * gamma1(B, C) <= 5");
  EXPECT_EQ(sum("1 <= gap(B, A) - gap(B, C) < 2"),
            "gamma1(B, A) - gamma1(B, C) >= 1 and gamma1(B, A) - gamma1(B, C) < 2");
  EXPECT_EQ(sum("gap(B, A) + 1 < 3 - gap(B, C)"), "gamma1(B, A) + gamma1(B, C) < 2");
  // The first distance has the factor 1, so a negative one turns the relation round.
  EXPECT_EQ(sum("-2 * gap(B, A) <= gap(B, C)"), "gamma1(B, A) + 0.5 * gamma1(B, C) >= 0");
  EXPECT_EQ(sum("margin(B, A) >= gap(B, C)"), "eta1(B, A) + gamma1(B, C) <= 0");
  // What is left may be one distance, or none.
  EXPECT_EQ(sum("2 * gap(B, A) <= 3"), "gamma1(B, A) <= 1.5");
  EXPECT_EQ(sum("gap(B, A) + gap(B, C) <= gap(B, A)"), "gamma1(B, C) <= 0");
  EXPECT_EQ(sum("gap(B, A) <= gap(B, A)"), "true");
  EXPECT_EQ(sum("gap(B, A) < gap(B, A)"), "false");
  const Formula f = parse_formula("gap(B, A) <= 2 * gap(B, C)", still);
  EXPECT_TRUE(has_sums(f));
  EXPECT_EQ(written(f), "gap(B, A) - 2 * gap(B, C) <= 0");
  EXPECT_EQ(parse_formula(written(f), still), f);
}

TEST(Parse, SumsAsObjectives) {
  Context still = scene();
  still.motion = false;
  const auto sum = [&](const char* sentence) { return text(parse_objective(sentence, still)); };
  EXPECT_EQ(sum("gap(B, A) + 2 * gap(B, C)"), "gap(B, A) + 2 * gap(B, C)");
  EXPECT_EQ(sum("-gap(B, A)-0.5*margin(B, C)"), "-gap(B, A) - 0.5 * margin(B, C)");
  EXPECT_EQ(parse_objective("gap(B, A) + 0.5 * gap(B, A)", still).kind, Objective::Kind::kSum);
  EXPECT_EQ(parse_objective("2 * gap(B, A) - gap(B, A)", still).kind, Objective::Kind::kDistance);
}

TEST(Parse, EveryCanonicalName) {
  for (std::size_t k = 0; k < kKindCount; ++k) {
    const std::string sentence = std::string(name(static_cast<Kind>(k))) + "(B, A) <= 1";
    EXPECT_EQ(canonical(sentence), sentence);
    EXPECT_EQ(parse_formula(sentence, scene()).atoms()[0].distance.kind, static_cast<Kind>(k));
  }
}

TEST(Parse, Synonyms) {
  const std::pair<const char*, const char*> pairs[] = {{"gap", "gamma1(B, A)"},
                                                       {"reach", "gamma2(B, A)"},
                                                       {"distance", "d1(B, A)"},
                                                       {"m1", "mu(B, A)"},
                                                       {"m2", "mu(A, B)"},
                                                       {"m3", "hausdorff(B, A)"},
                                                       {"hBA", "h(B, A)"},
                                                       {"hAB", "h(A, B)"},
                                                       {"H", "hausdorff(B, A)"},
                                                       {"diam_union", "diameter(B, A)"},
                                                       {"depth", "penetration(B, A)"},
                                                       {"γ1", "gamma1(B, A)"},
                                                       {"γ₁", "gamma1(B, A)"},
                                                       {"γ₂", "gamma2(B, A)"},
                                                       {"η1", "eta1(B, A)"},
                                                       {"η₂", "eta2(B, A)"},
                                                       {"δ2", "delta2(B, A)"},
                                                       {"\u03bc", "mu(B, A)"},
                                                       {"\u00b5", "mu(B, A)"}};
  for (const auto& [word, expected] : pairs) {
    EXPECT_EQ(canonical(std::string(word) + "(B, A) < 3"), std::string(expected) + " < 3");
  }
}

TEST(Parse, MarginIsNegatedAndFlipped) {
  EXPECT_EQ(canonical("margin(B, A) >= 1"), "eta1(B, A) <= -1");
  EXPECT_EQ(canonical("margin(B, A) > 0"), "eta1(B, A) < 0");
  EXPECT_EQ(canonical("margin(B, A) = -2mm"), "eta1(B, A) = 2");
  EXPECT_EQ(canonical("3 > margin(B, A)"), "eta1(B, A) > -3");
  EXPECT_EQ(canonical("inf margin(B, A) >= 1"), "sup eta1(B, A) <= -1");
}

TEST(Parse, Predicates) {
  EXPECT_EQ(canonical("overlaps(B, A)"), "gamma1(B, A) < 0");
  EXPECT_EQ(canonical("touches(B, A)"), "gamma1(B, A) = 0");
  EXPECT_EQ(canonical("disjoint(B, A)"), "gamma1(B, A) > 0");
  EXPECT_EQ(canonical("clear(B, A)"), "gamma1(B, A) >= 0");
  EXPECT_EQ(canonical("clear(B, A, 1cm)"), "gamma1(B, A) >= 10");
  EXPECT_EQ(canonical("within(B, A, 2)"), "gamma1(B, A) <= 2");
  EXPECT_EQ(canonical("near(B, A, 2)"), "gamma1(B, A) <= 2");
  EXPECT_EQ(canonical("far(B, A, 2)"), "gamma1(B, A) >= 2");
  EXPECT_EQ(canonical("keepout(B, A)"), "gamma1(B, A) >= 0");
  EXPECT_EQ(canonical("keepout(B, A, 2)"), "gamma1(B, A) >= 2");
  EXPECT_EQ(canonical("group(B, A, 2)"), "diameter(B, A) <= 2");
  EXPECT_EQ(canonical("inside(B, A)"), "eta1(B, A) <= 0");
  EXPECT_EQ(canonical("inside(B, A, 0.5)"), "eta1(B, A) <= -0.5");
  EXPECT_EQ(canonical("inside(A, B, -0.5)"), "eta1(A, B) <= 0.5");
  EXPECT_EQ(canonical("covers(B, A)"), "delta1(B, A) <= 0");
  EXPECT_EQ(canonical("covers(B, A, 2)"), "delta1(B, A) <= -2");
}

TEST(Parse, Minimum) {
  EXPECT_EQ(canonical("gamma2(B, A) -> min"), "gamma2(B, A) -> min");
  EXPECT_EQ(canonical("η1(B, A) → min"), "eta1(B, A) -> min");
  EXPECT_EQ(canonical("argmin(mu(B, A))"), "mu(B, A) -> min");
  const Formula formula = parse_formula("gamma2(B, A) -> min", scene());
  EXPECT_TRUE(formula.atoms()[0].minimum);
  EXPECT_TRUE(formula.sign_maps()[0].minimum);
}

TEST(Parse, Precedence) {
  const std::string a = "gamma1(B, A) > 1", b = "gamma1(B, A) > 2", c = "gamma1(B, A) > 3";
  EXPECT_EQ(canonical(a + " or " + b + " and " + c), a + " or " + b + " and " + c);
  EXPECT_EQ(canonical("(" + a + " or " + b + ") and " + c), "(" + a + " or " + b + ") and " + c);
  EXPECT_EQ(canonical(a + " or (" + b + " and " + c + ")"), a + " or " + b + " and " + c);
  EXPECT_EQ(canonical("not " + a + " and " + b), "not " + a + " and " + b);
  EXPECT_EQ(parse_formula("not " + a + " and " + b, scene()).root().op, Node::Op::kAnd);
  EXPECT_EQ(canonical("not (" + a + " and " + b + ")"), "not (" + a + " and " + b + ")");
  EXPECT_EQ(canonical("not not " + a), "not not " + a);
  EXPECT_EQ(canonical("not(not(" + a + "))"), "not not " + a);
  EXPECT_EQ(canonical("((" + a + "))"), a);
  EXPECT_EQ(canonical(a + " and (" + b + " and " + c + ")"), a + " and " + b + " and " + c);
  EXPECT_EQ(canonical("¬(" + a + " ∨ " + b + ") ∧ " + c), "not (" + a + " or " + b + ") and " + c);
  EXPECT_EQ(canonical("true or false and not true"), "true or false and not true");
}

TEST(Parse, UnitsAreConvertedExactly) {
  EXPECT_EQ(canonical("gap(B, A) > 0.5mm"), "gamma1(B, A) > 0.5");
  EXPECT_EQ(canonical("gap(B, A) > 20mil"), "gamma1(B, A) > 0.508");
  EXPECT_EQ(canonical("gap(B, A) > 1in"), "gamma1(B, A) > 25.4");
  EXPECT_EQ(canonical("gap(B, A) > 1 in"), "gamma1(B, A) > 25.4");
  EXPECT_EQ(canonical("gap(B, A) > 3um"), "gamma1(B, A) > 0.003");
  EXPECT_EQ(canonical("gap(B, A) > 3\u00b5m"), "gamma1(B, A) > 0.003");
  EXPECT_EQ(canonical("gap(B, A) > 2.5m"), "gamma1(B, A) > 2500");
  EXPECT_EQ(canonical("1cm <= gap(B, A) <= 1m"), "gamma1(B, A) >= 10 and gamma1(B, A) <= 1000");
  EXPECT_EQ(parse_formula("gap(B, A) > 1.1", scene()).atoms()[0].level, Real::ratio(11, 10));
}

TEST(Parse, NumbersWithoutFiniteDecimalKeepTheirUnit) {
  Context inches = scene();
  inches.unit = Unit::kInch;
  const Formula formula = parse_formula("gap(B, A) > -1mm", inches);
  EXPECT_EQ(formula.atoms()[0].level, Real::ratio(-5, 127));
  EXPECT_EQ(text(formula), "gamma1(B, A) > -1mm");
  EXPECT_EQ(canonical("margin(B, A) > 1mm", inches), "eta1(B, A) < -1mm");
  EXPECT_EQ(canonical("gap(B, A) > 127mm", inches), "gamma1(B, A) > 5");
  EXPECT_EQ(canonical("gap(B, A, turning=(1mm, 1)) > 1", inches), "gamma1(B, A, turning=(1mm, 1)) > 1");
  EXPECT_EQ(parse_formula("gap(B, A) > 10mm or gap(B, A) <= 1cm", inches).sign_maps().size(), 1u);
}

/// Exact: a third is a third. What is printed is read as the same number.
TEST(Parse, NumbersAreCalculated) {
  const auto level = [](const std::string& number) {
    const Formula formula = parse_formula("gap(B, A) >= " + number, scene());
    const std::string printed = text(formula);
    EXPECT_EQ(parse_formula(printed, scene()).atoms()[0].level, formula.atoms()[0].level) << printed;
    return formula.atoms()[0].level;
  };
  EXPECT_EQ(level("2*0.25"), Real::ratio(1, 2));
  EXPECT_EQ(level("2 * 0.25mm"), Real::ratio(1, 2));
  EXPECT_EQ(level("1/3"), Real::ratio(1, 3));
  EXPECT_EQ(level("-1/3in"), Real::ratio(-127, 15));
  EXPECT_EQ(level("7/2/2*4"), Real(7));
  EXPECT_EQ(level("(1 + 2)/8 mm"), Real::ratio(3, 8));
  EXPECT_EQ(level("-(2 - (1 - 4))*1/2"), Real::ratio(-5, 2));
  EXPECT_EQ(canonical("clear(B, A, 1/3 + 2*0.5)"), "gamma1(B, A) >= 4/3");
  EXPECT_EQ(canonical("clear(B, A, 0.25 + 2*0.1in)"), "gamma1(B, A) >= 5.33");
  EXPECT_EQ(canonical("inside(B, A, 1/4)"), "eta1(B, A) <= -0.25");
  EXPECT_EQ(canonical("1/2 <= gap(B, A) <= 1/2 + 1cm"), "gamma1(B, A) >= 0.5 and gamma1(B, A) <= 10.5");
  EXPECT_EQ(canonical("gap(B, A, along=(1/2, -(1+1))) > 1/3"), "gamma1(B, A, along=(0.5, -2)) > 1/3");
  Context still = scene();
  still.motion = false;
  EXPECT_EQ(canonical("2*3*gap(B, A) - 2*gap(B, C) <= 2", still), "gamma1(B, A) - 1/3 * gamma1(B, C) <= 1/3");
  EXPECT_EQ(canonical("gap(B, A) - 1/3*gap(B, C) <= 1/3", still), "gamma1(B, A) - 1/3 * gamma1(B, C) <= 1/3");
}

TEST(Parse, Shapes) {
  EXPECT_EQ(canonical("gamma1(B, \"my part\") > 0"), "gamma1(B, \"my part\") > 0");
  EXPECT_EQ(canonical("gamma1(B, 'my part') > 0"), "gamma1(B, \"my part\") > 0");
  EXPECT_EQ(canonical("gamma1(B, \"board\") > 0"), "gamma1(B, board) > 0");
  EXPECT_EQ(canonical("gamma1(B, A1 + A2) > 0"), "gamma1(B, A1+A2) > 0");
  EXPECT_EQ(canonical("gamma1(B, A1+\"my part\") > 0"), "gamma1(B, A1+\"my part\") > 0");
  EXPECT_EQ(canonical("gamma1(B, mm) > 0 and gamma1(B, and) > 0"), "gamma1(B, mm) > 0 and gamma1(B, and) > 0");
  EXPECT_EQ(canonical("gamma1(A, B) > 0"), "gamma1(A, B) > 0");
  const Formula formula = parse_formula("gamma1(A1+A2, B) > 0", scene());
  EXPECT_EQ(formula.atoms()[0].distance.first, (std::vector<std::string>{"A1", "A2"}));
  EXPECT_EQ(formula.atoms()[0].distance.second, std::vector<std::string>{"B"});
}

TEST(Parse, Directions) {
  EXPECT_EQ(canonical("gamma1(B,A,along=(1,0))<=0"), "gamma1(B, A, along=(1, 0)) <= 0");
  EXPECT_EQ(canonical("eta2(B, A, toward = (-0.6, .8)) <= 0"), "eta2(B, A, toward=(-0.6, 0.8)) <= 0");
  EXPECT_EQ(canonical("delta1(B, A, turning=(0, 1cm)) > 45deg"), "delta1(B, A, turning=(0, 10)) > 45");
  EXPECT_EQ(canonical("gap(B, A, rotating=(0, 0)) > 30"), "gamma1(B, A, rotating=(0, 0)) > 30");
  EXPECT_EQ(parse_formula("gap(B, A, rotating=(0, 0)) > 30", scene()).atoms(),
            parse_formula("gap(B, A, turning=(0, 0)) > 30", scene()).atoms());
  EXPECT_EQ(canonical("30 deg <= gap(B, A, turning=(0, 0))"), "gamma1(B, A, turning=(0, 0)) >= 30");
  EXPECT_EQ(canonical("margin(B, A, along=(1, 0)) >= 1"), "eta1(B, A, along=(1, 0)) <= -1");
  const Distance distance = parse_formula("gamma1(B,A,along=(0.1,0)) < 1", scene()).atoms()[0].distance;
  EXPECT_EQ(distance.mode, Mode::kAlong);
  EXPECT_EQ(distance.vector[0], Real::ratio(1, 10));
  Context solid = scene();
  solid.dimension = 3;
  EXPECT_EQ(canonical("gamma1(B,A,along=(1,0,2))<=0", solid), "gamma1(B, A, along=(1, 0, 2)) <= 0");
}

TEST(Parse, ExtremaOverTime) {
  EXPECT_EQ(canonical("inf gamma1(B, A) > 0"), "inf gamma1(B, A) > 0");
  EXPECT_EQ(canonical("1 > sup γ₁(B, A)"), "sup gamma1(B, A) < 1");
  EXPECT_EQ(canonical("sup eta1(B, A) -> min"), "sup eta1(B, A) -> min");
  const auto natural = [](const char* sentence) {
    return natural_extremum(parse_formula(sentence, scene()).atoms()[0].distance);
  };
  EXPECT_EQ(natural("gamma1(B, A) > 0"), Extremum::kInf);
  EXPECT_EQ(natural("gamma2(B, A) > 0"), Extremum::kSup);
  EXPECT_EQ(natural("sup gamma1(B, A) > 0"), Extremum::kSup);
}

TEST(Parse, SymbolsAndAsciiAreOneLanguage) {
  const Formula ascii = parse_formula("not (gamma1(B, A) <= -1 or mu(B, A) != 2) and eta2(B, A) -> min", scene());
  const Formula symbols = parse_formula("¬(γ₁(B, A) ≤ −1 ∨ μ(B, A) ≠ 2) ∧ η2(B, A) → min", scene());
  EXPECT_EQ(ascii, symbols);
  EXPECT_EQ(text(ascii, Script::kSymbols), "¬(γ₁(B, A) ≤ -1 ∨ μ(B, A) ≠ 2) ∧ η₂(B, A) → min");
}

TEST(Parse, Placement) {
  Context each = scene();
  each.moving = {"self"};
  each.extra = {"other"};
  const Formula pair = parse_formula("clear(self, other, 1mm) and inside(self, A)", each);
  EXPECT_EQ(text(pair), "gamma1(self, other) >= 1 and eta1(self, A) <= 0");
  const Formula renamed_pair = renamed(pair, {{"self", "A1"}, {"other", "my part"}});
  EXPECT_EQ(text(renamed_pair), "gamma1(A1, \"my part\") >= 1 and eta1(A1, A) <= 0");
  EXPECT_EQ(text(renamed_pair.atoms()[0]), "gamma1(A1, \"my part\") >= 1");
  EXPECT_EQ(renamed_pair.sign_maps()[0].distance.first, std::vector<std::string>{"A1"});
  Context constraints = scene();
  constraints.moving = {"A1", "A2"};
  constraints.independent = true;
  EXPECT_EQ(canonical("gamma1(A1, A2) <= 20", constraints), "gamma1(A1, A2) <= 20");
}

TEST(Parse, ShapesThatMoveTogetherMayBeAUnion) {
  Context context = scene();
  context.moving = {"A1", "A2"};
  EXPECT_EQ(canonical("gamma1(A1+A2, A) > 0", context), "gamma1(A1+A2, A) > 0");
}

TEST(Parse, ASideMayBeginWithASignOrAFactor) {
  EXPECT_EQ(canonical("-gap(B, A) <= 5"), "gamma1(B, A) >= -5");
  EXPECT_EQ(canonical("+gap(B, A) <= 5"), "gamma1(B, A) <= 5");
  EXPECT_EQ(canonical("-margin(B, A) <= 5"), "eta1(B, A) <= 5");
  EXPECT_EQ(canonical("(1+2) * gap(B, A) >= 3"), "gamma1(B, A) >= 1");
  EXPECT_EQ(canonical("-(1 + 3)/2 * gap(B, A) >= 3"), "gamma1(B, A) <= -1.5");
  EXPECT_EQ(canonical("(1+2) <= gap(B, A)"), "gamma1(B, A) >= 3");
  EXPECT_EQ(canonical("not ((2) * gap(B, A) >= 3 or ((1 <= gap(B, A))))"),
            "not (gamma1(B, A) >= 1.5 or gamma1(B, A) >= 1)");
  EXPECT_EQ(canonical("gap(B, A, rotating=(0, 0)) >= 30deg + 15deg"), "gamma1(B, A, rotating=(0, 0)) >= 45");
  EXPECT_EQ(canonical("2 * gap(B, A, rotating=(0, 0)) >= 30deg"), "gamma1(B, A, rotating=(0, 0)) >= 15");
  for (const char* wrong : {"gap(B, A, rotating=(0, 0)) >= 30mm + 15mm", "2 * gap(B, A, rotating=(0, 0)) >= 30mm",
                            "gap(B, A) >= 30deg + 15deg", "(1+2)", "()"})
    EXPECT_THROW(parse_formula(wrong, scene()), Error) << wrong;
}

TEST(Parse, MovingFirst) {
  const std::vector<std::string> moving{"B"};
  const auto rotated = [&](const char* sentence) {
    return text(moving_first(parse_formula(sentence, scene()).atoms()[0].distance, moving));
  };
  EXPECT_EQ(rotated("gamma1(A, B) > 0"), "gamma1(B, A)");
  EXPECT_EQ(rotated("eta1(A, B) > 0"), "delta1(B, A)");
  EXPECT_EQ(rotated("delta2(A, B, toward=(1, 0)) > 0"), "eta2(B, A, toward=(1, 0))");
  EXPECT_EQ(rotated("mu(A, B) > 0"), "mu(A, B)");
  EXPECT_EQ(rotated("eta1(B, A) > 0"), "eta1(B, A)");
}

TEST(ParseObjective, AllForms) {
  const auto canonical_objective = [](const char* sentence, int dimension = 2) {
    Context context = scene();
    context.dimension = dimension;
    const Objective objective = parse_objective(sentence, context);
    EXPECT_EQ(parse_objective(text(objective), context), objective) << sentence;
    return text(objective);
  };
  EXPECT_EQ(canonical_objective("gamma2(B, A)"), "gamma2(B, A)");
  EXPECT_EQ(canonical_objective("reach(B,A)"), "reach(B, A)");
  EXPECT_EQ(canonical_objective("distance( B, A )"), "distance(B, A)");
  EXPECT_EQ(canonical_objective("sup margin(B, A)"), "sup margin(B, A)");
  EXPECT_EQ(canonical_objective("x"), "x");
  EXPECT_EQ(canonical_objective(" y "), "y");
  EXPECT_EQ(canonical_objective("z", 3), "z");
  EXPECT_EQ(canonical_objective("distance to [1, -2.5cm]"), "distance to [1, -25]");
  EXPECT_EQ(canonical_objective("distance to [0,0,1]", 3), "distance to [0, 0, 1]");
  Context still = scene();
  still.motion = false;
  EXPECT_EQ(parse_objective("(1 + 2) * gap(B, A)", still), parse_objective("3 * gap(B, A)", still));
  const Objective margin = parse_objective("margin(B, A)", scene());
  EXPECT_TRUE(margin.negated);
  EXPECT_EQ(margin.distance.kind, Kind::kEta1);
}

TEST(Written, KeepsTheNamesOfTheWriter) {
  const auto as_written = [](const char* sentence) {
    const Formula formula = parse_formula(sentence, scene());
    EXPECT_EQ(parse_formula(written(formula), scene()), formula) << sentence;
    return written(formula);
  };
  EXPECT_EQ(as_written("inside(B,A)"), "inside(B, A)");
  EXPECT_EQ(as_written("inside(B,A,0.50)"), "inside(B, A, 0.5)");
  EXPECT_EQ(as_written("within(B,A,0)"), "within(B, A, 0)");
  EXPECT_EQ(as_written("margin(B,A)>=1"), "margin(B, A) >= 1");
  EXPECT_EQ(as_written("1 <= cover(B, A) < 2"), "cover(B, A) >= 1 and cover(B, A) < 2");
  EXPECT_EQ(as_written("gamma1(B, A) >= -1 or not touches(B, A)"), "gamma1(B, A) >= -1 or not touches(B, A)");
  EXPECT_EQ(as_written("m2(B, A) <= 3"), "m2(B, A) <= 3");
  EXPECT_EQ(as_written("protrusion(A, B) = 0"), "protrusion(A, B) = 0");
  EXPECT_EQ(as_written("gap(B, A) -> min"), "gap(B, A) -> min");
  EXPECT_EQ(as_written("between(B,A)<=1"), "between(B, A) <= 1");
  EXPECT_EQ(as_written("between(A, B) >= 0.2"), "between(A, B) >= 0.2");
}

TEST(Written, PlainWordsOfCanonicalText) {
  EXPECT_EQ(plain("gamma1(B, A)").text, "gap(B, A)");
  EXPECT_FALSE(plain("gamma1(B, A)").negated);
  EXPECT_EQ(plain("eta1(B, A)").text, "margin(B, A)");
  EXPECT_TRUE(plain("eta1(B, A)").negated);
  EXPECT_EQ(plain("inf delta1(B, A)").text, "sup cover(B, A)");
  EXPECT_EQ(plain("eta2(B, A)").text, "eta2(B, A)");
}

TEST(Parse, LongFormulasAreLinear) {
  std::string sentence = "true";
  for (int i = 0; i < 20000; ++i) sentence += " and gamma1(B, A) > " + std::to_string(i % 100);
  const Formula formula = parse_formula(sentence, scene());
  EXPECT_EQ(formula.atoms().size(), 20000u);
  EXPECT_EQ(formula.sign_maps().size(), 100u);
}

TEST(Parse, ARuleBetweenListsKeepsItsNames) {
  Context board;
  board.shapes = {"R1", "R2", "C1", "J1", "smd", "tht"};
  board.moving = {"R1", "R2"};
  board.groups = {{"smd", {"R1", "R2", "C1"}}, {"tht", {"J1"}}};
  const Formula one = parse_formula("between(tht, smd) >= 0.2", board);
  ASSERT_EQ(one.atoms().size(), 1u);
  EXPECT_EQ(one.atoms()[0].distance.first, (std::vector<std::string>{"R1", "R2"}));
  EXPECT_EQ(written(one), "between(tht, smd) >= 0.2");
  EXPECT_EQ(parse_formula(written(one), board), one);
  const Formula itself = parse_formula("between(smd, smd) > 1", board);
  ASSERT_EQ(itself.atoms().size(), 1u);
  EXPECT_EQ(written(itself), "between(smd, smd) > 1");
  board.groups["tht"] = {"R1", "R2", "J1"};
  const Formula of_both = parse_formula("between(smd, tht) = 1", board);
  ASSERT_EQ(of_both.atoms().size(), 1u);
  EXPECT_EQ(of_both.atoms()[0].distance.second, (std::vector<std::string>{"tht", "smd"}));
  board.groups["tht"] = {"J1"};
  Context both = board;  // each list has a shape that moves and one that stands
  both.groups["tht"] = {"R2", "J1"};
  both.groups["smd"] = {"R1", "C1"};
  const Formula two = parse_formula("between(smd, tht) >= 0.2", both);
  ASSERT_EQ(two.atoms().size(), 2u);
  EXPECT_EQ(two.root().op, Node::Op::kAnd);
  EXPECT_EQ(two.atoms()[0].distance.first, std::vector<std::string>{"R1"});
  EXPECT_EQ(two.atoms()[0].distance.second, std::vector<std::string>{"tht"});
  EXPECT_EQ(two.atoms()[1].distance.first, std::vector<std::string>{"R2"});
  EXPECT_EQ(two.atoms()[1].distance.second, std::vector<std::string>{"smd"});
  EXPECT_EQ(written(two), "between(R1, tht) >= 0.2 and between(R2, smd) >= 0.2");
  EXPECT_EQ(parse_formula(written(two), both), two);
  EXPECT_EQ(parse_formula("between(smd, tht) < 0.2", both).root().op, Node::Op::kOr);
  EXPECT_THROW(parse_formula("between(smd, tht) = 0.2", both), Error);
  both.moving.push_back("J1");
  both.groups["tht"] = {"R2", "J1", "J2"};
  const Formula several = parse_formula("between(smd, tht) >= 0.2", both);
  EXPECT_EQ(written(several), "between(R1, tht) >= 0.2 and between(R2, smd) >= 0.2 and between(J1, smd) >= 0.2");
  EXPECT_EQ(parse_formula(written(several), both), several);
  board.independent = true;
  board.body_of = {{"R1", 0}, {"R2", 1}};
  const Formula pairs = parse_formula("between(tht, smd) >= 0.2", board);
  EXPECT_EQ(written(pairs), "between(R1, J1) >= 0.2 and between(R2, J1) >= 0.2");
}

}  // namespace formula_parse
}  // namespace findspace::formula
