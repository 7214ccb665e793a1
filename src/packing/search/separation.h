// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// One question: can these parts stand in a row of this length? Overlapping parts are moved by guided local search, and
// what is nearly free is repaired by a linear program, which may take any length up to another. Guarantee: what is free
// has no overlaps, in doubles; a failure proves nothing. Cost: passes over the overlapping parts, until some have
// brought no progress. Source: Gardeyn & Wauters 2024. Keywords: guided local search, overlap minimisation.
#pragma once

#include <cstdint>
#include <vector>

#include "packing/compaction/linear_moves.h"
#include "packing/search/arrangement.h"
#include "packing/search/mover.h"
#include "packing/search/random.h"

namespace findspace::packing {

struct DoubleLayout {
  std::vector<Pose> poses;
  double length = 0;
};

/// Passes without progress, and how often the best is tried again.
struct Patience {
  int passes, strikes;
};

class Separation {
 public:
  Separation(const FieldTable& table, const Row& row, std::vector<Pose> poses, double length, Random& random);

  /// Begins anew at this length; a repair may end at any length up to `most`.
  void begin(const std::vector<Pose>& poses, double length, double most);
  enum class State { kUnderWay, kFree, kStuck };
  State pass(const Patience& patience);
  /// Where it is free.
  const DoubleLayout& free() const { return free_; }
  /// The layout that overlapped least, and by how much.
  const std::vector<Pose>& nearest() const { return nearest_; }
  double least_loss() const { return least_loss_; }
  double loss() const { return loss_; }
  std::uint64_t work() const { return arrangement_.looked_at() + extra_work_; }
  /// By linear programs; the new length.
  double shorten(std::vector<Pose>& poses, double length);

 private:
  State strike(const Patience& patience);
  bool repair();

  Random& random_;
  Arrangement arrangement_;
  Mover mover_;
  LinearMoves linear_;
  DoubleLayout free_;
  std::vector<Pose> nearest_;
  std::vector<std::size_t> order_;
  double most_ = 0, loss_ = 0, least_loss_ = 0, first_loss_ = 0, repaired_loss_ = 0;
  int idle_ = 0, strikes_ = 0;
  std::uint64_t extra_work_ = 0;
};

}  // namespace findspace::packing
