// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/rays/ray_directional.h"

#include <algorithm>

#include "distance/rays/ray_covers.h"
#include "distance/rays/ray_signs.h"
#include "distance/rays/round_directional.h"
#include "space/body/union_frontier.h"
#include "space/rays/piece_rays.h"
#include "space/rays/ray_sources.h"
#include "space/rays/swept_pieces.h"

namespace findspace::distance {
namespace {

using exact::Real;
using space::Body;
using space::BodyPart;
using space::ConvexRegion;
using space::HalfSpace;
using space::LinePiece;
using space::RayGrid;
using space::RealVector;
using space::Sweep;
using Source = space::RaySourcePointer;
using TriedSource = exact::Tried<Source>;

/// The positions at which the closed bodies meet, by pairs of parts.
ClosedSets differences(const Body& b, const Body& a) {
  ClosedSets out;
  for (const BodyPart& t : a.parts) {
    for (const BodyPart& s : b.parts) out.regions.push_back({difference_core(t, s), t.radius + s.radius});
  }
  return out;
}

class Directional {
 public:
  Directional(const RealVector& direction, bool both_ways, std::int64_t scale, const RayGrid& grid)
      : way_(direction),
        length_(sqrt(space::dot(direction, direction))),
        unit_(space::scaled(Real(1) / length_, direction)),
        both_ways_(both_ways),
        scale_(scale),
        grid_(grid) {}

  /// gamma1 of the open set that the cover is, its own closed companion being the closures'. Not at level 0.
  Source signed_map(const BodiesOnLines& bodies, BodiesOnLines::Of of, const Real& level) const;
  /// gamma1 below 0 where the set is one region.
  Source depth_map(const GrownRegion& set, const Real& level) const;
  /// The greatest distance to a inside_of closed set.
  Source farthest_map(const ClosedSets& closed, const Real& level) const;
  /// From p at most `reach` along the way: sums of what is met with the way back.
  Source within(const ClosedSets& sets, const Real& reach) const;
  DirectionalQuery query(bool farthest) const { return {unit_, both_ways_, farthest}; }
  const RayGrid& grid() const { return grid_; }

 private:
  Source constant(int sign) const { return space::constant_rays(grid_, sign); }
  Source swept(const ClosedSets& sets, Sweep sweep) const;
  Source farther(const ClosedSets& sets, const Real& level, const Real& most, bool forward) const;

