// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The signed pair distances gamma1, eta1 and delta1 of a moving shape B at p and a fixed shape A (distances.md 3.1):
//   f(p) = d(p, C) - d(p, O^c)   with open O and closed C, O in C:
//   gamma1: O = U (interiors meet),       C = X (the shapes meet);      always defined
//   eta1:   O = {B+p in int A},           C = {B+p in A};               defined if C is not empty, else +infinity
//   everywhere delta1: O = {A in int (B+p)},         C = {A in B+p};               likewise
// Shapes are taken as closed sets (their closure); B must be bounded. Units: grid steps.
// Guarantee: sign maps are exact at every level; values are exact reals. Cost: one convolution for the base map, one
// with a disc for each level other than 0. The first level of gamma1 that is asked for is made without the base as a
// whole, where shapes are large (level.h); for the second one the base is made and kept.
// Keywords: signed distance, penetration depth, clearance, containment margin.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>

#include "distance/planar_features/boundary_features.h"
#include "distance/planar_features/t_distance.h"
#include "plane/complex/shared_region.h"
#include "plane/offset/level.h"
#include "plane/query/nearest.h"

namespace findspace::distance {

class WindowDistance;

class SignedDistance : public TDistance {
 public:
  /// From the sign map at level 0.
  explicit SignedDistance(plane::SignMap base);
  static SignedDistance gamma1(plane::SharedRegion b, plane::SharedRegion a);
  static SignedDistance eta1(const plane::Region& b, const plane::Region& a);
  static SignedDistance delta1(const plane::Region& b, const plane::Region& a);

  /// False where the distance is +infinity everywhere.
  bool defined() const override { return defined_; }
  /// The sign of f - level at every position.
  plane::SignMap sign_map(const exact::Real& level) const override;
  /// The sign map at level 0.
  const plane::SignMap& base() const;

  /// f at a position; nothing if undefined.
  std::optional<PlanarAnswer> value(const exact::RealPoint& p) const override;
  exact::RealPoint seed() const override;
  std::optional<Size> size() const override;
  TDistancePointer near(const plane::PieceBox& window, double low, double high) const override;
  std::optional<std::vector<SmoothForm>> forms(const exact::RealPoint& p, double radius) const override;
  std::vector<NearLevelCurve> level_curves(const exact::RealPoint& p, double tolerance) const override;
  /// 0: the least level of sets without interior.
  std::vector<exact::Real> special_levels() const override { return {exact::Real()}; }

 private:
  SignedDistance() = default;

  /// Made when first asked for; a copy makes its own.
  struct Sides {
    Sides() = default;
    Sides(const Sides& /*other*/) {}
    Sides& operator=(const Sides&) = delete;
    std::once_flag made;
    std::unique_ptr<const BoundaryForms> outside, inside;
  };

  /// A large map, for many places.
  struct Prepared {
    explicit Prepared(const plane::SignMap& base);
    plane::Locator cells;
    plane::NearestSearch inside, outside;  // the nearest place there
  };

  /// Of gamma1, made when first asked for; copies share it.
  struct Base {
    std::once_flag made;
    plane::SignMap map;
    std::optional<std::pair<plane::SharedRegion, plane::SharedRegion>> of;  // fixed, moving
    std::atomic<bool> asked = false;                                        // for it, or for a level
    std::atomic<int> values = 0;                                            // that were asked for
    std::once_flag prepared;
    std::shared_ptr<const Prepared> many;  // made when there were some
  };
  const Prepared* prepared() const;

  std::shared_ptr<Base> base_ = std::make_shared<Base>();
  std::shared_ptr<const WindowDistance> window_;  // of near(), whose sign maps are those of a window
  mutable Sides sides_;
  bool defined_ = true;
};

}  // namespace findspace::distance
