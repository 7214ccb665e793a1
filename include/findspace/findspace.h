// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// findspace: the exact set of all positions of a part. Everything a user of the library needs; no third-party header is
// included.
//   shape.h   what there is: polygons, discs, arcs, and what operations make of them
//   world.h   which of it moves, and the questions: distances, sign maps, formulas, optima
//   region.h  the answers: exact point sets
//   error.h   what is thrown for bad input
#pragma once

#include "findspace/error.h"
#include "findspace/region.h"
#include "findspace/shape.h"
#include "findspace/world.h"
