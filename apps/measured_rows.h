// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Which distances `measure` prints, in which order and by which names: gap, margin, reach, protrusion and hausdorff of
// every pair, then what the formula speaks of besides; or all of them. What `check` prints beside an atom.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "formula/language/formula.h"
#include "io/write/json_answers.h"

namespace findspace::app {

struct MeasuredRow {
  std::size_t of = 0;  // the distance
  std::string text;    // "margin(B, A)"
  bool negated = false;
};

/// Of distances by their canonical texts, pair by pair as Solver::measure gives them.
std::vector<MeasuredRow> rows_by_text(std::span<const std::string> texts, bool all);

/// The word of an atom's distance, where the atom itself does not say it: "margin " of inside(B, A).
std::string said_distance(const formula::Atom& atom);

/// The distance with the value that its word says.
template <class DistanceAt>
DistanceAt as_said(DistanceAt d, bool negated) {
  if (negated) d.value = io::negated(d.value);
  return d;
}

/// The rows of `distances`.
template <class DistanceAt>
std::vector<MeasuredRow> measured_rows(const std::vector<DistanceAt>& distances, bool all) {
  std::vector<std::string> texts;
  for (const DistanceAt& d : distances) texts.push_back(d.text);
  return rows_by_text(texts, all);
}

}  // namespace findspace::app
