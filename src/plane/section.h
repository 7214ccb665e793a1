// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A marked complex along a line: the marks of {through + t * direction} for every t. Guarantee: exact; every place
// where the line meets a vertex or an edge is a stop with its own mark, touching included. Method: all parameters where
// the line meets an edge or a vertex, in order, and the cells there and between. Cost: O(n) and one point location for
// each stop and gap. Keywords: ray, chord, cross section, one-dimensional slice, ray casting.
#pragma once

#include <vector>

#include "plane/cell_complex.h"
#include "plane/real_vector.h"

namespace findspace::plane {

struct Section {
  struct Stop {
    exact::Real t;
    Mark at = 0;
    Mark after = 0;  // up to the next stop, or for ever
  };
  Mark before = 0;          // ahead of the first stop
  std::vector<Stop> stops;  // by growing t

  /// The part of it with first <= t <= last as a section whose first stop is `first` and whose last is `last`; first <
  /// last.
  Section between(const exact::Real& first, const exact::Real& last) const;
};

/// `direction` is not (0, 0).
Section section(const CellComplex& complex, const RealVector& through, const RealVector& direction);

}  // namespace findspace::plane
