// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/solid/solid_pair.h"

#include <algorithm>

#include "distance/answer/answer.h"
#include "distance/search/position_set.h"
#include "distance/search/set_protrusion.h"
#include "distance/search/solid_protrusion.h"
#include "distance/solid/far_corners.h"
#include "exact/margins/protrusion.h"
#include "exact/margins/rounding.h"
#include "exact/margins/space_distance.h"
#include "plane/base/search_work.h"
#include "space/body/body_boxes.h"

namespace findspace::distance {

using exact::Real;
using exact::Refusal;
using space::Body;
using space::BodyPart;
using space::real;
using space::RealVector;

TriedAnswer nearest_value(const RealVector& p, const space::NearestOutside& found, int sign, const char* what) {
  if (!found.at && found.spent) return plane::search_spent(what);
  if (!found.at) return std::nullopt;
  Answer out = signed_value(p, *found.at, sign);
  if (!found.spent) return out;
  Real end = Real::from_double(sign * found.bound);
  out.nearest.reset();
  out.set_unproven();
  out.way = Way::kSearch;
  out.error = abs(out.value - end).to_double();
  out.enclosed = sign > 0 ? Enclosure{std::move(end), out.value} : Enclosure{out.value, std::move(end)};
  return out;
}

TriedAnswer SolidSide::gap(const RealVector& p, Depth depth) const {
  if (a_->round() || b_->round()) return round_gap(p, depth);
  const space::OpenUnion& overlap = overlap_.of([&] { return overlap_cover(*b_, *a_); });
  if (overlap.covers(p)) {
    return nearest_value(p, overlap.nearest_in_complement(p), -1,
                         "how deep the shapes are in one another was not found");
  }
  return signed_value(p, *overlap.nearest_touching(p), 1);
}

TriedAnswer SolidSide::round_gap(const RealVector& p, Depth depth) const {
  std::optional<Answer> best;
  for (const BodyPart& t : a_->parts) {
    for (const BodyPart& s : b_->parts) {
      Answer v = difference(t, s).to_boundary(p);
      if (!best || v.value < best->value) best = std::move(v);
    }
  }
  const bool one_pair = a_->parts.size() == 1 && b_->parts.size() == 1;
  if (depth == Depth::kSign || one_pair || best->value.sign() >= 0) return best;
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
  const auto& free = round_overlap_.of([&] {
    const space::Bounds3 box = space::meeting(bounds(*b_), bounds(*a_));
    return std::make_shared<const PositionSet>(PositionSet::outside(differences_of_parts(*a_, *b_), box.low, box.high));
  });
  TriedAnswer out = free->nearest(p, true);
  if (!out) return out;
  if (!*out) return Refusal("the nearest free position of the rounded shapes is not found");
  return minus(**std::move(out));
}

TriedAnswer SolidSide::protrusion(const RealVector& p, Depth depth) const {
  if (a_->convex()) return protrusion_of_convex(*b_, a_->parts[0], p);
  if (!a_->round()) {
    if (auto inside = inside_polyhedra(p)) return inside;
  }
  Answer out = protrusion_of_union(*b_, *a_, p);
  const bool inside = a_->round() && out.value.sign() <= 0;
  if (depth == Depth::kValue && inside) return depth_inside(p);
  return out;
}

/// The depth of the deepest point of B + p, which lies in the interior of A's parts.
TriedAnswer SolidSide::reach_into_parts(const RealVector& p) const {
  const BodyPart& part = a_->parts[0];
  const bool point = a_->convex() && part.point();
  if (!a_->round() && !point) return protrusion_of_cells(*b_, outside_of_fixed(), p);
  if (!a_->convex()) return reach_into_round_parts(p);
  // Within a radius r of a core the depth is r less the distance to the core, or r more than the depth in it.
  Answer out;
  if (!part.core) {
    const TriedAnswer apart = gap(p, Depth::kSign);
    if (!apart) return apart;
    out.value = std::min(-(*apart)->value, part.radius);
    return out;
  }
  Body core = *a_;
  core.parts[0].radius = Real();
  core.outside = true;
  const TriedAnswer v = solid_pair(b_, std::make_shared<const Body>(std::move(core))).try_value(Which::kMu, p);
  if (!v) return v;
  out.value = (*v)->value + part.radius;
  if (!(*v)->proven) out.set_unproven();
  out.error = (*v)->error;
  return out;
}

/// The same, of a union: how far B protrudes from what that leaves free.
TriedAnswer SolidSide::reach_into_round_parts(const RealVector& p) const {
  const space::Bounds3 box = bounds(*a_);
  const PositionSet free = PositionSet::outside_of(*a_);
  NearSet left;
  left.places = &free;
  for (const BodyPart& part : a_->parts) left.take_away(part);
  const Solids solids = solids_of(*b_, p);
  const space::Extent about = space::rounded(box);
  const double size = 1 + space::length(space::rounded(p)) + space::length(about.low) + space::length(about.high);
  const exact::Tried<SetProtrusion> out = set_protrusion(solids, {left}, size, margin::kProtrudesTo * size);
  if (!out) return out.refusal();
  return std::optional(out->answer(size));
}

TriedAnswer SolidSide::diameter(const RealVector& p) const {
  TriedAnswer most = reach(p);
  for (const Body* body : {a_.get(), b_.get()}) {
    const Real own = distance::diameter(*body);
    if ((*most)->value < own) most = exact_answer<RealVector>(own, Way::kParts);
  }
  return most;
}

namespace {

/// B in the closure of what A's parts leave: the dual distances of the parts (distances.md 3.1).
class ComplementSide : public PairSide {
 public:
  explicit ComplementSide(std::shared_ptr<const SolidSide> parts) : parts_(std::move(parts)) {}

  exact::Interval gap_within(const space::Vector& p) const override { return -parts_->fit_within(p); }
  exact::Interval fit_within(const space::Vector& p) const override { return -parts_->gap_within(p); }

  TriedAnswer gap(const RealVector& p, Depth /*depth*/) const override {
    TriedAnswer v = parts_->fit(p);
    if (!v) return v;
    return *v ? minus(**std::move(v)) : lowest_answer<RealVector>(Way::kParts);
  }
  TriedAnswer fit(const RealVector& p) const override { return less_gap(p, Depth::kValue); }
  TriedAnswer protrusion(const RealVector& p, Depth /*depth*/) const override {
    TriedAnswer inside = less_gap(p, Depth::kSign);
    if (!inside || (*inside)->value.sign() <= 0) return inside;
    return parts_->reach_into_parts(p);
  }

 private:
  TriedAnswer less_gap(const RealVector& p, Depth depth) const {
    TriedAnswer v = parts_->gap(p, depth);
    if (!v) return v;
    return minus(**std::move(v));
  }

  std::shared_ptr<const SolidSide> parts_;
};

}  // namespace

PairDistances solid_pair(std::shared_ptr<const Body> b, std::shared_ptr<const Body> a) {
  if (!a->outside) return {std::make_shared<const SolidSide>(b, a), std::make_shared<const SolidSide>(a, b)};
  auto parts = std::make_shared<Body>(*a);
  parts->outside = false;
  return {std::make_shared<const ComplementSide>(std::make_shared<const SolidSide>(std::move(b), std::move(parts))),
          std::make_shared<const PairSide>()};
}

TriedAnswer SolidSide::reach(const RealVector& p) const {
  return std::optional(farthest_apart(corners_of(*b_), corners_of(*a_), p));
}

}  // namespace findspace::distance
