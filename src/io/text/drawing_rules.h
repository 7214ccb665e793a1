// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// How drawings and meshes are read: what becomes of curves beyond arcs, of outlines with gaps and of surfaces with
// slits and holes. Rules of the
// command line come first, then those beside a shape, then those of the scene. Keywords: tolerance, chaining, gap
// closing.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "exact/number/real.h"
#include "formula/language/units.h"

namespace findspace::io {

/// Where the arcs that stand for a curve lie: on either side, or so that the set is inside (outside) the true one.
enum class CurveRule { kNear, kInside, kOutside };

struct DrawingRules {
  std::optional<CurveRule> curves;
  std::optional<std::string> tolerance;    // a length as text: "0.001mm", or a number in the scene's unit
  std::optional<std::string> join;         // the widest gap that is closed
  std::optional<bool> open_lines;          // open outlines are lines, not errors
  std::optional<std::string> repair;       // of meshes: the width within which open edges and their vertices are joined
  std::optional<std::string> close_holes;  // of meshes: how wide holes may be that are closed

  /// These where they say something, else those.
  DrawingRules over(const DrawingRules& those) const;
};

/// "near", "inside", "outside"; throws Error(kUnknownName).
CurveRule parse_curve_rule(std::string_view name);
std::string_view name(CurveRule rule);

/// A length such as "0.01mm" or "0.01", in the unit of the scene. Throws Error: kSyntax, kUnknownName, kBadValue for a
/// unit where the scene has none or a length that is negative.
exact::Real parse_length(std::string_view text, std::optional<formula::Unit> unit);

}  // namespace findspace::io
