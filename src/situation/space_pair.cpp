// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "situation/space_pair.h"

#include <algorithm>
#include <numeric>

#include "findspace/error.h"
#include "situation/solve_space.h"
#include "space/box_shape.h"
#include "space/deepest.h"

namespace findspace::situation {

using distance::BoxPair;
using distance::SolidValue;
using distance::Which;
using exact::Real;
using space::Body;
using space::BoxComplex;
using space::Mark;
using space::real;
using space::RealVector;

namespace {

/// The union of the shapes as closed boxes.
std::optional<BoxComplex> united_boxes(const std::vector<const SpaceShape*>& shapes) {
  std::vector<const BoxComplex*> sets;
  for (const SpaceShape* s : shapes) {
    if (!s->boxes) return std::nullopt;
    sets.push_back(&*s->boxes);
  }
  return overlay(sets,
                 [](std::span<const Mark> m) {
                   return Mark(std::any_of(m.begin(), m.end(), [](Mark x) { return x != 0; }));
                 })
      .closure();
}

/// The union as a body; `boxes`: the same set as boxes, where it is made of them. Null: `refused` says why.
std::shared_ptr<const Body> united_bodies(const std::vector<const SpaceShape*>& shapes,
                                          const std::optional<BoxComplex>& boxes, std::string& refused) {
  if (boxes && shapes.size() > 1) {
    if (auto made = space::body_of(boxes->simplified())) return std::make_shared<const Body>(*std::move(made));
  }
  std::vector<const Body*> bodies;
  for (const SpaceShape* s : shapes) {
    if (!s->body) {
      refused = s->refused;
      return nullptr;
    }
    bodies.push_back(s->body.get());
  }
  if (bodies.size() == 1) return shapes[0]->body;
  try {
    return std::make_shared<const Body>(united(bodies));
  } catch (const Error& e) {
    if (e.code() != ErrorCode::kUnsupported) throw;
    refused = e.what();
    return nullptr;
  }
}

void scale_down(SolidValue& v, const Real& scale) {
  const auto down = [&](RealVector& q) {
    for (Real& c : q) c /= scale;
  };
  v.value /= scale, v.error /= scale.to_double();
  if (v.nearest) down(*v.nearest);
  if (v.points) down((*v.points)[0]), down((*v.points)[1]);
}

}  // namespace

SpacePair::SpacePair(const std::vector<const SpaceShape*>& moving, const std::vector<const SpaceShape*>& fixed) {
  auto b = united_boxes(moving), a = united_boxes(fixed);
  b_ = united_bodies(moving, b, refused_);
  a_ = united_bodies(fixed, a, refused_);
  if (b && a) boxes_ = std::make_unique<BoxPair>(*std::move(b), *std::move(a));
  if (!b_ || !a_) return;
  if (b_->outside) {
    if (!boxes_) throw Error(ErrorCode::kUnsupported, "a moving shape has to be bounded");
    refused_ = "a moving shape has to be bounded";
    return;
  }
  scale_ = std::lcm(b_->scale, a_->scale);
  b_ = std::make_shared<const Body>(space::at_scale(*b_, scale_));
  a_ = std::make_shared<const Body>(space::at_scale(*a_, scale_));
  bodies_ = std::make_unique<distance::SolidPair>(b_, a_);
}

const BoxPair& SpacePair::boxes() const {
  if (boxes_) return *boxes_;
  throw Error(ErrorCode::kUnsupported,
              "an exact map needs shapes whose faces are all parallel to the axes; --resolution N gives one on N times "
              "N lines");
}

const distance::SolidPair& SpacePair::bodies() const {
  if (bodies_) return *bodies_;
  throw Error(ErrorCode::kUnsupported, refused_);
}

std::optional<SolidValue> SpacePair::value(Which which, const RealVector& p) const {
  if (boxes_ && BoxPair::has_value(which)) {
    try {
      return boxes_->value(which, p);
    } catch (const Error& e) {
      // Too many coordinates for the grid: the bodies need none.
      if (e.code() != ErrorCode::kUnsupported || !bodies_) throw;
    }
  }
  const Real scale(scale_);
  auto v = bodies().value(which, space::scaled(scale, p));
  if (v && scale_ != 1) scale_down(*v, scale);
  return v;
}

namespace {

/// The half spaces {p : B + p does not leave this facet of A by more than the level}; `turned` for p -> -p.
std::vector<space::HalfSpace> fitting_planes(const Body& b, const space::BodyPart& a, const Real& level, bool turned) {
  std::vector<space::HalfSpace> planes;
  for (const space::Plane& p : a.core->planes()) {
    const RealVector n = real(p.normal);
    planes.emplace_back(turned ? space::negated(n) : n,
                        Real(p.offset) + support(b, n) - level * sqrt(space::dot(n, n)));
  }
  return planes;
}

}  // namespace

/// The empty set.
SpacePair::Sublevel SpacePair::none() const {
  Sublevel out{space::ConvexRegion({}, {}), Real(), Real(scale_)};
  RealVector up;
  up[2] = Real(1);
  out.region.cut(space::HalfSpace(up, Real(1)));
  return out;
}

std::optional<SpacePair::Sublevel> SpacePair::sublevel(Which which, const Real& level) const {
  if (!bodies_ || a_->outside) return std::nullopt;
  if (which == Which::kD1 && level.sign() > 0) which = Which::kGamma1;  // above 0 they are the same
  const Real scale(scale_), at = level * scale;
  const bool eta = which == Which::kEta1 || (which == Which::kMu && level.sign() <= 0),
             delta = which == Which::kDelta1 || (which == Which::kMuBack && level.sign() <= 0);
  const bool one_pair = a_->convex() && b_->convex();
  const bool balls = one_pair && a_->parts[0].point() && b_->parts[0].point();
  const auto plain = [](const Body& body) { return body.convex() && body.parts[0].core && !body.round(); };
  std::vector<space::HalfSpace> planes;
  Real radius;
  if (balls) {
    const Real &ra = a_->parts[0].radius, &rb = b_->parts[0].radius;
    if ((eta && ra < rb) || (delta && rb < ra)) return none();
    const bool near = which == Which::kGamma1 || which == Which::kGamma2 || eta || delta;
    if (!near) return std::nullopt;
    radius = at + (which == Which::kGamma1 ? ra + rb : which == Which::kGamma2 ? -(ra + rb) : eta ? ra - rb : rb - ra);
  } else if (eta && plain(*a_)) {
    planes = fitting_planes(*b_, a_->parts[0], std::min(at, Real()), false);
    radius = std::max(at, Real());
  } else if (delta && plain(*b_)) {
    planes = fitting_planes(*a_, b_->parts[0], std::min(at, Real()), true);
    radius = std::max(at, Real());
  } else if (which == Which::kGamma1 && one_pair) {
    const Real grown = at + a_->parts[0].radius + b_->parts[0].radius;
    planes = space::difference_planes(a_->parts[0], b_->parts[0]);
    radius = std::max(grown, Real());
    if (grown.sign() < 0) {
      for (space::HalfSpace& h : planes)
        h = space::HalfSpace(h.normal, h.offset - grown * sqrt(space::dot(h.normal, h.normal)));
    }
  } else {
    return std::nullopt;
  }
  if (radius.sign() < 0) return none();
  if (balls) {
    const RealVector center = real(a_->parts[0].center - b_->parts[0].center);
    return Sublevel{space::ConvexRegion(center, center), radius, scale};
  }
  // All positions at which the boxes around the shapes meet.
  const space::Bounds3 a = bounds(*a_), b = bounds(*b_);
  Sublevel out{space::ConvexRegion(space::minus(a.low, b.high), space::minus(a.high, b.low)), radius, scale};
  for (const space::HalfSpace& h : planes) out.region.cut(h);
  return out;
}

namespace {

BoxPair::Least least_at(const RealVector& at, const Real& value, const Real& scale) {
  space::IntervalBox box;
  for (std::size_t k = 0; k < 3; ++k) box[k] = {at[k] / scale, at[k] / scale, true, true};
  return {value / scale, BoxComplex::of_boxes(std::array<space::IntervalBox, 1>{box})};
}

}  // namespace

/// gamma1, eta1 and delta1 of convex shapes.
std::optional<BoxPair::Least> SpacePair::deepest_fit(Which which) const {
  if (!bodies_ || a_->outside) return std::nullopt;
  const auto plain = [](const Body& body) { return body.convex() && body.parts[0].core && !body.round(); };
  std::vector<space::HalfSpace> planes;
  Real grown;
  if (which == Which::kEta1 && plain(*a_)) {
    planes = fitting_planes(*b_, a_->parts[0], Real(), false);
  } else if (which == Which::kDelta1 && plain(*b_)) {
    planes = fitting_planes(*a_, b_->parts[0], Real(), true);
  } else if (which == Which::kGamma1 && a_->convex() && b_->convex()) {
    planes = space::difference_planes(a_->parts[0], b_->parts[0]);
    grown = a_->parts[0].radius + b_->parts[0].radius;
    if (planes.empty()) return least_at(real(a_->parts[0].center - b_->parts[0].center), -grown, Real(scale_));
  } else {
    return std::nullopt;
  }
  const space::Bounds3 a = bounds(*a_), b = bounds(*b_);
  const auto found = space::deepest(planes, space::minus(a.low, b.high), space::minus(a.high, b.low));
  if (!found) return std::nullopt;
  // Where nothing fits there is no distance.
  if (found->value.sign() > 0) return BoxPair::Least{Real(), BoxComplex()};
  return least_at(found->at, found->value - grown, Real(scale_));
}

std::optional<BoxPair::Least> SpacePair::least(Which which) const {
  if (auto found = boxes_ ? boxes_->least(which) : std::nullopt) return found;
  if (auto found = deepest_fit(which)) return found;
  if (which != Which::kGamma2 && which != Which::kEta2 && which != Which::kDelta2) return std::nullopt;
  const auto found = nearly_least(which);  // the others are taken by whole sets
  if (!found) return BoxPair::Least{Real(), BoxComplex()};
  if (!found->proven) return std::nullopt;
  const Real scale(scale_);
  return least_at(space::scaled(scale, found->at), found->value * scale, scale);
}

std::optional<distance::SolidLeast> SpacePair::nearly_least(Which which) const {
  bodies();
  const std::lock_guard lock(least_guard_);
  auto& slot = least_[which];
  if (!slot) slot = std::make_unique<std::optional<distance::SolidLeast>>(distance::solid_least(which, *b_, *a_));
  auto found = *slot;
  if (!found) return found;
  const Real scale(scale_);
  found->value /= scale, found->bound /= scale;
  for (Real& c : found->at) c /= scale;
  return found;
}

}  // namespace findspace::situation
