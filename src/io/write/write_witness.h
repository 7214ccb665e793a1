// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Where a distance is attained, as JSON and in words, as docs/results.md describes it. Keywords: witness, closest
// features.
#pragma once

#include <string>
#include <string_view>

#include "formula/language/position_answers.h"

namespace findspace::io {

/// The members of a "witness" object of a distance at a position, without the braces; "" where nothing is known.
std::string witness_members(const formula::DistanceAt& d, const distance::Coordinates& at);
/// "vertex (1, 2) of B and edge (0, 0) to (4, 0) of A, part left", or the two points; "" where nothing is known.
std::string witness_words(const formula::DistanceAt& d);
/// "is 0 after (0, 0, 1.5), at (5, 5, 11)": the way to the nearest contact; "" where there is none.
std::string way_words(const formula::DistanceAt& d, const distance::Coordinates& at);
/// A length in the unit, or a number of degrees: "4 mm".
std::string amount_words(const formula::DistanceAt& d, double amount, std::string_view unit);
/// How far an atom that fails is from holding, "off by 4 mm"; "off by at least 4 mm" where the value has one end only.
std::string lacks_words(const formula::AtomAt& atom, std::string_view unit);
/// A line about the nearest feasible position: where it is, that there is none, or that it is not computed; "" where it
/// was not asked for.
std::string nearest_words(const formula::AskedNearest& nearest, std::string_view unit);
/// "[x, y]" or "[x, y, z]".
std::string json_point(const distance::Coordinates& p);
/// "(x, y)" or "(x, y, z)", to six digits.
std::string shown_point(const distance::Coordinates& p);

}  // namespace findspace::io
