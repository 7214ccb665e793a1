// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The Phi-function of two bodies of the plane that are finite unions of rounded convex parts (planar_parts.h): the
// least of the pairs' Phi-functions. For a pair with cores P, Q and R the sum of their radii it is
//   R = 0   the max form of the two polygons;
//   R > 0   the normalised one: the distance of the cores less R outside, the max form of the cores less R inside. So
//           two discs give |u| - R, a rectangle and a disc the piecewise form (6) of the source.
// `normalised` is normalised in both cases. Guarantee: state, active edges and compare_distance() are exact at every
// real position up to 2^500 steps away (Error(kBadValue) beyond); values have a relative error of 2^-50, also next to
// contact. Inside, minus the value of a union is a lower bound of the true depth (docs/phi.md). Cost: a filter over the
// edges of every pair, then exact arithmetic for the few that compete. Keywords: phi-function, no-fit polygon, signed
// distance, non-convex.
#pragma once

#include <span>
#include <vector>

#include "exact/planar/geometry.h"
#include "space/phi/phi_function.h"
#include "space/phi/phi_pairs.h"
#include "space/polytope/planar_parts.h"

namespace findspace::space {

/// The edges of the frontier of P - Q for the cores of two parts, none of two points.
struct PlanarPair {
  std::span<const PlanarEdge> edges() const { return phi ? phi->edges() : std::span<const PlanarEdge>(); }
  std::optional<PlanarPhi> phi;  // nothing for two points
  Point2 apex;                   // of two points: their difference
  exact::Real radius;
};

/// The forms of the source beside `phi` for one pair (phi.md 7), at u: of two discs |u|^2 - R^2; of a rectangle with
/// sides along the axes and a disc the least of five functions without cases (7), which has the value of (6).
struct OtherForms {
  std::optional<exact::Real> square;
  std::optional<double> case_free;
};
OtherForms other_forms(const PlanarPair& pair, const exact::RealPoint& u);

using PlanarAt = PairAt<Vector2>;

class PlanarPhiUnion {
 public:
  PlanarPhiUnion(std::span<const PlanarPart> a, std::span<const PlanarPart> b);

  int pair_count() const { return static_cast<int>(pairs_.size()); }
  /// Pair i * (number of parts of B) + j belongs to A_i and B_j.
  const PlanarPair& pair(int k) const { return pairs_[k]; }

  using At = LeastAt<Vector2>;
  At at(const exact::RealPoint& u) const;
  /// The sign of (normalised form at u) - rho, for rho >= 0.
  int compare_distance(const exact::RealPoint& u, const exact::Real& rho) const;

 private:
  std::vector<PlanarPair> pairs_;
};

}  // namespace findspace::space
