// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Units by name, and numbers as texts and messages have them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "formula/language/units.h"
#include "plane/contour/decimal_grid.h"

namespace findspace::io {

using formula::Unit;
using plane::Grid;
using plane::RoundingLog;

/// `um mm cm m in mil`; throws Error(kUnknownName).
Unit parse_unit(std::string_view name);
/// Length of the decimal number at the start of `text`, 0 if there is none: [+-] digits [. digits] [e [+-] digits].
std::size_t scan_number(std::string_view text);
/// A number as messages show it, e.g. "12.5".
std::string show(double value);

}  // namespace findspace::io
