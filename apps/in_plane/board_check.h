// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The rule check of a whole board: the formula of --where holds for every part where it stands. In it `self` is the
// part and `others` are the parts that share a side of the board with it; without a formula no body may leave the board
// or overlap another. Guarantee: as of `check`; parts that are farther away by their boxes than a rule asks are not
// looked at. Cost: n log n boxes, and a distance for each pair that is near. Keywords: design rule check, DRC,
// courtyard overlap, clearance matrix.
#pragma once

#include "common/options.h"
#include "common/session.h"

namespace findspace::app {

Outcome check_board(const Session& session);

}  // namespace findspace::app
