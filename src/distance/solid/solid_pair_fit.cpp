// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The distances of SolidPair that say how a body fits into another: eta1 and eta2, and with the roles exchanged delta1
// and delta2. E, the positions at which it does:
//   in a ball             an intersection of balls;
//   in an offset polytope A = P (+) r, of parts no rounder than that: part by part and vertex by vertex an intersection
//                         of rounded polytopes; else that of the parts less r in P, as (P (+) r) (-) r = P;
//   in polyhedra          what is farther from the cover of outside cells less B's cores than their radii;
//   in a union of round parts: solid_pair_union.cpp.
// Guarantee: as solid_pair.h; boundaries that are round are searched (position_set.h). Keywords: erosion, Minkowski
// difference, containment.

#include <algorithm>
#include <cmath>

#include "distance/answer/answer.h"
#include "distance/search/position_set.h"
#include "distance/search/solid_protrusion.h"
#include "distance/solid/solid_pair.h"
#include "space/body/body_boxes.h"

namespace findspace::distance {

using exact::Real;
using space::Body;
using space::BodyPart;
using space::real;
using space::RealVector;

namespace {

std::optional<space::Bounds3> fit_box(const Body& b, const Body& a) { return space::fitting(bounds(b), bounds(a)); }

}  // namespace

const PositionSet& SolidPair::boundary_of(const Side& side, const Fit& fit) {
  std::call_once(fit.level_made, [&] {
    const Body &b = *side.moving, &a = *side.fixed;
    const space::Bounds3 box = *fit_box(b, a);
    std::vector<GrownSet> sets;
    for (const Fit::Group& group : fit.groups) {
      for (std::size_t k = 0; k < group.cover.size(); ++k) sets.push_back({group.cover.planes(k), {}, group.radius});
    }
    fit.boundary =
        std::make_shared<const PositionSet>(a.convex() ? PositionSet::inside(b, a.parts[0], box.low, box.high)
                                                       : PositionSet::outside(std::move(sets), box.low, box.high));
  });
  return *fit.boundary;
}

std::unique_ptr<SolidPair::Fit> SolidPair::made_fit(const Side& side) {
  auto made = std::make_unique<Fit>();
  const Body &b = *side.moving, &a = *side.fixed;
  if (a.convex() && a.parts[0].point()) {
    std::vector<space::Ball> balls;
    for (const BodyPart& part : b.parts) {
      for (const space::Point& v : part.vertices())
        balls.push_back({real(a.parts[0].center - v), a.parts[0].radius - part.radius});
    }
    made->balls.emplace(std::move(balls));
    return made;
  }
  if (a.round() && !a.convex()) {
    const auto box = fit_box(b, a);
    made->none = !box;
    if (box) made->in_union = union_containers(b, a, *box);
    return made;
  }
  if (a.convex()) {
    const auto plain = without_radius(b, a);
    if (!plain) {
      made->round = true;
      made->none = !fit_box(b, a);
      return made;
    }
    Fit::Group& group = made->groups.emplace_back();
    group.core = plain->first;
    made->cells = space::outside_cells(plain->second);
    group.cover = space::outside_cover(group.core, made->cells);
    return made;
  }
  made->cells = space::outside_cells(a);
  std::vector<Real> radii;
  for (const BodyPart& part : b.parts) {
    if (std::find(radii.begin(), radii.end(), part.radius) == radii.end()) radii.push_back(part.radius);
  }
  made->groups.resize(radii.size());
  for (std::size_t k = 0; k < radii.size(); ++k) {
    Fit::Group& group = made->groups[k];
    group.core.scale = b.scale;
    group.radius = radii[k];
    for (const BodyPart& part : b.parts) {
      if (part.radius != radii[k]) continue;
      group.core.parts.push_back(part);
      group.core.parts.back().radius = Real();
    }
    group.cover = space::outside_cover(group.core, made->cells);
  }
  made->round = b.round();
  made->none = b.round() && !fit_box(b, a);
  return made;
}

const SolidPair::Fit& SolidPair::fit_of(const Side& side) const {
  std::call_once(side.made, [&] { side.fit = made_fit(side); });
  return *side.fit;
}

TriedAnswer SolidPair::contained(const Side& side, const RealVector& p) const {
  const bool in_round = side.fixed->round() && !(side.fixed->convex() && side.fixed->parts[0].point());
  if (in_round) {
    const exact::Tried<Answer> tried = protrusion_of(side, p, Depth::kValue);
    if (!tried) return tried.refusal();
    const Answer& v = *tried;
    if (v.value.sign() <= 0) return std::optional(v);  // inside both distances agree
    const Fit& f = fit_of(side);
    if (f.none) return std::nullopt;
    if (f.in_union) return into_union(side, f, p, v);
    if (!f.round) {
      const auto q = f.balls ? f.balls->nearest(p) : f.groups[0].cover.nearest_in_complement(p);
      return q ? std::optional(signed_value(p, *q, 1)) : std::nullopt;
    }
    // Moved by as much, the way that B protrudes by, it often fits.
    if (!v.witness.empty()) {
      const RealVector q = space::minus(p, space::minus(v.witness[0].at, v.witness[1].at));
      if (boundary_of(side, f).holds(q)) return std::optional(signed_value(p, q, 1));
    }
    return boundary_of(side, f).nearest(p, false);
  }
  const Fit& f = fit_of(side);
  if (f.balls) {
    const auto q = f.balls->nearest(p);
    if (!q) return std::nullopt;
    if (*q != p) return std::optional(signed_value(p, *q, 1));
    exact::Tried<Answer> inside = protrusion_of(side, p, Depth::kValue);  // inside E both distances agree
    if (!inside) return inside.refusal();
    return std::optional(*std::move(inside));
  }
  if (auto v = inside_polyhedra(side, p)) return v;
  if (f.none) return std::nullopt;
  if (f.round) return boundary_of(side, f).nearest(p, false);
  const auto q = f.groups[0].cover.nearest_in_complement(p);
  return q ? std::optional(signed_value(p, *q, 1)) : std::nullopt;
}

std::optional<Answer> SolidPair::inside_polyhedra(const Side& side, const RealVector& p) const {
  std::optional<Answer> least;
  for (const Fit::Group& group : fit_of(side).groups) {
    if (group.cover.covers(p)) return std::nullopt;
    const RealVector q = *group.cover.nearest_touching(p);
    Answer v = signed_value(p, q, -1);
    if (group.radius.sign() > 0) {
      // The ball fits where it is no deeper than that; so much less is the way to where it does not.
      const Real d = -v.value;
      v.value = group.radius - d;
      if (v.value.sign() > 0) return std::nullopt;
      v.nearest.reset();
      if (v.value.sign() < 0) v.nearest = space::along(q, group.radius / d, space::minus(p, q));
    }
    if (!least || least->value < v.value) least = std::move(v);
  }
  return least;
}

TriedAnswer SolidPair::farthest_in(const Side& side, const RealVector& p) const {
  const Fit& f = fit_of(side);
  if (f.none) return std::nullopt;
  if (f.in_union) return farthest_in_union(f, p);
  if (f.round) {
    TriedAnswer v = boundary_of(side, f).farthest(p);
    if (v && *v) (*v)->nearest.reset();
    return v;
  }
  std::optional<RealVector> q;
  if (f.balls) {
    if (!f.balls->few())
      return exact::Refusal("more than " + std::to_string(space::BallMeet::kMostBalls) +
                            " balls (or vertices of a polytope in a ball) are not computed");
    q = f.balls->farthest(p);
  } else {
    const auto box = fit_box(*side.moving, *side.fixed);
    if (!box) return std::nullopt;
    q = farthest_in_complement(f.groups[0].cover, box->low, box->high, p);
  }
  if (!q) return std::nullopt;
  Answer out;
  out.value = sqrt(space::dot(space::minus(*q, p), space::minus(*q, p)));
  return std::optional(std::move(out));
}

TriedAnswer SolidPair::clearance_inside(const Side& side, const RealVector& p) const {
  const bool in_rounds = side.fixed->round() && !side.fixed->convex();
  if (in_rounds) {
    const exact::Tried<Answer> out = protrusion_of(side, p, Depth::kSign);
    if (!out) return out.refusal();
    if (out->value.sign() > 0) return std::optional(Answer{});
  }
  TriedAnswer inside = contained(side, p);
  if (!inside) return inside;
  return cut_off(*std::move(inside), true);
}

exact::Tried<Answer> SolidPair::depth_inside(const Side& side, const RealVector& p) {
  const space::Bounds3 box = bounds(*side.fixed);
  std::vector<GrownSet> sets;
  for (const BodyPart& part : side.fixed->parts) sets.push_back({part.planes(), real(part.center), part.radius});
  const PositionSet free = PositionSet::outside(std::move(sets), box.low, box.high);
  std::optional<Answer> least;
  for (const BodyPart& part : side.moving->parts) {
    exact::Tried<Answer> v = free.least(touching_distance(part, space::rounded(p), part.radius.to_double()));
    if (!v) return v;
    if (!least || v->value < least->value) least = *std::move(v);
  }
  return minus(*std::move(least));
}

}  // namespace findspace::distance
