// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Truth from the demands that fail, against truth from all of them; its work is counted.
#include <gtest/gtest.h>

#include <random>
#include <string>

#include "findspace/error.h"
#include "formula/explain/conflict.h"
#include "formula/language/parse.h"
#include "plane/base/search_work.h"

namespace findspace::formula {
namespace formula_failing_cells {

Formula read(const std::string& text) {
  return parse_formula(text, {.shapes = {"A", "B"},
                              .moving = {"B"},
                              .extra = {},
                              .independent = false,
                              .motion = false,
                              .unit = Unit::kMillimetre,
                              .dimension = 2});
}

/// Of conditions, constants, `and`, `or` and `not`.
std::string random_text(std::mt19937& random, int depth) {
  const auto choice = [&](unsigned many) { return random() % many; };
  if (depth == 0 || choice(5) == 0) {
    if (choice(9) == 0) return choice(2) == 0 ? "true" : "false";
    return "gap(B, A) <= " + std::to_string(choice(20));
  }
  if (choice(5) == 0) return "not (" + random_text(random, depth - 1) + ")";
  std::string out = "(" + random_text(random, depth - 1);
  const char* const op = choice(2) == 0 ? " and " : " or ";
  for (unsigned more = 1 + choice(3); more > 0; --more) out += op + random_text(random, depth - 1);
  return out + ")";
}

std::vector<MetDemands> random_cells(std::mt19937& random, std::size_t demands) {
  std::vector<MetDemands> out(8, MetDemands(demands));
  for (MetDemands& met : out)
    for (std::size_t k = 0; k < demands; ++k) met[k] = random() % 4 != 0;
  return out;
}

TEST(FailingCells, TellTheTruthOfAllDemands) {
  std::mt19937 random(7);
  for (int turn = 0; turn < 300; ++turn) {
    const std::string text = random_text(random, turn % 5);
    const Formula formula = read(text);
    const Demands demands(formula);
    const std::vector<MetDemands> cells = random_cells(random, demands.size());
    FailingCells failing(demands, cells);
    const MetDemands counts = random_cells(random, demands.size())[0];
    const std::vector<bool> holds = failing.where([&](std::size_t k) { return counts[k]; });
    for (std::size_t cell = 0; cell < cells.size(); ++cell) {
      MetDemands met = cells[cell];
      for (std::size_t k = 0; k < met.size(); ++k) met[k] = met[k] || !counts[k];
      EXPECT_EQ(holds[cell], demands.truth(met)) << text << ", cell " << cell;
    }
    for (std::size_t also = 0; also < demands.size(); ++also) {
      std::size_t first = 0;
      for (MetDemands met; first < cells.size(); ++first) {
        met = cells[first];
        met[also] = false;
        if (demands.truth(met)) break;
      }
      EXPECT_EQ(failing.first([&](std::size_t k) { return k != also; }, also), first) << text;
    }
  }
}

/// Each cell fails one of many demands.
FailingCells one_fails(const Demands& demands) {
  std::vector<MetDemands> cells(demands.size(), MetDemands(demands.size(), true));
  for (std::size_t k = 0; k < cells.size(); ++k) cells[k][k] = false;
  return {demands, cells};
}

TEST(FailingCells, CountTheirWork) {
  std::string text = "gap(B, A) >= 0";
  for (int level = 1; level < 100; ++level) text += " and gap(B, A) >= " + std::to_string(level);
  const Demands demands(read(text));
  FailingCells enough = one_fails(demands);
  EXPECT_EQ(find_conflict(enough).atoms.size(), 100u);
  const plane::SearchLimit limit{200};
  const plane::ScopedSearchLimit here(&limit);
  FailingCells few = one_fails(demands);
  try {
    find_conflict(few);
    FAIL() << "no limit";
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), ErrorCode::kLimit);
    EXPECT_NE(std::string(e.what()).find("an explanation of so many conditions costs more than the work limit"),
              std::string::npos)
        << e.what();
  }
}

}  // namespace formula_failing_cells
}  // namespace findspace::formula
