// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// One moving and one fixed shape of space (each perhaps several names) in the forms they have: as boxes, as bodies, or
// both, large meshes as surfaces too. Lengths in grid steps. Distances that boxes answer exactly are asked of them,
// then surfaces what they tell, the others the bodies, which are made for it where there are surfaces. Guarantee: as
// box_maps.h, surface_pair.h and solid_pair.h.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "distance/solid/box_maps.h"
#include "distance/solid/solid_least.h"
#include "distance/surface/surface_pair.h"
#include "formula/solid/csg_shapes.h"
#include "space/polytope/convex_region.h"

namespace findspace::formula {

class SpacePair {
 public:
  SpacePair(const std::vector<const SpaceShape*>& moving, const std::vector<const SpaceShape*>& fixed);

  /// Why nothing is answered of these shapes; null where something is.
  const std::optional<exact::Refusal>& refusal() const { return refusal_; }
  /// Nothing where the distance is undefined.
  exact::Tried<std::optional<distance::Answer>> value(distance::Which which, const space::RealVector& p) const;
  /// As SpaceSolver::quick_distance; while this lives.
  std::function<exact::Interval(const space::Vector&)> within(distance::Which which) const;
  /// One of the shapes is a large mesh.
  bool large() const { return surfaces_.has_value(); }
  /// Values lie between those of bodies, which no longer search brings together.
  bool between() const { return between_.has_value(); }
  /// The least value and its positions; nothing where this is not computed.
  exact::Tried<std::optional<distance::BoxMaps::Least>> least(distance::Which which) const;
  /// The least value as far as it is known (solid_least.h), in grid steps; nothing where the distance is undefined.
  exact::Tried<std::optional<distance::Answer>> nearly_least(distance::Which which) const;
  /// The same of gamma1, eta1 or delta1 along a direction, of any length; no position may take it.
  exact::Tried<std::optional<distance::Answer>> directional_least(distance::Which which,
                                                                  const space::RealVector& direction,
                                                                  bool both_ways) const;
  /// {distance <= level}, if it is a convex polytope, or one grown by a ball: gamma1 of convex shapes, eta1 in a convex
  /// polytope or of a ball in a ball, delta1 of such, mu to these at levels up to 0, gamma2 of balls. Its coordinates
  /// and radius are in grid steps times `scale`.
  struct Sublevel {
    space::ConvexRegion region;
    exact::Real radius;
    exact::Real scale;
  };
  std::optional<Sublevel> sublevel(distance::Which which, const exact::Real& level) const;
  /// The position nearest to p at which gamma1 is at least a level above 0, within the error of a search where rounded
  /// sets meet; nothing where it is not computed: for large meshes, and bodies of more than kMostApart pairs of parts.
  std::optional<space::RealVector> nearest_apart(const exact::Real& level, const space::RealVector& p) const;
  static constexpr std::size_t kMostApart = 256;
  /// Refused if one of the shapes has slanted or round faces.
  exact::Tried<const distance::BoxMaps*> boxes() const;

 private:
  using BodyPointer = std::shared_ptr<const space::Body>;
  using Shapes = std::vector<SpaceShape>;
  /// Of one scale; without a pair `refused` says why.
  struct Bodies {
    BodyPointer b, a;
    std::optional<distance::PairDistances> pair;
    std::int64_t scale = 1;
    std::optional<exact::Refusal> refused;
  };
  /// Two bodies of convex outlines, as far as sublevel sets go.
  struct Outlines {
    const space::Body *b, *a;
    std::int64_t scale;
  };

  const Bodies& all() const;  // made when first asked for
  std::unique_ptr<const Bodies> made_bodies() const;
  void make_surfaces();
  exact::Tried<std::optional<distance::Answer>> value_of_bodies(distance::Which which,
                                                                const space::RealVector& p) const;
  std::optional<Outlines> outlines(bool eta, bool delta) const;
  static Sublevel none(std::int64_t scale);
  std::optional<distance::BoxMaps::Least> deepest_fit(distance::Which which) const;

  std::optional<exact::Refusal> refusal_;
  Shapes moving_, fixed_;
  std::optional<space::BoxComplex> moving_boxes_, fixed_boxes_;
  std::unique_ptr<distance::BoxMaps> boxes_;
  std::shared_ptr<const distance::CsgSide> cut_side_;
  bool cut_moves_ = false;
  std::optional<CutBetween> between_;
  std::optional<distance::PairDistances> cut_;
  std::int64_t cut_scale_ = 1;
  std::optional<distance::PairDistances> surfaces_;
  distance::Surfaced surfaced_b_, surfaced_a_;
  std::int64_t surface_scale_ = 1;
  mutable std::mutex bodies_guard_, least_guard_;
  mutable std::unique_ptr<const Bodies> bodies_;
  mutable std::map<distance::Which, std::unique_ptr<std::optional<distance::Answer>>> least_;  // in steps / scale
};

}  // namespace findspace::formula
