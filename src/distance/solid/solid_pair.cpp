// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/solid/solid_pair.h"

#include <algorithm>

#include "distance/answer/answer.h"
#include "distance/search/position_set.h"
#include "distance/search/set_protrusion.h"
#include "distance/search/solid_protrusion.h"
#include "exact/margins/protrusion.h"
#include "space/body/body_boxes.h"

namespace findspace::distance {

using exact::Real;
using exact::Refusal;
using exact::Tried;
using space::Body;
using space::BodyPart;
using space::real;
using space::RealVector;

namespace {

TriedAnswer defined(Tried<Answer> v) {
  if (!v) return v.refusal();
  return std::optional(*std::move(v));
}

}  // namespace

SolidPair::SolidPair(std::shared_ptr<const Body> b, std::shared_ptr<const Body> a)
    : b_(std::move(b)), a_(std::move(a)), outside_(a_->outside) {
  if (outside_) {
    auto parts = std::make_shared<Body>(*a_);
    parts->outside = false;
    a_ = std::move(parts);
  }
  forth_.moving = b_.get();
  forth_.fixed = a_.get();
  back_.moving = a_.get();
  back_.fixed = b_.get();
}

Tried<Answer> SolidPair::gap_of_parts(const RealVector& p, Depth depth) const {
  if (a_->round() || b_->round()) return round_gap(p, depth);
  std::call_once(overlap_made_, [&] { overlap_ = std::make_unique<space::OpenUnion>(overlap_cover(*b_, *a_)); });
  if (overlap_->covers(p)) return signed_value(p, *overlap_->nearest_in_complement(p), -1);
  return signed_value(p, *overlap_->nearest_touching(p), 1);
}

Tried<Answer> SolidPair::round_gap(const RealVector& p, Depth depth) const {
  std::optional<Answer> best;
  for (const BodyPart& t : a_->parts) {
    for (const BodyPart& s : b_->parts) {
      Answer v = difference(t, s).to_boundary(p);
      if (!best || v.value < best->value) best = std::move(v);
    }
  }
  const bool one_pair = a_->parts.size() == 1 && b_->parts.size() == 1;
  if (depth == Depth::kSign || one_pair || best->value.sign() >= 0) return *best;
  const auto is_ball = [](const BodyPart& part) { return part.point(); };
  if (std::all_of(a_->parts.begin(), a_->parts.end(), is_ball) &&
      std::all_of(b_->parts.begin(), b_->parts.end(), is_ball) &&
      a_->parts.size() * b_->parts.size() <= space::BallMeet::kMostBalls) {
    std::vector<space::Ball> balls;
    for (const BodyPart& t : a_->parts) {
      for (const BodyPart& s : b_->parts) balls.push_back({real(t.center - s.center), t.radius + s.radius});
    }
    const auto out = nearest_outside(balls, p);
    if (!out) return Refusal("the nearest free position of the balls is not found");
    return signed_value(p, *out, -1);
  }
  std::call_once(round_overlap_made_, [&] {
    const space::Bounds3 box = space::meeting(bounds(*b_), bounds(*a_));
    std::vector<GrownSet> sets;
    for (const BodyPart& t : a_->parts) {
      for (const BodyPart& s : b_->parts) sets.push_back(difference(t, s));
    }
    round_overlap_ = std::make_shared<const PositionSet>(PositionSet::outside(std::move(sets), box.low, box.high));
  });
  TriedAnswer out = round_overlap_->nearest(p, true);
  if (!out) return out.refusal();
  if (!*out) return Refusal("the nearest free position of the rounded shapes is not found");
  return minus(**std::move(out));
}

Tried<Answer> SolidPair::protrusion_of(const Side& side, const RealVector& p, Depth depth) const {
  if (side.fixed->convex()) return protrusion_of_convex(*side.moving, side.fixed->parts[0], p);
  if (!side.fixed->round()) {
    if (auto inside = inside_polyhedra(side, p)) return *inside;
  }
  Answer out = protrusion_of_union(*side.moving, *side.fixed, p);
  const bool inside = side.fixed->round() && out.value.sign() <= 0;
  if (depth == Depth::kValue && inside) return depth_inside(side, p);
  return out;
}

/// The depth of the deepest point of B + p, which lies in the interior of A's parts.
Tried<Answer> SolidPair::reach_into_parts(const RealVector& p) const {
  if (!a_->round()) return protrusion_of_cells(*b_, fit_of(forth_).cells, p);
  if (!a_->convex()) return reach_into_round_parts(p);
  // Within a radius r of a core the depth is r less the distance to the core, or r more than the depth in it.
  const BodyPart& part = a_->parts[0];
  Answer out;
  if (!part.core) {
    const Tried<Answer> apart = gap_of_parts(p, Depth::kSign);
    if (!apart) return apart;
    out.value = std::min(-apart->value, part.radius);
    return out;
  }
  Body core = *a_;
  core.parts[0].radius = Real();
  core.outside = true;
  const TriedAnswer v = SolidPair(b_, std::make_shared<const Body>(std::move(core))).try_value(Which::kMu, p);
  if (!v) return v.refusal();
  out.value = (*v)->value + part.radius;
  if (!(*v)->proven) out.set_unproven();
  out.error = (*v)->error;
  return out;
}

/// The same, of a union: how far B protrudes from what that leaves free.
Answer SolidPair::reach_into_round_parts(const RealVector& p) const {
  const space::Bounds3 box = bounds(*a_);
  std::vector<GrownSet> sets;
  NearSet left;
  for (const BodyPart& part : a_->parts) {
    sets.push_back({part.planes(), real(part.center), part.radius});
    if (part.point()) left.add_ball(part);
  }
  const PositionSet free = PositionSet::outside(std::move(sets), box.low, box.high);
  left.places = &free;
  const Solids solids = solids_of(*b_, p);
  const space::Extent about = space::rounded(box);
  const double size = 1 + space::length(space::rounded(p)) + space::length(about.low) + space::length(about.high);
  return set_protrusion(solids, {left}, size, margin::kProtrudesTo * size).answer(size);
}

template <class Ask>
TriedAnswer SolidPair::seen(Inner inner, const RealVector& p, const Ask& ask) const {
  if (outside_) return std::nullopt;
  if (inner == Inner::kB) return ask(forth_, p);
  return exchanged_back(ask(back_, space::negated(p)), p);
}

// Where A is the closure of the complement of its parts: the dual distances of the parts (distances.md 3.1).

TriedAnswer SolidPair::gap(const RealVector& p, Depth depth) const {
  if (!outside_) return defined(gap_of_parts(p, depth));
  TriedAnswer v = contained(forth_, p);
  if (!v) return v;
  return std::optional(*v ? minus(**std::move(v)) : lowest_answer<RealVector>(Way::kParts));
}

TriedAnswer SolidPair::reach(const RealVector& p) const {
  if (outside_) return std::nullopt;
  return std::optional(reach_of_parts(p));
}

TriedAnswer SolidPair::diameter(const RealVector& p) const {
  if (outside_) return std::nullopt;
  Answer most = reach_of_parts(p);
  for (const Body* body : {a_.get(), b_.get()}) {
    const Real own = distance::diameter(*body);
    if (most.value < own) most = exact_answer<RealVector>(own, Way::kParts);
  }
  return std::optional(std::move(most));
}

TriedAnswer SolidPair::fit(Inner inner, const RealVector& p) const {
  if (!outside_ || inner == Inner::kA)
    return seen(inner, p, [this](const Side& side, const RealVector& q) { return contained(side, q); });
  Tried<Answer> v = gap_of_parts(p, Depth::kValue);
  if (!v) return v.refusal();
  return std::optional(minus(*std::move(v)));
}

TriedAnswer SolidPair::farthest_fit(Inner inner, const RealVector& p) const {
  return seen(inner, p, [this](const Side& side, const RealVector& q) { return farthest_in(side, q); });
}

TriedAnswer SolidPair::clearance(Inner inner, const RealVector& p) const {
  if (outside_) return PairDistances::clearance(inner, p);
  return seen(inner, p, [this](const Side& side, const RealVector& q) { return clearance_inside(side, q); });
}

TriedAnswer SolidPair::protrusion(Inner inner, const RealVector& p, Depth depth) const {
  if (!outside_ || inner == Inner::kA)
    return seen(inner, p,
                [&](const Side& side, const RealVector& q) { return defined(protrusion_of(side, q, depth)); });
  Tried<Answer> v = gap_of_parts(p, Depth::kSign);
  if (!v) return v.refusal();
  Answer inside = minus(*std::move(v));
  if (inside.value.sign() <= 0) return std::optional(std::move(inside));
  return defined(reach_into_parts(p));
}

}  // namespace findspace::distance
