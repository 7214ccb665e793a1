// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A product of factors as a list: from the number of a factor to how often it divides. Internal to src/exact.
#pragma once

#include <map>

namespace findspace::exact::detail {

using Powers = std::map<int, int>;

/// The factors of `to` that `from` lacks.
inline Powers lacking(const Powers& from, const Powers& to) {
  Powers out;
  for (const auto& [f, power] : to) {
    const auto have = from.find(f);
    const int rest = power - (have == from.end() ? 0 : have->second);
    if (rest > 0) out[f] = rest;
  }
  return out;
}

}  // namespace findspace::exact::detail
