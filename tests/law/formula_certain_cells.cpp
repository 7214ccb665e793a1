// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Where distances differ by at most w at two places p and q: what holds at p holds widened at q, and what holds
// narrowed at q holds at p. Random formulas with every relation, values on and between the levels.
#include <gtest/gtest.h>

#include <array>
#include <random>

#include "formula/language/certain_cells.h"
#include "formula/language/evaluate.h"
#include "formula/solid/side.h"

namespace findspace::formula {
namespace formula_certain_cells {

using exact::Real;

constexpr std::array<Relation, 6> kRelations{Relation::kLess,     Relation::kLessEqual,    Relation::kEqual,
                                             Relation::kNotEqual, Relation::kGreaterEqual, Relation::kGreater};

Distance distance(Kind kind) {
  Distance d;
  d.kind = kind;
  d.first = {"B"};
  d.second = {"A"};
  return d;
}

/// `values`: of gamma1 and of eta1.
bool truth(const Formula& formula, const std::array<Real, 2>& values) {
  std::vector<std::int8_t> signs;
  for (const SignMap& m : formula.sign_maps())
    signs.push_back(
        static_cast<std::int8_t>(exact::compare(values[m.distance.kind == Kind::kGamma1 ? 0 : 1], m.level)));
  return evaluate(formula, signs);
}

Formula random_formula(std::mt19937& random, int depth) {
  const auto pick = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  if (depth == 0 || pick(4) == 0) {
    const Distance d = distance(pick(2) == 0 ? Kind::kGamma1 : Kind::kEta1);
    return Formula(compare(d, kRelations[static_cast<std::size_t>(pick(6))], Real(pick(5) - 2)));
  }
  if (pick(3) == 0) return negation(random_formula(random, depth - 1));
  const std::array<Formula, 2> parts{random_formula(random, depth - 1), random_formula(random, depth - 1)};
  return pick(2) == 0 ? conjunction(parts) : disjunction(parts);
}

TEST(CertainCells, HoldAsFarAsDistancesAllow) {
  std::mt19937 random(4);
  const auto pick = [&](int low, int high) {
    return low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1));
  };
  int holds = 0, narrow = 0, not_wide = 0;
  for (int k = 0; k < 20000; ++k) {
    const Formula formula = random_formula(random, 3);
    const int by = pick(0, 4);  // in quarters
    std::array<Real, 2> at_p, at_q;
    for (std::size_t c = 0; c < 2; ++c) {
      const int value = pick(-12, 12);
      at_p[c] = Real::ratio(value, 4);
      at_q[c] = Real::ratio(value + pick(-by, by), 4);
    }
    const Real width = Real::ratio(by, 4);
    const bool here = truth(formula, at_p), wide = truth(widened(formula, width), at_q),
               tight = truth(narrowed(formula, width), at_q);
    EXPECT_TRUE(!here || wide);
    EXPECT_TRUE(!tight || here);
    EXPECT_TRUE(by != 0 || (here == wide && here == tight));
    holds += here;
    narrow += tight;
    not_wide += !wide;
  }
  EXPECT_GT(narrow, holds / 4);  // they say something
  EXPECT_GT(not_wide, 2000);
}

/// Signs that a search leaves at 0 near a level count on the safe side.
TEST(CertainCells, KeepTheirSideUnderASearch) {
  std::mt19937 random(5);
  for (int k = 0; k < 2000; ++k) {
    const Formula formula = random_formula(random, 3);
    const auto side = [](const Formula& f) { return side_of_search(f, std::vector<bool>(f.sign_maps().size(), true)); };
    const Side wide = side(widened(formula, Real(1))), tight = side(narrowed(formula, Real(1)));
    EXPECT_TRUE(wide == Side::kExact || wide == Side::kOuter);
    EXPECT_TRUE(tight == Side::kExact || tight == Side::kInner);
  }
}

}  // namespace formula_certain_cells
}  // namespace findspace::formula
