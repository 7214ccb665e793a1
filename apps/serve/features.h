// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The distance between two features of shapes that somebody points at: of each place the nearest vertex, edge or arc of
// a boundary, a vertex where one is about as near. Guarantee: the feature is the nearest to about 1e-12, its distance
// to the other one is exact. Cost: linear in the cells of all shapes. Keywords: measuring tool, caliper.
#pragma once

#include <array>
#include <string>

#include "formula/planar/world.h"

namespace findspace::app {

/// {"from": FEATURE, "to": FEATURE, "distance": .., "points": [..]}; `at`: where the moving shapes stand, and the
/// places, all in the scene's unit. Throws Error where there are no shapes.
std::string features_between(const formula::World& world, const exact::RealPoint& at,
                             const std::array<exact::RealPoint, 2>& places, const std::string& unit);

}  // namespace findspace::app
