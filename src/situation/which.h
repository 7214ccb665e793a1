// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// From the formula's names of distances to those of a pair of shapes, in which the first moves.
#pragma once

#include "distance/shape_pair.h"
#include "situation/names.h"

namespace findspace::situation {

/// For a distance whose first shape moves, unless `second_moves`.
distance::Which which(Kind kind, bool second_moves);

}  // namespace findspace::situation
