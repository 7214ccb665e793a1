// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Decimal numbers as people write them, read exactly: "1.1" is 11/10, never the double nearest to it.
// Grammar: [+-] digits [. digits] [e [+-] digits], with at least one digit in the mantissa; ".5" and "5." are allowed.
// Nothing around it, not even blanks. NaN, infinities, hexadecimal and anything else are Error(kSyntax).
// Cost: linear in the digits for the parse, one big-integer product for the value.
// Keywords: decimal grid, snap, round half away from zero.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "exact/number/real.h"

namespace findspace::exact {

/// (-1)^negative * digits * 10^exponent, where `digits` has no leading or trailing zeros (zero is "", exponent 0).
struct Decimal {
  bool negative = false;
  std::string digits;
  std::int64_t exponent = 0;

  /// Throws Error(kSyntax); Error(kOutOfRange) where the exponent or the number of digits is beyond kMaxExponent.
  static Decimal parse(std::string_view text);
  /// The exact value.
  Real value() const;

  static constexpr std::int64_t kMaxExponent = 4000;  // beyond what any double can hold, small enough to be cheap
};

inline constexpr std::int64_t kMaxGridCoordinate = std::int64_t{1} << 40;

/// The number of grid steps that a decimal is, in machine integers: nothing for numbers of more than 17 digits or with
/// so large an exponent, for what is not a decimal, off the grid or beyond 2^40 steps. Cost: some ten nanoseconds.
std::optional<std::int64_t> grid_integer(std::string_view text, const Real& step);

}  // namespace findspace::exact
