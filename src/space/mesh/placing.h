// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Where a node of a shape tree stands under its translations and reflections: x goes to factor x + by, in grid steps.
// Guarantee: exact. Cost: none.
#pragma once

#include <cstdint>

#include "space/mesh/mesh.h"

namespace findspace::space {

struct Placing {
  std::int64_t factor = 1;  // 1 or -1
  Point by;

  Point at(const Point& p) const { return by + Point{factor * p.x, factor * p.y, factor * p.z}; }
  Placing moved(const Point& t) const { return {factor, at(t)}; }
  Placing mirrored() const { return {-factor, by}; }
};

}  // namespace findspace::space
