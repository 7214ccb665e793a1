// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What must hold between two parts besides the gap of all, as it is stated: in the plane and in space.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "packing/problem/fraction.h"

namespace findspace::packing {

/// Copies of two parts keep this distance, where it is more than the gap of all.
struct PairGap {
  std::size_t first = 0, second = 0;
  Fraction gap;
};

/// What holds for a copy of the first part, called `self`, and one of the second, `other`: a formula (pair_formula.h).
/// Of one part it holds for any two copies, both ways. In different containers two parts are infinitely far apart.
struct PairCondition {
  std::size_t first = 0, second = 0;
  std::string where;
};

/// Whether a gap or a condition is that of two parts, in either order.
template <class Pair>
bool is_between(const Pair& pair, std::size_t first, std::size_t second) {
  return (pair.first == first && pair.second == second) || (pair.first == second && pair.second == first);
}

/// Of copies of two parts.
inline Fraction widest_gap(const Fraction& of_all, const std::vector<PairGap>& gaps, std::size_t first,
                           std::size_t second) {
  Fraction result = of_all;
  for (const PairGap& pair : gaps)
    if (is_between(pair, first, second)) result = std::max(result, pair.gap);
  return result;
}

inline bool are_between(const std::vector<PairCondition>& conditions, std::size_t first, std::size_t second) {
  return std::any_of(conditions.begin(), conditions.end(),
                     [&](const PairCondition& c) { return is_between(c, first, second); });
}

/// Which parts are tied by conditions, as a table. Cost: the square of the parts, once.
class Ties {
 public:
  Ties(const std::vector<PairCondition>& conditions, std::size_t parts)
      : parts_(parts), tied_(conditions.empty() ? 0 : parts * parts) {
    for (const PairCondition& c : conditions) tied_[c.first * parts + c.second] = tied_[c.second * parts + c.first] = 1;
  }
  bool between(std::size_t first, std::size_t second) const {
    return !tied_.empty() && tied_[first * parts_ + second] != 0;
  }

 private:
  std::size_t parts_;
  std::vector<char> tied_;
};

/// For all pairs of these parts.
inline void add_conditions(std::vector<PairCondition>& conditions, const std::vector<std::size_t>& parts,
                           const std::string& where) {
  for (std::size_t i = 0; i < parts.size(); ++i)
    for (std::size_t j = i; j < parts.size(); ++j) conditions.push_back({parts[i], parts[j], where});
}

}  // namespace findspace::packing
