// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "formula/solid/surface_rays.h"

#include <algorithm>

#include "plane/base/stage_observer.h"
#include "space/convolution/facet_rays.h"
#include "space/convolution/ray_ball.h"
#include "space/convolution/ray_pair.h"
#include "space/phi/contact_surface.h"
#include "space/rays/piece_rays.h"

namespace findspace::formula {

using exact::Real;
using space::BallRays;
using space::PairRays;
using space::Point;
using space::RayGrid;
using space::RayRow;
using space::RaySolid;
using space::RaySource;

namespace {

bool large(const std::vector<RaySolid>& a, const std::vector<RaySolid>& b) {
  const auto faces = [](const std::vector<RaySolid>& all) {
    std::size_t sum = 0;
    for (const RaySolid& s : all) sum += s.surface.faces.size();
    return sum;
  };
  return faces(a) * faces(b) > kFewPairs;
}

/// The sign of gamma1(b + p, a) - level, where surfaces answer it.
std::unique_ptr<RaySource> gap(const RaySolid& b, const RaySolid& a, const Real& level, bool many,
                               const RayGrid& grid) {
  if (b.ball() && a.ball()) return nullptr;
  if (!b.ball() && !a.ball()) {
    if (level.sign() == 0) return std::make_unique<PairRays>(a.surface, b.surface, grid);
    return level.sign() > 0 && many ? space::clearance_rays(a.surface, b.surface, level, grid) : nullptr;
  }
  const Real radius = (b.ball() ? b.radius : a.radius) + level;
  // Deeper than the surface the positions are not a body grown by a ball.
  if (level.sign() < 0 || radius.sign() <= 0) return nullptr;
  // |c + p - x| for x in a, or |c - p - x| for x in b: the distance of p to a - c, or to c - b.
  return std::make_unique<BallRays>(
      b.ball() ? space::moved(a.surface, -b.center) : space::moved(space::scaled(b.surface, -1), a.center), radius,
      grid);
}

/// The sign of eta1(b + p, a) - level, where surfaces answer it.
std::unique_ptr<RaySource> containment(const RaySolid& b, const RaySolid& a, const Real& level, bool many,
                                       const RayGrid& grid) {
  if (a.ball() || a.inner_walls) return nullptr;
  if (!b.ball()) {
    if (level.sign() == 0) return std::make_unique<PairRays>(a.surface, b.surface, grid, PairRays::Side::kComplement);
    if (level.sign() > 0 || !many) return nullptr;
    return space::clearance_rays(a.surface, b.surface, -level, grid, PairRays::Side::kComplement);
  }
  if (level.sign() > 0 || (b.radius - level).sign() <= 0) return nullptr;
  return std::make_unique<BallRays>(space::moved(a.surface, -b.center), b.radius - level, grid,
                                    BallRays::Side::kComplement);
}

/// The corners of the surfaces, or the centre of a single ball; nothing of other balls.
std::vector<Point> corners(const std::vector<RaySolid>& solids) {
  if (solids.size() == 1 && solids[0].ball()) return {solids[0].center};
  std::vector<Point> all;
  for (const RaySolid& s : solids) {
    if (s.ball()) return {};
    for (const auto& face : s.surface.faces) {
      for (const int v : face) all.push_back(s.surface.points[static_cast<std::size_t>(v)]);
    }
  }
  return all;
}

/// The vertices of the hull of the differences.
std::vector<Point> difference_corners(const std::vector<Point>& a, const std::vector<Point>& b) {
  if (a.size() == 1 && b.size() == 1) return {a[0] - b[0]};
  const auto surface = a.size() == 1   ? space::ContactSurface(a[0], space::Polytope::hull(b))
                       : b.size() == 1 ? space::ContactSurface(space::Polytope::hull(a), b[0])
                                       : space::ContactSurface(space::Polytope::hull(a), space::Polytope::hull(b));
  return {surface.vertices().begin(), surface.vertices().end()};
}

/// The sign of gamma2 - level.
std::unique_ptr<RaySource> farthest(const std::vector<RaySolid>& b, const std::vector<RaySolid>& a, const Real& level,
                                    const RayGrid& grid) {
  const std::vector<Point> of_a = corners(a), of_b = corners(b);
  if (of_a.empty() || of_b.empty()) return nullptr;
  const Real reach = level - a[0].radius - b[0].radius;
  if (reach.sign() < 0) return space::constant_rays(grid, 1);
  std::vector<space::LinePiece> balls;
  for (const Point& v : difference_corners(of_a, of_b)) balls.push_back(space::ball_piece(space::real(v), reach));
  return std::make_unique<space::PieceRays>(balls, 1, grid, space::PieceRays::Of::kIntersection);
}

/// The sign of gamma1 of all of them; null where there are balls, or an observer is to see every pair.
std::unique_ptr<RaySource> united(const std::vector<RaySolid>& b, const std::vector<RaySolid>& a, const RayGrid& grid) {
  const auto ball = [](const RaySolid& s) { return s.ball(); };
  if (plane::stage_observer() != nullptr || std::any_of(a.begin(), a.end(), ball) ||
      std::any_of(b.begin(), b.end(), ball))
    return nullptr;
  const auto surfaces = [](const std::vector<RaySolid>& all) {
    std::vector<space::Triangles> out;
    for (const RaySolid& s : all) out.push_back(s.surface);
    return out;
  };
  return std::make_unique<space::UnitedPairs>(surfaces(a), surfaces(b), grid);
}

}  // namespace

bool SurfaceRays::searched() const {
  return std::any_of(sources.begin(), sources.end(), [](const auto& s) { return s->searched(); });
}

exact::Tried<RayRow> SurfaceRays::try_row(int j) const { return space::extreme_row(sources, least, j); }

SurfaceRays surface_rays(distance::Which which, const std::vector<RaySolid>& b, const std::vector<RaySolid>& a,
                         const Real& level, const RayGrid& grid) {
  SurfaceRays result;
  const auto add = [&](std::unique_ptr<RaySource> source) {
    if (source) result.sources.push_back(std::move(source));
  };
  if (which == distance::Which::kGamma2) {
    add(farthest(b, a, level, grid));
    return result;
  }
  if (which == distance::Which::kGamma1 && level.sign() == 0 && b.size() * a.size() > 1) add(united(b, a, grid));
  if (!result.sources.empty()) return result;
  const bool many = large(a, b);
  std::size_t wanted = 0;
  if (which == distance::Which::kGamma1) {
    for (const RaySolid& s : b) {
      for (const RaySolid& t : a) add(gap(s, t, level, many, grid));
    }
    wanted = b.size() * a.size();
  } else {
    const bool cover = which == distance::Which::kDelta1;
    const std::vector<RaySolid>&inner = cover ? a : b, &outer = cover ? b : a;
    if (outer.size() != 1 || level.sign() > 0) return result;
    result.least = false;
    for (const RaySolid& s : inner) {
      add(cover ? containment(mirrored(s), mirrored(outer[0]), level, many, grid)
                : containment(s, outer[0], level, many, grid));
    }
    wanted = inner.size();
  }
  if (result.sources.size() != wanted) result.sources.clear();
  return result;
}

}  // namespace findspace::formula
