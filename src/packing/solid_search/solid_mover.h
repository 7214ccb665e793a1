// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A better position for one solid: some positions all over the container and about the solid at random. The best of
// them go along the axes, to the best place of each line, until no axis gains. Where none of that gained, along the
// directions in which the solid slides on what it touches, or leaves what it overlaps. Guarantee: the cost never rises;
// each line is searched exactly. Keywords: line search, local search, configuration space.
#pragma once

#include <array>
#include <vector>

#include "packing/search/random.h"
#include "packing/solid_search/solid_arrangement.h"

namespace findspace::packing {

class SolidMover {
 public:
  SolidMover(SolidArrangement& arrangement, Random& random) : a_(arrangement), random_(random) {}

  /// Moves the item where that lowers its weighted cost.
  void improve(std::size_t item);

 private:
  struct Candidate {
    SolidPose pose;
    double cost;
  };
  static constexpr std::size_t kKept = 3;

  void sample(std::size_t item, const Candidate& here);
  void offer(std::size_t item, const SolidPose& pose);
  std::size_t random_variant(std::size_t item);
  bool go_along(std::size_t item, Candidate& c, const Vector& way);
  void descend(std::size_t item, Candidate& c);
  bool slide(std::size_t item, Candidate& c);

  SolidArrangement& a_;
  Random& random_;
  std::array<Candidate, kKept> kept_;
  std::size_t count_ = 0;
  std::vector<SolidArrangement::Touch> touches_;
};

}  // namespace findspace::packing