  RealVector way_;  // the direction as it is stated: its coordinates are simpler than those of unit length
  Real length_;
  RealVector unit_;
  bool both_ways_;
  std::int64_t scale_;
  RayGrid grid_;
};

/// The sweep is in lengths.
Source Directional::swept(const ClosedSets& sets, Sweep sweep) const {
  sweep.from = sweep.from / length_;
  sweep.to = sweep.to / length_;
  std::vector<LinePiece> pieces;
  for (const GrownRegion& set : sets.regions) space::add_swept_pieces(set.core, set.radius, sweep, pieces);
  for (const HalfSpace& h : sets.beyond) pieces.push_back(space::swept_piece(h, sweep));
  return std::make_unique<space::PieceRays>(pieces, scale_, grid_);
}

Source Directional::within(const ClosedSets& sets, const Real& reach) const {
  return both_ways_ ? swept(sets, {way_, -reach, reach, false, false})
                    : swept(sets, {way_, -reach, Real(), false, true});
}

Source Directional::signed_map(const BodiesOnLines& bodies, BodiesOnLines::Of of, const Real& level) const {
  if (level.sign() > 0) return within(closures(bodies.cover(of)), level);
  return space::negated_rays(within(bodies.rest(of), -level));
}

/// The set and where it is moved by the depth have to hold the position: inside of the convex set is all between.
Source Directional::depth_map(const GrownRegion& set, const Real& level) const {
  std::vector<LinePiece> whole{space::whole_piece(set.core)};
  if (set.radius.sign() > 0) add_round_pieces(set.core, set.radius, whole);
  std::vector<Source> all;
  const auto add_moved = [&](const Real& by) {
    std::vector<LinePiece> pieces;
    for (const LinePiece& piece : whole) pieces.push_back(moved(piece, space::scaled(by, unit_)));
    all.push_back(std::make_unique<space::PieceRays>(pieces, scale_, grid_));
  };
  add_moved(Real());
  add_moved(level);
  if (both_ways_) add_moved(-level);
  return space::combined_rays(std::move(all), [](std::span<const std::int8_t> s) {
    return s[0] < 0 ? *std::max_element(s.begin(), s.end()) : std::int8_t(1);
  });
}

/// +1 where the set is met farther off than the level, 0 where not but at the level, -1 elsewhere.
Source Directional::farther(const ClosedSets& sets, const Real& level, const Real& most, bool forward) const {
  return space::negated_rays(forward ? swept(sets, {way_, -most, -level, true, false})
                                     : swept(sets, {way_, level, most, false, true}));
}

Source Directional::farthest_map(const ClosedSets& closed, const Real& level) const {
  if (level.sign() < 0 || closed.regions.empty()) return constant(1);
  // A position that meets the set within the level meets nothing of it farther off than the level and its extent.
  Real extent, radius;
  const ConvexRegion::Vertex& first = closed.regions[0].core.vertices()[0];
  for (const GrownRegion& set : closed.regions) {
    radius = std::max(radius, set.radius);
    for (const ConvexRegion::Vertex& v : set.core.vertices()) {
      for (std::size_t k = 0; k < 3; ++k) extent = std::max(extent, abs(v.at[k] - first.at[k]));
    }
  }
  const Real most = Real(2) * level + Real(6) * extent + Real(4) * radius + Real(1);
  std::vector<Source> all;
  if (level.sign() > 0) {
    all.push_back(within(closed, level));
  } else {
    // At level 0 only what is met at once counts.
    std::vector<LinePiece> pieces;
    for (const GrownRegion& set : closed.regions) {
      pieces.push_back(space::whole_piece(set.core));
      if (set.radius.sign() > 0) add_round_pieces(set.core, set.radius, pieces);
    }
    all.push_back(space::mapped_rays(std::make_unique<space::PieceRays>(pieces, scale_, grid_),
                                     [](int s) { return s <= 0 ? 0 : 1; }));
  }
  all.push_back(farther(closed, level, most, true));
  if (both_ways_) all.push_back(farther(closed, level, most, false));
  return space::greatest_rays(std::move(all));
}

/// Of eta1 and eta2, A inside_of.
bool fit_by_values(const Body& b, const Body& a) { return a.round() || (b.round() && !a.convex()); }

/// B in A, or A in B where the positions are those of D; neither is a complement.
TriedSource fit(const Directional& maker, const BodiesOnLines& bodies, BodiesOnLines::Of of, const Real& level,
                bool farthest) {
  const bool back = of == BodiesOnLines::Of::kOutsideBack;
  const Body b = back ? mirrored(bodies.a()) : bodies.b(), a = back ? mirrored(bodies.b()) : inside_of(bodies.a());
  if (fit_by_values(b, a)) return round_fit_map(level, maker.query(farthest), b, a, maker.grid());
  if (bodies.cover(of).all) return space::constant_rays(maker.grid(), 1);
  return farthest ? maker.farthest_map(bodies.rest(of), level)
                  : space::negated_rays(maker.signed_map(bodies, of, -level));
}

/// Of a bounded A.
Source gamma(const Directional& maker, const BodiesOnLines& bodies, const Real& level, bool farthest) {
  const Body &b = bodies.b(), &a = bodies.a();
  if (a.round() || b.round()) {
    const ClosedSets closed = differences(b, a);
    if (farthest) return maker.farthest_map(closed, level);
    if (level.sign() > 0) return maker.within(closed, level);
    if (closed.regions.size() == 1) return maker.depth_map(closed.regions[0], level);
    return round_depth_map(level, maker.query(false), b, a, maker.grid());
  }
  constexpr auto kOverlap = BodiesOnLines::Of::kOverlap;
  return farthest ? maker.farthest_map(closures(bodies.cover(kOverlap)), level)
                  : maker.signed_map(bodies, kOverlap, level);
}

TriedSource negated(TriedSource rays) { return rays ? space::negated_rays(*std::move(rays)) : std::move(rays); }

}  // namespace

TriedSource ray_directional_map(Which which, const Real& level, const RealVector& direction, bool both_ways,
                                const BodiesOnLines& bodies, const RayGrid& grid) {
  using Of = BodiesOnLines::Of;
  const bool farthest = which == Which::kGamma2 || which == Which::kEta2 || which == Which::kDelta2;
  if (!farthest && level.sign() == 0) return ray_sign_map(which, level, bodies.b(), bodies.a(), grid);
  const bool outside = bodies.a().outside;
  if (outside && farthest) return space::constant_rays(grid, 1);
  const Directional maker(direction, both_ways, bodies.b().scale, grid);
  // Inside and outside of A exchanged eta1 is -gamma1.
  switch (which) {
    case Which::kGamma1:
    case Which::kGamma2:
      if (outside) return negated(fit(maker, bodies, Of::kOutside, -level, false));
      return gamma(maker, bodies, level, farthest);
    case Which::kEta1:
    case Which::kEta2:
      if (outside)
        return space::negated_rays(gamma(maker, BodiesOnLines(bodies.b(), inside_of(bodies.a())), -level, false));
      return fit(maker, bodies, Of::kOutside, level, farthest);
    default:
      // A in B + p is -A + p in -B.
      if (outside) return space::constant_rays(grid, 1);
      return fit(maker, bodies, Of::kOutsideBack, level, farthest);
  }
}

}  // namespace findspace::distance
