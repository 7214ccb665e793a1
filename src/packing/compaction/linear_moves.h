// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// All parts moved at once by linear programs. Each pair of parts that are near each other keeps to a convex set of free
// positions (free_half_planes.h), and no part moves farther than the trust region. Shortening minimises the length;
// separation minimises the depths of the overlaps that are left, and next to that the length. Guarantee: in exact
// arithmetic no new overlap; in doubles that of the solver. Cost: some milliseconds a program. Source: Li & Milenkovic
// 1995 (compaction and separation); the solver is CLP. Keywords: linear programming compaction.
#pragma once

#include <vector>

#include "packing/compaction/free_half_planes.h"
#include "packing/nfp/row.h"

namespace findspace::packing {

class LinearMoves {
 public:
  /// Both must live as long.
  LinearMoves(const FieldTable& table, const Row& row) : table_(table), row_(row) {}

  /// Shortens a layout without overlaps until it gains no more; the new length.
  double shorten(std::vector<Pose>& poses, double length);
  /// Moves parts so that overlaps end, the length at most `most`; whether they did. The length is that reached.
  bool separate(std::vector<Pose>& poses, double& length, double most);
  /// Moves parts apart by `gap` where that costs little, at a length that may grow by some gaps; the new length.
  double loosen(std::vector<Pose>& poses, double length, double gap, bool on_grid);
  int solved() const { return solved_; }

 private:
  struct Bound {
    std::size_t a, b;
    Vec normal;
    double need;          // dot(normal, move of b - move of a) >= need,
    double most_lacking;  // or less by at most this, of soft rows
    bool soft;
  };
  enum class Goal { kShorten, kSeparate, kLoosen };

  void collect(const std::vector<Pose>& poses, double trust, Goal goal, double gap, bool on_grid);
  void collect_pair(const std::vector<Pose>& poses, std::size_t a, std::size_t b, double trust, Goal goal, double gap,
                    bool on_grid);
  /// False where the program has no solution.
  bool solve(std::vector<Pose>& poses, double& length, double most, double trust, Goal goal);

  const FieldTable& table_;
  const Row& row_;
  std::vector<Bound> rows_;
  std::vector<HalfPlane> planes_;
  double left_ = 0;  // the sum of what soft rows lack
  int solved_ = 0;
};

}  // namespace findspace::packing
