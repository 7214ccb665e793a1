// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Pairs of shapes of which one has no body, as balls are cut out of it (distance/cut/csg_pair.h); several shapes of one
// side count as their union. Lengths in steps of the scale. Guarantee: as there. Keywords: bowl, dome, lens.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "distance/csg/csg_pair.h"
#include "formula/solid/solve_space.h"

namespace findspace::formula {

/// Without a pair where none is cut, or some on both sides, or one is a complement.
struct CsgShapes {
  std::int64_t scale = 1;
  std::unique_ptr<distance::CsgPair> pair;
};
CsgShapes csg_shapes(std::span<const SpaceShape> moving, std::span<const SpaceShape> fixed);

}  // namespace findspace::formula
