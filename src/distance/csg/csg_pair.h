// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// T-distances of a body B and a solid A that round ones are cut out of (csg_solid.h), at a position of either:
//   gamma1, d1, penetration
//                   the depth by search (csg_positions.cpp);
//   gamma2
//   eta1, dstar     of B in A by its containers and obstacles: E is what fits into every container and meets no
//   obstacle; mu, h           of B to A as eta1 where B + p lies in A, else by set_protrusion.h; hausdorff where the
//   other one is known; eta2;
//                   in unions of such, and where a container is not convex, eta1 and eta2 by what A leaves of a box: B
//                   is in A where it is free of that;
//   delta1, delta2, mu of A to B + p   of a polytope B by how far A reaches along its normals, of a union of polytopes
//   by what that leaves, of a round part by the places of A that are farthest out, of a union of such between ends;
//   diameter   exact where two places of A are as far from each other as two of the sets that hold it, else enclosed;
//   least values (csg_least)   gamma1 and eta1 by the deepest place of a set of positions, others as solid_least.h;
//   along a direction eta1 by what B covers on its way, gamma1 between what holds A and the lines that are tried.
// Guarantee: distances from and to places on one sphere or on the polyhedra are exact, others found by search
// (boundary_search.h; `proven` false, `error`). Whether B + p lies in A is decided exactly. What is not computed is
// refused; so is what walls in parts of A (CsgSolid::walls) may change. Threads: safe. Keywords: bowl, spherical
// cavity, dome, lens, containment.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "distance/csg/csg_part.h"
#include "distance/rays/near_rays.h"
#include "distance/rays/swept_fits.h"
#include "distance/rays/value_rays.h"
#include "distance/search/position_set.h"
#include "distance/solid/solid_pair.h"
#include "plane/base/lazy.h"
#include "space/body/csg_solid.h"

namespace findspace::distance {

/// Why: its parts may hold walls.
exact::Refusal left_walls();

/// "B in A": a provider of pair_distances.h.
class CsgSide : public PairSide {
 public:
  /// Both of one scale, B bounded.
  CsgSide(std::shared_ptr<const space::Body> b, std::shared_ptr<const space::CsgSolid> a);

  TriedAnswer gap(const space::RealVector& p, Depth depth) const override;
  TriedAnswer reach(const space::RealVector& p) const override;
  TriedAnswer diameter(const space::RealVector& p) const override;
  TriedAnswer fit(const space::RealVector& p) const override;
  TriedAnswer farthest_fit(const space::RealVector& p) const override;
  TriedAnswer protrusion(const space::RealVector& p, Depth depth) const override;
  TriedAnswer clearance(const space::RealVector& p) const override;
  double protrudes_at_most(const space::RealVector& p) const override;

  /// A least value, with its position, where the deepest place of a set of positions says it; nothing where none does.
  TriedAnswer least_gap() const;
  TriedAnswer least_fit() const;
  /// A position at which the two meet.
  exact::Tried<space::RealVector> meeting() const;
  /// Whether B fits somewhere.
  exact::Tried<SweptFit> fits_somewhere() const;
  /// The least gamma1 along a direction, for B that moves.
  static TriedAnswer least_gap_along(const std::shared_ptr<const CsgSide>& side, const space::RealVector& direction,
                                     bool both_ways);
  /// Of A alone.
  const TriedAnswer& own_diameter() const {
    return diameter_.of([&] { return made_diameter(); });
  }

  const space::Body& complete() const { return *b_; }
  const space::CsgSolid& cut() const { return *a_; }
  /// What the distance less the level is between, or another function of the same sign that no step changes by more
  /// than its length; an empty one where the value is to tell. Not of gamma1.
  std::optional<TriedBetween> nearly(Which which, double level, const space::RealVector& p) const;
  /// The distance less the level, or another function of the same sign, along lines of that direction; null where
  /// `between` is to tell. What is said of gamma1 at levels below 0 has the opposite sign.
  static std::unique_ptr<const NearRule> nearness(std::shared_ptr<const CsgSide> side, Which which, double level,
                                                  const space::Vector& unit, const NearRange& range);

 private:
  friend class CsgBackSide;
  class GapNear;
  class FreeNear;
  /// B + p and A are apart by `value`, or, if `depth` is more than 0, their interiors meet.
  struct Gap {
    Answer value;
    double depth = 0;
  };

