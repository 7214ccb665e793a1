// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The longest stretch of a direction in a union of convex sets, or in what convex sets leave, where these are grown by
// balls. Branch and bound over triangles of the plane of lines: where a line enters and leaves a convex set tangents
// say on all lines from outside and places inside say by chords, so on a triangle the length of a stretch is at most
// the least of linear functions, and the greatest of that is a linear program (lp_bound.h). Guarantee: doubles; no
// stretch is longer than `bound`, which is within 2^-30 of the size of `length` unless kMostRunCells triangles were not
// enough, or sets touch without overlapping. The length found is to be confirmed at `middle`. Cost: for each triangle
// the sets near it. Keywords: longest chord, free run, branch and bound, outer approximation.
#pragma once

#include <vector>

#include "distance/search/boundary_search.h"
#include "space/polytope/extent.h"

namespace findspace::distance {

inline constexpr int kMostRunCells = 10000;

/// Sets {g <= 0} of convex functions that no step changes by more than its length.
struct RoundRunQuery {
  std::vector<TouchingConstraint> sets;
  bool between = false;  // stretches in what the sets leave
  space::Extent box;     // that holds all stretches
  space::Vector unit;    // the direction
};

struct RoundRun {
  double length = 0, bound = 0;
  space::Vector middle;
};

RoundRun longest_round_run(const RoundRunQuery& query);

}  // namespace findspace::distance
