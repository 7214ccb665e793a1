// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The results of `check` and `measure` at a position as JSON, as docs/results.md describes them, in the plane and in
// space. Values that are not exact carry the numbers that they lie between, rounded outwards. Keywords: serialisation,
// enclosure.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "formula/language/position_answers.h"

namespace findspace::io {

/// `at` in the scene's unit. `explain`: which way decided each atom, and how long it took.
std::string check_json(const formula::Check& check, const distance::Coordinates& at, std::string_view unit,
                       std::optional<double> angle = std::nullopt, const formula::AskedNearest& nearest = {},
                       bool explain = false);
/// The member "nearest_feasible"; null where no position is.
std::string nearest_member(const std::optional<formula::NearestFeasible>& nearest);
std::string measure_json(const std::vector<formula::DistanceAt>& distances, const distance::Coordinates& at,
                         std::string_view unit, std::optional<double> angle = std::nullopt);

}  // namespace findspace::io
