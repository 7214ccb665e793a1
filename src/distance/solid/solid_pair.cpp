// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/solid/solid_pair.h"

#include <algorithm>

#include "distance/answer/answer.h"
#include "distance/search/position_set.h"
#include "distance/search/solid_protrusion.h"

namespace findspace::distance {

using exact::Real;
using exact::Refusal;
using exact::Tried;
using space::Body;
using space::BodyPart;
using space::real;
using space::RealVector;

namespace {

Real length(const RealVector& v) { return sqrt(space::dot(v, v)); }

/// The value of a convex core with radius r around it; q is the nearest point of the core's frontier (or of the core).
Answer with_radius(const RealVector& p, const RealVector& q, bool inside, const Real& r) {
  const RealVector w = space::minus(p, q);
  const Real d = length(w);
  Answer out;
  out.value = (inside ? -d : d) - r;
  // The frontier lies r further out from q, on the line through p; at d = 0 the line is not known.
  if (out.value.sign() != 0 && d.sign() != 0) out.nearest = space::along(q, (inside ? -r : r) / d, w);
  return out;
}

/// max(0, v), or max(0, -v) if `negated`.
TriedAnswer cut(TriedAnswer v, bool negated) {
  if (!v) return v;
  return cut_off(*std::move(v), negated);
}
TriedAnswer cut(Tried<Answer> v, bool negated) {
  if (!v) return v.refusal();
  return cut_off(*std::move(v), negated);
}

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

Tried<Answer> SolidPair::gap(const RealVector& p, bool depth) const {
  if (a_->round() || b_->round()) return round_gap(p, depth);
  std::call_once(overlap_made_, [&] { overlap_ = std::make_unique<space::OpenUnion>(overlap_cover(*b_, *a_)); });
  if (overlap_->covers(p)) return signed_value(p, *overlap_->nearest_in_complement(p), -1);
  return signed_value(p, *overlap_->nearest_touching(p), 1);
}

Tried<Answer> SolidPair::round_gap(const RealVector& p, bool depth) const {
  std::optional<Answer> best;
  for (const BodyPart& t : a_->parts) {
    for (const BodyPart& s : b_->parts) {
      const std::vector<space::HalfSpace> planes = space::difference_planes(t, s);
      const Real r = t.radius + s.radius;
      Answer v;
      if (planes.empty()) {
        v = with_radius(p, real(t.center - s.center), false, r);
      } else {
        space::OpenUnion core;
        core.add(space::everywhere(), planes);
        const bool inside = core.covers(p);
        v = with_radius(p, *(inside ? core.nearest_in_complement(p) : nearest_in(planes, p)), inside, r);
      }
      if (!best || v.value < best->value) best = std::move(v);
    }
  }
  const bool one_pair = a_->parts.size() == 1 && b_->parts.size() == 1;
  if (!depth || one_pair || best->value.sign() >= 0) return *best;
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
    const space::Bounds3 of_a = bounds(*a_), of_b = bounds(*b_);
    std::vector<GrownSet> sets;
    for (const BodyPart& t : a_->parts) {
      for (const BodyPart& s : b_->parts) sets.push_back(difference(t, s));
    }
    round_overlap_ = std::make_shared<const PositionSet>(
        PositionSet::outside(std::move(sets), space::minus(of_a.low, of_b.high), space::minus(of_a.high, of_b.low)));
  });
  TriedAnswer out = round_overlap_->nearest(p, true);
  if (!out) return out.refusal();
  if (!*out) return Refusal("the nearest free position of the rounded shapes is not found");
  return minus(**std::move(out));
}

Tried<Answer> SolidPair::protrusion(const Side& side, const RealVector& p, bool depth) const {
  if (side.fixed->convex()) return protrusion_of_convex(*side.moving, side.fixed->parts[0], p);
  if (!side.fixed->round()) {
    if (auto inside = inside_polyhedra(side, p)) return *inside;
  }
  Answer out = protrusion_of_union(*side.moving, *side.fixed, p);
  const bool inside = side.fixed->round() && out.value.sign() <= 0;
  if (depth && inside) return depth_inside(side, p);
  return out;
}

