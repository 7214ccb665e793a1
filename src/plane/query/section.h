// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A marked complex along a line: the marks of {through + t * direction} for every t. Guarantee: exact; every place
// where the line meets a vertex or an edge is a stop with its own mark, touching included. Method: all parameters where
// the line meets an edge or a vertex, in order, and the cells there and between. Cost: O(n) and one point location for
// each stop and gap. Keywords: ray, chord, cross section, one-dimensional slice, ray casting.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "plane/base/real_vector.h"
#include "plane/complex/cell_complex.h"

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
  static Section constant(const exact::Real& first, const exact::Real& last, Mark mark);
};

/// `direction` is not (0, 0).
Section section(const CellComplex& complex, const RealVector& through, const RealVector& direction);

/// The marks at p + path[k], reached at times[k], with straight legs at even speed between; times ascend.
Section section_of_path(const CellComplex& complex, const RealVector& p, std::span<const RealVector> path,
                        std::span<const exact::Real> times);

/// rule(marks of all sections) at every t, stops at all stops of any of them. The sections have one range of t; at
/// least one.
Section overlay_sections(std::span<const Section> sections, const std::function<Mark(std::span<const Mark>)>& rule);

}  // namespace findspace::plane
