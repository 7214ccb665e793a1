// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A conjunction of conditions as a disjunction of conjunctions of single ones (relations.h): what simultaneous
// placement can take. `or` between conditions on different bodies is expanded; what is on the same bodies stays
// together. Guarantee: equivalent. Cost: the product of the numbers of alternatives, refused beyond kMostAlternatives.
// Keywords: disjunctive normal form.
#pragma once

#include <span>
#include <vector>

#include "planning/order/problem.h"

namespace findspace::planning {

inline constexpr std::size_t kMostAlternatives = 4096;

using Alternative = std::vector<Condition>;

/// Throws Error(kUnsupported) beyond kMostAlternatives.
std::vector<Alternative> alternatives(std::span<const Condition> conditions);

}  // namespace findspace::planning
