// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What the public headers of packing share, in the plane and in space: numbers, names and conditions of pairs.
#pragma once

#include <findspace/error.h>
#include <findspace/packing.h>
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "io/nesting/stated_conditions.h"

namespace findspace::io {

/// `what`: the name of the number in an error.
inline packing::Fraction fraction(const Number& number, const char* what = nullptr) {
  try {
    return packing::Fraction::parse(number.text());
  } catch (const Error& e) {
    throw what == nullptr ? e : e.within(what);
  }
}

template <class Named>
std::size_t index_of(const std::string& name, const std::vector<Named>& all, const char* what) {
  const auto same = [&](const Named& one) { return one.name == name; };
  const auto found = std::find_if(all.begin(), all.end(), same);
  if (found == all.end()) throw Error(ErrorCode::kUnknownName, std::string("there is no ") + what + " '" + name + "'");
  return std::size_t(found - all.begin());
}

/// Layouts name what they place.
template <class Named>
void check_names(const std::vector<Named>& all, const char* what) {
  for (std::size_t k = 1; k < all.size(); ++k)
    for (std::size_t j = 0; j < k; ++j)
      if (all[j].name == all[k].name)
        throw Error(ErrorCode::kBadValue, fmt::format("two {} are called '{}'", what, all[k].name));
}

/// Refuses an item, counted from 0, that a layout of so many does not have.
inline void check_item(std::size_t item, std::size_t items) {
  if (item < items) return;
  throw Error(ErrorCode::kBadValue,
              items == 0 ? "the layout has no items" : fmt::format("the layout has items 0 to {}", items - 1));
}

inline int count_of(int count) {
  if (count < 0) throw Error(ErrorCode::kBadValue, "a count below 0");
  return count;
}

inline std::optional<packing::Fraction> amount_of(const std::optional<Number>& amount) {
  if (!amount) return std::nullopt;
  if (fraction(*amount) < 0) throw Error(ErrorCode::kBadValue, "a value or cost below 0");
  return fraction(*amount);
}

inline std::optional<Number> public_amount(const std::optional<packing::Fraction>& amount) {
  return amount ? std::optional<Number>(amount->text()) : std::nullopt;
}

/// Gaps, conditions and groups of a public problem, of which `parts` are the names.
template <class Problem, class Named>
StatedConditions stated_of(const Problem& problem, const std::vector<Named>& parts) {
  const auto part = [&](const std::string& name) { return index_of(name, parts, "part"); };
  StatedConditions result;
  for (const PackGap& pair : problem.gaps) {
    if (fraction(pair.gap) < 0) throw Error(ErrorCode::kBadValue, "a gap below 0");
    result.gaps.push_back({part(pair.first), part(pair.second), fraction(pair.gap)});
  }
  for (const PackCondition& c : problem.conditions)
    result.conditions.push_back({part(c.first), part(c.second), c.where});
  result.where = problem.where;
  for (const PackGroup& group : problem.groups) {
    StatedGroup& out = result.groups.emplace_back();
    for (const std::string& name : group.parts) out.parts.push_back(part(name));
    if (group.within) out.within = fraction(*group.within);
    if (out.within && *out.within < 0) throw Error(ErrorCode::kBadValue, "parts of a group within less than 0");
  }
  return result;
}

/// The same back, by the names of the parts.
template <class Problem>
void show_stated(const StatedConditions& stated, const std::vector<std::string>& names, Problem& problem) {
  for (const packing::PairGap& pair : stated.gaps)
    problem.gaps.push_back({names[pair.first], names[pair.second], pair.gap.text()});
  problem.where = stated.where;
  for (const packing::PairCondition& c : stated.conditions)
    problem.conditions.push_back({names[c.first], names[c.second], c.where});
  for (const StatedGroup& group : stated.groups) {
    PackGroup& out = problem.groups.emplace_back();
    for (const std::size_t part : group.parts) out.parts.push_back(names[part]);
    out.within = public_amount(group.within);
  }
}

/// The faults in words.
inline std::vector<std::string> texts_of(const PackVerdict& verdict) {
  std::vector<std::string> result;
  for (const PackFault& fault : verdict.faults) result.push_back(fault.text);
  return result;
}

}  // namespace findspace::io
