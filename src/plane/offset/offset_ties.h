// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What the boundary of D (offset_curves.h) is at ties, where curves touch, overlap, or meet three at a point: which
// ways bound what lies outside, which parts of two curves run against each other with D on both sides (slits), and
// which ties are single points in D. Guarantee: exact. Cost: the ways at each tie, sorted, with the curves that pass.
// Method: a curve that passes a tie has D on its left there, all the way round from where it goes on to where it comes
// from; what no curve has on its left lies outside.
#pragma once

#include <vector>

#include "plane/offset/offset_meetings.h"

namespace findspace::plane {

/// Of a piece, the part that follows the stop before `slot`.
struct OffsetPart {
  Index piece, slot;
};

class OffsetTies {
 public:
  OffsetTies(const OffsetCurves& curves, const OffsetMeetings& meetings);

  /// The part that bounds the same outside as one that ends at a tie; piece kNone: it bounds none.
  OffsetPart after(Index tie, OffsetPart part) const;

  /// Parts that start at a tie without a walk that comes there.
  std::vector<OffsetPart> not_reached;
  /// Parts from p0 to p1, one for each slit.
  std::vector<OffsetPart> slits;
  /// Ties with D all around.
  std::vector<Index> single_points;

 private:
  /// Of a part that starts at the tie, or ends there.
  struct Way {
    Index tie;
    OffsetPart part;
    bool starts;
    Index direction = 0;                // the number of its direction at the tie, counter-clockwise
    bool reached = false;               // where it starts: it comes after another one
    OffsetPart after = {kNone, kNone};  // where it ends
  };
  /// What lies on the left of curves that pass a tie: sectors (after each direction) and directions.
  struct Covered {
    std::vector<char> sectors, directions;
  };
  using Ways = std::vector<Way>::iterator;

  void collect();
  bool right(const Way& w) const { return c_.origins[w.part.piece].right == w.starts; }
  exact::Heading heading(const Way& w) const;
  bool same_direction(const Way& v, const Way& w) const;
  bool comes_first(const Way& v, const Way& w) const;
  /// How many directions there are.
  Index number_directions(Ways first, Ways last);
  Covered covered(Ways first, Ways last, Index directions) const;
  /// Of one tie.
  void resolve(Ways first, Ways last);
  /// The ways that end in this direction lead to `out`, with the outside in between.
  void reach(Ways first, Ways last, Index direction, Way& out);

  const OffsetCurves& c_;
  const OffsetMeetings& m_;
  std::vector<Way> ways_;     // tie by tie, those of each counter-clockwise
  std::vector<Index> first_;  // tie -> its first way
};

}  // namespace findspace::plane
