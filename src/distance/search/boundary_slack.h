// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The place of a domain that has the most slack among those that convex functions allow (boundary_search.h): the
// greatest t with each of `reverse_convex` at least t there and each of `convex` at most -t. More than 0 says that the
// allowed places have interior; it changes by no more than the functions do. The search is tetrahedral_max_min.h; the
// slack in a cell is at most a linear program of what the functions are at most and of their tangents. Guarantee:
// doubles; `value` is that at `place`, no place of the domain has more than `bound`. Cost: tens of cells. Keywords:
// Chebyshev centre, reverse convex programming.
#pragma once

#include <span>

#include "distance/search/boundary_search.h"

namespace findspace::distance {

struct Slack {
  double value = 0, bound = 0;
  space::Vector place;
  int cells = 0;  // that were divided
};

struct SlackEnd {
  double enough = 0;   // the bound need not be less
  double share = 0.5;  // of the bound: a value that is more than enough and so much of it need not be more
  double blur = 0;     // as near as the bound has to come to the value
};
Slack most_slack(std::span<const Tetrahedron> domain, const Constraints& constraints, const SlackEnd& end);

}  // namespace findspace::distance
