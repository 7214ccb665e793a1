// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "formula/language/condition_work.h"

#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "plane/base/work_budget.h"

namespace findspace::formula {

void charge_conditions(const Formula& formula, std::uint64_t limit) {
  using Names = std::vector<std::string>;
  std::map<std::tuple<Kind, const Names&, const Names&>, std::uint64_t> levels;
  plane::WorkBudget work(limit);
  for (const auto& [distance, level, minimum, more] : formula.sign_maps())
    work.charge(++levels[{distance.kind, distance.first, distance.second}], "a formula with so many conditions");
}

}  // namespace findspace::formula
