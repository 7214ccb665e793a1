// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Pairs of shapes of which one has no body, as balls are cut out of it (distance/csg/csg_pair.h); several shapes of one
// side count as their union. What is not told so lies between bounds (csg_between.h). Lengths in steps of the scale.
// Guarantee: as there. Keywords: bowl, dome, lens.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "distance/csg/csg_between.h"
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

/// Of shapes that round ones are cut out of on both sides, or on one beside a complement; nothing of others.
/// Lengths in steps / scale.
struct CutBetween {
  distance::DistancesBetween of;
  std::int64_t scale;
  bool back = false;  // it is of -A + p and -B, which is the same

  distance::Which which(distance::Which asked) const { return back ? distance::exchanged(asked) : asked; }
  distance::TriedAnswer value(distance::Which asked, const space::RealVector& p) const;
};
std::optional<CutBetween> cut_between(std::span<const SpaceShape> moving, std::span<const SpaceShape> fixed);

inline constexpr const char* kNoMapAlong =
    "of shapes that round ones are cut out of only gap at levels from 0 on and reach are computed along "
    "a direction that is not the lines' (--resolution N --axis z takes lines along z alone)";
/// Their map on lines, perhaps of the distance along a direction (null where that is not computed); the level in steps
/// of the scale.
std::unique_ptr<space::RaySource> csg_map(distance::Which which, const exact::Real& level, const CsgShapes& shapes,
                                          const space::RayGrid& grid,
                                          const std::optional<distance::AlongWay>& way = {});

}  // namespace findspace::formula
