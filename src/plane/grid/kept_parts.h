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

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "plane/complex/arrangement.h"
#include "plane/grid/inner_mask.h"

namespace findspace::plane {

/// Grid steps: far more than the rounding of the doubles below (2^43 steps at most).
inline constexpr double kSurelyBeyond = 2;

/// A segment or x-monotone arc along its axis.
class LatticeRunner {
 public:
  explicit LatticeRunner(const LatticeEdge& segment) : slack_(kSurelyBeyond), steep_(is_steep(segment)) {
    u0_ = steep_ ? segment.y0 : segment.x0;
    v0_ = steep_ ? segment.x0 : segment.y0;
    u1_ = steep_ ? segment.y1 : segment.x1;
    v1_ = steep_ ? segment.x1 : segment.y1;
    if (u1_ < u0_) {
      std::swap(u0_, u1_);
      std::swap(v0_, v1_);
      reversed_ = true;
    }
    if (u1_ > u0_) slope_ = (v1_ - v0_) / (u1_ - u0_);
  }
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
  std::int64_t depth(const InnerMask& mask, std::int64_t line) const {
    if (half_ != 0) return depth_of_arc(mask, line);
    const double first = std::max(u0_, double(mask.border(line))), last = std::min(u1_, double(mask.border(line + 1)));
    const double a = v0_ + slope_ * (first - u0_), b = v0_ + slope_ * (last - u0_);
    const std::int64_t c0 = mask.line_of(std::min(a, b) - slack_), c1 = mask.line_of(std::max(a, b) + slack_);
    std::int64_t least = INT64_MAX;
    for (std::int64_t c = c0; c <= c1 && least > 0; ++c)
      least = std::min(least, steep_ ? mask.depth(c, line) : mask.depth(line, c));
    return least;
  }

 private:
  struct Heights {
    double low, high;
  };
  static bool is_steep(const LatticeEdge& e) { return std::abs(e.y1 - e.y0) > std::abs(e.x1 - e.x0); }
  Heights of_arc(double u, double v) const;
  std::int64_t depth_of_arc(const InnerMask& mask, std::int64_t line) const;

  double u0_, v0_, u1_, v1_, slope_ = 0, unsure_end_ = 0;
  double slack_;                                     // of heights
  double center_u_ = 0, center_v_ = 0, radius_ = 0;  // of an arc
  bool steep_ = false, reversed_ = false, sure_ = true;
  std::int8_t half_ = 0;  // of an arc
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
