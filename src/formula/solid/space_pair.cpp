// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "formula/solid/space_pair.h"

#include <algorithm>

#include "findspace/error.h"
#include "formula/solid/faults.h"
#include "space/body/cell_parts.h"
#include "space/body/observe_body.h"
#include "space/box/box_operations.h"
#include "space/box/box_topology.h"
#include "space/shape/box_shape.h"

namespace findspace::formula {

using distance::Answer;
using distance::BoxMaps;
using distance::Which;
using exact::Real;
using exact::Refusal;
using exact::Tried;
using space::Body;
using space::BoxComplex;
using space::RealVector;

namespace {

/// The union of the shapes as closed boxes; perhaps too fine.
std::optional<BoxComplex> united_boxes(const std::vector<SpaceShape>& shapes) {
  std::vector<const BoxComplex*> sets;
  for (const SpaceShape& s : shapes) {
    if (!s.boxes) return std::nullopt;
    sets.push_back(&*s.boxes);
  }
  return sets.size() == 1 ? closure(*sets[0]) : closure(united(sets));
}

/// The union as a body; `boxes`: the same set as boxes, where it is made of them.
Tried<std::shared_ptr<const Body>> united_bodies(const std::vector<SpaceShape>& shapes,
                                                 const std::optional<BoxComplex>& boxes) {
  if (boxes && shapes.size() > 1) {
    if (auto made = space::body_of(boxes->simplified())) return std::make_shared<const Body>(*std::move(made));
  }
  std::vector<const Body*> bodies;
  for (const SpaceShape& s : shapes) {
    if (!s.body) return Refusal(s.refused);
    const Tried<LazyBody::Pointer> body = throwing_faults(s.body.try_pointer());
    if (!body || shapes.size() == 1) return body;
    bodies.push_back(body->get());
  }
  Tried<Body> all = try_united(bodies);
  if (!all) return Refusal(all.refusal().error.what());
  return std::make_shared<const Body>(*std::move(all));
}

}  // namespace

SpacePair::SpacePair(const std::vector<const SpaceShape*>& moving, const std::vector<const SpaceShape*>& fixed) {
  for (const SpaceShape* s : moving) moving_.push_back(*s);
  for (const SpaceShape* s : fixed) fixed_.push_back(*s);
  moving_boxes_ = united_boxes(moving_);
  fixed_boxes_ = united_boxes(fixed_);
  for (const auto* boxes : {&moving_boxes_, &fixed_boxes_}) {
    if (!*boxes || !(*boxes)->too_fine()) continue;
    refusal_ = BoxComplex(**boxes).checked().refusal();
    return;
  }
  if (moving_boxes_ && fixed_boxes_) boxes_ = std::make_unique<BoxMaps>(*moving_boxes_, *fixed_boxes_);
  const CsgShapes cut = csg_shapes(moving_, fixed_);
  cut_side_ = cut.side();
  cut_moves_ = cut.cut_moves;
  cut_scale_ = cut.scale;
  if (cut_side_) {
    cut_ = csg_pair(cut_side_, cut_moves_);
  } else {
    between_ = cut_between(moving_, fixed_);
    if (between_) cut_scale_ = between_->scale;
  }
  const auto large = [](const SpaceShape& s) { return s.surfaces != nullptr; };
  if (std::any_of(moving_.begin(), moving_.end(), large) || std::any_of(fixed_.begin(), fixed_.end(), large))
    make_surfaces();
  else if (const Bodies& made = all(); !boxes_ && made.b && made.b->outside)
    refusal_ = made.refused;
}

std::unique_ptr<const SpacePair::Bodies> SpacePair::made_bodies() const {
  auto out = std::make_unique<Bodies>();
  const auto b = united_bodies(moving_, moving_boxes_), a = united_bodies(fixed_, fixed_boxes_);
  if (!b || !a) {
    out->refused = (a ? b : a).refusal();
    return out;
  }
  out->b = *b;
  out->a = *a;
  if (out->b->outside && out->a->outside) {
    out->refused = Refusal("of two complements the distances are not computed in 3D");
    return out;
  }
  out->scale = space::joint_scale(out->b->scale, out->a->scale);
  out->b = std::make_shared<const Body>(space::at_scale(*out->b, out->scale));
  out->a = std::make_shared<const Body>(space::at_scale(*out->a, out->scale));
  observe_body("the moving shape", *out->b);
  observe_body("the fixed shape", *out->a);
  // B + p in A is A - p in B.
  out->pair = out->b->outside ? distance::exchanged(distance::solid_pair(out->a, out->b))
                              : distance::solid_pair(out->b, out->a);
  return out;
}

namespace {

/// Nothing of it where a shape has no surface, goes on for ever, or lies too far out.
distance::Surfaced surfaced(const std::vector<SpaceShape>& shapes, std::int64_t scale) {
  auto set = std::make_shared<space::SurfaceSet>();
  for (const SpaceShape& s : shapes) {
    if (!(s.surfaces ? set->add(*s.surfaces, scale) : s.body && set->add(*s.body, scale))) return {};
  }
  distance::Surfaced out{set, nullptr, false};
  const SpaceShape& only = shapes[0];
  out.convex = shapes.size() == 1 && (only.surfaces ? only.convex : only.body->convex());
  const bool as_it_is = shapes.size() == 1 && (out.convex || !only.surfaces);
  if (as_it_is) out.parts = std::make_shared<const Body>(space::at_scale(*only.body, scale));
  out.outline = as_it_is ? distance::Outline(out.parts) : distance::Outline::of(set, scale);
  return out;
}

}  // namespace

/// Where they cannot be made the bodies answer alone.
void SpacePair::make_surfaces() {
  for (const auto* shapes : {&moving_, &fixed_}) {
    for (const SpaceShape& s : *shapes) {
      if (!s.surfaces && s.body) surface_scale_ = space::joint_scale(surface_scale_, s.body->scale);
    }
  }
  surfaced_b_ = surfaced(moving_, surface_scale_);
  surfaced_a_ = surfaced(fixed_, surface_scale_);
  surfaces_ = distance::surface_pair(surfaced_b_, surfaced_a_);
}

const SpacePair::Bodies& SpacePair::all() const {
  const std::lock_guard lock(bodies_guard_);
  if (!bodies_) bodies_ = made_bodies();
  return *bodies_;
}

Tried<const BoxMaps*> SpacePair::boxes() const {
  if (boxes_) return boxes_.get();
  return Refusal(
      "an exact map needs shapes whose faces are all parallel to the axes; --resolution N gives one on N times "
      "N lines");
}

namespace {

/// What is asked at p in steps / scale, by that way if no search.
template <class Ask>
Tried<std::optional<Answer>> asked(distance::Way way, std::int64_t scale, const RealVector& p, const Ask& ask) {
  Tried<std::optional<Answer>> v = ask(space::scaled(Real(scale), p));
  if (v && *v && scale != 1) **v = distance::in_unit(**v, Real::ratio(1, scale));
  if (v && *v) (*v)->way = (*v)->proven ? way : distance::Way::kSearch;
  return v;
}

}  // namespace

Tried<std::optional<Answer>> SpacePair::value_of_bodies(Which which, const RealVector& p) const {
  if (!all().pair) return *all().refused;
  return asked(distance::Way::kParts, all().scale, p,
               [&](const RealVector& at) { return all().pair->try_value(which, at); });
}

// Boxes, then the ways of cut shapes and of surfaces, then bodies.
Tried<std::optional<Answer>> SpacePair::value(Which which, const RealVector& p) const {
  if (boxes_ && !BoxMaps::protrudes(which) && (!BoxMaps::is_reach(which) || !all().pair)) {
    auto v = asked(distance::Way::kBoxes, 1, p,
                   [&](const RealVector& at) { return boxes_->distances().try_value(which, at); });
    if (v || !all().pair) return v;  // too many coordinates for the grid: the bodies need none
  }
  if (cut_)
    return asked(distance::Way::kCut, cut_scale_, p, [&](const RealVector& at) { return cut_->try_value(which, at); });
  if (between_)
    return asked(distance::Way::kCut, cut_scale_, p, [&](const RealVector& at) { return between_->value(which, at); });
  if (surfaces_) {
    auto v = asked(distance::Way::kSurfaces, surface_scale_, p,
                   [&](const RealVector& at) { return surfaces_->try_value(which, at); });
    if (v) return v;
  }
  return value_of_bodies(which, p);
}

std::function<exact::Interval(const space::Vector&)> SpacePair::within(Which which) const {
  if (cut_ || between_ || (!surfaces_ && !all().pair)) return [](const space::Vector&) { return exact::whole_line(); };
  const auto scale = static_cast<double>(surfaces_ ? surface_scale_ : all().scale);
  return [pair = surfaces_ ? &*surfaces_ : &*all().pair, which, scale](const space::Vector& p) {
    const exact::Interval found = pair->within(which, space::scaled(scale, p));
    return scale == 1 ? found : exact::outward(found.lo / scale, found.hi / scale);
  };
}

// They overlap, or are nearer than the level, where B grown by a ball of it overlaps A.
std::optional<RealVector> SpacePair::nearest_apart(const Real& level, const RealVector& p) const {
  if (surfaces_ || cut_ || between_ || level.sign() <= 0) return std::nullopt;
  const Bodies& made = all();
  if (!made.pair || made.a->outside || made.b->outside || made.a->parts.size() * made.b->parts.size() > kMostApart)
    return std::nullopt;
  auto grown = std::make_shared<Body>(*made.b);
  for (space::BodyPart& part : grown->parts) part.radius = part.radius + level * Real(made.scale);
  const auto v =
      distance::solid_pair(std::move(grown), made.a).try_value(Which::kGamma1, space::scaled(Real(made.scale), p));
  if (!v || !*v || (*v)->value.sign() >= 0 || !(*v)->nearest) return std::nullopt;
  return space::scaled(Real::ratio(1, made.scale), *(*v)->nearest);
}

}  // namespace findspace::formula
