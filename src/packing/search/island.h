// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// One searcher for a shorter strip, with its own random numbers. It shrinks the strip, separates the overlapping parts
// by guided local search, repairs what is nearly free by a linear program, and shortens every success by another. It
// goes on from a near solution, two large parts exchanged, where a separation fails (exploration), or from the best
// layout in ever smaller steps (compression). Work is counted in pairs of parts looked at, so that a search can be
// repeated. Guarantee: its best layout has no overlaps, in doubles. Source: Gardeyn & Wauters 2024 (phases, pool).
// Keywords: guided local search, strip packing, open dimension.
#pragma once

#include <cstdint>
#include <vector>

#include "packing/compaction/linear_moves.h"
#include "packing/search/arrangement.h"
#include "packing/search/first_layout.h"
#include "packing/search/mover.h"
#include "packing/search/random.h"

namespace findspace::packing {

class Island {
 public:
  Island(const FieldTable& table, DoubleLayout start, std::uint64_t seed);

  /// One pass over the overlapping parts, or one step between two separations. `progress`: how much of the whole
  /// search is over, from 0 to 1.
  void step(double progress);
  const DoubleLayout& best() const { return best_; }
  /// Goes on from a better layout of another island.
  void adopt(const DoubleLayout& better);
  std::uint64_t work() const { return arrangement_.looked_at() + extra_work_; }
  /// Overlapping depth at the last pass, and separations that failed since the last success.
  double overlap() const { return loss_; }
  int failures() const { return failures_; }

 private:
  struct Near {
    std::vector<Pose> poses;
    double loss;
  };
  enum class Phase { kExplore, kCompress };

  void begin();               // a separation
  void shrink(double ratio);  // the best layout, moved together
  void restart_from_pool();
  void swap_two_large();
  void pass();
  void strike();
  void succeed(std::vector<Pose> poses);
  void keep(DoubleLayout better);
  void fail();
  bool repair();

  const FieldTable& table_;
  Random random_;
  Arrangement arrangement_;
  Mover mover_;
  LinearMoves linear_;
  DoubleLayout best_;
  std::vector<std::size_t> large_;  // items, by size
  Phase phase_ = Phase::kExplore;
  double progress_ = 0, loss_ = 0, least_loss_ = 0, first_loss_ = 0, repaired_loss_ = 0;
  bool separating_ = false;
  int idle_ = 0, strikes_ = 0, failures_ = 0;
  std::vector<Pose> incumbent_;
  std::vector<Near> pool_;
  std::vector<std::size_t> order_;
  std::uint64_t extra_work_ = 0;
};

}  // namespace findspace::packing
