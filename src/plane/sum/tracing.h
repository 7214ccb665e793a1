// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The tracing of a boundary path, as a convolution walks it: line, turn, line, turn ... Lines may have length 0
// (between an arc and a corner), turns may be empty (between segments in one direction). Directions are replaced by
// their places in the circular order of all directions of both operands: keys. Nothing is copied: a tracing refers to
// its `Path`, which must outlive it.
#pragma once

#include <vector>

#include "plane/complex/boundary.h"

namespace findspace::plane {

struct Tracing {
  struct Line {
    const Direction* direction;
    const Position *from, *to;
    bool empty = false;
    Index key = 0;
    Index place = 0;  // in `sorted`, unless empty
  };
  struct Turn {  // turn k follows line k
    const Position* center;
    const Step* arc = nullptr;  // null: a vertex
    std::int8_t sign = 1;       // +1 turns left, -1 right
    bool half_turn = false;     // by exactly 180 degrees at a vertex
    Index low = 0, length = 0;  // keys swept: low, low + 1, ..., low + length, counter-clockwise whatever the sign

    /// > 0 for a counter-clockwise arc, < 0 for a clockwise one, 0 for a vertex.
    exact::Real radius() const { return !arc ? exact::Real() : sign > 0 ? arc->radius : -arc->radius; }
    /// Of an arc: sign of the y component of the right normal along it (place = centre + radius * normal).
    std::int8_t normal_up() const { return std::int8_t(arc->half * sign); }
  };
  std::vector<Line> lines;
  std::vector<Turn> turns;
  std::vector<Index> sorted;  // the lines that are not empty, by key

  /// `flat`: the path of a curve or point that is a set of its own, walked on both sides.
  static Tracing from(const Path& path, bool flat);

  Index size() const { return Index(lines.size()); }
  Index line_after(Index turn) const { return turn + 1 == lines.size() ? 0 : turn + 1; }
  Index turn_before(Index line) const { return line == 0 ? Index(lines.size() - 1) : line - 1; }
};

/// Gives all lines their keys (even for a, odd for b) and all turns their intervals; returns the number of keys.
Index assign_keys(std::vector<Tracing>& a, std::vector<Tracing>& b);

}  // namespace findspace::plane
