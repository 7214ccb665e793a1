// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The distance between two features of shapes that somebody points at: of each place the nearest vertex, edge or arc of
// a boundary, a vertex where one is about as near. Guarantee: the feature is the nearest to about 1e-12, its distance
// to the other one is exact. Cost: linear in the cells of all shapes. Keywords: measuring tool, caliper.
#pragma once

#include <array>
#include <string>

#include "formula/language/position_answers.h"
#include "formula/planar/world.h"

namespace findspace::io {

struct FeaturePair {
  /// With the two features, in the order of the places, and where they are nearest to each other.
  formula::DistanceAt distance;
  /// Where the shapes of the features stand: the origin for those that do not move.
  std::array<exact::RealPoint, 2> stand;
};

/// `at`: where the moving shapes stand, and the places, all in the scene's unit. Throws Error where no shape has a
/// boundary.
FeaturePair features_between(const formula::World& world, const exact::RealPoint& at,
                             const std::array<exact::RealPoint, 2>& places);

/// {"from": FEATURE, "to": FEATURE, "distance": .., "points": [..]}
std::string feature_pair_json(const FeaturePair& pair, const std::string& unit);
std::string feature_pair_text(const FeaturePair& pair, const std::string& unit);

}  // namespace findspace::io
