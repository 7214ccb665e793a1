// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Instants of a shape that swings, and the signs of inf and sup over them. While it only rotates, its instants are the
// angles it passes, and those are known exactly (rotation_maps.h). Guarantee: which instants begin and end what,
// single ones and grazing ones, is exact; their times are the exact angles rounded to about 1e-13 of a turn. Cost: a
// map over all angles for each place where it rotates. Keywords: door leaf, rotational sweep.
#pragma once

#include <cstdint>
#include <optional>

#include "formula/planar/prepared_world.h"
#include "plane/query/section.h"

namespace findspace::formula {

/// The marks of the formula over the time at p, in grid steps, where the moving shapes stay in place and turn, and
/// nothing else moves; nothing where that is not so.
std::optional<plane::Section> swing_at(const PreparedWorld& world, const Formula& formula, const exact::RealPoint& p);

/// The sign of inf or sup over the time minus the level, where swing_at() knows the instants.
std::optional<std::int8_t> swing_sign(const PreparedWorld& world, const SignMap& wanted, const exact::RealPoint& p);

/// The same at the world's instant.
std::optional<std::int8_t> swing_sign_now(const PreparedWorld& world, const SignMap& wanted, const exact::RealPoint& p);

}  // namespace findspace::formula
