// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Where the curves of an offset cross. Guarantee: exact; all crossings are found that are not inside D (offset_curves.h
// says what D is). Cost: that of the pairs that may meet (near_pairs.h). Used by grid_offset.cpp only.
#pragma once

#include <vector>

#include "plane/complex/piece_meet.h"
#include "plane/offset/offset_curves.h"

namespace findspace::plane {

class OffsetMeetings {
 public:
  struct Stop {
    Index piece, point;
    Index other;  // the piece that crosses there
    Index twin;   // the place of this crossing among the stops of the other piece
  };

  /// Keeps references; adds the crossings to the curves' geometry.
  OffsetMeetings(OffsetCurves& curves, OffsetEdges& edges) : c_(curves), edges_(edges) {}

  /// False where curves touch, overlap, or meet three at a point, and that is not inside D.
  bool find();

  Index stop_count(Index i) const { return first_[i + 1] - first_[i]; }
  const Stop& stop(Index i, Index k) const { return stops_[first_[i] + k]; }
  /// Parts of all pieces between stops, counted through: part k of piece i ends at its stop k.
  Index part(Index i, Index k) const { return first_[i] + i + k; }
  Index part_count() const { return Index(stops_.size() + c_.pieces.size()); }
  /// Is the point in D, although it lies on these pieces?
  bool is_inside(Index point, std::initializer_list<Index> pieces);

 private:
  /// What a pair of pieces has in common; points from `known` on are new.
  void note(const PieceMeetings& found, Index known, Index i, Index j);
  void give_up_unless_inside(Index point, Index i, Index j) { good_ = good_ && is_inside(point, {i, j}); }
  bool sort_stops();

  OffsetCurves& c_;
  OffsetEdges& edges_;
  std::vector<Stop> stops_;
  std::vector<Index> first_;  // piece -> its first stop
  bool good_ = true;
};

}  // namespace findspace::plane