  exact::Tried<Gap> gap_at(const space::RealVector& p) const;
  bool away(const Answer& apart) const;
  /// The slack of what the two have in common; 0 where it is at most `enough` of the sizes.
  exact::Tried<double> common_depth(const space::RealVector& p, double enough) const;
  TriedAnswer apart(const space::RealVector& p) const;
  Between nearly_apart(const space::RealVector& p, double level) const;
  /// The positions at which B is free of A.
  const exact::Tried<PositionSet>& free() const {
    return free_.of([&] { return free_positions(*b_, parts_, size_); });
  }
  TriedAnswer overlapping(const space::RealVector& p) const;
  std::optional<Answer> free_of_sets(const space::RealVector& p) const;
  std::optional<Answer> least_gap_to_container() const;
  /// Of A.
  Answer named_reach(const space::CsgPart& part, const space::RealVector& from, const BoundaryPlace& found) const;
  bool by_containers() const;
  TriedAnswer worst_fit(const space::RealVector& p) const;
  exact::Tried<bool> is_whole(const Answer& worst) const;
  /// Without containers: by what A leaves of a box.
  struct Among;
  using TriedAmong = exact::Tried<std::shared_ptr<const Among>>;
  TriedAmong made_among() const;
  /// Null: B is larger than the box about A.
  const TriedAmong& among() const {
    return among_.of([&] { return made_among(); });
  }
  static TriedAnswer inside_among(const Among& all, const space::RealVector& p);
  static TriedAnswer fit_among(const Among& all, const space::RealVector& p);
  static TriedAnswer farthest_among(const Among& all, const space::RealVector& p);
  /// Of a polyhedral body and a solid that moves against it, at positions of the body in that box; both of one scale.
  static TriedAmong among_cells(const space::Body& fixed, const space::CsgSolid& moving, const space::Bounds3& places);
  TriedAnswer contained_in_union(const space::RealVector& p) const;
  TriedAnswer inside_union(const space::RealVector& p) const;
  TriedAnswer in_union(const space::RealVector& p,
                       TriedAnswer (*among_all)(const Among& all, const space::RealVector& p)) const;
  TriedAnswer farthest_in_union(const space::RealVector& p) const;
  TriedBetween nearly_in_union(const space::RealVector& p, double level) const;
  TriedBetween nearly_fits(const space::RealVector& p, double level) const;
  using TriedFits = exact::Tried<std::optional<PositionSet>>;
  TriedFits made_fits() const;
  /// With containers; nothing: nothing fits.
  const TriedFits& fits() const {
    return fits_.of([&] { return made_fits(); });
  }
  std::vector<NearSet> near_sets() const;
  space::Body holding_sets() const;
  bool holds_ends(const Answer& widest, const space::Body& sets) const;
  TriedAnswer made_diameter() const;
  /// Of B + p out of A, where it is not in A.
  TriedAnswer protrusion_out(const space::RealVector& p) const;
  /// Less the level; as near as tells about how far it is from that.
  TriedBetween nearly_protrudes(const space::RealVector& p, double level) const;

  std::shared_ptr<const space::Body> b_;
  std::shared_ptr<const space::CsgSolid> a_;
  std::vector<CsgPartSearch> parts_;
  std::vector<PairDistances> containers_, obstacles_;
  double size_ = 1;
  bool point_ = false, points_ = false;  // B is a single one, or has one among its parts
  plane::Lazy<TriedAnswer> diameter_;
  plane::Lazy<TriedFits> fits_;
  plane::Lazy<exact::Tried<PositionSet>> free_;
  plane::Lazy<TriedAmong> among_;
};

/// B moves, or with `cut_moves` A.
PairDistances csg_pair(std::shared_ptr<const CsgSide> side, bool cut_moves);
/// As solid_least().
TriedAnswer csg_least(Which which, const std::shared_ptr<const CsgSide>& side, bool cut_moves);
/// The same along a direction, as ray_directional_least().
TriedAnswer csg_directional_least(Which which, const std::shared_ptr<const CsgSide>& side, bool cut_moves,
                                  const space::RealVector& direction, bool both_ways);
/// As CsgSide::nearly, or by the value.
TriedBetween between(const std::shared_ptr<const CsgSide>& side, Which which, const exact::Real& level,
                     const space::RealVector& p);

/// The map on lines, with B moving; the level in steps of the scale of both. Rows are refused where values do not say
/// the sign.
std::unique_ptr<space::RaySource> cut_map(Which which, const exact::Real& level, std::shared_ptr<const CsgSide> side,
                                          std::int64_t scale, const space::RayGrid& grid);

/// A direction along which B may go, both ways or one way.
struct AlongWay {
  space::RealVector direction;
  bool both = true;
};
/// The same of a distance along a direction, by what B covers on its way: gamma1 at levels from 0 on, gamma2 and what
/// follows; null for others.
std::unique_ptr<space::RaySource> cut_map_along(Which which, const exact::Real& level, const AlongWay& way,
                                                std::shared_ptr<const CsgSide> side, std::int64_t scale,
                                                const space::RayGrid& grid);

}  // namespace findspace::distance
