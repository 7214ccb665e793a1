// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// SurfaceSide: what positions tell at which the surfaces touch.
#include "distance/answer/answer.h"
#include "distance/surface/surface_ball.h"
#include "distance/surface/surface_contact.h"
#include "distance/surface/surface_pair.h"

namespace findspace::distance {

using space::RealVector;
using space::TouchSide;

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

exact::Refusal not_touching() { return exact::Refusal("the positions at which the surfaces touch do not tell"); }

TriedAnswer of_ball(const space::SurfaceSet::Ball& ball, const Surfaced& fixed, TouchSide side, bool farthest,
                    const RealVector& p) {
  if (!fixed.surface || !fixed.surface->one_sheet() || fixed.convex || ball.radius.sign() <= 0) return not_touching();
  const SurfaceBall of{fixed.surface.get(), ball.radius, side};
  const RealVector center = space::real(ball.center), x = space::plus(p, center);
  BallPlace place = farthest ? farthest_for_ball(of, x) : nearest_for_ball(of, x);
  if (!place.decided) return not_touching();
  if (place.value && place.value->nearest) place.value->nearest = space::minus(*place.value->nearest, center);
  return std::move(place.value);
}

/// Each one surface, not both convex: then parts are the quick way.
bool decided_by_contacts(const Surfaced& b, const Surfaced& a) {
  const auto one = [](const Surfaced& s) { return s.surface && s.surface->one_sheet(); };
  return one(b) && one(a) && !(b.convex && a.convex);
}

TriedAnswer of_contact(const SurfaceContact& contact, const RealVector& p, int sign) {
  if (!contact.decided) return not_touching();
  if (!contact.place) return std::nullopt;
  Answer out = signed_value(p, *contact.place, sign);
  if (contact.error > 0) {
    out.set_unproven();
    out.error = contact.error;
  }
  return std::optional(std::move(out));
}

}  // namespace

const SurfaceContacts& SurfaceSide::Contacts::of(const Surfaced& b, const Surfaced& a, TouchSide from) {
  std::call_once(made, [&] { contacts = std::make_unique<const SurfaceContacts>(*b.surface, *a.surface, from); });
  return *contacts;
}

/// The one with fewer faces moves.
TriedAnswer SurfaceSide::depth(const RealVector& p) const {
  const bool back = faces(a_) < faces(b_);
  const Surfaced &moving = back ? a_ : b_, &fixed = back ? b_ : a_;
  const RealVector at = back ? space::negated(p) : p;
  TriedAnswer out = not_touching();
  if (const auto* ball = only_ball(moving)) {
    out = of_ball(*ball, fixed, TouchSide::kOutside, false, at);
    if (out && *out) (*out)->value = -(*out)->value;
  } else if (decided_by_contacts(moving, fixed)) {
    out = of_contact(outside_.of(moving, fixed, TouchSide::kOutside).nearest(at), at, -1);
  }
  if (!out || !*out) return not_touching();
  return back ? exchanged_back(std::move(out), p) : out;
}

TriedAnswer SurfaceSide::to_fit(bool farthest, const RealVector& p) const {
  TriedAnswer out = not_touching();
  if (const auto* ball = only_ball(b_)) {
    out = of_ball(*ball, a_, TouchSide::kInside, farthest, p);
  } else if (decided_by_contacts(b_, a_)) {
    const SurfaceContacts& of = inside_.of(b_, a_, TouchSide::kInside);
    out = of_contact(farthest ? of.farthest(p) : of.nearest(p), p, 1);
  }
  if (farthest && out && *out) (*out)->nearest.reset();
  return out;
}

}  // namespace findspace::distance
