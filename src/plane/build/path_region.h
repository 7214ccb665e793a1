// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The set of the points of straight pieces of a way, which may cross and cover each other. Guarantee: exact. Cost: one
// arrangement. Keywords: polyline, path.
#pragma once

#include <span>
#include <vector>

#include "plane/base/real_vector.h"
#include "plane/complex/cell_complex.h"

namespace findspace::plane {

/// With both ends. `along`: a rational vector of its direction; (0, 0) of a single point.
struct PathPiece {
  RealVector from, to, along;
};

/// The legs between way points, which are rational; of one way point a piece that is this point.
std::vector<PathPiece> pieces_of_path(std::span<const RealVector> path);

/// Throws Error(kOutOfRange) as window_between (swept.h) does.
Region region_of_pieces(std::span<const PathPiece> pieces);
Region region_of_path(std::span<const RealVector> path);

}  // namespace findspace::plane
