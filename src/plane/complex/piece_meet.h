// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Where pieces meet: the exact narrow phase of the arrangement. Guarantee: after all pairs that share a cell have been
// given, every common point of two pieces is an end of them or recorded as a split, under point ids that either are the
// same or are united by `ties` or by the later sort along a piece. Cost: two to four orientation tests for two
// segments; where strips of a grid are looked at at once, a copy of the cells of each.
#pragma once

#include <span>
#include <vector>

#include "plane/base/arena.h"
#include "plane/complex/arrangement.h"
#include "plane/complex/broad_phase.h"

namespace findspace::plane {

/// Where a point of the supporting curve lies with regard to a piece.
enum class Within { kOutside, kAtStart, kInside, kAtEnd };
Within within(const exact::Geometry& g, const Piece& piece, Index point_on_supporting_curve);

/// Order of two points of one piece, from p0 to p1.
int compare_along(const exact::Geometry& g, const Piece& piece, Index p, Index q);

/// Sign of the point's height over the piece (a non-vertical one whose x-range contains the point): +1 above, 0 on it.
int height(const exact::Geometry& g, const Piece& piece, Index point);

/// y of a non-vertical piece at the x of a point, which is in its range; the order of two there.
exact::Approx approx_y_at(const exact::Geometry& g, const Piece& piece, Index point);
int compare_heights(const exact::Geometry& g, const Piece& p, const Piece& q, Index point);

class PieceMeetings {
 public:
  struct Split {
    Index piece, point;
  };
  struct Tie {
    Index p, q;
  };

  PieceMeetings(exact::Geometry& g, std::span<const Piece> pieces, Memory memory)
      : splits(memory), ties(memory), g_(g), pieces_(pieces) {}
  void add_pair(Index i, Index j);
  /// All pairs of the pieces of a grid that share a cell; strips of it at once where there are many. The same as one
  /// pair after the other.
  void add_pairs(const CellGrid& grid);
  /// Records an isolated point if it lies on the piece.
  void add_point(Index point, Index piece);

  ArenaVector<Split> splits;
  ArenaVector<Tie> ties;

 private:
  void lines(Index i, Index j);
  void overlap(Index i, Index j);
  void curves(Index i, Index j);
  void place(Index piece, Index point, Within where);
  void meet_at(Index i, Index j, Index point);
  void drop_unused(std::size_t first_point, std::size_t first);
  Index shared_end(const Piece& p, const Piece& q) const;
  bool is_root(Index end, Index root_point, Index other_root_point) const;

  exact::Geometry& g_;
  std::span<const Piece> pieces_;
};

}  // namespace findspace::plane
