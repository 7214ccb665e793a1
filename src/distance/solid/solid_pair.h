// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What a moving body B and a fixed body A of space tell at a position p by their convex parts, with witnesses: a
// provider of pair_distances.h.
//   gamma1   sd(p; U, X): from the cover of the overlap set by differences of convex parts;
//   eta1     sd(p; iE, E): from the cover of the complement of E by differences of cells outside A and parts of B;
//   where A is
//            one ball E is an intersection of balls;  delta1: eta1 with the roles exchanged, at -p;
//   gamma2, eta2, delta2: the farthest vertex of X, E, D, flat and single pieces of E and D included;
//   mu       the greatest signed distance to A of a point of B: at a vertex where A is convex, else by search
//   (solid_protrusion.h); of a complement the depth of the deepest point of B in what that leaves.
// Guarantee: signs exact, values right to 2^-40 relative, most of them exact numbers (`proven`). Where a distance is
// not computed for a kind of body it is refused. Lengths in the bodies'
// common steps. Threads: safe. Keywords: signed distance, penetration depth, containment, Hausdorff distance, GJK, EPA.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "distance/answer/answer.h"
#include "distance/search/solid_max_min.h"
#include "distance/solid/pair_distances.h"
#include "plane/base/lazy.h"
#include "space/body/ball_meet.h"
#include "space/body/body.h"
#include "space/body/position_covers.h"

namespace findspace::distance {

class PositionSet;
struct UnionContainers;

/// Of one scale; B is not `outside`.
PairDistances solid_pair(std::shared_ptr<const space::Body> b, std::shared_ptr<const space::Body> a);

/// "B in A" of two bodies that are not `outside`.
class SolidSide : public PairSide {
 public:
  SolidSide(std::shared_ptr<const space::Body> b, std::shared_ptr<const space::Body> a);

  TriedAnswer gap(const space::RealVector& p, Depth depth) const override;
  TriedAnswer reach(const space::RealVector& p) const override;
  TriedAnswer diameter(const space::RealVector& p) const override;
  TriedAnswer fit(const space::RealVector& p) const override;
  TriedAnswer farthest_fit(const space::RealVector& p) const override;
  TriedAnswer protrusion(const space::RealVector& p, Depth depth) const override;
  TriedAnswer clearance(const space::RealVector& p) const override;
  // Of at most kMostNear pairs of parts, or of vertices and parts: solid_pair_within.cpp.
  exact::Interval gap_within(const space::Vector& p) const override;
  exact::Interval reach_within(const space::Vector& p) const override;
  exact::Interval fit_within(const space::Vector& p) const override;
  exact::Interval protrusion_within(const space::Vector& p) const override;
  /// The depth of the deepest point of B + p, which lies in the interior of A.
  TriedAnswer reach_into_parts(const space::RealVector& p) const;

 private:
  /// E, made when first needed.
  struct Fit {
    /// What moves without its radius, where that is taken apart from the cover.
    struct Group {
      space::Body core;
      exact::Real radius;
      space::OpenUnion cover;
    };
    std::vector<space::Extent> places{};    // of a union of several pieces: they hold E
    std::vector<space::OutsideCell> cells;  // of a convex A less a radius
    std::vector<Group> groups;              // one for each radius
    std::optional<space::BallMeet> balls;
    bool round = false;  // the boundary of E is
    bool none = false;   // the moving one is too large
    plane::Lazy<std::shared_ptr<const PositionSet>> boundary;
    std::shared_ptr<const UnionContainers> in_union;  // where the fixed one is a union of round parts
  };

  /// Distances as numbers know them, each made when first needed; empty where they would be too many.
  using Distances = std::vector<ConvexDistance>;
  struct NearFit {
    Distances all;
    bool known = false;  // it is the distance to E, without any where E is empty
  };
  struct Near {
    plane::Lazy<Distances> gap, protrusion;
    plane::Lazy<NearFit> fit;
    double size = 0;  // of the coordinates of both
  };
  static constexpr std::size_t kMostNear = 64;
  NearFit made_near_fit() const;
  exact::Interval about(double value, const space::Vector& p) const;

  const Fit& positions() const {
    return *fit_.of([&] { return made_fit(); });
  }
  std::unique_ptr<Fit> made_fit() const;
  /// Of A, which has no radius.
  const std::vector<space::OutsideCell>& outside_of_fixed() const {
    return outside_.of([&] { return space::outside_cells(*a_); });
  }
  const PositionSet& boundary_of(const Fit& fit) const;
  TriedAnswer to_fit(const space::RealVector& p) const;
  /// Where B + p lies in A, a union of polyhedra: at most 0.
  std::optional<Answer> inside_polyhedra(const space::RealVector& p) const;
  /// The box holds E.
  std::shared_ptr<const UnionContainers> union_containers(const space::Bounds3& box) const;
  /// `outside`: the protrusion of B at p.
  TriedAnswer into_union(const Fit& fit, const space::RealVector& p, const Answer& outside) const;
  static TriedAnswer farthest_in_union(const Fit& fit, const space::RealVector& p);
  /// Minus the distance of B, which lies in A, to what is outside that.
  TriedAnswer depth_inside(const space::RealVector& p) const;
  TriedAnswer round_gap(const space::RealVector& p, Depth depth) const;
  TriedAnswer reach_into_round_parts(const space::RealVector& p) const;

  std::shared_ptr<const space::Body> b_, a_;
  plane::Lazy<std::unique_ptr<const Fit>> fit_;
  plane::Lazy<std::vector<space::OutsideCell>> outside_;
  plane::Lazy<space::OpenUnion> overlap_;
  plane::Lazy<std::shared_ptr<const PositionSet>> round_overlap_;
  Near near_;
};

/// A signed distance at p, whose zero set is nearest at what was found: enclosed where the search for that did not come
/// to its end. `what`: why it is refused where nothing was found by then.
TriedAnswer nearest_value(const space::RealVector& p, const space::NearestOutside& found, int sign, const char* what);

}  // namespace findspace::distance
