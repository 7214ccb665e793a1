// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The smallest circle around a closed bounded set C, given by the vertices and arcs of its boundary: the one position
// with the least greatest distance to C. Method: in numbers, the circle around some points of C, and again with the
// point of C farthest from its centre, until none lies outside; that tells which parts of C touch it. Two or three of
// them make the circle exactly. It is accepted with the proof that no part of C lies outside it and that the centre
// lies between the points of C on it. Guarantee: exact, or nothing where square roots do not express it or a proof is
// missing. Cost: linear, a few rounds. Source: Welzl 1991; Remez's exchange for the arcs. Keywords: minimum enclosing
// circle, 1-centre, Chebyshev centre.
#pragma once

#include <optional>
#include <span>

#include "distance/planar_features/boundary_features.h"

namespace findspace::distance {

struct Circle {
  exact::RealPoint center;
  exact::Real radius;
};

std::optional<Circle> smallest_circle(const plane::Region& set, std::span<const BoundaryFeature> vertices_and_arcs);

}  // namespace findspace::distance
