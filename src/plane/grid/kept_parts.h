// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What of a piece may lie outside the cells of a mask (inner_mask.h). A piece is followed along its longer axis, an arc
// along x, and is cut where it passes from a line of cells that are all masked to one that is not, on the border
// between them. An end that is not kept lies in a masked cell too. Guarantee: what is left out lies in masked, closed
// cells; no two parts overlap, and none has length 0. Only conservative double arithmetic; no sign is decided, and a
// piece whose doubles may be off too far is kept as it is. Cost: the cells along the piece; deep ones are passed at
// once.
#pragma once

#include <vector>

#include "plane/complex/arrangement.h"
#include "plane/grid/inner_mask.h"

namespace findspace::plane {

/// A segment or x-monotone arc along its axis.
class LatticeRunner {
 public:
  explicit LatticeRunner(const LatticeEdge& segment);
  LatticeRunner(const exact::Geometry& g, const Piece& piece);

  /// Its doubles are near enough to the truth.
  bool is_sure() const { return sure_; }
  double start() const { return u0_; }
  double end() const { return u1_; }
  /// Along y.
  bool steep() const { return steep_; }
  /// It starts at p1.
  bool reversed() const { return reversed_; }
  /// Borders nearer to an end than this may lie on the other side of it; 0: none.
  double unsure_end() const { return unsure_end_; }
  /// How many lines from this one on it passes in masked cells only.
  std::int64_t depth(const InnerMask& mask, std::int64_t line) const;

 private:
  struct Heights {
    double low, high;
  };
  Heights between(double u, double v) const;

  double u0_, v0_, u1_, v1_, slope_ = 0, unsure_end_ = 0;
  double center_u_ = 0, center_v_ = 0, radius_ = 0;  // of an arc
  bool steep_ = false, reversed_ = false, sure_ = true;
  int half_ = 0;  // of an arc
};

/// What is kept of a piece: from one border of lines of cells to another, or to an end of the piece (kEnd).
struct KeptPart {
  static constexpr std::int64_t kEnd = INT64_MIN;  // no line

  Index piece;
  bool steep, reversed;
  std::int64_t from, to;
};

/// `number` is put into the parts.
void add_kept_parts(const LatticeRunner& run, const InnerMask& mask, Index number, std::vector<KeptPart>& out);

}  // namespace findspace::plane
