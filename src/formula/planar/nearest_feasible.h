// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The nearest feasible position, min {|q - p| : the formula holds at q}, or of the closure of those. Where all
// atoms must hold and those that fail compare gamma1, eta1 or delta1 with a number, no map is made if their contacts
// decide. Such a distance f changes no faster than the position, so no position with the level is nearer to p than
// |f(p) - level|; one that is as near lies on the line through p and the nearest contact, and it is the answer if f has
// the level there (beyond it, too, for `<` and `>`, which it bounds) and the other atoms hold. Else the whole region is
// made. Guarantee: exact. Keywords: closest feasible configuration, minimum translation.
#pragma once

#include <optional>

#include "exact/number/tried.h"
#include "formula/language/position_answers.h"
#include "formula/planar/prepared_world.h"

namespace findspace::formula {

/// The nearest position to p, in grid steps, at which the formula holds, or of the closure of those; nothing if it
/// holds nowhere. Refused where the region is known between bounds only.
exact::Tried<std::optional<NearestFeasible>> nearest_feasible_to(const PreparedWorld& world, const Formula& formula,
                                                                 const exact::RealPoint& p);

}  // namespace findspace::formula
