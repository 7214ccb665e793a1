// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The rule check of a whole board: the formula of --where holds for every part where it stands (findspace/board.h).
#pragma once

#include "common/options.h"
#include "common/reporter.h"

namespace findspace::app {

/// Of the board that the options name, in which nothing moves.
Outcome check_board(const Options& options, Reporter& reporter);

}  // namespace findspace::app
