// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/planar/at_position.h"

#include "plane/base/real_vector.h"

namespace findspace::distance {

using exact::Real;
using exact::RealPoint;
using plane::operator+;
using plane::operator-;

namespace {

/// max(0, f), or max(0, -f); what attains f attains it where it is not cut off.
std::optional<PlanarAnswer> cut(std::optional<PlanarAnswer> m, bool negated) {
  const PlanarAnswer none = exact_answer(Real(), m ? m->way : Way::kMap);
  if (!m) return negated ? std::optional(none) : std::nullopt;
  if (m->minus_infinity) return negated ? std::nullopt : std::optional(none);
  if (m->proven) {
    if (negated) m->value = -m->value;
    return m->value.sign() < 0 ? none : m;
  }
  return cut_off(std::move(m), negated);
}

}  // namespace

AtPosition::AtPosition(std::shared_ptr<const ShapePair> pair)
    : pair_(std::move(pair)),
      searched_(pair_->at_origin() ? pair_->at_origin()->pair : pair_),
      boundaries_(searched_->moving(), searched_->fixed()),
      contacts_(searched_, boundaries_),
      directed_(boundaries_, contacts_) {}

double AtPosition::scale(const RealPoint& p) const {
  const auto& there = pair_->at_origin();
  return boundaries_.scale(there ? p + there->by : p);
}

std::optional<PlanarAnswer> AtPosition::measure(Which which, const RealPoint& p) const {
  if (!p.x.is_rational() || !p.y.is_rational()) return measured_there(which, p);
  {
    const std::lock_guard lock(guard_);
    if (last_ && last_->which == which && last_->at.x == p.x && last_->at.y == p.y) return last_->answer;
  }
  std::optional<PlanarAnswer> out = measured_there(which, p);
  const std::lock_guard lock(guard_);
  last_ = {which, p, out};
  return out;
}

std::optional<PlanarAnswer> AtPosition::measured_there(Which which, const RealPoint& p) const {
  const auto& there = pair_->at_origin();
  if (!there) return measured(which, p);
  auto m = measured(which, p + there->by);
  if (!m) return m;
  if (m->nearest) m->nearest = *m->nearest - there->by;
  if (m->farthest) m->farthest = *m->farthest - there->by;
  // The witness, too, is as far away as A was moved.
  for (Feature& f : m->witness) f.at = f.at - there->fixed_by;
  return m;
}

/// d1 = max(0, gamma1). Of shapes that overlap a common point is mostly found sooner than how they stand.
std::optional<PlanarAnswer> AtPosition::plain(const RealPoint& p) const {
  if (auto found = boundaries_.common_corner(p)) return found;
  if (auto crossing = crossing_pair(boundaries_.fixed(), boundaries_.moving(), p))
    return boundary_answer(Real(), features(*crossing));
  Standing s = boundaries_.standing(p);
  if (s.kind == Standing::Kind::kApart) {
    PlanarAnswer out = boundary_answer(s.pair->distance, features(*s.pair));
    out.nearest = p + (s.pair->first - s.pair->second);
    return out;
  }
  if (s.kind == Standing::Kind::kClose) {
    auto m = cut(contacts_.signed_value(Which::kGamma1, s, p), false);
    if (m->value.sign() > 0) return m;
  }
  return boundary_answer(Real(), boundaries_.common_point(s, p));
}

std::optional<PlanarAnswer> AtPosition::measured(Which which, const RealPoint& p) const {
  if (!boundaries_.complete()) return searched_->distance(which)->value(p);
  switch (which) {
    case Which::kGamma1:
    case Which::kEta1:
    case Which::kDelta1:
      return contacts_.signed_distance(which, p);
    case Which::kGamma2: {
      if (!boundaries_.bounded()) return std::nullopt;
      FeaturePair k = farthest_pair(boundaries_.fixed(), boundaries_.moving(), p);
      return boundary_answer(k.distance, features(k));
    }
    case Which::kEta2:
    case Which::kDelta2:
      return contacts_.farthest(which, p);
    case Which::kMu:
      return directed_.directed(false, p);
    case Which::kMuBack:
      return directed_.directed(true, p);
    case Which::kHausdorff:
      return directed_.hausdorff(p);
    case Which::kD1:
      return plain(p);
    case Which::kH:
      return cut(directed_.directed(false, p), false);
    case Which::kHBack:
      return cut(directed_.directed(true, p), false);
    case Which::kDstar:
      return cut(contacts_.signed_distance(Which::kDelta1, p), true);
    case Which::kDstarBack:
      return cut(contacts_.signed_distance(Which::kEta1, p), true);
    case Which::kDiameter:
      return boundaries_.diameter(p);
    case Which::kPenetration:
      return cut(contacts_.signed_distance(Which::kGamma1, p), true);
  }
  return std::nullopt;
}

}  // namespace findspace::distance
