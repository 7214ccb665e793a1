// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// SurfacePair: what positions tell at which the surfaces touch.
#include <algorithm>

#include "distance/solid_value.h"
#include "distance/surface_pair.h"
#include "space/touch_search.h"

namespace findspace::distance {

using space::RealVector;
using space::TouchSets;
using space::TouchSide;
using Answer = SurfacePair::Answer;

namespace {

std::size_t faces(const Surfaced& s) {
  std::size_t sum = 0;
  for (const auto& sheet : s.surface->sheets()) sum += sheet->body.faces.size();
  return sum;
}

/// Those of a body of polytopes; none of another.
std::vector<space::Polytope> polytopes(const Surfaced& s) {
  const auto body = s.parts ? s.parts : s.make ? s.make() : nullptr;
  std::vector<space::Polytope> out;
  if (!body || body->round() || body->outside || body->rounded > 0) return out;
  for (const space::BodyPart& part : body->parts) {
    if (!part.core) return {};
    out.push_back(*part.core);
  }
  return out;
}

bool within_limits(const std::vector<space::Polytope>& parts) {
  constexpr std::int64_t kFarthest = std::int64_t{1} << 38;
  return std::all_of(parts.begin(), parts.end(), [](const space::Polytope& part) {
    return std::all_of(part.vertices().begin(), part.vertices().end(), [](const space::Point& p) {
      return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) <= kFarthest;
    });
  });
}

}  // namespace

/// Of a fixed one that is not convex: else parts are the quick way.
const TouchSets* SurfacePair::touching(const Side& side, TouchSide from) {
  Touching& touching = from == TouchSide::kInside ? *side.inside : *side.outside;
  std::call_once(touching.made, [&] {
    const auto& surface = side.fixed->surface;
    if (!surface || !surface->one_sheet() || side.fixed->convex) return;
    std::vector<space::Polytope> parts = polytopes(*side.moving);
    if (parts.empty() || !within_limits(parts)) return;
    std::shared_ptr<const TouchSets::Sheet> sheet(surface, surface->sheets()[0].get());
    touching.sets = std::make_unique<const TouchSets>(std::move(sheet), std::move(parts), from);
  });
  return touching.sets.get();
}

std::optional<space::SurfaceGaps::Relation> SurfacePair::touching_relation(const Side& side, const RealVector& p) {
  using Relation = space::SurfaceGaps::Relation;
  const TouchSets* sets = touching(side, TouchSide::kInside);
  if (!sets) return std::nullopt;
  const TouchSets::Lies lies = sets->lies(p);
  return lies == TouchSets::Lies::kInside    ? Relation::kInside
         : lies == TouchSets::Lies::kOutside ? Relation::kApart
                                             : Relation::kOther;
}

std::optional<Answer> SurfacePair::depth(const RealVector& p) const {
  const bool back = faces(a_) < faces(b_);
  const Side& side = back ? back_ : forth_;
  const TouchSets* sets = touching(side, TouchSide::kOutside);
  if (!sets) return std::nullopt;
  const RealVector at = back ? space::negated(p) : p;
  SolidValue out = signed_value(at, *nearest_touch(*sets, at), -1);
  if (back && out.nearest) out.nearest = space::negated(*out.nearest);
  return Answer{std::move(out)};
}

std::optional<Answer> SurfacePair::to_fit(const Side& side, Which which, const RealVector& p) {
  const TouchSets* sets = touching(side, TouchSide::kInside);
  if (!sets) return std::nullopt;
  const auto q = which == Which::kEta2 ? farthest_touch(*sets, p) : nearest_touch(*sets, p);
  if (!q) return Answer{};
  SolidValue out = signed_value(p, *q, 1);
  if (which == Which::kEta2) out.nearest.reset();
  return Answer{std::move(out)};
}

}  // namespace findspace::distance
