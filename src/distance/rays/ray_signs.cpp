// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/rays/ray_signs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "distance/planar/shape_pair.h"
#include "distance/rays/protrusion_rays.h"
#include "distance/rays/ray_covers.h"
#include "distance/rays/value_rays.h"
#include "distance/search/solid_protrusion.h"
#include "distance/solid/far_corners.h"
#include "distance/solid/solid_pair.h"
#include "space/body/position_covers.h"
#include "space/body/union_frontier.h"
#include "space/body/wall_bridges.h"
#include "space/rays/piece_rays.h"
#include "space/rays/ray_sources.h"

namespace findspace::distance {

using exact::Real;
using space::Body;
using space::BodyPart;
using space::ConvexRegion;
using space::HalfSpace;
using space::LinePiece;
using space::PieceRays;
using space::RayGrid;
using space::real;
using space::RealVector;
using Source = space::RaySourcePointer;
using Signs = std::span<const std::int8_t>;

namespace {

/// The maps of the five distances that the others follow from.
class RaySignMaker {
 public:
  RaySignMaker(const space::Body& b, const space::Body& a, const space::RayGrid& grid)
      : b_(b), a_(a), grid_(grid), scale_(b.scale) {}

  space::RaySourcePointer gamma1(const exact::Real& level) const;
  space::RaySourcePointer eta1(const exact::Real& level) const;
  space::RaySourcePointer eta2(const exact::Real& level) const;
  space::RaySourcePointer mu(const exact::Real& level) const;
  space::RaySourcePointer gamma2(const exact::Real& level) const;

 private:
  space::RaySourcePointer constant(int sign) const { return space::constant_rays(grid_, sign); }
  space::RaySourcePointer rays(std::vector<space::LinePiece> pieces,
                               space::PieceRays::Of of = space::PieceRays::Of::kUnion) const {
    space::drop_repeated(pieces);
    return std::make_unique<space::PieceRays>(pieces, scale_, grid_, of);
  }
  space::RaySourcePointer values(Which which, const exact::Real& level) const;
  space::RaySourcePointer balls(const std::vector<std::pair<space::RealVector, exact::Real>>& all) const;
  /// The sign of the signed distance to the cover (negative inside) less a level.
  space::RaySourcePointer cover(const RayCover& cover, const exact::Real& level) const;
  space::RaySourcePointer convex_gap(const space::BodyPart& b, const space::BodyPart& a,
                                     const exact::Real& grown) const;
  space::RaySourcePointer mu_of_vertices(const space::BodyPart& b, const exact::Real& level) const;
  /// `further`: sets within A.
  space::RaySourcePointer vertices_near(const exact::Real& level, std::span<const space::WallBridge> further) const;
  void add_near(const space::BodyPart& t, const space::BodyPart& s, const exact::Real& level,
                std::vector<space::LinePiece>& pieces) const;

