// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// `distance -> min` for maps on rays: the atom becomes `distance <= v` with the least value v, which some position
// takes. Guarantee: the same set where v is proven; else it holds the minimisers and what comes as near to them as v is
// known (distance/solid/solid_least.h), so the map is an outer bound, or an inner one where the atom is negated.
// Keywords: argmin, level set.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "formula/solid/side.h"
#include "formula/solid/solve_rays.h"
#include "formula/solid/solve_space.h"

namespace findspace::formula {

struct LeastOf {
  std::string text;                       // the atom's
  std::optional<distance::Answer> least;  // in the scene's unit; nothing where undefined: the atom holds nowhere
};

struct MinimaAsLevels {
  Formula formula;
  std::vector<LeastOf> minima;
  Side side = Side::kExact;
};

bool has_minima(const Formula& formula);
/// Throws Error(kUnsupported) where a least value is not computed.
MinimaAsLevels minima_as_levels(const SpaceSolver& solver, const Formula& formula);

/// A formula ready to be taken on lines.
struct QuestionOnLines {
  MinimaAsLevels levels;
  RayWindow window;        // a box that holds the frontier
  bool unbounded = false;  // the set goes on beyond it
  /// The formula is one `-> min` with a least value: some position is known, whatever the lines meet.
  bool somewhere = false;
  /// And that is all that is known, or there is none: its set has no map on lines along one of the axes.
  bool one_position = false;

  /// The formula, or another one of the same atoms at other levels, on these lines.
  RegionOnLines on(const RayWorld& world, const Formula& asked, const space::RayGrid& grid) const;
};
/// `solver` is called where there are least values. `axes`: along which the lines run.
QuestionOnLines question_on_lines(const RayWorld& world, const std::function<const SpaceSolver&()>& solver,
                                  const Formula& formula, const std::vector<int>& axes);

}  // namespace findspace::formula
