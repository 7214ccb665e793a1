// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Pictures of one position: the moving shape where `check` or `measure` puts it, and the distances as dimension lines.
// They show what was computed; places are rounded to the picture's pixels.
#pragma once

#include <string>
#include <vector>

#include "formula/planar/solve.h"
#include "io/question/asked_scene.h"

namespace findspace::io {

/// Distances that fail in red, and the nearest feasible position in dashes (null: not known, or `at` is feasible).
/// @p world in steps of its grid, @p at in the scene's unit.
std::string check_picture(const AskedScene& asked, const formula::World& world, const formula::Formula& formula,
                          const exact::RealPoint& at, const formula::Check& check,
                          const formula::NearestFeasible* nearest);

/// With gamma1 of every pair.
std::string measure_picture(const AskedScene& asked, const formula::World& world, const exact::RealPoint& at,
                            const std::vector<formula::DistanceAt>& distances);

}  // namespace findspace::io
