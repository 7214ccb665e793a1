// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/text/drawing_rules.h"

#include <fmt/format.h>

#include <array>

#include "findspace/error.h"
#include "io/text/units.h"

namespace findspace::io {
namespace {

constexpr std::array<std::string_view, 3> kCurveRules{"near", "inside", "outside"};
constexpr std::array<std::string_view, 3> kPartRules{"one", "elements", "outlines"};

}  // namespace

CurveRule parse_curve_rule(std::string_view text) {
  for (std::size_t i = 0; i < kCurveRules.size(); ++i)
    if (text == kCurveRules[i]) return static_cast<CurveRule>(i);
  throw Error(ErrorCode::kUnknownName,
              fmt::format("curves become arcs that lie {}, not '{}'", fmt::join(kCurveRules, ", "), text));
}

PartRule parse_part_rule(std::string_view text) {
  for (std::size_t i = 0; i < kPartRules.size(); ++i)
    if (text == kPartRules[i]) return static_cast<PartRule>(i);
  throw Error(ErrorCode::kUnknownName,
              fmt::format("the parts of a drawing are {}, not '{}'", fmt::join(kPartRules, ", "), text));
}

std::string_view name(CurveRule rule) { return kCurveRules[static_cast<std::size_t>(rule)]; }

exact::Real parse_length(std::string_view text, std::optional<formula::Unit> unit) {
  const std::size_t digits = scan_number(text);
  if (digits == 0) throw Error(ErrorCode::kSyntax, fmt::format("'{}' is not a length, such as 0.01mm", text));
  exact::Real value = exact::Real::parse_decimal(text.substr(0, digits));
  if (value.sign() < 0) throw Error(ErrorCode::kBadValue, fmt::format("the length '{}' is negative", text));
  std::string_view unit_name = text.substr(digits);
  while (!unit_name.empty() && unit_name[0] == ' ') unit_name.remove_prefix(1);
  if (unit_name.empty()) return value;
  const Unit given = parse_unit(unit_name);
  if (!unit)
    throw Error(ErrorCode::kBadValue, fmt::format("the length '{}' has a unit, so the scene needs \"unit\" too", text));
  return value * formula::factor(given, *unit);
}

}  // namespace findspace::io

namespace findspace {

DrawingRules DrawingRules::over(const DrawingRules& those) const {
  return {curves ? curves : those.curves, tolerance ? tolerance : those.tolerance,      join ? join : those.join,
          mend ? mend : those.mend,       open_lines ? open_lines : those.open_lines,   parts ? parts : those.parts,
          repair ? repair : those.repair, close_holes ? close_holes : those.close_holes};
}

}  // namespace findspace
