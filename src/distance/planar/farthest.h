// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The farthest distances gamma2, eta2, delta2 (distances.md 3.2): f(p) = max {|c - p| : c in C} for a closed bounded
// set C,
//   gamma2: C = X (the shapes meet);  eta2: C = E (B+p in A);  delta2: C = D (A in B+p);
// with all dangling parts and isolated points of C. Undefined (+infinity) if C is empty or unbounded.
// {f <= l} is an intersection of equal discs, convex; the least level is the radius of the smallest circle around C.
// Guarantee: exact. Cost: sign map: a hull and one convolution with a disc; value: linear; the circle:
// smallest_circle.h. Keywords: farthest point, reach, diameter.
#pragma once

#include "distance/planar_features/boundary_features.h"
#include "distance/planar_features/t_distance.h"

namespace findspace::distance {

class Farthest : public TDistance {
 public:
  /// C = the closed set of marks <= 0 of a sign map at level 0 (contact, containment or covering).
  explicit Farthest(const plane::SignMap& base);
  /// f(p) = |p - q|.
  static Farthest from_point(const exact::RealPoint& q);

  bool defined() const override { return defined_; }
  plane::SignMap sign_map(const exact::Real& level) const override;
  std::optional<PlanarAnswer> value(const exact::RealPoint& p) const override;
  exact::RealPoint seed() const override;
  std::optional<std::vector<SmoothForm>> forms(const exact::RealPoint& p, double radius) const override;
  std::vector<NearLevelCurve> level_curves(const exact::RealPoint& p, double tolerance) const override;
  std::optional<Lowest> lowest() const override;

  /// A point of C farthest from p.
  exact::RealPoint farthest_point(const exact::RealPoint& p) const;

 private:
  struct Best {
    exact::Real distance;
    exact::RealPoint at;
  };
  Best best(const exact::RealPoint& p) const;

  plane::Region set_;
  std::vector<BoundaryFeature> features_;  // vertices and arcs
  bool defined_ = true;
};

}  // namespace findspace::distance
