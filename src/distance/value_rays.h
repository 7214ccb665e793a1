// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The sign map on rays of a distance at a level, where round fronts are to be measured from, by its values: a value v
// at a place says the sign as far as |v - level| on either side of it, as no distance changes by more than a step. What
// is left of a line is halved. Guarantee: the sign is - or + only where that is certain; 0 where the distance is within
// kCertain of the sizes of the level (more where a line runs along the front: kCoarse). Cost: some forty values for
// each end, more where the line is nearly along the front. Keywords: sphere tracing, interval bisection, Lipschitz
// bound.
#pragma once

#include <memory>

#include "distance/solid_pair.h"
#include "space/ray_map.h"

namespace findspace::distance {

/// Whether the sign map of gamma1, eta1, eta2 or mu at the level is found by values. No `outside` of B.
bool by_values(Which which, const exact::Real& level, const space::Body& b, const space::Body& a);

class ValueRays : public space::RaySource {
 public:
  static constexpr double kCertain = 0x1p-30, kCoarse = 0x1p-16;

  /// Bounded bodies of one scale; the level in their steps.
  ValueRays(Which which, const exact::Real& level, const space::Body& b, const space::Body& a,
            const space::RayGrid& grid);

  const space::RayGrid& grid() const override { return grid_; }
  space::RayRow row(int j) const override;

 private:
  struct Stretch {
    double from, to;
    int sign;
  };
  /// Of one line, in the bodies' steps.
  struct Walk {
    space::RealVector start, unit;
    std::vector<Stretch> known;
    int values = 0;
  };

  Walk walk(int i, int j) const;
  void look(Walk& walk, double from, double to) const;
  void put(const Walk& walk, space::RayRow& row) const;

  Which which_;
  exact::Real level_;
  SolidPair pair_;
  space::RayGrid grid_;
  double unit_, size_ = 0;  // grid parts to the bodies' steps
  space::Vector middle_;    // about it the box of positions at which the bodies' boxes meet
};

}  // namespace findspace::distance
