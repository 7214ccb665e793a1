// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Of a formula that compares one distance with several levels: it holds where the value of the distance is in a set of
// numbers, and is a sum over the signs at the levels at which that set begins or ends. The other levels tell nothing.
// Guarantee: exact. Cost: the formula is asked at every level and beside it. Keywords: interval set, redundant
// constraint.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "formula/language/formula.h"
#include "plane/base/sign_sum.h"

namespace findspace::formula {

struct LevelTruth {
  std::vector<std::size_t> sign_maps;  // of the formula, ascending: those whose levels tell something
  plane::SignSum sum;                  // over their signs: 1 where the formula holds, 0 elsewhere
};

/// Whether all sign maps of both formulas are of one distance, which is no angle.
bool of_one_distance(const Formula& a, const Formula& b);
/// Nothing unless the formula has several sign maps and all are of one distance, which is no angle.
std::optional<LevelTruth> level_truth(const Formula& formula);

}  // namespace findspace::formula
