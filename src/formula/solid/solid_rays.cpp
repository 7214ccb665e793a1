// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "formula/solid/solid_rays.h"

#include <algorithm>
#include <array>
#include <memory>
#include <optional>

#include "distance/rays/corner_rays.h"
#include "distance/rays/protrusion_rays.h"
#include "distance/rays/ray_signs.h"
#include "distance/search/solid_protrusion.h"
#include "distance/solid/pair_distances.h"

namespace findspace::formula {

using distance::Which;
using exact::Real;
using exact::Tried;
using space::RayGrid;
using space::RaySolid;
using Source = space::RaySourcePointer;

namespace {

/// Of their sizes: what the convex parts of a moving solid may be off, so that the search reckons with it.
constexpr double kMostMoved = distance::ProtrusionRays::kInner / 8;
/// Pairs of triangles up to which parts that are off by more, a grid step or so, are taken as they are.
constexpr std::size_t kMostPairs = 200000;

std::size_t faces_of(const std::vector<RaySolid>& solids) {
  std::size_t sum = 0;
  for (const RaySolid& s : solids) sum += s.surface.faces.size();
  return sum;
}

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

std::vector<space::Point> corners_of(const std::vector<RaySolid>& solids) {
  std::vector<space::Point> out;
  for (const RaySolid& s : solids) {
    if (s.ball()) out.push_back(s.center);
    for (const auto& face : s.surface.faces) {
      for (const int v : face) out.push_back(s.surface.points[static_cast<std::size_t>(v)]);
    }
  }
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

/// What moves, as the search takes it: a convex solid, its surface, or convex parts; nothing where none of them does.
Tried<std::optional<distance::ProtrusionParts>> moving_parts(const TouchingSolid& b, const distance::ProtrusionField& a,
                                                             double level, std::size_t pairs) {
  std::optional<distance::ProtrusionParts> out;
  const bool any_ball = std::any_of(b.solids.begin(), b.solids.end(), [](const RaySolid& s) { return s.ball(); });
  if (!any_ball && !convex(b.solids)) out = distance::protrusion_parts(b.solids, a, level);
  if (out) return out;
  const Tried<space::Body> body = b.body();
  if (!body) return body.refusal();
  const bool off = body->moved > a.size() * kMostMoved;
  if (!distance::polyhedra_and_balls(*body) || body->outside || (off && pairs > kMostPairs)) return out;
  out = distance::protrusion_parts(*body, 1 / static_cast<double>(body->scale));
  if (!off) out->moved = body->moved;
  return out;
}

/// How far polyhedra, and balls, protrude from what is not convex. `first`: a map that is + where nothing is to be
/// searched, of which the greater sign counts.
Tried<Source> protrusion(const TouchingSolid& b, const std::vector<RaySolid>& a, const Real& level, const RayGrid& grid,
                         Source first) {
  const std::size_t pairs = faces_of(b.solids) * faces_of(a);
  if (pairs <= kFewPairs) return nullptr;
  const Real shift = Real::from_double(distance::ProtrusionRays::kCertain) * Real(exact::kRayLimit);
  if (level < shift) return nullptr;
  const std::shared_ptr<distance::ProtrusionField> field = distance::field_of_surfaces(a);
  Tried<std::optional<distance::ProtrusionParts>> parts = moving_parts(b, *field, level.to_double(), pairs);
  if (!parts) return parts.refusal();
  if (!*parts) return nullptr;
  const auto corners = [&, all = corners_of(b.solids)](const Real& l) {
    const double most = l.to_double() - field->size() * distance::ProtrusionRays::kInner;
    return distance::corner_stretches(all, a, l, grid,
                                      [field, most](const space::Extent& box) { return field->within(box, most); });
  };
  return std::make_unique<distance::ProtrusionRays>(**std::move(parts), field, level, corners, grid, 1,
                                                    std::move(first));
}

/// A in B + p is -A + p in -B.
Tried<Source> protrusion_back(const TouchingSolid& b, const TouchingSolid& a, const Real& level, const RayGrid& grid,
                              Source first) {
  std::vector<RaySolid> moving = a.solids, fixed = b.solids;
  for (std::vector<RaySolid>* all : {&moving, &fixed}) {
    for (RaySolid& s : *all) s = mirrored(std::move(s));
  }
  const auto mirrored = [&]() -> Tried<space::Body> {
    Tried<space::Body> made = a.body();
    return made ? space::mirrored(*std::move(made)) : std::move(made);
  };
  return protrusion({moving, mirrored}, fixed, level, grid, std::move(first));
}

/// At a level above 0; `first` as there.
Tried<Source> any_protrusion(Which which, const TouchingSolid& b, const TouchingSolid& a, const Real& level,
                             const RayGrid& grid, Source first) {
  if (auto rays = protrusion_of_convex(which, b.solids, a.solids, level, grid)) {
    if (!first) return rays;
    std::vector<Source> both;
    both.push_back(std::move(first));
    both.push_back(std::move(rays));
    return space::greatest_rays(std::move(both));
  }
  return which == Which::kMu ? protrusion(b, a.solids, level, grid, std::move(first))
                             : protrusion_back(b, a, level, grid, std::move(first));
}

/// The length of the diagonal of their box.
double size_of(const std::vector<RaySolid>& solids) {
  space::Point low, high;
  bool any = false;
  space::extend_box(solids, low, high, any);
  return space::length(exact::approx(high - low));
}

/// The greatest of both; first what needs no search, or the protrusion of the larger one, and the other one where that
/// allows a place.
Tried<SurfaceRays> hausdorff(const TouchingSolid& b, const TouchingSolid& a, const Real& level, const RayGrid& grid) {
  const bool back_first = convex(b.solids) || (!convex(a.solids) && size_of(a.solids) > size_of(b.solids));
  const std::array<Which, 2> ways{back_first ? Which::kMuBack : Which::kMu, back_first ? Which::kMu : Which::kMuBack};
  if (level.sign() > 0) {
    Tried<Source> source{Source()};
    for (const Which way : ways) {
      source = any_protrusion(way, b, a, level, grid, *std::move(source));
      if (!source) return source.refusal();
      if (!*source) return SurfaceRays();
    }
    return SurfaceRays::of(*std::move(source));
  }
  std::vector<Source> both;
  for (const Which way : ways) {
    Tried<SurfaceRays> some = solid_rays(way, b, a, level, grid);
    if (!some || some->sources.empty()) return some;
    both.push_back(as_source(*std::move(some)));
  }
  return SurfaceRays::of(space::greatest_rays(std::move(both)));
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
    Tried<Source> source = any_protrusion(which, b, a, level, grid, nullptr);
    if (!source) return source.refusal();
    return SurfaceRays::of(*std::move(source));
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
  return rays.least ? space::least_rays(std::move(rays.sources)) : space::greatest_rays(std::move(rays.sources));
}

}  // namespace findspace::formula
