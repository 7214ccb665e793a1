// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "formula/solid/solid_rays.h"

#include <algorithm>
#include <optional>

#include "distance/rays/protrusion_rays.h"
#include "distance/rays/ray_signs.h"
#include "distance/search/solid_protrusion.h"
#include "distance/solid/pair_distances.h"
#include "space/convolution/ray_ball.h"
#include "space/rays/piece_rays.h"

namespace findspace::formula {

using distance::Which;
using exact::Real;
using exact::Tried;
using space::RayGrid;
using space::RaySolid;
using Source = space::RaySourcePointer;

namespace {

/// Pairs of triangles up to which there is memory for the surface about every corner.
constexpr std::size_t kMostPairs = 200000;

bool convex(const std::vector<RaySolid>& solids) { return solids.size() == 1 && space::is_convex(solids[0]); }

/// The hull; nothing where there are balls.
std::optional<space::Body> hull(const std::vector<RaySolid>& solids) {
  std::vector<space::Point> points;
  for (const RaySolid& s : solids) {
    if (s.ball()) return std::nullopt;
    for (const auto& face : s.surface.faces) {
      for (const int v : face) points.push_back(s.surface.points[static_cast<std::size_t>(v)]);
    }
  }
  space::Body body;
  body.parts.push_back(space::part_of(points, Real()));
  return body;
}

/// How far one protrudes from a convex one by more than 0: as far as its hull does.
Source protrusion_of_convex(Which which, const std::vector<RaySolid>& b, const std::vector<RaySolid>& a,
                            const Real& level, const RayGrid& grid) {
  if (!convex(which == Which::kMu ? a : b)) return nullptr;
  const auto of_b = hull(b), of_a = hull(a);
  return of_a && of_b ? distance::ray_sign_map(which, level, *of_b, *of_a, grid) : nullptr;
}

/// The sign of the distance of a corner at p to the nearest solid, less a level above 0.
Source corner_near(const space::Point& v, const std::vector<RaySolid>& a, const Real& level, const RayGrid& grid) {
  std::vector<Source> all;
  std::vector<space::LinePiece> balls;
  for (const RaySolid& s : a) {
    if (s.ball())
      balls.push_back(space::ball_piece(space::real(s.center - v), s.radius + level));
    else
      all.push_back(std::make_unique<space::BallRays>(space::moved(s.surface, -v), level, grid));
  }
  if (!balls.empty()) all.push_back(std::make_unique<space::PieceRays>(balls, 1, grid));
  return as_source({std::move(all), true});
}

/// Of the corner for which that is greatest.
Source corners_near(const space::Body& b, const std::vector<RaySolid>& a, const Real& level, const RayGrid& grid) {
  std::vector<space::Point> corners;
  for (const space::BodyPart& part : b.parts)
    corners.insert(corners.end(), part.vertices().begin(), part.vertices().end());
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  std::vector<Source> all;
  for (const space::Point& v : corners) all.push_back(corner_near(v, a, level, grid));
  return space::greatest_rays(std::move(all));
}

/// How far polyhedra of few corners, and balls, protrude from what is not convex.
Tried<Source> protrusion(const TouchingSolid& b, const std::vector<RaySolid>& a, const Real& level,
                         const RayGrid& grid) {
  const auto faces = [](const std::vector<RaySolid>& solids) {
    std::size_t sum = 0;
    for (const RaySolid& s : solids) sum += s.surface.faces.size();
    return sum;
  };
  const std::size_t pairs = faces(b.solids) * faces(a);
  if (pairs <= kFewPairs || pairs > kMostPairs) return nullptr;
  const Tried<space::Body> made = b.body();
  if (!made) return made.refusal();
  const space::Body& body = *made;
  if (body.scale != 1 || !distance::polyhedra_and_balls(body) || body.outside) return nullptr;
  const Real shift = Real::from_double(distance::ProtrusionRays::kCertain) * Real(exact::kRayLimit);
  if (level < shift) return nullptr;
  return std::make_unique<distance::ProtrusionRays>(
      body, distance::field_of_surfaces(a), level, [&](const Real& l) { return corners_near(body, a, l, grid); }, grid);
}

/// A in B + p is -A + p in -B.
Tried<Source> protrusion_back(const TouchingSolid& b, const TouchingSolid& a, const Real& level, const RayGrid& grid) {
  std::vector<RaySolid> moving = a.solids, fixed = b.solids;
  for (std::vector<RaySolid>* all : {&moving, &fixed}) {
    for (RaySolid& s : *all) s = mirrored(std::move(s));
  }
  const auto mirrored = [&]() -> Tried<space::Body> {
    Tried<space::Body> made = a.body();
    return made ? space::mirrored(*std::move(made)) : std::move(made);
  };
  return protrusion({moving, mirrored}, fixed, level, grid);
}

/// The greatest of both; what needs no search is asked first, and rows without a place that it allows no more.
Tried<SurfaceRays> hausdorff(const TouchingSolid& b, const TouchingSolid& a, const Real& level, const RayGrid& grid) {
  std::vector<Source> both;
  const bool back_first = convex(b.solids);
  for (const Which way : {back_first ? Which::kMuBack : Which::kMu, back_first ? Which::kMu : Which::kMuBack}) {
    Tried<SurfaceRays> some = solid_rays(way, b, a, level, grid);
    if (!some || some->sources.empty()) return some;
    both.push_back(as_source(*std::move(some)));
  }
  return SurfaceRays::of(space::greatest_rays(std::move(both)));
}

Tried<SurfaceRays> one(Tried<Source> source) {
  if (!source) return source.refusal();
  return SurfaceRays::of(*std::move(source));
}

}  // namespace

Tried<SurfaceRays> solid_rays(Which which, const TouchingSolid& b, const TouchingSolid& a, const Real& level,
                              const RayGrid& grid) {
  if (const auto cut = distance::cut_off_of(which)) {
    if (level.sign() < 0) return SurfaceRays::of(space::constant_rays(grid, 1));
    Tried<SurfaceRays> rays = solid_rays(cut->base, b, a, cut->negated ? -level : level, grid);
    if (!rays || rays->sources.empty()) return rays;
    return SurfaceRays::of(space::cut_off_rays(as_source(*std::move(rays)), cut->negated, level));
  }
  if (which == Which::kHausdorff) return hausdorff(b, a, level, grid);
  if (which == Which::kDiameter) return SurfaceRays();
  const bool protrudes = which == Which::kMu || which == Which::kMuBack;
  if (protrudes && level.sign() > 0) {
    if (auto rays = protrusion_of_convex(which, b.solids, a.solids, level, grid))
      return SurfaceRays::of(std::move(rays));
    return one(which == Which::kMu ? protrusion(b, a.solids, level, grid) : protrusion_back(b, a, level, grid));
  }
  if (which == Which::kMuBack) which = Which::kDelta1;
  SurfaceRays rays;
  if (which != Which::kEta2 && which != Which::kDelta2) rays = surface_rays(which, b.solids, a.solids, level, grid);
  if (!rays.sources.empty()) return rays;
  return SurfaceRays::of(touching_rays(which, b.solids, a.solids, level, grid, [&] {
    return as_source(surface_rays(which, b.solids, a.solids, Real(), grid));
  }));
}

Source as_source(SurfaceRays rays) {
  if (rays.sources.size() == 1) return std::move(rays.sources[0]);
  return space::combined_rays(std::move(rays.sources), [least = rays.least](std::span<const std::int8_t> s) {
    return least ? *std::min_element(s.begin(), s.end()) : *std::max_element(s.begin(), s.end());
  });
}

}  // namespace findspace::formula
