// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Candidates for an extreme level of a T-distance over a set: the levels at which the level curves near some positions,
// and the boundary of the set, meet. Guarantee: exact numbers; whether one is the extremum is for the caller to prove.
#pragma once

#include <vector>

#include "distance/planar_features/boundary_features.h"
#include "distance/planar_features/t_distance.h"

namespace findspace::distance {

/// Near the vertices of `reached` (marks > 0) and, if given, of the closed set `over`; between low and high, ascending.
std::vector<exact::Real> extremum_candidates(const TDistance& f, const plane::Region* over,
                                             const plane::CellComplex& reached, double low, double high);

struct ComponentPoints {
  std::vector<exact::RealPoint> points;
  double within = 0;  // all cells lie no farther than this from the point of their component
};

/// A vertex of each connected piece of the cells with marks > 0.
ComponentPoints one_point_a_component(const plane::CellComplex& c);

}  // namespace findspace::distance
