// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The sign map of one open face bounded by rings of segments and arcs: -1 inside, 0 on the boundary, +1 outside.
// Guarantee: exact, for rings that do not touch each other or themselves and have no straight corners. Cost: linear.
#pragma once

#include <span>

#include "plane/cell_complex.h"

namespace findspace::plane {

/// A corner of a ring and the x-monotone curve that leaves it, the inside on its left.
struct RingEdge {
  Index point, carrier;
  bool right;            // it runs to the right, or straight up
  std::int8_t half = 0;  // of a circle: +1 upper, -1 lower
};

/// `starts`: the first edges of the rings, the outer ring first unless the face is unbounded. Points and carriers that
/// no ring uses are left out.
SignMap ring_map(const exact::Geometry& geometry, std::span<const RingEdge> edges, std::span<const Index> starts,
                 bool unbounded = false);

}  // namespace findspace::plane