  const space::Body &b_, &a_;
  space::RayGrid grid_;
  std::int64_t scale_;
};

std::vector<HalfSpace> shifted(std::vector<HalfSpace> planes, const Real& inward) {
  for (HalfSpace& h : planes) h = HalfSpace(h.normal, h.offset + inward * sqrt(space::dot(h.normal, h.normal)));
  return planes;
}

/// The positions at which the point is in the set, as deep as that.
LinePiece holding_piece(const space::WallBridge& set, const space::Point& v, const Real& depth) {
  std::vector<HalfSpace> planes;
  for (const HalfSpace& h : set.planes) planes.emplace_back(h.normal, h.offset + space::dot(h.normal, real(v)));
  const space::Vector by = exact::approx(v);
  return space::polytope_piece(shifted(std::move(planes), depth), set.extent.low - by, set.extent.high - by);
}

/// To a convex set a body has the distance of its hull. Without radii.
BodyPart hull_of(const Body& body) {
  std::vector<space::Point> points;
  for (const BodyPart& part : body.parts) points.insert(points.end(), part.vertices().begin(), part.vertices().end());
  return space::part_of(points, Real());
}

Source RaySignMaker::cover(const RayCover& cover, const Real& level) const {
  std::vector<LinePiece> sets;
  for (std::size_t k = 0; k < cover.sets.size(); ++k)
    sets.push_back(space::polytope_piece(cover.sets[k], cover.extents[k].low, cover.extents[k].high));
  if (level.sign() == 0) return rays(std::move(sets));
  std::vector<LinePiece> near;
  for (const ConvexRegion& piece : space::cover_frontier(cover.sets, cover.low, cover.high))
    add_round_pieces(piece, abs(level), near);
  std::vector<Source> both;
  both.push_back(rays(std::move(sets)));
  both.push_back(rays(std::move(near)));
  if (level.sign() > 0)
    return space::combined_rays(std::move(both), [](Signs s) { return s[0] < 0 ? std::int8_t(-1) : s[1]; });
  return space::combined_rays(std::move(both), [](Signs s) { return std::int8_t(s[0] < 0 ? -s[1] : 1); });
}

Source RaySignMaker::values(Which which, const Real& level) const { return by_values_map(which, level, b_, a_, grid_); }

Source RaySignMaker::balls(const std::vector<std::pair<RealVector, Real>>& all) const {
  std::vector<LinePiece> pieces;
  for (const auto& [center, radius] : all) {
    if (radius.sign() < 0) return constant(1);
    pieces.push_back(space::ball_piece(center, radius));
  }
  return rays(std::move(pieces), PieceRays::Of::kIntersection);
}

/// The difference of two parts, whose radii are in `grown`, grown (or shrunk) by that.
Source RaySignMaker::convex_gap(const BodyPart& b, const BodyPart& a, const Real& grown) const {
  std::vector<HalfSpace> planes = space::difference_planes(a, b);
  const space::Extent extent = space::difference_extent(a, b);
  if (planes.empty()) return balls({{real(a.center - b.center), grown}});
  return rays({space::polytope_piece(shifted(std::move(planes), -grown), extent.low, extent.high)});
}

Source RaySignMaker::gamma1(const Real& level) const {
  if (a_.outside) {
    Body parts = a_;
    parts.outside = false;
    return space::negated_rays(RaySignMaker(b_, parts, grid_).eta1(-level));
  }
  if (by_values(Which::kGamma1, level, b_, a_)) return values(Which::kGamma1, level);
  if (a_.parts.size() == 1 && b_.parts.size() == 1) {
    const Real grown = a_.parts[0].radius + b_.parts[0].radius + level;
    if (grown.sign() <= 0) return convex_gap(b_.parts[0], a_.parts[0], grown);
  }
  if (level.sign() < 0 && !(a_.parts.size() == 1 && b_.parts.size() == 1)) return cover(overlap_sets(b_, a_), level);
  std::vector<LinePiece> pieces;
  for (const BodyPart& t : a_.parts) {
    for (const BodyPart& s : b_.parts) add_near(t, s, level, pieces);
  }
  return rays(std::move(pieces));
}

/// What is nearer to the difference of two parts than the level and their radii; where these are less than 0, what is
/// as deep in it.
void RaySignMaker::add_near(const BodyPart& t, const BodyPart& s, const Real& level,
                            std::vector<LinePiece>& pieces) const {
  std::vector<HalfSpace> planes = space::difference_planes(t, s);
  const Real grown = t.radius + s.radius + level;
  if (grown.sign() < 0) planes = shifted(std::move(planes), -grown);
  if (!planes.empty()) {
    const space::Extent extent = space::difference_extent(t, s);
    pieces.push_back(space::polytope_piece(std::move(planes), extent.low, extent.high));
  }
  if (grown.sign() > 0) add_round_pieces(difference_core(t, s), grown, pieces);
}

Source RaySignMaker::eta1(const Real& level) const {
  if (a_.outside) {
    Body parts = a_;
    parts.outside = false;
    return space::negated_rays(RaySignMaker(b_, parts, grid_).gamma1(-level));
  }
  if (by_values(Which::kEta1, level, b_, a_)) return values(Which::kEta1, level);
  if (a_.round()) {
    if (level.sign() > 0 && a_.convex()) {
      if (const auto plain = without_radius(b_, a_))
        return RaySignMaker(plain->first, plain->second, grid_).eta1(level);
    }
    if (a_.convex() && (level.sign() <= 0 || (b_.convex() && a_.parts[0].point() && b_.parts[0].point()))) {
      const Real tolerance = a_.parts[0].radius - b_.parts[0].radius;
      const bool never = b_.convex() && a_.parts[0].point() && b_.parts[0].point() && tolerance.sign() < 0;
      return never ? constant(1) : mu(level);
    }
    return mu(level);  // at level 0: of what has no interior they have the same sign
  }
  const RayCover complement = outside_sets(b_, a_);
  if (complement.all) return constant(1);
  if (!b_.round() || a_.convex()) return space::negated_rays(cover(complement, -level));
  // Each part has to fit: its core, deeper than its radius.
  std::vector<Source> all;
  for (const BodyPart& part : b_.parts) {
    Body core;
    core.scale = b_.scale;
    core.parts.push_back(part);
    core.parts[0].radius = Real();
    all.push_back(space::negated_rays(cover(outside_sets(core, a_), part.radius - level)));
  }
  return space::greatest_rays(std::move(all));
}

/// The frontier of E holds the vertices of its hull.
Source RaySignMaker::eta2(const Real& level) const {
  if (a_.outside) return constant(1);
  if (by_values(Which::kEta2, level, b_, a_)) return values(Which::kEta2, level);
  std::vector<std::pair<RealVector, Real>> all;
  if (a_.round()) {
    if (const auto plain = without_radius(b_, a_); plain && !a_.parts[0].point())
      return RaySignMaker(plain->first, plain->second, grid_).eta2(level);
    const Real tolerance = a_.parts[0].radius - b_.parts[0].radius;
    if (tolerance.sign() < 0) return constant(1);
    all.emplace_back(real(a_.parts[0].center - b_.parts[0].center), level - tolerance);
    return balls(all);
  }
  const RayCover complement = outside_sets(b_, a_);
  if (complement.all) return constant(1);
  for (const ConvexRegion& piece : space::cover_frontier(complement.sets, complement.low, complement.high)) {
    for (const ConvexRegion::Vertex& v : piece.vertices()) all.emplace_back(v.at, level);
  }
  return all.empty() ? constant(1) : balls(all);
}

/// Against a convex A: the part's vertices and radius, {p : p + v within `level` of A for all v}.
Source RaySignMaker::mu_of_vertices(const BodyPart& b, const Real& level) const {
  const BodyPart& a = a_.parts[0];
  const Real reach = level + a.radius - b.radius;
  if (a.point()) {
    std::vector<std::pair<RealVector, Real>> all;
    for (const space::Point& v : b.vertices()) all.emplace_back(real(a.center - v), reach);
    return balls(all);
  }
  BodyPart point;
  BodyPart core = a;
  core.radius = Real();
  std::vector<Source> all;
  if (reach.sign() > 0) {
    const Body convex{{core}, false, a_.scale, 0, 0};
    for (const space::Point& v : b.vertices()) {
      Body corner;
      corner.scale = a_.scale;
      point.center = v;
      corner.parts.push_back(point);
      all.push_back(RaySignMaker(corner, convex, grid_).gamma1(reach));
    }
    return space::greatest_rays(std::move(all));
  }
  std::vector<HalfSpace> planes;
  for (const HalfSpace& p : core.planes()) {
    const RealVector& n = p.normal;
    BodyPart plain = b;
    plain.radius = Real();
    planes.emplace_back(n, p.offset + support(plain, n) - reach * sqrt(space::dot(n, n)));
  }
  return rays({space::polytope_piece(std::move(planes), space::everywhere().low, space::everywhere().high)});
}

/// The sign of the greatest distance of a vertex of B to A, less the level.
Source RaySignMaker::vertices_near(const Real& level, std::span<const space::WallBridge> further) const {
  std::vector<Source> all;
  BodyPart corner;
  std::vector<space::Point> seen;
  for (const BodyPart& part : b_.parts) {
    for (const space::Point& v : part.vertices()) {
      if (std::find(seen.begin(), seen.end(), v) != seen.end()) continue;
      seen.push_back(v);
      corner.center = v;
      std::vector<LinePiece> pieces;
      for (const BodyPart& t : a_.parts) add_near(t, corner, level, pieces);
      for (const space::WallBridge& set : further) pieces.push_back(holding_piece(set, v, -level));
      all.push_back(rays(std::move(pieces)));
    }
  }
  return space::greatest_rays(std::move(all));
}

Source RaySignMaker::mu(const Real& level) const {
  if (a_.convex()) {
    if (b_.parts.size() > 1 && !b_.round()) return mu_of_vertices(hull_of(b_), level);
    std::vector<Source> all;
    for (const BodyPart& part : b_.parts) all.push_back(mu_of_vertices(part, level));
    return space::greatest_rays(std::move(all));
  }
  if (level.sign() < 0 || (level.sign() == 0 && (a_.outside || !a_.round()))) return eta1(level);
  if (by_values(Which::kMu, level, b_, a_)) return values(Which::kMu, level);
  // What lies across a wall between parts is in none of them; it counts where they are not grown.
  std::vector<space::WallBridge> across;
  if (level.sign() == 0) across = space::wall_bridges(a_);
  return std::make_unique<ProtrusionRays>(
      protrusion_parts(b_), field_of_parts(a_, across), level,
      [&](const Real& l) { return stretches_of(vertices_near(l, across)); }, grid_, static_cast<double>(scale_));
}

Source RaySignMaker::gamma2(const Real& level) const {
  if (a_.outside) return constant(1);
  std::vector<std::pair<RealVector, Real>> all;
  for (const BodyPart& t : a_.parts) {
    for (const BodyPart& s : b_.parts) {
      for (const space::Point& v : t.vertices()) {
        for (const space::Point& w : s.vertices()) all.emplace_back(real(v - w), level - t.radius - s.radius);
      }
    }
  }
  return balls(all);
}

}  // namespace

Source ray_sign_map(Which which, const Real& level, const Body& b, const Body& a, const RayGrid& grid) {
  const auto plus = [&] { return space::constant_rays(grid, 1); };
  if (const auto cut = cut_off_of(which)) {
    if (level.sign() < 0) return plus();
    return space::cut_off_rays(ray_sign_map(cut->base, cut->negated ? -level : level, b, a, grid), cut->negated, level);
  }
  // A in B + p is -A + p in -B.
  const Body back_b = mirrored(a), back_a = mirrored(b);
  const RaySignMaker forth(b, a, grid), back(back_b, back_a, grid);
  switch (which) {
    case Which::kGamma1:
      return forth.gamma1(level);
    case Which::kGamma2:
      return forth.gamma2(level);
    case Which::kEta1:
      return forth.eta1(level);
    case Which::kEta2:
      return forth.eta2(level);
    case Which::kDelta1:
      return a.outside ? plus() : back.eta1(level);
    case Which::kDelta2:
      return a.outside ? plus() : back.eta2(level);
    case Which::kMu:
      return forth.mu(level);
    case Which::kMuBack:
      return a.outside ? plus() : back.mu(level);
    case Which::kHausdorff: {
      if (a.outside || level.sign() < 0) return plus();
      std::vector<Source> both;
      both.push_back(forth.mu(level));
      both.push_back(back.mu(level));
      return space::greatest_rays(std::move(both));
    }
    case Which::kDiameter: {
      if (a.outside) return plus();
      const Real own = std::max(diameter(a), diameter(b));
      if (level < own) return plus();
      const int least = compare(own, level);  // not above
      return space::mapped_rays(forth.gamma2(level), [least](int s) { return std::max(s, least); });
    }
    default:
      break;
  }
  return plus();
}

}  // namespace findspace::distance
