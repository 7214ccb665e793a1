// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// `check` and `measure` at a position as text for people, in the plane and in space. Numbers have six digits here;
// --json gives them all.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "formula/language/position_answers.h"

namespace findspace::io {

struct MeasuredRow {
  std::size_t of = 0;  // the distance
  std::string text;    // "margin(B, A)"
  bool negated = false;
};
/// Of distances pair by pair as Solver::measure gives them: which are printed, in which order and by which names: the
/// usual ones of every pair, then what the formula speaks of besides; or all of them.
std::vector<MeasuredRow> measured_rows(const std::vector<formula::DistanceAt>& distances, bool all);
inline constexpr std::array<std::string_view, 5> kUsualDistances{"gap", "margin", "reach", "protrusion", "hausdorff"};
/// "gap" of "inf gap(B, A)".
std::string_view distance_word(std::string_view text);
/// Whether the text of a distance says a direction, as "gap(B, A, toward=(1, 0))" does.
bool is_directional(std::string_view text);

/// The word of an atom's distance, where the atom itself does not say it: "margin " of inside(B, A).
std::string said_distance(const formula::Atom& atom);
/// Which way decided an atom, and how long it took: ", by features in 0.12 ms".
std::string explained(distance::Way way, double milliseconds);

/// `at`: the position as text; `place` may be empty, and then no ways from it are shown. `nearest`: the nearest
/// feasible position, where it was asked for. `explain`: which way decided each atom, and how long it took.
std::string check_text(const formula::Check& check, std::string_view at, const distance::Coordinates& place,
                       std::string_view unit, const formula::AskedNearest& nearest, bool explain);
std::string measure_text(const std::vector<formula::DistanceAt>& distances, std::string_view at,
                         const distance::Coordinates& place, std::string_view unit, bool all);

}  // namespace findspace::io
