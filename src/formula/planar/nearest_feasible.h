// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The nearest feasible position, min {|q - p| : the formula holds at q}, or of the closure of those: from contacts
// where these decide (nearest_contact.h), else from windows of the region that grow about p, and from the whole region
// where these are no longer small. Of alternatives (`or`) the nearest counts, and those that distances exclude are not
// looked at. Guarantee: exact. Keywords: closest feasible configuration, minimum translation.
#pragma once

#include "formula/language/position_answers.h"
#include "formula/planar/prepared_world.h"

namespace findspace::formula {

/// The nearest position to p, in grid steps, at which the formula holds, or of the closure of those; nothing if it
/// holds nowhere. Refused where the region is known between bounds only.
TriedNearest nearest_feasible_to(const PreparedWorld& world, const Formula& formula, const exact::RealPoint& p);

}  // namespace findspace::formula
