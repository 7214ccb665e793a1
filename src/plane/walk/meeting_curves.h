// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Directed curves with the places where they meet (curve_stops.h): how they run, in which parts
// stops divide them, and the half-edges about each degenerate vertex. Guarantee: exact. Cost: that of the stops.
#pragma once

#include <vector>

#include "plane/base/arena.h"
#include "plane/walk/curve_stops.h"

namespace findspace::plane {

/// Of a curve, between two stops.
struct CurvePart {
  Index curve, slot;
};

class MeetingCurves {
 public:
  /// Finds where they meet.
  MeetingCurves(DirectedCurves& c, Memory memory);
  /// Where that is known.
  MeetingCurves(const DirectedCurves& c, CurveStops found, Memory memory);

  Index size() const { return Index(c_.pieces.size()); }
  /// Curves run with their inner side on the left.
  bool right(Index i) const { return runs_right(c_, i); }
  Index start(Index i) const { return curves_[i].start; }
  Index end(Index i) const { return curves_[i].end; }
  Index supporting_curve(Index i) const { return c_.pieces[i].supporting_curve; }
  /// The curve that ends where curve i starts, or kNone.
  Index before(Index i) const { return curves_[i].before; }
  Index stop_count(Index i) const { return curves_[i + 1].first_part - curves_[i].first_part - 1; }
  const Stop& stop(Index i, Index k) const { return found_.stops[curves_[i].first_part - i + k]; }
  /// Parts of all curves between stops, counted through: part k of curve i ends at its stop k.
  Index part(CurvePart p) const { return curves_[p.curve].first_part + p.slot; }
  Index part_count() const { return Index(found_.stops.size()) + size(); }
  Index start(CurvePart p) const { return p.slot == 0 ? start(p.curve) : stop(p.curve, p.slot - 1).point; }
  Index end(CurvePart p) const { return p.slot == stop_count(p.curve) ? end(p.curve) : stop(p.curve, p.slot).point; }
  /// The degenerate vertex at which a part starts, or kNone.
  Index degenerate_before(CurvePart p) const {
    if (p.slot == 0) return found_.degenerate_vertices.at(start(p.curve));
    const Stop& s = stop(p.curve, p.slot - 1);
    return s.other == kNone ? s.twin : kNone;
  }
  const DegenerateVertices& degenerate_vertices() const { return found_.degenerate_vertices; }

  /// Parts along which another curve runs the other way, so that both their sides are inner sides; some come twice.
  ArenaVector<CurvePart> parts_with_two_inner_sides() const;

 private:
  /// As it is walked along.
  struct Curve {
    Index start = kNone, end = kNone, before = kNone, first_part = 0;
  };

  const DirectedCurves& c_;
  CurveStops found_;
  ArenaVector<Curve> curves_;  // and one more, of which only the first part counts
  Memory memory_;
};

}  // namespace findspace::plane
