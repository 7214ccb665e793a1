// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/surface/surface_pair.h"

#include <algorithm>

#include "distance/answer/answer.h"
#include "distance/search/convex_distance.h"
#include "distance/search/solid_protrusion.h"
#include "distance/surface/surface_ball.h"
#include "distance/surface/surface_contact.h"
#include "distance/surface/surface_field.h"
#include "exact/margins/space_distance.h"
#include "space/body/body_boxes.h"

namespace findspace::distance {

using exact::Real;
using space::RealVector;
using space::SurfaceGap;
using space::Vector;
using Relation = space::SurfaceGaps::Relation;
using space::TouchSide;

namespace {

/// A signed distance whose zero set is nearest along the way, the sign -1 inside.
Answer of_gap(const SurfaceGap& gap, const RealVector& p, int sign) {
  Answer out;
  out.value = sign < 0 ? -gap.value : gap.value;
  const Real length = gap.value + gap.radius;
  if (gap.value.sign() != 0) {
    const Real part = gap.radius.sign() == 0 ? Real(1) : gap.value / length;
    out.nearest = space::along(p, part, gap.way);
  }
  return out;
}

exact::Refusal untold() { return exact::Refusal("the surfaces do not tell"); }

}  // namespace

SurfaceSide::SurfaceSide(Surfaced b, Surfaced a) : b_(std::move(b)), a_(std::move(a)) {
  if (b_.surface && a_.surface) gaps_ = std::make_unique<const space::SurfaceGaps>(a_.surface, b_.surface);
}

SurfaceSide::Field::Field(const space::SurfaceSet& set) : field(set, {}) {
  for (const auto& sheet : set.sheets())
    for (const int f : sheet->body.first_face) pieces.push_back(exact::approx(sheet->body.corner(f, 0)));
  for (const auto& ball : set.balls()) pieces.push_back(exact::approx(ball.center));
}

bool SurfaceSide::Field::surely_outside(const std::vector<Vector>& places, const Vector& p, double away) const {
  return std::all_of(places.begin(), places.end(),
                     [&](const Vector& x) { return field.inside(space::plus(x, p), away) == std::optional(false); });
}

SurfaceSide::Near SurfaceSide::made_near() const {
  const auto gap = [](const Surfaced& convex, const Surfaced& other) -> std::optional<ConvexGap> {
    if (!convex.convex || !convex.outline || !ConvexGap::few(*other.surface)) return std::nullopt;
    return std::optional<ConvexGap>(std::in_place, other.surface, convex.outline->parts[0]);
  };
  Near out{Field(*b_.surface), Field(*a_.surface), gap(b_, a_), {}};
  if (!out.of_b) out.of_a = gap(a_, b_);
  return out;
}

exact::Interval SurfaceSide::surfaces_within(const Near& known, const Vector& p) const {
  const auto about = [](double value, double error) { return exact::Interval{value - error, value + error}; };
  if (known.of_b) return about((*known.of_b)(p), known.of_b->error(p));
  const Vector back = space::scaled(-1, p);
  if (known.of_a) return about((*known.of_a)(back), known.of_a->error(p));
  const space::SurfaceGaps::Near near = gaps_->near(p);
  return about(near.value, near.error);
}

// Where the surfaces do not touch, each piece of the one lies outside the other or within it, as any place of it does.
exact::Interval SurfaceSide::gap_within(const Vector& p) const {
  if (!gaps_) return exact::whole_line();
  const Near& near = near_.of([&] { return made_near(); });
  exact::Interval out = surfaces_within(near, p);
  const bool apart = out.lo > 0 && near.a.surely_outside(near.b.pieces, p, out.lo) &&
                     near.b.surely_outside(near.a.pieces, space::scaled(-1, p), out.lo);
  if (!apart) out.lo = -exact::kInfinity;
  return out;
}

PairDistances surface_pair(const Surfaced& b, const Surfaced& a) {
  return {std::make_shared<const SurfaceSide>(b, a), std::make_shared<const SurfaceSide>(a, b)};
}

std::optional<Relation> SurfaceSide::relation(const RealVector& p, std::optional<Answer>& gap) const {
  if (!gaps_) return std::nullopt;
  const Relation found = gaps_->relation(p);
  if (found != Relation::kOther) gap = of_gap(gaps_->gap(p, gaps_->near(p)), p, found == Relation::kInside ? -1 : 1);
  return found;
}

TriedAnswer SurfaceSide::gap(const RealVector& p, Depth depth) const {
  std::optional<Answer> gap;
  const auto found = relation(p, gap);
  if (!found) return untold();
  if (*found == Relation::kApart) return gap;
  if (depth == Depth::kSign) return std::optional(Answer{});
  return this->depth(p);
}

std::optional<Answer> SurfaceSide::of_corners(Which which, const RealVector& p) const {
  if (which == Which::kGamma2) return farthest_of_few(b_.outline.corners(), a_.outline.corners(), p);
  if (which != Which::kMu || b_.convex || !a_.outline->convex()) return std::nullopt;
  const space::BodyPart& a = a_.outline->parts[0];
  const auto only = only_farthest(b_.outline.corners(), a, p);
  if (!only) return std::nullopt;
  return protrusion_of_convex(space::body_of_part(*only), a, p);
}

TriedAnswer SurfaceSide::of_outlines(Which which, const RealVector& p) const {
  if (!a_.outline || !b_.outline) return untold();
  if (auto out = of_corners(which, p)) return out;
  return solid_pair(b_.outline.pointer(), a_.outline.pointer()).try_value(which, p);
}

namespace {

/// Of the outline, which is not made for it.
space::Bounds3 box_of(const Surfaced& s) {
  return s.surface && s.surface->has_hull() ? s.surface->box() : bounds(*s.outline);
}

}  // namespace

bool SurfaceSide::too_large() const { return b_.outline && a_.outline && !space::fitting(box_of(b_), box_of(a_)); }

TriedAnswer SurfaceSide::fit(const RealVector& p) const {
  if (too_large()) return std::nullopt;
  if (by_outlines()) return of_outlines(Which::kEta1, p);
  if (!gaps_ || !a_.surface->one_frontier()) return untold();
  std::optional<Answer> gap;
  const auto found = relation(p, gap);
  if (!found) return untold();
  return *found == Relation::kInside ? TriedAnswer(gap) : to_fit(false, p);
}

TriedAnswer SurfaceSide::farthest_fit(const RealVector& p) const {
  if (too_large()) return std::nullopt;
  return by_outlines() ? of_outlines(Which::kEta2, p) : to_fit(true, p);
}

/// Where the one lies in the other it is the fit.
TriedAnswer SurfaceSide::protrusion(const RealVector& p, Depth /*depth*/) const {
  if (by_outlines()) return of_outlines(Which::kMu, p);
  std::optional<Answer> gap;
  const auto found = relation(p, gap);
  if (!found) return untold();
  if (*found == Relation::kInside) return gap;
  Answer out = protrusion_out(p);
  // Whether it lies inside a union of several, or across walls within, and how deep, is not known.
  const bool is_known =
      a_.surface->one_frontier() || *found == Relation::kApart || out.value > Real::from_double(out.error);
  if (!is_known) return untold();
  return std::optional(std::move(out));
}

TriedAnswer SurfaceSide::clearance(const RealVector& p) const {
  if (by_outlines()) return PairSide::clearance(p);
  if (!a_.surface || !a_.surface->one_frontier()) return untold();
  std::optional<Answer> gap;
  const auto found = relation(p, gap);
  if (!found) return untold();
  if (*found != Relation::kInside) return std::optional(Answer{});
  return cut_off(std::move(gap), true);
}

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

const SurfaceContacts& contacts(const plane::Lazy<std::unique_ptr<const SurfaceContacts>>& of, const Surfaced& b,
                                const Surfaced& a, TouchSide from) {
  return *of.of([&] { return std::make_unique<const SurfaceContacts>(*b.surface, *a.surface, from); });
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
    out = of_contact(contacts(outside_, moving, fixed, TouchSide::kOutside).nearest(at), at, -1);
  }
  if (!out || !*out) return not_touching();
  return back ? exchanged_back(std::move(out), p) : out;
}

