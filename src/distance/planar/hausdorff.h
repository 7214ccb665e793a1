// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The signed directed Hausdorff distance mu(B+p, A) = max over b in B of gamma1(b+p, A) (distances.md 3.3, 3.5): how
// far B + p protrudes from A at most, or minus the margin it has inside. With V = A (+) level * int K and its closed
// companion:
//   level > 0: - where B+p lies in V, 0 where it lies in A (+) level * K but not in V, + elsewhere; the zero set may be
//   fat; level <= 0: as eta1.
// The other order, mu(A, B+p), is reflected(mu of A moving over B); the Hausdorff distance is the greater of the two.
// Guarantee: sign maps exact; values exact in a place found by search (see farthest_from_set.h). Cost: sign map: one
// convolution with a disc and one with B, or two where the level has parts of its own. Keywords: Hausdorff distance,
// directed Hausdorff distance.
#pragma once

#include <memory>
#include <mutex>

#include "distance/planar/farthest_from_set.h"
#include "distance/planar/max_min_boxes.h"
#include "distance/planar/signed_distance.h"
#include "distance/planar_features/t_distance.h"
#include "plane/complex/shared_region.h"

namespace findspace::distance {

class DirectedHausdorff : public TDistance {
 public:
  /// mu(B+p, A); closed shapes. +infinity if B is not bounded.
  DirectedHausdorff(plane::SharedRegion b, plane::SharedRegion a);

  bool defined() const override { return b_->faces[0].mark <= 0; }
  plane::SignMap sign_map(const exact::Real& level) const override;
  std::optional<PlanarAnswer> value(const exact::RealPoint& p) const override;
  exact::RealPoint seed() const override;
  std::optional<Size> size() const override;
  TDistancePointer near(const plane::PieceBox& window, double low, double high) const override;
  std::vector<NearLevelCurve> level_curves(const exact::RealPoint& p, double tolerance) const override;
  std::vector<exact::Real> special_levels() const override { return {exact::Real()}; }

 private:
  /// For the searches of sets without arcs.
  struct Trees {
    FeatureTree b, a;
    MaxMinBoxes boxes;

    Trees(const plane::Region& moving, const plane::Region& fixed) : b(moving), a(fixed), boxes(a) {}
  };

  const SignedDistance& containment() const;
  const Trees& trees() const;
  std::optional<FarthestPlace> greatest(const exact::RealPoint& p, double least_value) const;

  const FarthestFromSet& search() const;
  double scale(double px, double py) const;

  plane::SharedRegion b_, a_;
  mutable std::once_flag made_, trees_made_, search_made_;  // what is made when first needed:
  mutable std::unique_ptr<const FarthestFromSet> search_;
  mutable std::unique_ptr<const Trees> trees_;
  mutable std::unique_ptr<SignedDistance> containment_;  // eta1
};

}  // namespace findspace::distance
