// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The configuration set F = {(p_1..p_n) : p_i in own[i], p_i - p_j in between[i, j]} and its projections P_i
// (distances.md 6.3): the positions of body i for which the others can still be placed. Method: bodies that no
// condition joins are apart; where the conditions form a forest two passes of P_i <- P_i and P_j (+) N_ij give the
// projections; else that is a filter, bodies with finitely many positions are branched on, and what is left is a search
// over convex cells (cell_search.h). Guarantee: `exact`: the regions are the projections. Otherwise they hold only
// positions that are certainly in them (perhaps none), and `reason` says why. Cost: a Minkowski sum an edge and pass;
// the search is exponential in the number of pairs. Keywords: arc consistency, constraint propagation, forest,
// projection.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "plane/complex/cell_complex.h"
#include "planning/order/problem.h"

namespace findspace::planning {

struct PairSystem {
  std::vector<plane::Region> own;
  std::map<std::pair<std::size_t, std::size_t>, plane::Region> between;  // i < j
};

struct Projections {
  std::vector<plane::Region> positions;
  bool exact = true;
  std::string reason;
};

Projections project(PairSystem system, const Limit& limit);

/// {p_j : q - p_j in N or p_j - q in N}: what the set between two bodies leaves to the other when one stands at q;
/// `first`: the one that stands is the first of the pair.
plane::Region left_by(const plane::Region& between, const exact::RealPoint& q, bool first);

}  // namespace findspace::planning
