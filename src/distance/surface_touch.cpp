// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// SurfacePair: what positions tell at which the surfaces touch.
#include <algorithm>

#include "distance/solid_value.h"
#include "distance/surface_ball.h"
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

/// The moving one, where it is a single ball.
const space::SurfaceSet::Ball* only_ball(const Surfaced& s) {
  const bool one = s.surface && s.surface->sheets().empty() && s.surface->balls().size() == 1;
  return one ? s.surface->balls().data() : nullptr;
}

std::optional<Answer> of_ball(const space::SurfaceSet::Ball& ball, const Surfaced& fixed, TouchSide side, bool farthest,
                              const RealVector& p) {
  if (!fixed.surface || !fixed.surface->one_sheet() || fixed.convex || ball.radius.sign() <= 0) return std::nullopt;
  const SurfaceBall of{fixed.surface.get(), ball.radius, side};
  const RealVector center = space::real(ball.center), x = space::plus(p, center);
  BallPlace place = farthest ? farthest_for_ball(of, x) : nearest_for_ball(of, x);
  if (!place.told) return std::nullopt;
  if (place.value && place.value->nearest) place.value->nearest = space::minus(*place.value->nearest, center);
  return Answer{std::move(place.value)};
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
  const RealVector at = back ? space::negated(p) : p;
  std::optional<Answer> out;
  if (const auto* ball = only_ball(*side.moving)) {
    out = of_ball(*ball, *side.fixed, TouchSide::kOutside, false, at);
    if (out && out->value) out->value->value = -out->value->value;
  } else if (const TouchSets* sets = touching(side, TouchSide::kOutside)) {
    out = Answer{signed_value(at, *nearest_touch(*sets, at), -1)};
  }
  if (!out || !out->value) return std::nullopt;
  if (back && out->value->nearest) out->value->nearest = space::negated(*out->value->nearest);
  return out;
}

std::optional<Answer> SurfacePair::to_fit(const Side& side, Which which, const RealVector& p) {
  if (const auto* ball = only_ball(*side.moving)) {
    auto out = of_ball(*ball, *side.fixed, TouchSide::kInside, which == Which::kEta2, p);
    if (out && out->value && which == Which::kEta2) out->value->nearest.reset();
    return out;
  }
  const TouchSets* sets = touching(side, TouchSide::kInside);
  if (!sets) return std::nullopt;
  const auto q = which == Which::kEta2 ? farthest_touch(*sets, p) : nearest_touch(*sets, p);
  if (!q) return Answer{};
  SolidValue out = signed_value(p, *q, 1);
  if (which == Which::kEta2) out.nearest.reset();
  return Answer{std::move(out)};
}

}  // namespace findspace::distance
