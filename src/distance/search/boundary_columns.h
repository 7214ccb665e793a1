// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What searches know of functions over a tetrahedron, by numbers at its corners: a linear function below or above each.
// Whether some place of the tetrahedron can have all of them at least 0 is a linear program. Internal to the searches.
// Guarantee: doubles. Keywords: cutting planes.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "distance/search/boundary_search.h"
#include "distance/search/lp_bound.h"

namespace findspace::distance {

inline double most(const Column& c) { return *std::max_element(c.begin(), c.end()); }
inline double least(const Column& c) { return *std::min_element(c.begin(), c.end()); }

inline Column less(double from, Column c) {
  for (double& entry : c) entry = from - entry;
  return c;
}

/// At most what a convex function is, at the corners, by its tangent at x.
inline Column tangent(const Touching& at, const space::Vector& x, const Tetrahedron& corner) {
  Column out;
  for (std::size_t v = 0; v < 4; ++v) out[v] = at.value + space::dot(at.slope, corner[v] - x);
  return out;
}

/// The place at which the least of the columns is greatest, with that; `spread`: from the lowest entry (or 0) to the
/// highest.
struct HighestPlace {
  double value = 0, spread = 0;
  space::Vector place;
};
inline HighestPlace highest_place(std::vector<Column> columns, const Tetrahedron& corner) {
  double lowest = 0, highest = 0;
  for (const Column& c : columns) {
    lowest = std::min(lowest, least(c));
    highest = std::max(highest, most(c));
  }
  const LpBound bound = bounding_lp(std::move(columns), {});
  return {bound.value, highest - lowest, mean(bound.rows, corner)};
}

}  // namespace findspace::distance
