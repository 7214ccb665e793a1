// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// SpacePair: sublevel sets that are convex, and least values.
#include <algorithm>

#include "distance/rays/ray_directional_least.h"
#include "formula/solid/space_pair.h"
#include "space/polytope/deepest.h"

namespace findspace::formula {

using distance::BoxMaps;
using distance::Which;
using exact::Real;
using exact::Tried;
using space::Body;
using space::BoxComplex;
using space::real;
using space::RealVector;

namespace {

/// The half spaces {p : B + p does not leave this facet of A by more than the level}; `rotated` for p -> -p.
std::vector<space::HalfSpace> fitting_planes(const Body& b, const space::BodyPart& a, const Real& level, bool rotated) {
  std::vector<space::HalfSpace> planes;
  for (const space::Plane& p : a.core->planes()) {
    const RealVector n = real(p.normal);
    planes.emplace_back(rotated ? space::negated(n) : n,
                        Real(p.offset) + support(b, n) - level * sqrt(space::dot(n, n)));
  }
  return planes;
}

}  // namespace

/// The empty set.
SpacePair::Sublevel SpacePair::none(std::int64_t scale) {
  Sublevel out{space::ConvexRegion({}, {}), Real(), Real(scale)};
  RealVector up;
  up[2] = Real(1);
  out.region.cut(space::HalfSpace(up, Real(1)));
  return out;
}

/// The bodies, or of a large one whose hull is enough that.
std::optional<SpacePair::Outlines> SpacePair::outlines(bool eta, bool delta) const {
  if (!surfaces_) {
    if (!all().pair || all().a->outside || all().b->outside) return std::nullopt;
    return Outlines{all().b.get(), all().a.get(), all().scale};
  }
  if (!surfaced_a_.outline || !surfaced_b_.outline) return std::nullopt;
  if ((!delta && !surfaced_a_.convex) || (!eta && !surfaced_b_.convex)) return std::nullopt;
  return Outlines{surfaced_b_.outline.pointer().get(), surfaced_a_.outline.pointer().get(), surface_scale_};
}

std::optional<SpacePair::Sublevel> SpacePair::sublevel(Which which, const Real& level) const {
  if (which == Which::kD1 && level.sign() > 0) which = Which::kGamma1;  // above 0 they are the same
  const bool eta = which == Which::kEta1 || (which == Which::kMu && level.sign() <= 0),
             delta = which == Which::kDelta1 || (which == Which::kMuBack && level.sign() <= 0);
  const auto pair = outlines(eta, delta);
  if (!pair) return std::nullopt;
  const space::Body *a = pair->a, *b = pair->b;
  const Real scale(pair->scale), at = level * scale;
  const bool one_pair = a->convex() && b->convex();
  const bool balls = one_pair && a->parts[0].point() && b->parts[0].point();
  const auto plain = [](const Body& body) { return body.convex() && body.parts[0].core && !body.round(); };
  std::vector<space::HalfSpace> planes;
  Real radius;
  if (balls) {
    const Real &ra = a->parts[0].radius, &rb = b->parts[0].radius;
    if ((eta && ra < rb) || (delta && rb < ra)) return none(pair->scale);
    const bool near = which == Which::kGamma1 || which == Which::kGamma2 || eta || delta;
    if (!near) return std::nullopt;
    radius = at + (which == Which::kGamma1 ? ra + rb : which == Which::kGamma2 ? -(ra + rb) : eta ? ra - rb : rb - ra);
  } else if (eta && plain(*a)) {
    planes = fitting_planes(*b, a->parts[0], std::min(at, Real()), false);
    radius = std::max(at, Real());
  } else if (delta && plain(*b)) {
    planes = fitting_planes(*a, b->parts[0], std::min(at, Real()), true);
    radius = std::max(at, Real());
  } else if (which == Which::kGamma1 && one_pair) {
    const Real grown = at + a->parts[0].radius + b->parts[0].radius;
    planes = space::difference_planes(a->parts[0], b->parts[0]);
    radius = std::max(grown, Real());
    if (grown.sign() < 0) {
      for (space::HalfSpace& h : planes)
        h = space::HalfSpace(h.normal, h.offset - grown * sqrt(space::dot(h.normal, h.normal)));
    }
  } else {
    return std::nullopt;
  }
  if (radius.sign() < 0) return none(pair->scale);
  if (balls) {
    const RealVector center = real(a->parts[0].center - b->parts[0].center);
    return Sublevel{space::ConvexRegion(center, center), radius, scale};
  }
  // All positions at which the boxes around the shapes meet.
  const space::Bounds3 of_a = bounds(*a), of_b = bounds(*b);
  Sublevel out{space::ConvexRegion(space::minus(of_a.low, of_b.high), space::minus(of_a.high, of_b.low)), radius,
               scale};
  for (const space::HalfSpace& h : planes) out.region.cut(h);
  return out;
}

namespace {

BoxMaps::Least least_at(const RealVector& at, const Real& value, const Real& scale) {
  space::IntervalBox box;
  for (std::size_t k = 0; k < 3; ++k) box[k] = {at[k] / scale, at[k] / scale, true, true};
  return {value / scale, BoxComplex::of_boxes(std::array<space::IntervalBox, 1>{box})};
}

}  // namespace

/// gamma1, eta1 and delta1 of convex shapes.
std::optional<BoxMaps::Least> SpacePair::deepest_fit(Which which) const {
  const auto pair = outlines(which == Which::kEta1, which == Which::kDelta1);
  if (!pair) return std::nullopt;
  const space::Body &a = *pair->a, &b = *pair->b;
  const std::int64_t scale = pair->scale;
  const auto plain = [](const Body& body) { return body.convex() && body.parts[0].core && !body.round(); };
  std::vector<space::HalfSpace> planes;
  Real grown;
  if (which == Which::kEta1 && plain(a)) {
    planes = fitting_planes(b, a.parts[0], Real(), false);
  } else if (which == Which::kDelta1 && plain(b)) {
    planes = fitting_planes(a, b.parts[0], Real(), true);
  } else if (which == Which::kGamma1 && a.convex() && b.convex()) {
    planes = space::difference_planes(a.parts[0], b.parts[0]);
    grown = a.parts[0].radius + b.parts[0].radius;
    if (planes.empty()) return least_at(real(a.parts[0].center - b.parts[0].center), -grown, Real(scale));
  } else {
    return std::nullopt;
  }
  const space::Bounds3 of_a = bounds(a), of_b = bounds(b);
  const auto found = space::deepest(planes, space::minus(of_a.low, of_b.high), space::minus(of_a.high, of_b.low));
  if (!found) return std::nullopt;
  // Where nothing fits there is no distance.
  if (found->value.sign() > 0) return BoxMaps::Least{Real(), BoxComplex()};
  return least_at(found->at, found->value - grown, Real(scale));
}

Tried<std::optional<BoxMaps::Least>> SpacePair::least(Which which) const {
  if (boxes_) {
    auto of_boxes = boxes_->least(which);
    if (!of_boxes || *of_boxes) return of_boxes;
  }
  if (auto found = deepest_fit(which)) return found;
  if (which != Which::kGamma2 && which != Which::kEta2 && which != Which::kDelta2) return std::nullopt;
  const auto tried = nearly_least(which);  // the others are taken by whole sets
  if (!tried) return tried.refusal();
  const std::optional<distance::Answer>& found = *tried;
  if (!found) return BoxMaps::Least{Real(), BoxComplex()};
  if (!found->proven) return std::nullopt;
  const Real scale(all().scale);
  return least_at(space::scaled(scale, found->at), found->value * scale, scale);
}

Tried<std::optional<distance::Answer>> SpacePair::nearly_least(Which which) const {
  if (!cut_ && !between_ && !all().pair) return *all().refused;
  const std::lock_guard lock(least_guard_);
  auto& slot = least_[which];
  if (!slot) {
    auto made = cut_side_  ? distance::csg_least(which, cut_side_, cut_moves_)
                : between_ ? between_->of.least(between_->which(which))
                           : distance::solid_least(which, *all().b, *all().a);
    if (!made) return made;
    slot = std::make_unique<std::optional<distance::Answer>>(*std::move(made));
  }
  auto found = *slot;
  if (!found) return found;
  return distance::in_unit(*found, Real::ratio(1, cut_ || between_ ? cut_scale_ : all().scale));
}

Tried<std::optional<distance::Answer>> SpacePair::directional_least(Which which, const RealVector& direction,
                                                                    bool both_ways) const {
  if (const auto zero = sublevel(which, Real())) {
    const auto found = distance::convex_directional_least(zero->region, zero->radius, direction, both_ways);
    return found ? std::optional(distance::in_unit(*found, Real(1) / zero->scale)) : std::nullopt;
  }
  if (cut_ || between_) {
    auto found = between_ ? between_->of.least_along(between_->which(which), {direction, both_ways})
                          : distance::csg_directional_least(which, cut_side_, cut_moves_, direction, both_ways);
    if (!found || !*found) return found;
    return distance::in_unit(**found, Real::ratio(1, cut_scale_));
  }
  if (!all().pair) return *all().refused;
  auto found = distance::ray_directional_least(which, direction, both_ways, *all().b, *all().a);
  if (!found || !*found) return found;
  return distance::in_unit(**found, Real::ratio(1, all().scale));
}

}  // namespace findspace::formula
