// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What placing several bodies gives, in the plane and in space: one body after another, each among those that stand
// already, or all together. Guarantee: that of what places one body. Keywords: packing, nesting, sequential placement,
// simultaneous placement.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "planning/order/problem.h"

namespace findspace::planning {

/// A minimiser alone; or, where no position takes the least values, any that keeps the conditions on coordinates.
enum class Pick { kBest, kAny };

/// One after another: `Step` is what was found for one body.
template <class Step, class V>
struct SequenceOf {
  std::vector<Step> steps;  // by body; fewer where the limit came first
  PosesOf<V> poses;
  bool limit_reached = false;

  /// All bodies, by place(body), which finds the pose of the body among `poses` and enters it there.
  template <class Place>
  void place_each(std::size_t bodies, const Limit& limit, const Place& place) {
    poses.resize(bodies);
    StepTimes times;
    for (std::size_t body = 0; body < bodies && !limit_reached; ++body) {
      limit_reached = times.next_is_late(limit);
      if (limit_reached) return;
      times.begin();
      steps.push_back(place(body));
      times.end();
    }
  }
};

/// All together: `Positions` are those of one body at which the others have positions too.
template <class Positions, class V>
struct TogetherOf {
  std::vector<Positions> positions;     // by body
  PosesOf<V> witness;                   // complete, or all empty: each at its best place after those before it
  std::vector<char> attained;           // by body: 0 where no place is best, so that it stands at any
  std::optional<std::string> unproven;  // why the positions are not known to be all

  void begin(std::size_t bodies) {
    witness.resize(bodies);
    attained.assign(bodies, 1);
  }
};

}  // namespace findspace::planning