TriedAnswer SurfaceSide::to_fit(bool farthest, const RealVector& p) const {
  TriedAnswer out = not_touching();
  if (!a_.surface || !a_.surface->one_frontier()) return out;
  if (const auto* ball = only_ball(b_)) {
    out = of_ball(*ball, a_, TouchSide::kInside, farthest, p);
  } else if (decided_by_contacts(b_, a_)) {
    const SurfaceContacts& of = contacts(inside_, b_, a_, TouchSide::kInside);
    out = of_contact(farthest ? of.farthest(p) : of.nearest(p), p, 1);
  }
  if (farthest && out && *out) (*out)->nearest.reset();
  return out;
}

namespace {

std::vector<space::Point> corners_of(const space::SurfaceSet& set) {
  std::vector<space::Point> out;
  for (const auto& sheet : set.sheets()) out.insert(out.end(), sheet->body.points.begin(), sheet->body.points.end());
  return out;
}

/// The balls, and the box about the surfaces; what lies outside these is decided by the field.
Solids solids_about(const SurfaceField& field) {
  Solids out;
  for (const auto& ball : field.set().balls()) {
    const Vector center = space::plus(exact::approx(ball.center), field.by());
    out.round.push_back({center, center, ball.radius.to_double()});
  }
  if (field.set().sheets().empty()) return out;
  for (const space::Point& v : corners_of(field.set()))
    out.corners.push_back(space::plus(exact::approx(v), field.by()));
  out.cells = tetrahedra_of_box(field.box());
  return out;
}

/// Of which a distance is asked where little time is to be spent.
constexpr std::size_t kFewCorners = 64;

Answer exact_distance(const space::SurfaceSet& a, const RealVector& at) {
  NearestBall nearest(at);
  for (const auto& sheet : a.sheets()) nearest.offer(way_to(*sheet, at), Real());
  for (const auto& ball : a.balls()) nearest.offer(space::minus(space::real(ball.center), at), ball.radius);
  return *nearest.found();
}

}  // namespace

