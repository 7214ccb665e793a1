// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The curves at which what a moving window sees of a marked complex M can change. The window is the segment from p +
// from to p + to; its positions p see a vertex or an edge of M along
//     a copy of M moved by -from (seen at the window's start), a copy moved by -to (seen at its end),
//     for each place where the window glances past something (an event) the segment of positions that see it in
//     between, for each edge parallel to the window the segment of positions that see some of it in between.
// Events are vertices where edges end, turn back or change their marks against the direction of the window, and places
// of arcs with the tangent of the window. Between events edges join into chains that cross the window's direction once;
// the positions that see a chain in the open window are the inside of a strip: the chain's two copies and the segments
// of its ends. Guarantee: exact. Cost: linear. Source: partial Minkowski sums, distances.md 7.1. Keywords: sweep, swept
// area, visibility.
#pragma once

#include <algorithm>
#include <vector>

#include "plane/base/real_vector.h"
#include "plane/complex/cell_complex.h"
#include "plane/complex/piece_builder.h"
#include "plane/complex/winding.h"

namespace findspace::plane {

/// A window between two different ends: to - from is a positive multiple of the primitive integer vector (dx, dy).
struct Window {
  RealVector from, to;
  std::int64_t dx = 0, dy = 0;
};

/// An edge, or what a place with the window's tangent leaves of an arc. It runs as its edge from node p to node q.
struct StripPart {
  Index edge = 0;
  Index p = 0, q = 0;
  int rise = 0;  // +1: to the left of the window's direction on the way from p to q; -1: to the right; 0: parallel
};

/// A vertex of M, or (after those) a place of an arc with the window's tangent.
struct StripNode {
  bool event = true;
  Mark mark = 0, ahead = 0, behind = 0;  // on it, and next to it in and against the window's direction
  Mark least() const { return std::min(mark, std::min(ahead, behind)); }
};

class SweepStrips {
 public:
  SweepStrips(const CellComplex& m, const Window& window);

  /// What a piece of `curves` is.
  struct Source {
    enum class Role { kStart, kEnd, kSide, kPassing };
    Role role = Role::kSide;
    Index part = 0;  // of kStart and kEnd
    Mark mark = 0;   // of kPassing: the least mark that positions inside the piece see
  };

  std::vector<StripPart> parts;
  std::vector<StripNode> nodes;
  std::vector<Index> start_point, end_point;  // node -> its point in the copy seen at the start, at the end
  PieceBuilder curves;
  std::vector<Source> sources;   // per piece
  std::vector<Chain> chains;     // per piece; weight 0 where it bounds no strip
  std::vector<Mark> chain_mark;  // per piece: the least mark on and beside the chain of its strip
  std::vector<Corner> corners;

 private:
  using Role = Source::Role;

  void copy_geometry();
  void split_edges();
  int rise_of_line(const exact::SupportingCurve& k) const;
  void split_arc(Index e);
  void look_around(Index v);
  Index first_after(const std::vector<Index>& around, const std::vector<int>& key) const;
  int turn_class(Index half_edge) const;
  Index part_at(Index half_edge) const {
    return half_edge & 1u ? part_start_[half_edge / 2 + 1] - 1 : part_start_[half_edge / 2];
  }
  void add_curves();
  void add_chain(Index first);
  Index next_in_chain(Index part) const;
  Index low(Index part) const { return parts[part].rise > 0 ? parts[part].p : parts[part].q; }
  Index high(Index part) const { return parts[part].rise > 0 ? parts[part].q : parts[part].p; }
  Mark least(Index part) const;
  Index add_copy(Role role, Index part, bool upward, std::int32_t weight, Mark mark);
  void add_along(Index line, Index from, Index to, const Source& source, std::int32_t weight, Mark mark);
  Index line_of(Index node);

  const CellComplex& m_;
  Window window_;
  bool rightward_;                   // the window's direction is lexicographically positive
  Index end_supporting_curves_ = 0;  // first supporting curve of the copy seen at the end
  std::vector<Index> part_start_;    // edge -> its first part
  std::vector<Index> upward_;        // vertex without event -> the part that leaves it upward
  std::vector<Index> lines_;         // node -> the line along which it is passed, or kNone
};

}  // namespace findspace::plane
