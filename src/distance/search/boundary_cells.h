// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Tetrahedra that searches divide (boundary_search.h, boundary_slack.h). Guarantee: doubles. Keywords: bisection.
#pragma once

#include <cstddef>
#include <utility>

#include "distance/search/solid_max_min.h"
#include "plane/base/stage_observer.h"

namespace findspace::distance {

/// A box about the box. Cells whose faces lie in those of the sets would touch what is allowed and never be settled;
/// cells of this one stand askew.
std::pair<space::Vector, space::Vector> askew(const space::Vector& low, const space::Vector& high);

/// Its length, and its ends.
double longest_edge(const Tetrahedron& t, std::size_t& a, std::size_t& b);

space::Vector centre(const Tetrahedron& t);

/// Whether x is on the same side of each face as the corner that is not on it; numbers.
bool holds(const Tetrahedron& t, const space::Vector& x);

/// Given to the observer of the search.
inline void observe(plane::ObservedCells& cells, const Tetrahedron& t) {
  if (!cells) return;
  const auto corner = [](const space::Vector& v) { return plane::StageDrawing::Corner{v.x, v.y, v.z}; };
  cells.add_tetrahedron({corner(t[0]), corner(t[1]), corner(t[2]), corner(t[3])});
}

}  // namespace findspace::distance
