// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// `check` and `measure` at a position as text for people, in the plane and in space. Numbers have six digits here;
// --json gives them all.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "formula/language/position_answers.h"

namespace findspace::app {

/// `at`: the position as text; `place` may be empty, and then no ways from it are shown. `nearest`: the nearest
/// feasible position, where it was asked for. `explain`: which way decided each atom, and how long it took.
std::string check_text(const formula::Check& check, std::string_view at, const distance::Coordinates& place,
                       std::string_view unit, const formula::AskedNearest& nearest, bool explain);
/// The rows of measured_rows.h.
std::string measure_text(const std::vector<formula::DistanceAt>& distances, std::string_view at,
                         const distance::Coordinates& place, std::string_view unit, bool all);

}  // namespace findspace::app
