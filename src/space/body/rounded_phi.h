// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The Phi-function of two bodies of space that are finite unions of rounded convex parts (body.h), at exact
// positions: the least of the pairs' Phi-functions. For a pair with cores P, Q and R the sum of their radii it is
//   R = 0   the max form of the two polytopes (phi_function.h);
//   R > 0   the normalised one: the distance of the cores less R outside, the max form of the cores less R inside;
//   where
//           P - Q has no interior (of balls and capsules often) the distance less R everywhere.
// `normalised` is normalised in both cases. Guarantee: state, active facets and compare_distance() are exact at every
// real position up to 2^500 steps away (Error(kBadValue) beyond); values have a relative error of 2^-50, also next to
// contact. Inside, minus the value of a union is a lower bound of the true depth (docs/phi.md). Cost: pairs times the
// cost of a pair. Keywords: ball, sphere, capsule, rounded box, phi-function of composed objects.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "space/body/body.h"
#include "space/phi/phi_exact.h"
#include "space/phi/phi_pairs.h"

namespace findspace::space {

struct RoundedPair {
  std::optional<PhiFunction> phi;  // of the cores, where their difference has interior
  std::vector<Point> flat;         // else its corners: a point, the two ends of a segment, or a polygon's
  RealVector normal;               // of that polygon, which runs counter-clockwise about it; else 0
  Vector aside{1, 0, 0};           // a unit vector along which the difference has no extent
  exact::Real radius;

  /// Of two points.
  bool balls() const { return flat.size() == 1; }
};

using RoundedAt = PairAt<Vector>;

class RoundedPhi {
 public:
  RoundedPhi(std::span<const BodyPart> a, std::span<const BodyPart> b);

  int pair_count() const { return static_cast<int>(pairs_.size()); }
  /// Pair i * (number of parts of B) + j belongs to A_i and B_j.
  const RoundedPair& pair(int k) const { return pairs_[k]; }

  using At = LeastAt<Vector>;
  At at(const RealVector& u) const;
  /// The sign of (normalised form at u) - rho, for rho >= 0.
  int compare_distance(const RealVector& u, const exact::Real& rho) const;

 private:
  std::vector<RoundedPair> pairs_;
};

}  // namespace findspace::space
