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
  Walker(const OffsetCurves& curves, const OffsetMeetings& meetings)
      : c_(curves), m_(meetings), walked_(meetings.part_count(), false) {
    to_.edges.resize(meetings.part_count());
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
  struct Part {
    Index piece, slot;
  };

  /// Keeps the walk from a part, if it is closed and new.
  void walk(Part from) {
    Part at = from;
    Index before, size = size_;
    do {
      char& walked = walked_[m_.part(at.piece, at.slot)];
      if (walked) return;
      walked = true;
      set_edge(to_.edges[size++], at);
      before = at.piece;
      if (!advance(at)) return;
    } while (at.piece != from.piece || at.slot != from.slot);
    to_.rings.push_back({size_, {from.piece, before}});
    size_ = size;
  }

  void set_edge(RingEdge& e, Part at) const {
    const Piece& piece = c_.pieces[at.piece];
    e.point = at.slot == 0 ? c_.start(at.piece) : m_.stop(at.piece, at.slot - 1).point;
    e.supporting_curve = piece.supporting_curve;
    e.right = c_.origins[at.piece].right;
    e.half = piece.half;
  }

  /// To the part that follows; false where the walk would pass into D.
  bool advance(Part& at) const {
    if (at.slot < m_.stop_count(at.piece)) {
      const OffsetMeetings::Stop& stop = m_.stop(at.piece, at.slot);
      if (turn(c_.geometry, stop.point, c_.heading(at.piece), c_.heading(stop.other)) > 0) return false;
      at = {stop.other, stop.twin + 1};
      return true;
    }
    at = {c_.origins[at.piece].next, 0};
    return at.piece != kNone;
  }

  const OffsetCurves& c_;
  const OffsetMeetings& m_;
  std::vector<char> walked_;  // of each part
  OffsetWalks to_;
  Index size_ = 0;  // edges that are kept
};

}  // namespace

OffsetWalks offset_walks(const OffsetCurves& curves, const OffsetMeetings& meetings) {
  return Walker(curves, meetings).run();
}

}  // namespace findspace::plane
