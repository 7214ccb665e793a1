// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Distances at a position: one with its witnesses, and all of the moving shapes. Keywords: measurement, closest
// features, distance table.
#pragma once

#include <optional>
#include <vector>

#include "distance/planar_least/best_position.h"
#include "formula/language/position_answers.h"
#include "formula/planar/prepared_world.h"

namespace findspace::formula {

/// One distance at p, in grid steps.
DistanceAt distance_at(const PreparedWorld& world, const Distance& wanted, const exact::RealPoint& p);

/// Of a distance that is known between two numbers, in grid steps or in degrees: the one that is shown, with what it
/// may be off; nothing where undefined.
DistanceAt ranged_answer(const PreparedWorld& world, const Distance& wanted,
                         const std::optional<distance::ValueRange>& range);

/// One of a plain distance without a motion, whose answer is known.
DistanceAt plain_distance_at(const PreparedWorld& world, const Distance& wanted, distance::PlanarAnswer answer,
                             const exact::RealPoint& p);

/// All distances of the moving shapes to every other shape at p, in grid steps, with a motion their inf and sup; and
/// those that the formula names besides. `wanted`: by their texts; others may be left out.
std::vector<DistanceAt> measure_at(const PreparedWorld& world, const exact::RealPoint& p, const Formula& formula,
                                   const WantedText& wanted);

}  // namespace findspace::formula
