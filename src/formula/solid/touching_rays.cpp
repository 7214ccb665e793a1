// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "formula/solid/touching_rays.h"

#include <algorithm>
#include <optional>

#include "formula/solid/contact_rays.h"
#include "formula/solid/surface_rays.h"
#include "space/surface/touch_rays.h"

namespace findspace::formula {

using distance::Which;
using exact::Real;
using space::Body;
using space::Point;
using space::TouchPair;
using space::TouchSide;
using Source = space::RaySourcePointer;
using Signs = std::span<const std::int8_t>;

namespace {

/// Sets of a triangle and a convex part, at most.
constexpr std::size_t kMostSets = 100000;
constexpr std::int64_t kFarthest = std::int64_t{1} << 38;

bool within_limits(const std::vector<Point>& points, std::int64_t scale) {
  return std::all_of(points.begin(), points.end(), [&](const Point& p) {
    return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) <= kFarthest / scale;
  });
}

/// The surface of `fixed` and the convex parts of `moving`; both reflected if `mirrored`.
exact::Tried<std::optional<TouchPair>> pair_of(const space::Triangles& fixed, const TouchingSolid& moving,
                                               TouchSide side, bool mirrored) {
  exact::Tried<Body> made = moving.body();
  if (!made) return made.refusal();
  Body& body = *made;
  if (body.round() || body.outside || body.rounded > 0) return std::nullopt;
  if (body.parts.size() * fixed.faces.size() > kMostSets || !within_limits(fixed.points, body.scale))
    return std::nullopt;
  if (mirrored) body = space::mirrored(std::move(body));
  TouchPair pair{space::scaled(fixed, mirrored ? -body.scale : body.scale), {}, side, body.scale};
  for (space::BodyPart& part : body.parts) {
    if (!part.core) return std::nullopt;
    const auto corners = part.core->vertices();
    if (!within_limits({corners.begin(), corners.end()}, 1)) return std::nullopt;
    pair.moving.push_back(std::move(*part.core));
  }
  return std::optional(std::move(pair));
}

bool one_surface(const TouchingSolid& s) { return s.solids.size() == 1 && !s.solids[0].ball(); }

}  // namespace

exact::Tried<Source> touching_rays(Which which, const TouchingSolid& b, const TouchingSolid& a, const Real& level,
                                   const space::RayGrid& grid, const std::function<Source()>& zero) {
  const bool depth = which == Which::kGamma1, cover = which == Which::kDelta1 || which == Which::kDelta2;
  const bool farthest = which == Which::kEta2 || which == Which::kDelta2;
  const bool wanted = depth ? level.sign() < 0 : farthest || ((cover || which == Which::kEta1) && level.sign() > 0);
  if (!wanted || !one_surface(a) || !one_surface(b)) return nullptr;
  const std::size_t of_a = a.solids[0].surface.faces.size(), of_b = b.solids[0].surface.faces.size();
  if (of_a * of_b <= kFewPairs) return nullptr;
  // A meets B + p where -B meets -A + p; A lies in B + p where -A + p lies in -B.
  const bool back = depth ? of_a < of_b : cover;
  const TouchingSolid &fixed = back ? b : a, &moving = back ? a : b;
  if (space::is_convex(fixed.solids[0]) || (!depth && fixed.solids[0].inner_walls)) return nullptr;
  const TouchSide side = depth ? TouchSide::kOutside : TouchSide::kInside;
  if (std::min(of_a, of_b) >= space::kManyFaces && !space::is_convex(moving.solids[0]))
    return contact_rays(which, b.solids[0], a.solids[0], level, grid);
  const auto made = pair_of(fixed.solids[0].surface, moving, side, back);
  if (!made) return made.refusal();
  const std::optional<TouchPair>& pair = *made;
  if (!pair) return nullptr;
  if (farthest) return space::all_touching_near(*pair, level, grid);
  std::vector<Source> both;
  both.push_back(zero());
  both.push_back(space::near_touching(*pair, abs(level), grid));
  if (depth) return space::combined_rays(std::move(both), [](Signs s) { return std::int8_t(s[0] < 0 ? -s[1] : 1); });
  return space::combined_rays(std::move(both), [](Signs s) { return s[0] <= 0 ? std::int8_t(-1) : s[1]; });
}

}  // namespace findspace::formula
