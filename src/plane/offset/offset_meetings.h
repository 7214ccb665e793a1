// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Where the curves of an offset meet: crossings of two, and ties, where they do more: touch, end on each other, begin
// or cease to overlap, or meet three at a point. Guarantee: exact; all are found that are not inside D (offset_curves.h
// says what D is), and no tie lies inside D. Cost: that of the pairs that may meet (near_pairs.h). Used by the walks
// along them only (offset_walks.h).
#pragma once

#include <span>
#include <vector>

#include "plane/complex/piece_meet.h"
#include "plane/offset/offset_curves.h"

namespace findspace::plane {

class OffsetMeetings {
 public:
  struct Stop {
    Index piece, point;
    Index other;  // the piece that crosses there; kNone at a tie
    Index twin;   // the place of this crossing among the stops of the other piece; the number of the tie
  };

  /// Keeps references; adds the crossings to the curves' geometry.
  OffsetMeetings(OffsetCurves& curves, OffsetEdges& edges) : c_(curves), edges_(edges) {}

  void find();

  Index stop_count(Index i) const { return first_[i + 1] - first_[i]; }
  const Stop& stop(Index i, Index k) const { return stops_[first_[i] + k]; }
  /// Parts of all pieces between stops, counted through: part k of piece i ends at its stop k.
  Index part(Index i, Index k) const { return first_[i] + i + k; }
  Index part_count() const { return Index(stops_.size() + c_.pieces.size()); }
  Index tie_count() const { return Index(tie_points_.size()); }
  /// The tie at an end of a piece or a stop, or kNone.
  Index tie_at(Index point) const { return tie_of_.empty() ? kNone : tie_of_[point]; }
  /// The one that stands for all points of a tie.
  Index tie_point(Index tie) const { return tie_points_[tie]; }
  /// Is the point in D, although it lies on these pieces?
  bool is_inside(Index point, std::initializer_list<Index> pieces);

 private:
  /// What a pair of pieces has in common; points from `known` on are new.
  void note(const PieceMeetings& found, Index known, Index i, Index j);
  /// Brings the stops of each piece together, in the order of travel.
  void sort_stops();
  /// Of a piece, in their order: those at one place are tied.
  void tie_equal(Index piece, std::span<const Index> stops);
  void number_ties();
  /// After sorting: `order` holds the stops piece by piece. Those at one tie become one.
  void set_stops(const std::vector<Index>& order);

  OffsetCurves& c_;
  OffsetEdges& edges_;
  std::vector<Stop> stops_;
  std::vector<Index> first_;              // piece -> its first stop
  std::vector<PieceMeetings::Tie> ties_;  // points at one place, or one that is a tie by itself
  std::vector<Index> tie_of_;             // point -> its tie; empty while there is none
  std::vector<Index> tie_points_;
};

}  // namespace findspace::plane
