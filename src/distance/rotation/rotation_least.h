// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The least value of a function f of the angle over a set of angles, from its sign maps at levels. Guarantee: the
// bisection encloses the value to about 1e-13 of its size; where it is a whole number of steps, that is proven by the
// sign map there, and the angles are exact. Else the angles, one for each place, are given to about half the digits.
// Where f is -infinity, that is told, with all such angles. Where the work of the question is spent (search_work.h) the
// bounds are what is known by then; a least value may be missing. Cost: about 60 sign maps. Keywords: argmin over
// orientations.
#pragma once

#include <functional>
#include <map>
#include <utility>

#include "distance/answer/optimum.h"
#include "plane/base/search_work.h"
#include "plane/rotation/rotation_map.h"

namespace findspace::distance {

/// Marks 1 at the angles.
using RotationOptimum = OptimumOf<plane::RotationMap>;

/// The sign maps of f minus a level, where a set lies and its ends. Each is made once, and counts its work.
class RotatedLevels {
 public:
  using Signs = std::function<plane::RotationMap(const exact::Real&)>;
  /// `step`: f tends to be a multiple of it.
  RotatedLevels(Signs signs, exact::Real step) : signs_(std::move(signs)), step_(std::move(step)) {}

  exact::Real level(double steps) const { return exact::Real::from_double(steps) * step_; }
  const plane::RotationMap& at(double steps);
  /// Whoever asks may look at no more than is known.
  bool is_spent(double steps) const { return plane::cells_left() <= 0 && !made_.contains(steps); }

 private:
  Signs signs_;
  exact::Real step_;
  std::map<double, plane::RotationMap> made_;
};

/// The set has marks 0/1. Where f `jumps`, a value at an end that the set lacks may be less than all near it.
RotationOptimum least_rotation(RotatedLevels& levels, const plane::RotationMap& set, bool jumps);

}  // namespace findspace::distance
