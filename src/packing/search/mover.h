// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A better position for one item: some positions all over the strip and about the item at random, the best of them
// improved by two descents. One goes to the boundaries of the no-fit polygons that it is in, and to crossings of their
// edges; the other along coordinates by steps that grow and shrink. Guarantee: the cost never rises.
// Source: Gardeyn & Wauters 2024 (sparrow) for sampling and coordinate descent. Keywords: no-fit polygon, local search.
#pragma once

#include <array>

#include "packing/search/arrangement.h"
#include "packing/search/random.h"

namespace findspace::packing {

class Mover {
 public:
  Mover(Arrangement& arrangement, Random& random) : a_(arrangement), random_(random) {}

  /// Moves the item where that lowers its weighted cost.
  void improve(std::size_t item);

 private:
  struct Candidate {
    Pose pose;
    double cost;
  };
  static constexpr std::size_t kKept = 3;

  void sample(std::size_t item, const Candidate& here);
  void offer(std::size_t item, const Pose& pose);
  void project(std::size_t item, Candidate& c);
  bool project_once(std::size_t item, Candidate& c);
  void descend(std::size_t item, Candidate& c, double step);
  bool try_at(std::size_t item, Candidate& c, Vec at);
  std::size_t random_variant(std::size_t item);

  Arrangement& a_;
  Random& random_;
  std::array<Candidate, kKept> kept_;
  std::size_t count_ = 0;
};

}  // namespace findspace::packing
