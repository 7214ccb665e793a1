// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// SurfacePair: what positions tell at which the surfaces touch.
#include "distance/answer/answer.h"
#include "distance/surface/surface_ball.h"
#include "distance/surface/surface_contact.h"
#include "distance/surface/surface_pair.h"

namespace findspace::distance {

using space::RealVector;
using space::TouchSide;
using Decided = SurfacePair::Decided;

namespace {

std::size_t faces(const Surfaced& s) {
  std::size_t sum = 0;
  for (const auto& sheet : s.surface->sheets()) sum += sheet->body.faces.size();
  return sum;
}

/// The moving one, where it is a single ball.
const space::SurfaceSet::Ball* only_ball(const Surfaced& s) {
  const bool one = s.surface && s.surface->sheets().empty() && s.surface->balls().size() == 1;
  return one ? s.surface->balls().data() : nullptr;
}

std::optional<Decided> of_ball(const space::SurfaceSet::Ball& ball, const Surfaced& fixed, TouchSide side,
                               bool farthest, const RealVector& p) {
  if (!fixed.surface || !fixed.surface->one_sheet() || fixed.convex || ball.radius.sign() <= 0) return std::nullopt;
  const SurfaceBall of{fixed.surface.get(), ball.radius, side};
  const RealVector center = space::real(ball.center), x = space::plus(p, center);
  BallPlace place = farthest ? farthest_for_ball(of, x) : nearest_for_ball(of, x);
  if (!place.decided) return std::nullopt;
  if (place.value && place.value->nearest) place.value->nearest = space::minus(*place.value->nearest, center);
  return Decided{std::move(place.value)};
}

/// Each one surface, not both convex: then parts are the quick way.
bool decided_by_contacts(const Surfaced& b, const Surfaced& a) {
  const auto one = [](const Surfaced& s) { return s.surface && s.surface->one_sheet(); };
  return one(b) && one(a) && !(b.convex && a.convex);
}

std::optional<Decided> of_contact(const SurfaceContact& contact, const RealVector& p, int sign) {
  if (!contact.decided) return std::nullopt;
  if (!contact.place) return Decided{};
  Answer out = signed_value(p, *contact.place, sign);
  if (contact.error > 0) {
    out.proven = false;
    out.error = contact.error;
  }
  return Decided{std::move(out)};
}

}  // namespace

const SurfaceContacts& SurfacePair::contacts(const Side& side, TouchSide from) {
  Contacts& slot = from == TouchSide::kInside ? *side.inside : *side.outside;
  std::call_once(slot.made, [&] {
    slot.contacts = std::make_unique<const SurfaceContacts>(*side.moving->surface, *side.fixed->surface, from);
  });
  return *slot.contacts;
}

std::optional<Decided> SurfacePair::depth(const RealVector& p) const {
  const bool back = faces(a_) < faces(b_);
  const Side& side = back ? back_ : forth_;
  const RealVector at = back ? space::negated(p) : p;
  std::optional<Decided> out;
  if (const auto* ball = only_ball(*side.moving)) {
    out = of_ball(*ball, *side.fixed, TouchSide::kOutside, false, at);
    if (out && out->value) out->value->value = -out->value->value;
  } else if (decided_by_contacts(*side.moving, *side.fixed)) {
    out = of_contact(contacts(side, TouchSide::kOutside).nearest(at), at, -1);
  }
  if (!out || !out->value) return std::nullopt;
  if (back && out->value->nearest) out->value->nearest = space::negated(*out->value->nearest);
  return out;
}

std::optional<Decided> SurfacePair::to_fit(const Side& side, Which which, const RealVector& p) {
  if (const auto* ball = only_ball(*side.moving)) {
    auto out = of_ball(*ball, *side.fixed, TouchSide::kInside, which == Which::kEta2, p);
    if (out && out->value && which == Which::kEta2) out->value->nearest.reset();
    return out;
  }
  if (!decided_by_contacts(*side.moving, *side.fixed)) return std::nullopt;
  const SurfaceContacts& of = contacts(side, TouchSide::kInside);
  const bool farthest = which == Which::kEta2;
  auto out = of_contact(farthest ? of.farthest(p) : of.nearest(p), p, 1);
  if (out && out->value && farthest) out->value->nearest.reset();
  return out;
}

}  // namespace findspace::distance
