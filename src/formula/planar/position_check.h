// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The truth of a formula at one position. Guarantee: exact. Where a distance is known between bounds only and they do
// not decide, it is refused. Cost: no map of all positions is made where a value is clearly not the level. Keywords:
// point query, sign.
#pragma once

#include <cstdint>
#include <optional>

#include "formula/language/position_answers.h"
#include "formula/planar/prepared_world.h"

namespace findspace::formula {

struct DecidedSign {
  std::int8_t sign = 0;
  distance::Way way = distance::Way::kMap;
  std::optional<distance::PlanarAnswer> value{};  // of its distance, where it was found for the sign
};

/// The sign of a distance minus the level at p, in grid steps, and which way decided it.
DecidedSign decided_sign(const PreparedWorld& world, const SignMap& wanted, const exact::RealPoint& p);
/// The sign alone.
std::int8_t sign_at(const PreparedWorld& world, const SignMap& wanted, const exact::RealPoint& p);

/// Whether the formula holds at p, in grid steps; no more signs are found than decide it.
bool holds_at(const PreparedWorld& world, const Formula& formula, const exact::RealPoint& p);

/// Every atom of the formula at p, in grid steps, and whether the formula holds there.
Check check_at(const PreparedWorld& world, const Formula& formula, const exact::RealPoint& p);

}  // namespace findspace::formula
