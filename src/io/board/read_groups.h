// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The groups of a board: (group "name" (uuid "..") (members "..")), since KiCad 6. A group has the footprints among its
// members, and those of the groups among them. Groups of the same name are numbered, and a group without a name is
// called "group". What is not a footprint is passed over; a group without one is left out. Cost: the number of groups
// times their members. Keywords: group, members, locked.
#pragma once

#include <vector>

#include "io/board/board.h"
#include "io/board/sexpr.h"

namespace findspace::io {

/// `footprints` are the board's in the order of its parts. The parts of a locked group are locked.
void read_groups(const Sexpr& root, const std::vector<Sexpr>& footprints, Board& board);

}  // namespace findspace::io
