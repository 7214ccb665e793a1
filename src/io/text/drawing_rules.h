// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The rules of drawings (findspace/files.h) as text: names and lengths. Keywords: tolerance, chaining.
#pragma once

#include <optional>
#include <string_view>

#include "exact/number/real.h"
#include "findspace/files.h"
#include "formula/language/units.h"

namespace findspace::io {

/// "near", "inside", "outside"; throws Error(kUnknownName).
CurveRule parse_curve_rule(std::string_view name);
std::string_view name(CurveRule rule);
/// "one", "elements", "outlines"; throws Error(kUnknownName).
PartRule parse_part_rule(std::string_view name);

/// A length such as "0.01mm" or "0.01", in the unit of the scene. Throws Error: kSyntax, kUnknownName, kBadValue for a
/// unit where the scene has none or a length that is negative.
exact::Real parse_length(std::string_view text, std::optional<formula::Unit> unit);

}  // namespace findspace::io
