// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A layout of solids in which one was put somewhere else by hand, as make_room.h has it in the plane. Where it stands
// free there, nothing else moves. Else all overlaps are taken out by small moves, upon a floor at a height as much
// greater as that needs; or what overlaps it is set upon all others, and the layout is lowered. Guarantee: what is
// returned is feasible, exactly, and has all solids. Cost: a verification, and some linear programs. Keywords:
// interactive packing, repair, drag and drop.
#pragma once

#include <array>
#include <optional>

#include "packing/solid_problem/solid_problem.h"

namespace findspace::packing {

/// The item stays in its container. Nothing where the others cannot make room, the item is fixed, or a fixed solid is
/// missing.
std::optional<SolidLayout> with_room(const SolidProblem& problem, const SolidLayout& layout, std::size_t item,
                                     const std::array<Fraction, 3>& at);

}  // namespace findspace::packing
