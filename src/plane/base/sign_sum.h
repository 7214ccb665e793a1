// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A function of the signs of several functions that is a sum over them. Where one sign changes it is known anew at
// once, however many there are. Keywords: weighted sum, incremental evaluation.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace findspace::plane {

/// `first` and what the sign of each function adds: of function k the sign s adds added[k][s + 1].
struct SignSum {
  std::int32_t first = 0;
  std::vector<std::array<std::int32_t, 3>> added;

  std::int32_t of(std::size_t k, std::int8_t sign) const { return added[k][std::size_t(sign + 1)]; }
};

}  // namespace findspace::plane
