// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A layout in which one item was put somewhere else by hand, and the others make room. First all overlaps are taken out
// by small moves, in a strip as much longer as that needs. Else what overlaps the item is set behind the end of the
// strip, and the layout is shortened; on sheets a search seeks room on those that are used. A box is a strip of its
// height. Guarantee: what is returned is feasible, exactly; fixed parts stay. Cost: some linear programs, on sheets a
// hundred passes of a search. Keywords: interactive nesting, repair, drag and drop.
#pragma once

#include <array>
#include <optional>

#include "packing/problem/problem.h"

namespace findspace::packing {

/// The item, which is none of the fixed ones, stays on its sheet of the layout; its origin is put on the grid. Nothing
/// where the others cannot make room.
std::optional<Layout> with_room(const Problem& problem, const Layout& layout, std::size_t item,
                                std::array<double, 2> at);

}  // namespace findspace::packing
