// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// From the formula's names of distances to those of a pair of shapes, in which the first moves.
#pragma once

#include "distance/directional.h"
#include "distance/shape_pair.h"
#include "situation/formula.h"

namespace findspace::situation {

/// For a distance whose first shape moves, unless `second_moves`.
distance::Which which(Kind kind, bool second_moves);

/// With along= or toward=.
bool is_directional(const Distance& d);
/// Their direction; throws Error(kUnsupported) where it is no ratio of integers below 2^53.
distance::Track track(const Distance& d);

}  // namespace findspace::situation
