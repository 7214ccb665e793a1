// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A layout in doubles made into one that is proved: parts are moved apart by some steps of a fine grid where that costs
// nearly nothing, put onto the grid, and verified exactly. Contacts along an axis between parts on the grid stay
// contacts, so stacks without clearance survive. Guarantee: what is returned is feasible by exact predicates.
// Cost: at most six linear programs and verifications.
#pragma once

#include <optional>
#include <vector>

#include "packing/compaction/linear_moves.h"
#include "packing/problem/problem.h"

namespace findspace::packing {

/// Nothing where the overlaps of the layout are too deep for that. What is missing is left out, for the reason given.
std::optional<Layout> finished(const Problem& problem, const FieldTable& table, const Row& row,
                               const std::vector<Pose>& poses, double length);

/// Columns of the parts' boxes on a strip, behind the fixed parts: feasible where no condition of pairs forbids it.
Layout layout_of_boxes(const Problem& problem, const FieldTable& table);

/// The items of a layout that the search may move, in its order: neither fixed parts nor what fits nowhere.
std::vector<const Placed*> movable_items(const Problem& problem, const FieldTable& table, const Layout& layout);

/// Their poses, in its order, without the fixed parts. The row begins with the layout's sheets.
std::vector<Pose> poses_of(const Problem& problem, const FieldTable& table, const Row& row, const Layout& layout);

}  // namespace findspace::packing
