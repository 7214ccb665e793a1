// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Two forms of parts at any rational position: whether their interiors meet, and whether they are nearer than a gap. By
// the Phi-functions of their convex parts and balls; by their surfaces where one of them had to be rounded. Guarantee:
// exact. Cost: made once for two forms; then a filter in doubles, and exact arithmetic for the few facets that compete.
// Keywords: collision predicate.
#pragma once

#include <memory>
#include <optional>

#include "packing/solid_problem/solid_problem.h"
#include "space/body/rounded_phi.h"
#include "space/phi/phi_union.h"
#include "space/surface/surface_gap.h"

namespace findspace::packing {

/// Their coordinates are in grid steps / scale. Throws Error(kOutOfRange) where there are too many digits.
std::shared_ptr<const space::SurfaceSet> surfaces_of(const SolidForm& form, std::int64_t scale);

class SolidPairProof {
 public:
  SolidPairProof(const SolidProblem& problem, const SolidForm& a, const SolidForm& b);

  /// B moved by u, in units.
  bool interiors_meet(const std::array<Fraction, 3>& u) const;
  /// Of two whose interiors do not meet.
  bool is_nearer(const std::array<Fraction, 3>& u, const Fraction& gap) const;
  /// In units, as doubles find it.
  double depth(const std::array<Fraction, 3>& u) const;

 private:
  space::RealVector in_steps(const std::array<Fraction, 3>& u) const;

  int128 steps_;  // in a unit
  std::optional<space::PhiUnion> phi_;
  std::optional<space::RoundedPhi> round_;  // where there are balls
  std::optional<space::SurfaceGaps> gaps_;
};

}  // namespace findspace::packing
