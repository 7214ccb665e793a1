// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "formula/solid/touching_rays.h"

#include <algorithm>

#include "formula/solid/contact_rays.h"
#include "formula/solid/surface_rays.h"
#include "space/surface/touch_rays.h"

namespace findspace::formula {

using distance::Which;
using exact::Real;
using space::RaySolid;
using space::TouchPair;
using space::TouchSide;
using Source = space::RaySourcePointer;
using Signs = std::span<const std::int8_t>;

namespace {

/// Of facets of two large solids. More of those near the lines take gigabytes; all of them are needed for the farthest,
/// and with more values are quicker on few lines.
constexpr std::size_t kMostFacetPairsNear = 4000000, kMostFacetPairs = 1000000;

/// The sheet of a surface, reflected through the origin if `mirrored`.
std::shared_ptr<const space::RaySheet> sheet(const RaySolid& solid, bool mirrored) {
  return sheet_of(mirrored ? space::mirrored(solid) : solid);
}

bool one_surface(const std::vector<RaySolid>& s) { return s.size() == 1 && !s[0].ball(); }

}  // namespace

Source touching_rays(Which which, const std::vector<RaySolid>& b, const std::vector<RaySolid>& a, const Real& level,
                     const space::RayGrid& grid, const std::function<Source()>& zero) {
  const bool depth = which == Which::kGamma1, cover = which == Which::kDelta1 || which == Which::kDelta2;
  const bool farthest = which == Which::kEta2 || which == Which::kDelta2;
  const bool wanted = depth ? level.sign() < 0 : farthest || ((cover || which == Which::kEta1) && level.sign() > 0);
  if (!wanted || !one_surface(a) || !one_surface(b)) return nullptr;
  const std::size_t of_a = a[0].surface.faces.size(), of_b = b[0].surface.faces.size();
  if (of_a * of_b <= kFewPairs) return nullptr;
  // A lies in B + p where -A + p lies in -B.
  const RaySolid &moving = (cover ? a : b)[0], &fixed = (cover ? b : a)[0];
  // Where the larger one, or the outer one, is convex, parts are the quick way.
  if (is_convex(depth && of_a < of_b ? moving : fixed) || (!depth && fixed.inner_walls)) return nullptr;
  TouchPair pair{sheet(fixed, cover), sheet(moving, cover), depth ? TouchSide::kOutside : TouchSide::kInside};
  if (std::min(of_a, of_b) >= space::kManyFaces && !is_convex(depth && of_a < of_b ? fixed : moving))
    pair.most_pairs = farthest ? kMostFacetPairs : kMostFacetPairsNear;
  Source near = farthest ? space::all_touching_near(pair, level, grid) : space::near_touching(pair, abs(level), grid);
  if (!near) return contact_rays(which, b[0], a[0], level, grid);
  if (farthest) return near;
  std::vector<Source> both;
  both.push_back(zero());
  both.push_back(std::move(near));
  if (depth) return space::combined_rays(std::move(both), [](Signs s) { return std::int8_t(s[0] < 0 ? -s[1] : 1); });
  return space::combined_rays(std::move(both), [](Signs s) { return s[0] <= 0 ? std::int8_t(-1) : s[1]; });
}

}  // namespace findspace::formula
