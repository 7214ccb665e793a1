// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Which distances `measure` prints, in which order and by which names: gap, margin, reach, protrusion and hausdorff of
// every pair, then what the formula speaks of besides; or all of them. What `check` prints beside an atom.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "common/options.h"
#include "formula/language/names.h"
#include "formula/language/position_answers.h"

namespace findspace::app {

struct MeasuredRow {
  std::size_t of = 0;  // the distance
  std::string text;    // "margin(B, A)"
  bool negated = false;
};

/// The word of an atom's distance, where the atom itself does not say it: "margin " of inside(B, A).
std::string said_distance(const formula::Atom& atom);

/// Which way decided an atom, and how long it took: ", by features in 0.12 ms".
std::string explained(distance::Way way, double milliseconds);

/// Of distances pair by pair as Solver::measure gives them.
std::vector<MeasuredRow> measured_rows(const std::vector<formula::DistanceAt>& distances, bool all);

/// The kinds that a measurement has to compute; none: all. Throws Error(kUsage) for an unknown --only.
std::vector<formula::Kind> wanted_kinds(const Options& options);
/// Those of --only; all without it.
std::vector<formula::DistanceAt> only_wanted(std::vector<formula::DistanceAt> distances, const Options& options);
/// Whether every distance that is there is printed.
inline bool shows_all(const Options& options) { return options.all || !options.only.empty(); }

}  // namespace findspace::app
