// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A form of a part at any rational position in a container that is no box: whether it lies in the container, and
// whether it is nearer than an edge to what is outside. By their surfaces. Guarantee: exact. Cost: made once for the
// two; then that of surface_gap.h. Keywords: containment, inside test, irregular container.
#pragma once

#include <array>
#include <memory>

#include "packing/solid_problem/solid_problem.h"
#include "space/surface/surface_gap.h"

namespace findspace::packing {

class SolidContainment {
 public:
  /// Of a container with an inside. Throws Error(kOutOfRange) where there are too many digits.
  SolidContainment(const SolidProblem& problem, const SolidContainer& container, const SolidForm& form);

  /// The form moved to `at`, in units.
  bool holds(const std::array<Fraction, 3>& at, const Fraction& edge) const;
  /// Where it does not hold: how far the farthest corner or ball is outside, or by how much it is too near; 0 where
  /// only edges cross. In units, as doubles find it.
  double excess(const std::array<Fraction, 3>& at, const Fraction& edge) const;

 private:
  space::RealVector in_steps(const std::array<Fraction, 3>& at) const;

  int128 steps_;  // in a unit
  std::shared_ptr<const space::SurfaceSet> container_, form_;
  space::SurfaceGaps gaps_;
};

}  // namespace findspace::packing
