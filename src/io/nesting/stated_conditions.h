// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Gaps and conditions of pairs as a packing problem states them, in the plane and in space: `gaps`, `pairs`, `where`
// and `groups` (docs/nesting.md).
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/nesting/nesting_json.h"
#include "packing/problem/pair_condition.h"

namespace findspace::io {

/// The keys of what `gaps`, `pairs` and `groups` list.
inline constexpr std::array<std::string_view, 2> kGapKeys{"between", "gap"}, kPairKeys{"between", "where"},
    kGroupKeys{"parts", "within"};

/// Parts that stay together: any two copies in one container, and no farther apart than that.
struct StatedGroup {
  std::vector<std::size_t> parts;
  std::optional<packing::Fraction> within = {};
};

struct StatedConditions {
  std::vector<packing::PairGap> gaps;
  std::vector<packing::PairCondition> conditions;
  std::string where;  // for all pairs
  std::vector<StatedGroup> groups;
};

/// Groups and what holds for all pairs of so many parts as conditions of pairs, with the others. `farthest`: no gap in
/// a container is larger; without one a group says how large. Throws Error.
std::vector<packing::PairCondition> conditions_of(const StatedConditions& stated, std::size_t parts,
                                                  const std::optional<packing::Fraction>& farthest,
                                                  const std::string& place);

/// Of a problem; `names` are those of its parts. Throws Error.
void read_conditions(const NestingJson& json, const std::vector<std::string>& names, int dimension,
                     StatedConditions& out);

/// The names of parts.
template <class Named>
std::vector<std::string> names_of(const std::vector<Named>& all) {
  std::vector<std::string> names;
  for (const Named& one : all) names.push_back(one.name);
  return names;
}

}  // namespace findspace::io
