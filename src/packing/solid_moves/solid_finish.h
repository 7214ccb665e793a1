// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A layout of solids in doubles made into one that is proved, as finish.h does in the plane: parts are moved apart by
// some steps of a fine grid where that costs nearly nothing, put onto the grid, and verified exactly. Contacts along an
// axis stay contacts. Guarantee: what is returned is feasible by exact predicates. Cost: at most seven linear programs
// and verifications.
#pragma once

#include <optional>
#include <vector>

#include "packing/solid_depth/solid_column.h"

namespace findspace::packing {

/// Nothing where the overlaps of the layout are too deep for that.
/// What is missing is left out, for the reason given; in containers of given sizes so is what overlaps after all:
/// then it is no longer among the poses.
std::optional<SolidLayout> finished(const SolidProblem& problem, const SolidTable& table, const SolidColumn& column,
                                    std::vector<SolidPose>& poses, double height);

/// The boxes of the parts upon each other in one container without a lid, above what is fixed: always feasible.
SolidLayout tower_of(const SolidProblem& problem, const SolidTable& table);

/// The poses of a layout, in its order, without the fixed solids. The column begins with the layout's containers.
std::vector<SolidPose> poses_of(const SolidProblem& problem, const SolidTable& table, const SolidColumn& column,
                                const SolidLayout& layout);

}  // namespace findspace::packing
