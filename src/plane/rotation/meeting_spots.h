// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Where, roughly, two contact curves can meet while B rotates through a narrow sector of angles: a place in the middle
// of the sector and how far the meeting can travel from it. Most pairs and triples of curves are passed over by it.
// Guarantee: only what certainly does not matter for rotated_free.h is passed over. Cost: some dozen nanoseconds a pair
// of curves, more where it asks whether B is free there. Keywords: floating point filter, critical orientation.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "plane/rotation/rotated_free_events.h"

namespace findspace::plane {

class MeetingSpots {
 public:
  MeetingSpots() = default;
  /// Angles between middle - half and middle + half.
  MeetingSpots(const FreeQuestion& question, std::span<const ContactPair> pairs, double middle, double half);

  /// How far a point of the curve, fixed to what it is hinged at, can move from the middle of the sector to its ends.
  static double travel(const ContactCurves& curves, const ContactPair& pair, double half);
  double travel(std::size_t i) const { return travels_[i]; }

  /// Two curves (i < k): in a point of F; in one as far away as the level.
  bool may_meet(std::size_t i, std::size_t k) const { return spot(i, k).possible; }
  bool may_meet_at_level(std::size_t i, std::size_t k) const;
  /// Three of them (i < k < m).
  bool may_meet(std::size_t i, std::size_t k, std::size_t m) const {
    return may_come(i, k, m) && may_come(i, m, k) && may_come(k, m, i);
  }

 private:
  struct Spot {
    bool possible = true;
    RoughPoint at;
    double travel = std::numeric_limits<double>::infinity();
  };
  const Spot& spot(std::size_t i, std::size_t k) const { return spots_[i * curves_.size() + k]; }
  Spot place(std::size_t i, std::size_t k) const;
  bool may_come(std::size_t i, std::size_t k, std::size_t third) const;

  double half_ = 0, tolerance_ = 0, level_ = 0;
  std::vector<RoughCurve> curves_;  // in the middle
  std::vector<double> travels_;
  std::vector<Spot> spots_;  // by pairs of curves
};

}  // namespace findspace::plane
