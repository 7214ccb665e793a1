// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Instants of a shape that swings, and the signs of inf and sup over them. While it only turns in place, as another
// shape sees it, its instants are the angles it passes, and those are known exactly (rotation_maps.h). The other shape
// may turn about the same point. Guarantee: which instants begin and end what,
// single ones and grazing ones, is exact; their times are the exact angles rounded to about 1e-13 of a turn. Cost: a
// map over all angles for each place where it rotates. Keywords: door leaf, rotational sweep.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "formula/planar/prepared_world.h"
#include "plane/query/section.h"

namespace findspace::formula {

/// The marks of the formula over the time at p, in grid steps, where every distance is of shapes that swing, all in the
/// same way; nothing where that is not so.
std::optional<plane::Section> swing_at(const PreparedWorld& world, const Formula& formula, const exact::RealPoint& p);

/// The sign of inf or sup over the time minus the level, or that at the world's instant, where its shapes swing.
std::optional<std::int8_t> swing_sign(const PreparedWorld& world, const SignMap& wanted, const exact::RealPoint& p);

/// A distance that is the same all the time, as its shapes turn together about one point: the one of shapes that stand
/// still. Nothing where that is not so.
struct AtRest {
  std::shared_ptr<const PreparedWorld> world;
  Distance distance;
  exact::RealPoint at;  // in grid steps
};
std::optional<AtRest> at_rest(const PreparedWorld& world, const Distance& wanted, const exact::RealPoint& p);

}  // namespace findspace::formula
