// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/surface/surface_pair.h"

#include <algorithm>

#include "distance/answer/answer.h"
#include "space/body/body_boxes.h"

namespace findspace::distance {

using exact::Real;
using space::RealVector;
using space::SurfaceGap;
using space::Vector;
using Relation = space::SurfaceGaps::Relation;

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
  for (const auto& sheet : set.sheets()) pieces.push_back(exact::approx(sheet->body.points[0]));
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

exact::Interval SurfaceSide::surfaces_within(const Vector& p) const {
  const auto about = [](double value, double error) { return exact::Interval{value - error, value + error}; };
  if (near_->of_b) return about((*near_->of_b)(p), near_->of_b->error(p));
  const Vector back = space::scaled(-1, p);
  if (near_->of_a) return about((*near_->of_a)(back), near_->of_a->error(p));
  const space::SurfaceGaps::Near near = gaps_->near(p);
  return about(near.value, near.error);
}

// Where the surfaces do not touch, each piece of the one lies outside the other or within it, as any place of it does.
exact::Interval SurfaceSide::gap_within(const Vector& p) const {
  if (!gaps_) return exact::whole_line();
  std::call_once(near_made_, [&] { near_.emplace(made_near()); });
  exact::Interval out = surfaces_within(p);
  const bool apart = out.lo > 0 && near_->a.surely_outside(near_->b.pieces, p, out.lo) &&
                     near_->b.surely_outside(near_->a.pieces, space::scaled(-1, p), out.lo);
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

TriedAnswer SurfaceSide::of_outlines(Which which, const RealVector& p) const {
  if (!a_.outline || !b_.outline) return untold();
  return solid_pair(b_.outline, a_.outline).try_value(which, p);
}

bool SurfaceSide::too_large() const {
  return b_.outline && a_.outline && !space::fitting(bounds(*b_.outline), bounds(*a_.outline));
}

TriedAnswer SurfaceSide::fit(const RealVector& p) const {
  if (too_large()) return std::nullopt;
  if (by_outlines()) return of_outlines(Which::kEta1, p);
  if (!gaps_ || !a_.surface->one_sheet()) return untold();
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
  // Whether it lies inside a union of several, and how deep, is not known.
  const bool is_known =
      a_.surface->one_sheet() || *found == Relation::kApart || out.value > Real::from_double(out.error);
  if (!is_known) return untold();
  return std::optional(std::move(out));
}

TriedAnswer SurfaceSide::clearance(const RealVector& p) const {
  if (by_outlines()) return PairSide::clearance(p);
  if (!a_.surface || !a_.surface->one_sheet()) return untold();
  std::optional<Answer> gap;
  const auto found = relation(p, gap);
  if (!found) return untold();
  if (*found != Relation::kInside) return std::optional(Answer{});
  return cut_off(std::move(gap), true);
}

}  // namespace findspace::distance
