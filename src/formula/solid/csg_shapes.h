// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Pairs of shapes of which one has no body, as balls are cut out of it (distance/csg/csg_pair.h); several shapes of one
// side count as their union. Where both are such, values lie between bounds (csg_between.h). Lengths in steps of the
// scale. Guarantee: as there. Keywords: bowl, dome, lens.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "distance/csg/csg_pair.h"
#include "formula/solid/solve_space.h"

namespace findspace::formula {

/// The shape that is cut, and the other one; without them where none is cut, or some on both sides, or one is a
/// complement.
struct CsgShapes {
  std::int64_t scale = 1;
  std::shared_ptr<const space::Body> complete;
  std::shared_ptr<const space::CsgSolid> cut;
  bool cut_moves = false;

  /// Null where nothing is cut.
  std::shared_ptr<const distance::CsgSide> side() const;
};
CsgShapes csg_shapes(std::span<const SpaceShape> moving, std::span<const SpaceShape> fixed);

/// Of shapes that are cut on both sides, or cut ones that move and a complement; nothing of others. Lengths in steps /
/// scale.
struct CutBetween {
  distance::PairDistances pair;
  std::int64_t scale;
};
inline constexpr const char* kOnlyValuesOfTwoCut =
    "of two shapes that round ones are cut out of, or one and a complement, only values at a position are computed";
std::optional<CutBetween> cut_between(std::span<const SpaceShape> moving, std::span<const SpaceShape> fixed);

/// Their map on lines, perhaps of the distance along a direction (null where that is not computed); the level in steps
/// of the scale.
std::unique_ptr<space::RaySource> csg_map(distance::Which which, const exact::Real& level, const CsgShapes& shapes,
                                          const space::RayGrid& grid,
                                          const std::optional<distance::AlongWay>& way = {});

}  // namespace findspace::formula
