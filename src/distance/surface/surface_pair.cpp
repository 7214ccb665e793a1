// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/surface/surface_pair.h"

#include "distance/answer/answer.h"
#include "space/body/body_boxes.h"

namespace findspace::distance {

using exact::Real;
using space::RealVector;
using space::SurfaceGap;
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

SurfacePair::SurfacePair(Surfaced b, Surfaced a) : b_(std::move(b)), a_(std::move(a)) {
  forth_ = side(b_, a_);
  back_ = side(a_, b_);
}

SurfacePair::Side SurfacePair::side(const Surfaced& moving, const Surfaced& fixed) {
  Side out;
  out.moving = &moving;
  out.fixed = &fixed;
  if (moving.surface && fixed.surface)
    out.gaps = std::make_unique<const space::SurfaceGaps>(fixed.surface, moving.surface);
  return out;
}

/// How the two lie, and their distance where that is one.
std::optional<Relation> SurfacePair::relation(const Side& side, const RealVector& p, std::optional<Answer>& gap) {
  if (!side.gaps) return std::nullopt;
  const Relation found = side.gaps->relation(p);
  if (found != Relation::kOther)
    gap = of_gap(side.gaps->gap(p, side.gaps->near(p)), p, found == Relation::kInside ? -1 : 1);
  return found;
}

TriedAnswer SurfacePair::gap(const RealVector& p, Depth depth) const {
  std::optional<Answer> gap;
  const auto found = relation(forth_, p, gap);
  if (!found) return untold();
  if (*found == Relation::kApart) return gap;
  if (depth == Depth::kSign) return std::optional(Answer{});
  return this->depth(p);
}

TriedAnswer SurfacePair::of_outlines(Which which, const RealVector& p) const {
  if (!a_.outline || !b_.outline) return untold();
  return SolidPair(b_.outline, a_.outline).try_value(which, p);
}

bool SurfacePair::too_large(const Side& side) {
  const auto &b = side.moving->outline, &a = side.fixed->outline;
  return b && a && !space::fitting(bounds(*b), bounds(*a));
}

TriedAnswer SurfacePair::fit(Inner inner, const RealVector& p) const {
  const Side& of = side(inner);
  const RealVector q = seen(inner, p);
  if (too_large(of)) return std::nullopt;
  if (of.fixed->convex && of.moving->outline)
    return decided(inner, SolidPair(of.moving->outline, of.fixed->outline).try_value(Which::kEta1, q), p);
  if (!of.gaps || !of.fixed->surface->one_sheet()) return untold();
  std::optional<Answer> gap;
  const auto found = relation(of, q, gap);
  if (!found) return untold();
  return decided(inner, *found == Relation::kInside ? TriedAnswer(gap) : to_fit(of, false, q), p);
}

TriedAnswer SurfacePair::farthest_fit(Inner inner, const RealVector& p) const {
  const Side& of = side(inner);
  const RealVector q = seen(inner, p);
  if (too_large(of)) return std::nullopt;
  if (of.fixed->convex && of.moving->outline)
    return decided(inner, SolidPair(of.moving->outline, of.fixed->outline).try_value(Which::kEta2, q), p);
  return decided(inner, to_fit(of, true, q), p);
}

/// Where the one lies in the other it is the fit.
TriedAnswer SurfacePair::protrusion(Inner inner, const RealVector& p, Depth /*depth*/) const {
  const Side& of = side(inner);
  const RealVector q = seen(inner, p);
  if (of.fixed->convex && of.moving->outline)
    return decided(inner, SolidPair(of.moving->outline, of.fixed->outline).try_value(Which::kMu, q), p);
  std::optional<Answer> gap;
  const auto found = relation(of, q, gap);
  if (!found) return untold();
  if (*found == Relation::kInside) return decided(inner, gap, p);
  Answer out = protrusion(of, q);
  // Whether it lies inside a union of several, and how deep, is not known.
  const bool is_known =
      of.fixed->surface->one_sheet() || *found == Relation::kApart || out.value > Real::from_double(out.error);
  if (!is_known) return untold();
  return decided(inner, std::optional(std::move(out)), p);
}

TriedAnswer SurfacePair::clearance(Inner inner, const RealVector& p) const {
  const Side& of = side(inner);
  if (of.fixed->convex && of.moving->outline) return PairDistances::clearance(inner, p);
  if (!of.fixed->surface || !of.fixed->surface->one_sheet()) return untold();
  std::optional<Answer> gap;
  const auto found = relation(of, seen(inner, p), gap);
  if (!found) return untold();
  if (*found != Relation::kInside) return std::optional(Answer{});
  TriedAnswer v = decided(inner, gap, p);
  return cut_off(*std::move(v), true);
}

}  // namespace findspace::distance
