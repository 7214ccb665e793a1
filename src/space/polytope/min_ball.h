// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The smallest ball that holds finitely many points. Guarantee: exact centre and squared radius (rational for rational
// points). Method: the ball of at most four of them, which takes in the farthest point outside until there is none.
// Source: Gärtner 1999, without its heuristics. Keywords: smallest enclosing ball, Chebyshev centre, 1-center.
#pragma once

#include <vector>

#include "space/polytope/real_vector.h"

namespace findspace::space {

struct EnclosingBall {
  RealVector center;
  exact::Real square;  // of the radius
};

/// At least one point.
EnclosingBall min_ball(const std::vector<RealVector>& points);

}  // namespace findspace::space
