// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Pairs of shapes of which one has no body, as balls are cut out of it (distance/cut/cut_pair.h); several shapes of one
// side count as their union. Lengths in steps of the scale. Guarantee: as there. Keywords: bowl, dome, lens.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "distance/cut/cut_pair.h"
#include "situation/solid/solve_space.h"

namespace findspace::situation {

/// Without a pair where none is cut, or some on both sides, or one is a complement.
struct CutShapes {
  std::int64_t scale = 1;
  std::unique_ptr<distance::CutPair> pair;
};
CutShapes cut_shapes(std::span<const SpaceShape> moving, std::span<const SpaceShape> fixed);

}  // namespace findspace::situation