TriedAnswer SolidPair::bounded(Which which, const RealVector& p) const {
  const RealVector q = space::negated(p);
  // Exchanged roles see the position from the other side.
  const auto seen_back = [](TriedAnswer v) {
    if (v && *v && (*v)->nearest) (*v)->nearest = space::negated(*(*v)->nearest);
    return v;
  };
  const auto protrusion_back = [&](bool depth) {
    Tried<Answer> v = protrusion(back_, q, depth);
    if (!v) return v;
    exchange_roles(*v, p);
    if (v->nearest) v->nearest = space::negated(*v->nearest);
    return v;
  };
  switch (which) {
    case Which::kGamma1:
      return defined(gap(p));
    case Which::kGamma2:
      return std::optional(reach(p));
    case Which::kEta1:
      return contained(forth_, p);
    case Which::kEta2:
      return farthest_fit(forth_, p);
    case Which::kDelta1:
      return seen_back(contained(back_, q));
    case Which::kDelta2:
      return seen_back(farthest_fit(back_, q));
    case Which::kMu:
      return defined(protrusion(forth_, p));
    case Which::kMuBack:
      return defined(protrusion_back(true));
    case Which::kHausdorff: {
      const Tried<Answer> forth = protrusion(forth_, p, false), back = protrusion_back(false);
      if (!forth || !back) return (forth ? back : forth).refusal();
      return std::optional(forth->value < back->value ? *back : *forth);
    }
    case Which::kD1:
      return cut(gap(p, false), false);
    case Which::kH:
      return cut(protrusion(forth_, p, false), false);
    case Which::kHBack:
      return cut(protrusion_back(false), false);
    case Which::kDstar:
      return seen_back(clearance_inside(back_, q));
    case Which::kDstarBack:
      return clearance_inside(forth_, p);
    case Which::kPenetration:
      return cut(gap(p), true);
    case Which::kDiameter: {
      Answer most = reach(p);
      for (const Body* body : {a_.get(), b_.get()}) {
        const Real own = diameter(*body);
        if (most.value < own) most = exact_answer<RealVector>(own, Way::kParts);
      }
      return std::optional(std::move(most));
    }
  }
  return std::nullopt;
}

/// The depth of the deepest point of B + p, which lies in the interior of A's parts.
Tried<Answer> SolidPair::reach_into_parts(const RealVector& p) const {
  if (!a_->round()) return protrusion_of_cells(*b_, fit(forth_).cells, p);
  if (!a_->convex()) return Refusal("the protrusion from the complement of a union of round parts is not computed");
  // Within a radius r of a core the depth is r less the distance to the core, or r more than the depth in it.
  const BodyPart& part = a_->parts[0];
  Answer out;
  if (!part.core) {
    const Tried<Answer> apart = gap(p, false);
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
  out.proven = (*v)->proven;
  out.error = (*v)->error;
  return out;
}

/// A is the closure of the complement of its parts: the dual distances of the parts (distances.md 3.1).
TriedAnswer SolidPair::unbounded(Which which, const RealVector& p) const {
  const auto gamma1 = [&]() -> TriedAnswer {
    TriedAnswer v = contained(forth_, p);
    if (!v) return v;
    return std::optional(*v ? minus(**std::move(v)) : lowest_answer<RealVector>(Way::kParts));
  };
  const auto eta1 = [&](bool depth) -> Tried<Answer> {
    Tried<Answer> v = gap(p, depth);
    if (!v) return v;
    return minus(*std::move(v));
  };
  const auto mu = [&]() -> Tried<Answer> {
    Tried<Answer> v = eta1(false);
    if (!v || v->value.sign() <= 0) return v;
    return reach_into_parts(p);
  };
  switch (which) {
    case Which::kGamma1:
      return gamma1();
    case Which::kEta1:
      return defined(eta1(true));
    case Which::kMu:
      return defined(mu());
    case Which::kH:
      return cut(mu(), false);
    case Which::kD1:
      return cut(gamma1(), false);
    case Which::kPenetration:
      return cut(gamma1(), true);
    case Which::kDstarBack:
      return cut(eta1(true), true);
    case Which::kDstar:
      return std::optional(Answer{});
    default:
      return std::nullopt;
  }
}

TriedAnswer SolidPair::try_value(Which which, const RealVector& p) const {
  return outside_ ? unbounded(which, p) : bounded(which, p);
}

}  // namespace findspace::distance
