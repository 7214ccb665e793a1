// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What a moving body B and a fixed body A of space tell at a position p by their convex parts, with witnesses: all that
// pair_distances.h asks.
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
#include <mutex>
#include <optional>
#include <vector>

#include "distance/answer/answer.h"
#include "distance/solid/pair_distances.h"
#include "space/body/ball_meet.h"
#include "space/body/body.h"
#include "space/body/position_covers.h"

namespace findspace::distance {

class PositionSet;
struct UnionContainers;

class SolidPair : public PairDistances {
 public:
  /// Both of one scale; B is not `outside`.
  SolidPair(std::shared_ptr<const space::Body> b, std::shared_ptr<const space::Body> a);

 private:
  /// "moving in fixed": E of a body in another, made when first needed.
  struct Fit {
    /// What moves without its radius, where that is taken apart from the cover.
    struct Group {
      space::Body core;
      exact::Real radius;
      space::OpenUnion cover;
    };
    std::vector<space::OutsideCell> cells;
    std::vector<Group> groups;  // one for each radius
    std::optional<space::BallMeet> balls;
    bool round = false;  // the boundary of E is
    bool none = false;   // the moving one is too large
    mutable std::once_flag level_made;
    mutable std::shared_ptr<const PositionSet> boundary;
    std::shared_ptr<const UnionContainers> in_union;  // where the fixed one is a union of round parts
  };
  struct Side {  // one of the two as moving, the other as fixed
    const space::Body* moving = nullptr;
    const space::Body* fixed = nullptr;
    mutable std::once_flag made;
    mutable std::unique_ptr<Fit> fit;
  };

  const Fit& fit_of(const Side& side) const;
  static std::unique_ptr<Fit> made_fit(const Side& side);
  static const PositionSet& boundary_of(const Side& side, const Fit& fit);
  TriedAnswer contained(const Side& side, const space::RealVector& p) const;
  /// Where B + p lies in A, a union of polyhedra: at most 0.
  std::optional<Answer> inside_polyhedra(const Side& side, const space::RealVector& p) const;
  TriedAnswer farthest_in(const Side& side, const space::RealVector& p) const;
  /// The box holds E.
  static std::shared_ptr<const UnionContainers> union_containers(const space::Body& b, const space::Body& a,
                                                                 const space::Bounds3& box);
  /// `outside`: the protrusion of the moving body at p.
  TriedAnswer into_union(const Side& side, const Fit& fit, const space::RealVector& p, const Answer& outside) const;
  static TriedAnswer farthest_in_union(const Fit& fit, const space::RealVector& p);
  /// max(0, -eta1), also where eta1 is not computed.
  TriedAnswer clearance_inside(const Side& side, const space::RealVector& p) const;
  /// Minus the distance of the moving body, which lies in the fixed one, to what is outside that.
  static exact::Tried<Answer> depth_inside(const Side& side, const space::RealVector& p);
  exact::Tried<Answer> gap_of_parts(const space::RealVector& p, Depth depth) const;
  exact::Tried<Answer> round_gap(const space::RealVector& p, Depth depth) const;
  Answer reach_of_parts(const space::RealVector& p) const;
  exact::Tried<Answer> protrusion_of(const Side& side, const space::RealVector& p, Depth depth) const;
  exact::Tried<Answer> reach_into_parts(const space::RealVector& p) const;
  Answer reach_into_round_parts(const space::RealVector& p) const;
  /// What `ask` says of the side and the position as seen from it; undefined of what lies in A's complement.
  template <class Ask>
  TriedAnswer seen(Inner inner, const space::RealVector& p, const Ask& ask) const;

  TriedAnswer gap(const space::RealVector& p, Depth depth) const override;
  TriedAnswer reach(const space::RealVector& p) const override;
  TriedAnswer diameter(const space::RealVector& p) const override;
  TriedAnswer fit(Inner inner, const space::RealVector& p) const override;
  TriedAnswer farthest_fit(Inner inner, const space::RealVector& p) const override;
  TriedAnswer protrusion(Inner inner, const space::RealVector& p, Depth depth) const override;
  TriedAnswer clearance(Inner inner, const space::RealVector& p) const override;

  std::shared_ptr<const space::Body> b_, a_;  // a_ without its `outside`
  bool outside_ = false;
  Side forth_, back_;
  mutable std::once_flag overlap_made_;
  mutable std::unique_ptr<space::OpenUnion> overlap_;
  mutable std::once_flag round_overlap_made_;
  mutable std::shared_ptr<const PositionSet> round_overlap_;
};

/// max |v - w| + radii over two points of the body.
exact::Real diameter(const space::Body& body);

}  // namespace findspace::distance
