// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/offset/offset_walks.h"

#include <algorithm>
#include <utility>

#include "exact/planar/geometry_signs.h"

namespace findspace::plane {
namespace {

class Walker {
 public:
  Walker(const OffsetCurves& curves, const OffsetMeetings& meetings, const OffsetTies& ties)
      : c_(curves), m_(meetings), ties_(ties), walked_(meetings.part_count(), false) {
    to_.edges.resize(meetings.part_count());
    for (const OffsetPart& p : ties.not_reached) walked_[m_.part(p.piece, p.slot)] = true;
  }

  OffsetWalks run() && {
    Index piece = 0;
    for (auto next = walked_.begin(); (next = std::find(next, walked_.end(), char(false))) != walked_.end();) {
      const Index part = Index(next - walked_.begin());
      while (m_.part(piece + 1, 0) <= part) ++piece;
      walk({piece, part - m_.part(piece, 0)});
    }
    to_.edges.resize(size_);
    return std::move(to_);
  }

 private:
  /// Keeps the walk from a part, if it is closed and new.
  void walk(OffsetPart from) {
    OffsetPart at = from;
    Index before, size = size_;
    tied_ = false;
    do {
      char& walked = walked_[m_.part(at.piece, at.slot)];
      if (walked) return;
      walked = true;
      set_edge(to_.edges[size++], at);
      before = at.piece;
      if (!advance(at)) return;
    } while (at.piece != from.piece || at.slot != from.slot);
    to_.rings.push_back({size_, {from.piece, before}, tied_});
    size_ = size;
  }

  void set_edge(RingEdge& e, OffsetPart at) const {
    const Piece& piece = c_.pieces[at.piece];
    e.point = at.slot == 0 ? c_.start(at.piece) : m_.stop(at.piece, at.slot - 1).point;
    e.supporting_curve = piece.supporting_curve;
    e.right = c_.origins[at.piece].right;
    e.half = piece.half;
  }

  /// To the part that follows; false where the walk would pass into D.
  bool advance(OffsetPart& at) {
    const bool ends = at.slot == m_.stop_count(at.piece);
    const Index tie = m_.tie_at(ends ? c_.end(at.piece) : m_.stop(at.piece, at.slot).point);
    if (tie != kNone) {
      tied_ = true;
      at = ties_.after(tie, at);
    } else if (ends) {
      at = {c_.origins[at.piece].next, 0};
    } else {
      const OffsetMeetings::Stop& stop = m_.stop(at.piece, at.slot);
      if (turn(c_.geometry, stop.point, c_.heading(at.piece), c_.heading(stop.other)) > 0) return false;
      at = {stop.other, stop.twin + 1};
    }
    return at.piece != kNone;
  }

  const OffsetCurves& c_;
  const OffsetMeetings& m_;
  const OffsetTies& ties_;
  std::vector<char> walked_;  // of each part
  OffsetWalks to_;
  Index size_ = 0;     // edges that are kept
  bool tied_ = false;  // the walk that is made has passed a tie
};

}  // namespace

OffsetWalks offset_walks(const OffsetCurves& curves, const OffsetMeetings& meetings, const OffsetTies& ties) {
  return Walker(curves, meetings, ties).run();
}

}  // namespace findspace::plane
