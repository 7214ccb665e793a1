// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A form of a part at any rational position in a container that is no box: whether it lies in the container, and
// whether it is nearer than an edge to what is outside. By their surfaces, by the form's corners in a ball, or by the
// cells of its box that a container lacks. Guarantee: exact, for what lies in the box. Cost: made once for the two;
// then that of surface_gap.h, of a comparison a corner, or of solid_pair_proof.h. Keywords: containment, inside test,
// irregular container.
#pragma once

#include <array>
#include <memory>

#include "packing/solid_problem/solid_problem.h"

namespace findspace::packing {

class SolidContainment {
 public:
  virtual ~SolidContainment() = default;

  /// The form moved to `at`, in units, where it keeps to the box within the edge.
  virtual bool holds(const std::array<Fraction, 3>& at, const Fraction& edge) const = 0;
  /// Where it does not hold: how far the farthest corner or ball is outside, or how deep a corner of the walls lies in
  /// it, or by how much it is too near; 0 where only edges cross. In units, as doubles find it.
  virtual double excess(const std::array<Fraction, 3>& at, const Fraction& edge) const = 0;
};

/// Of a container with an inside. Throws Error(kOutOfRange) where there are too many digits.
std::unique_ptr<const SolidContainment> containment_of(const SolidProblem& problem, const SolidContainer& container,
                                                       const SolidForm& form);

}  // namespace findspace::packing