Answer SurfaceSide::protrusion_out(const RealVector& p) const {
  const space::SurfaceSet &b = *b_.surface, &a = *a_.surface;
  const SurfaceField of_a(a, {}), of_b(b, space::rounded(p));
  SolidOfSurface about{&of_b, {}};
  if (b_.outline) about.hull = space::PlaneTree(b_.outline->parts[0].planes());
  const auto& parts = b_.parts;
  const SolidMaxMin found =
      parts ? surface_max_min(solids_of(*parts, p), nullptr, of_a) : surface_max_min(solids_about(of_b), &about, of_a);
  return protrusion_answer(found, corners_of(b), p, [&](const RealVector& at) { return exact_distance(a, at); });
}

SurfaceSide::FewCorners SurfaceSide::made_few_corners() const {
  FewCorners out;
  if (!gaps_) return out;
  out.field.emplace(*a_.surface, Vector{});
  const std::vector<space::Point> corners = corners_of(*b_.surface);
  const std::size_t apart = corners.size() / kFewCorners + 1;
  for (std::size_t k = 0; k < corners.size(); k += apart) out.corners.push_back(exact::approx(corners[k]));
  for (const Vector& v : out.corners) out.size = std::max(out.size, space::size_of(v));
  const space::Extent box = out.field->box();
  out.size += std::max(space::size_of(box.low), space::size_of(box.high));
  return out;
}

exact::Interval SurfaceSide::protrusion_within(const Vector& p) const {
  const FewCorners& few = few_corners_.of([&] { return made_few_corners(); });
  exact::Interval out = exact::whole_line();
  for (const Vector& v : few.corners) {
    const Vector x = space::plus(v, p);
    const SurfaceField::Signed at = few.field->at(x);
    if (at.value > std::max(out.lo, 0.0) && few.field->inside(x, at.distance) == std::optional(false))
      out.lo = at.value;
  }
  if (!(out.lo > 0)) return exact::whole_line();
  out.lo -= margin::kNumbersOff * (few.size + space::size_of(p));
  return out;
}

}  // namespace findspace::distance
