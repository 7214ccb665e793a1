// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// All parts moved at once by linear programs: of each two convex parts that are near each other the highest plane of
// their Phi-function keeps separating them, and no part moves farther than the trust region. Shortening minimises the
// height; separation minimises the depths of the overlaps that are left, and next to that the height. Guarantee: in
// exact arithmetic no new overlap; in doubles that of the solver. Cost: some milliseconds a program. Source: as
// linear_moves.h. Keywords: linear programming compaction, separating plane.
#pragma once

#include <vector>

#include "packing/solid_depth/solid_column.h"

namespace findspace::packing {

class SolidLinearMoves {
 public:
  /// Both must live as long.
  SolidLinearMoves(const SolidTable& table, const SolidColumn& column) : table_(table), column_(column) {}

  /// Shortens a layout without overlaps until it gains no more; the new height.
  double shorten(std::vector<SolidPose>& poses, double height);
  /// Moves parts so that overlaps end, the height at most `most`; whether they did. The height is that reached.
  bool separate(std::vector<SolidPose>& poses, double& height, double most);
  /// Moves parts apart by `gap` where that costs little, at a height that may grow by some gaps; the new height.
  /// `on_axes`: contacts of axis-parallel planes stay.
  double loosen(std::vector<SolidPose>& poses, double height, double gap, bool on_axes);
  int solved() const { return solved_; }

 private:
  struct Bound {
    std::size_t a, b;
    Vector normal;
    double need;          // normal . (move of b - move of a) >= need,
    double most_lacking;  // or less by at most this, of soft rows
    bool soft;
  };
  enum class Goal { kShorten, kSeparate, kLoosen };

  void collect(const std::vector<SolidPose>& poses, double trust, Goal goal, double gap, bool on_axes);
  void collect_pair(const std::vector<SolidPose>& poses, std::size_t a, std::size_t b, double reach, Goal goal,
                    double gap, bool on_axes);
  /// Two that are tied move by less than would end their conditions.
  void collect_tie(const std::vector<SolidPose>& poses, std::size_t a, std::size_t b, double reach);
  void keep(const Bound& bound);
  /// Of a part, or of an obstacle: these have the numbers behind them.
  const SolidPose& pose(const std::vector<SolidPose>& poses, std::size_t k) const {
    return k < poses.size() ? poses[k] : column_.obstacles()[k - poses.size()];
  }
  /// False where the program has no solution.
  bool solve(std::vector<SolidPose>& poses, double& height, double most, double trust, Goal goal);

  const SolidTable& table_;
  const SolidColumn& column_;
  std::vector<Bound> rows_;
  std::size_t first_of_pair_ = 0;
  double left_ = 0;  // the sum of what soft rows lack
  int solved_ = 0;
};

}  // namespace findspace::packing
