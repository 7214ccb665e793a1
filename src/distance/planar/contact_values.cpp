// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/planar/contact_values.h"

#include <algorithm>
#include <cmath>

#include "distance/planar/farthest.h"
#include "exact/margins/planar_distance.h"
#include "plane/base/real_vector.h"
#include "plane/query/topology.h"

namespace findspace::distance {

using exact::RealPoint;
using plane::operator+;
using plane::operator-;

namespace {

constexpr std::size_t kFewEdges = 10'000, kFewParts = 64;  // of A: the whole is as quick
constexpr std::size_t kEdgesAQuestion = 500;               // of A: more questions cost more than its map

/// How shapes stand where boundaries tell the distance by themselves.
Standing::Kind decided_by_boundaries(Which which) {
  using Kind = Standing::Kind;
  return which == Which::kGamma1 ? Kind::kApart : which == Which::kEta1 ? Kind::kInside : Kind::kAround;
}

}  // namespace

std::vector<Feature> ContactValues::contact(const RealPoint& position, const RealPoint& p) const {
  const FeatureTree &fixed = boundaries_.fixed(), &moving = boundaries_.moving();
  FeaturePair k = touching_pair(fixed, moving, position);
  // Chains touch where they cross, too.
  if (near_value(k.distance) > (moving.scale() + fixed.scale()) * margin::kHardlyOut)
    k = distance::common_point(fixed, moving, position);
  k.second = k.second - (position - p);
  return features(k);
}

std::optional<PlanarAnswer> ContactValues::signed_distance(Which which, const RealPoint& p) const {
  const Standing s = boundaries_.standing(p);
  if (s.kind != decided_by_boundaries(which)) return signed_value(which, s, p);
  const bool outside = s.kind == Standing::Kind::kApart;
  PlanarAnswer out = boundary_answer(outside ? s.pair->distance : -s.pair->distance, features(*s.pair));
  out.nearest = p + (s.pair->first - s.pair->second);
  return out;
}

const PenetrationDepth* ContactValues::penetration_depth(Which which) const {
  const std::size_t k = which == Which::kGamma1 ? 0 : which == Which::kEta1 ? 1 : 2;
  std::call_once(made_[k], [&] {
    const FeatureTree &fixed = boundaries_.fixed(), &moving = boundaries_.moving();
    // A lies in B + p where A - p lies in B.
    depths_[k] = which == Which::kDelta1
                     ? PenetrationDepth::make(fixed, moving, PenetrationDepth::Of::kContainment)
                     : PenetrationDepth::make(moving, fixed,
                                              which == Which::kGamma1 ? PenetrationDepth::Of::kContact
                                                                      : PenetrationDepth::Of::kContainment);
  });
  return depths_[k] && depths_[k]->pays() && !pair_->has(which) ? depths_[k].get() : nullptr;
}

const plane::BoundaryComponents* ContactValues::parts() const {
  std::call_once(parts_made_, [&] {
    const plane::Region& a = boundaries_.fixed().region();
    if (a.edges.size() < kFewEdges || !boundaries_.bounded()) return;
    parts_.emplace(a);
    if (parts_->size() < kFewParts) parts_.reset();
    questions_left_ = std::int64_t(a.edges.size() / kEdgesAQuestion);
  });
  return parts_ ? &*parts_ : nullptr;
}

std::optional<ContactValues::Held> ContactValues::held_near(Which which, const RealPoint& p) const {
  const FeatureTree& moving = boundaries_.moving();
  if (which == Which::kDelta1 || pair_->has(which) || moving.empty() || !parts() || questions_left_-- <= 0)
    return std::nullopt;
  const plane::Region& whole = boundaries_.fixed().region();
  const FeatureBox& b = moving.nodes()[0].box;
  const double x = near_value(p.x), y = near_value(p.y);
  for (std::int64_t reach = std::llround(std::max(b.x1 - b.x0, b.y1 - b.y0)) + 1;; reach *= 2) {
    const double by = double(reach) + 1;  // and more than rounding
    const plane::Region near = parts()->near(whole, {b.x0 + x - by, b.y0 + y - by, b.x1 + x + by, b.y1 + y + by});
    if (2 * near.edges.size() > whole.edges.size()) return std::nullopt;
    if (near.vertices.empty() && which == Which::kGamma1) return Held{false, {}};
    if (near.edges.empty() && which == Which::kGamma1) return std::nullopt;  // isolated points
    if (near.edges.empty()) continue;
    const FeatureTree fixed(near);
    const auto depth = PenetrationDepth::make(
        moving, fixed, which == Which::kGamma1 ? PenetrationDepth::Of::kContact : PenetrationDepth::Of::kContainment,
        PenetrationDepth::When::kAlways);
    if (!depth) return std::nullopt;
    if (!depth->holds(p)) return Held{false, {}};
    // Fewer parts have fewer obstacles to contact, and fewer places to lie in: beyond the reach nothing is certain.
    PenetrationDepth::Found found = depth->nearest(p);
    if (!found.known) return std::nullopt;
    if (found.nearest && found.nearest->distance <= exact::Real(reach)) return Held{true, std::move(found)};
  }
}

std::optional<ContactValues::Held> ContactValues::held(Which which, const RealPoint& p) const {
  if (auto near = held_near(which, p)) return near;
  const PenetrationDepth* depth = penetration_depth(which);
  if (!depth) return std::nullopt;
  const RealPoint at = which == Which::kDelta1 ? -p : p;
  if (!depth->holds(at)) return Held{false, {}};
  return Held{true, depth->nearest(at)};
}

std::optional<PlanarAnswer> ContactValues::signed_value(Which which, const Standing& s, const RealPoint& p) const {
  const std::optional<Held> held = this->held(which, p);
  if (!held) return by_map(which, p);
  const bool back = which == Which::kDelta1, positive = held->holds != (which == Which::kGamma1);
  if (!held->holds) {  // their insides (or that of B and the outside of A) do not meet
    const FeaturePair k = s.pair ? *s.pair : closest_pair(boundaries_.fixed(), boundaries_.moving(), p);
    PlanarAnswer out = boundary_answer(positive ? k.distance : -k.distance, features(k));
    if (k.distance.sign() != 0) out.nearest = p + (k.first - k.second);
    return out;
  }
  const PenetrationDepth::Found& found = held->found;
  if (!found.known) return by_map(which, p);
  // Of contact: it holds everywhere.
  if (!found.nearest) return positive ? std::nullopt : std::optional(lowest_answer(Way::kContacts));
  PlanarAnswer out = exact_answer(positive ? found.nearest->distance : -found.nearest->distance, Way::kContacts);
  const RealPoint& q = found.nearest->at;
  const RealPoint there = back ? -q : q;
  if (out.value.sign() != 0) out.nearest = there;
  out.witness = contact(there, p);
  return out;
}

std::optional<PlanarAnswer> ContactValues::by_map(Which which, const RealPoint& p) const {
  auto out = pair_->distance(which)->value(p);
  if (!out || out->minus_infinity) return out;
  if (out->nearest || out->value.sign() == 0) out->witness = contact(out->nearest.value_or(p), p);
  return out;
}

std::optional<PlanarAnswer> ContactValues::farthest(Which which, const RealPoint& p) const {
  const bool back = which == Which::kDelta2;
  const FeatureTree &fixed = boundaries_.fixed(), &moving = boundaries_.moving();
  // What holds all that is far away contains a bounded shape there.
  if (!plane::is_bounded((back ? moving : fixed).region()) && plane::is_bounded((back ? fixed : moving).region()))
    return std::nullopt;
  const auto to = [&](const RealPoint& q, const exact::Real& distance, Way way) {
    PlanarAnswer out = exact_answer(distance, way);
    out.farthest = q;
    out.witness = contact(q, p);
    return out;
  };
  const PenetrationDepth* depth = pair_->has(which) ? nullptr : penetration_depth(back ? Which::kDelta1 : Which::kEta1);
  if (depth) {
    const PenetrationDepth::Found found = depth->farthest(back ? -p : p);
    if (found.known && !found.nearest) return std::nullopt;
    if (found.known) return to(back ? -found.nearest->at : found.nearest->at, found.nearest->distance, Way::kContacts);
  }
  auto f = pair_->distance(which);
  if (!f->defined()) return std::nullopt;
  return to(static_cast<const Farthest&>(*f).farthest_point(p), f->value(p)->value, Way::kMap);
}

}  // namespace findspace::distance
