// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The distances of AtPosition that are translations to a contact: gamma1, eta1, delta1, eta2, delta2.

#include "distance/planar/at_position.h"
#include "distance/planar/farthest.h"
#include "exact/number/margins.h"
#include "plane/base/real_vector.h"

namespace findspace::distance {

using exact::RealPoint;
using plane::operator+;
using plane::operator-;

/// The points that come together when B goes from p to `position`, where it touches A.
void AtPosition::add_contact(Measured& m, const RealPoint& position, const RealPoint& p) const {
  FeaturePair k = touching_pair(fixed(), moving(), position);
  // Chains touch where they cross, too.
  if (near_value(k.distance) > (moving().scale() + fixed().scale()) * margin::kHardlyOut)
    k = distance::common_point(fixed(), moving(), position);
  k.second = k.second - (position - p);
  m.witness = features(k);
}

std::optional<Measured> AtPosition::signed_distance(Which which, Standing::Kind quick, const RealPoint& p) const {
  Standing s = standing(p);
  if (s.kind == quick) {
    bool outside = quick == Standing::Kind::kApart;
    RealPoint step = s.pair->first - s.pair->second;
    return Measured{outside ? s.pair->distance : -s.pair->distance, p + step, std::nullopt, features(*s.pair)};
  }
  return signed_value(which, s, p);
}

/// Null where there is none, or the map serves better.
const PenetrationDepth* AtPosition::penetration_depth(Which which) const {
  const std::size_t k = which == Which::kGamma1 ? 0 : which == Which::kEta1 ? 1 : 2;
  std::call_once(ways_made_[k], [&] {
    // A lies in B + p where A - p lies in B.
    ways_[k] = which == Which::kDelta1
                   ? PenetrationDepth::make(fixed(), moving(), PenetrationDepth::Of::kContainment)
                   : PenetrationDepth::make(
                         moving(), fixed(),
                         which == Which::kGamma1 ? PenetrationDepth::Of::kContact : PenetrationDepth::Of::kContainment);
  });
  return ways_[k] && ways_[k]->pays() && !searched_->has(which) ? ways_[k].get() : nullptr;
}

/// gamma1, eta1 or delta1.
std::optional<Measured> AtPosition::signed_value(Which which, const Standing& s, const RealPoint& p) const {
  const PenetrationDepth* way = penetration_depth(which);
  if (!way) return by_map(which, p);
  const bool back = which == Which::kDelta1;
  const RealPoint at = back ? -p : p;
  const bool holds = way->holds(at), positive = holds != (which == Which::kGamma1);
  Measured m;
  if (!holds) {  // their insides (or that of B and the outside of A) do not meet
    const FeaturePair k = s.pair ? *s.pair : closest_pair(fixed(), moving(), p);
    m = {positive ? k.distance : -k.distance, std::nullopt, std::nullopt, features(k)};
    if (k.distance.sign() != 0) m.nearest = p + (k.first - k.second);
    return m;
  }
  const PenetrationDepth::Answer answer = way->nearest(at);
  if (!answer.known) return by_map(which, p);
  if (!answer.nearest) {
    m.minus_infinity = true;  // of contact: it holds everywhere
    return positive ? std::nullopt : std::optional(std::move(m));
  }
  m.value = positive ? answer.nearest->distance : -answer.nearest->distance;
  const RealPoint& q = answer.nearest->at;
  const RealPoint there = back ? -q : q;
  if (m.value.sign() != 0) m.nearest = there;
  add_contact(m, there, p);
  return m;
}

std::optional<Measured> AtPosition::by_map(Which which, const RealPoint& p) const {
  auto v = searched_->distance(which)->value(p);
  if (!v) return std::nullopt;
  Measured m{v->value, v->nearest, std::nullopt, {}, v->minus_infinity};
  if (m.minus_infinity) return m;
  if (m.nearest || m.value.sign() == 0) add_contact(m, m.nearest.value_or(p), p);
  return m;
}

std::optional<Measured> AtPosition::farthest(Which which, const RealPoint& p) const {
  const bool back = which == Which::kDelta2;
  if (const PenetrationDepth* way =
          searched_->has(which) ? nullptr : penetration_depth(back ? Which::kDelta1 : Which::kEta1)) {
    PenetrationDepth::Answer answer = way->farthest(back ? -p : p);
    if (answer.known && !answer.nearest) return std::nullopt;
    if (answer.known) {
      const RealPoint& q = answer.nearest->at;
      Measured m{answer.nearest->distance, std::nullopt, back ? -q : q, {}};
      add_contact(m, *m.farthest, p);
      return m;
    }
  }
  auto f = searched_->distance(which);
  if (!f->defined()) return std::nullopt;
  const auto& family = static_cast<const Farthest&>(*f);
  RealPoint q = family.farthest_point(p);
  Measured m{f->value(p)->value, std::nullopt, q, {}};
  add_contact(m, q, p);
  return m;
}

}  // namespace findspace::distance
