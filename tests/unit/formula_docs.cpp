// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// docs/formula.md teaches the language that is read: every word is on the page, and every formula of its tables is one.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <regex>

#include "formula/language/parse.h"

namespace findspace::formula {
namespace formula_docs {

std::string page() {
  std::ifstream file(FINDSPACE_SOURCE "/docs/formula.md");
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

TEST(FormulaPage, HasEveryWord) {
  const std::string text = page();
  const auto has = [&](std::string_view word) {
    return text.find("`" + std::string(word) + "`") != std::string::npos ||
           text.find("`" + std::string(word) + "(") != std::string::npos;
  };
  for (const DistanceName& row : distance_names()) EXPECT_TRUE(has(row.name)) << row.name;
  for (const PredicateName& row : predicate_names()) EXPECT_TRUE(has(row.name)) << row.name;
  for (const std::string_view unit : kUnitNames) EXPECT_TRUE(has(unit)) << unit;
}

TEST(FormulaPage, ItsFormulasAreFormulas) {
  Context context{.shapes = {"A", "A1", "A2", "R", "my part", "board", "chip", "key", "screws"},
                  .moving = {"B", "chip"},
                  .extra = {},
                  .independent = false,
                  .motion = true,
                  .unit = Unit::kMillimetre,
                  .dimension = 2};
  // Code in the first column of the tables, and the indented formulas; letters stand for numbers in some.
  const std::regex code("(?:\n\\| |, |\n    )`?([^|`\n\"][^|`\n]*\\((?:B|A|chip), [^|`\n]*\\)[^|`\n]*)(?:`|\n)");
  const std::string text = page();
  int count = 0;
  for (std::sregex_iterator match(text.begin(), text.end(), code), end; match != end; ++match) {
    std::string formula = std::regex_replace((*match)[1].str(), std::regex(", [cdm]\\)"), ", 1)");
    if (formula.find("bord") != std::string::npos) continue;  // the page's example of a mistake
    const bool condition = formula.find_first_of("<>=") != std::string::npos || formula.find("→") != std::string::npos;
    context.motion = formula.find("inf ") == 0 || formula.find("sup ") == 0;  // sums have none
    ++count;
    if (condition || find_predicate(formula.substr(0, formula.find('('))) != nullptr) {
      EXPECT_NO_THROW(parse_formula(formula, context)) << formula;
    } else {
      EXPECT_NO_THROW(parse_objective(formula, context)) << formula;
    }
  }
  EXPECT_GE(count, 30);
}

}  // namespace formula_docs
}  // namespace findspace::formula
