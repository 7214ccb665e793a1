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

#include "packing/search/separation.h"

namespace findspace::packing {

class Island {
 public:
  Island(const FieldTable& table, const Row& row, DoubleLayout start, std::uint64_t seed);

  /// One pass over the overlapping parts, or one step between two separations. `progress`: how much of the whole
  /// search is over, from 0 to 1.
  void step(double progress);
  const DoubleLayout& best() const { return best_; }
  /// Goes on from a better layout of another island.
  void adopt(const DoubleLayout& better);
  std::uint64_t work() const { return separation_.work(); }
  /// Overlapping depth at the last pass.
  double overlap() const { return separation_.loss(); }

 private:
  struct Near {
    std::vector<Pose> poses;
    double loss;
  };
  enum class Phase { kExplore, kCompress };

  void begin();                            // a separation
  std::vector<Pose> shrunk(double ratio);  // the best layout, moved together
  std::vector<Pose> from_pool();
  void swap_two_large(std::vector<Pose>& poses);
  void keep(DoubleLayout better);
  void fail();

  const FieldTable& table_;
  const Row& row_;
  Random random_;
  Separation separation_;
  DoubleLayout best_;
  std::vector<std::size_t> large_;  // items, by size
  Phase phase_ = Phase::kExplore;
  double progress_ = 0, target_ = 0;
  bool separating_ = false;
  std::vector<Near> pool_;
};

}  // namespace findspace::packing
