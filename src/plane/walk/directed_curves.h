// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Segments, each with a set on its inner side: the edges of sets that are united, or the curves of a convolution. What
// bounds the union of what lies on inner sides is found by walks along outer sides (outer_walks.h).
#pragma once

#include <vector>

#include "plane/complex/arrangement.h"

namespace findspace::plane {

/// What a curve says about the sectors at its ends.
struct InnerSide {
  bool left = false;  // its inner side is to the left of p0 -> p1
  /// Whether the set lies behind the whole line at this end, for a little way: not at a corner of a convolution that
  /// turns round the other way.
  bool hides_at_p0 = true, hides_at_p1 = true;
};

struct DirectedCurves {
  exact::Geometry geometry;
  std::vector<Piece> pieces;     // segments of grid lines
  std::vector<InnerSide> sides;  // per piece
  /// The lines are unreduced (unreduced_lines.h), all ends are grid points, and crossings are approximated roughly.
  bool unreduced = false;
};

/// Curves run with their inner side on the left: this one to the right?
inline bool runs_right(const DirectedCurves& c, Index i) { return c.sides[i].left; }
inline Index start_of(const DirectedCurves& c, Index i) { return runs_right(c, i) ? c.pieces[i].p0 : c.pieces[i].p1; }
inline Index end_of(const DirectedCurves& c, Index i) { return runs_right(c, i) ? c.pieces[i].p1 : c.pieces[i].p0; }

}  // namespace findspace::plane
