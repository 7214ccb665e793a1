// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/surface/surface_pair.h"

#include "distance/answer/answer.h"

namespace findspace::distance {

using exact::Real;
using space::RealVector;
using space::SurfaceGap;
using Decided = SurfacePair::Decided;
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

bool box_fits(const space::Body& moving, const space::Body& fixed) {
  const space::Bounds3 outer = bounds(fixed), inner = bounds(moving);
  for (std::size_t k = 0; k < 3; ++k) {
    if (outer.high[k] - outer.low[k] < inner.high[k] - inner.low[k]) return false;
  }
  return true;
}

Decided exchanged_back(Decided v, const RealVector& p) {
  if (!v.value) return v;
  if (v.value->nearest) v.value->nearest = space::negated(*v.value->nearest);
  exchange_roles(*v.value, p);
  return v;
}

std::optional<Decided> cut(std::optional<Decided> v, bool negated) {
  if (v) v->value = cut_off(std::move(v->value), negated);
  return v;
}

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

/// gamma1 and what follows from it.
std::optional<Decided> SurfacePair::apart(Which which, const RealVector& p) const {
  std::optional<Answer> gap;
  const auto found = relation(forth_, p, gap);
  if (!found) return std::nullopt;
  if (*found != Relation::kApart) {
    if (which == Which::kD1) return Decided{Answer{}};
    return which == Which::kGamma1 ? depth(p) : cut(depth(p), true);
  }
  return cut(Decided{gap}, which == Which::kPenetration);
}

/// Where the one lies in the other eta1, which mu is too; else mu, and of eta1 nothing.
std::optional<Decided> SurfacePair::inside(const Side& side, Which which, const RealVector& p) {
  std::optional<Answer> gap;
  const bool one = side.fixed->surface && side.fixed->surface->one_sheet();
  if (!side.gaps || (!one && which != Which::kMu)) return std::nullopt;
  const auto found = relation(side, p, gap);
  if (!found) return std::nullopt;
  if (*found == Relation::kInside) return Decided{gap};
  if (which != Which::kMu) return to_fit(side, which, p);
  Answer out = protrusion(side, p);
  // Whether it lies inside a union of several, and how deep, is not known.
  const bool decided = one || *found == Relation::kApart || out.value > Real::from_double(out.error);
  return decided ? std::optional(Decided{std::move(out)}) : std::nullopt;
}

std::optional<Decided> SurfacePair::contained(const Side& side, Which which, const RealVector& p) {
  const auto &b = side.moving->outline, &a = side.fixed->outline;
  const bool fit = which == Which::kEta1 || which == Which::kEta2;
  if (fit && b && a && !box_fits(*b, *a)) return Decided{};
  if (side.fixed->convex && b) return Decided{SolidPair(b, a).value(which, p)};
  if (which == Which::kEta2) return to_fit(side, which, p);
  return inside(side, which, p);
}

/// The Hausdorff distance.
std::optional<Decided> SurfacePair::larger(const RealVector& p) const {
  const auto forth = contained(forth_, Which::kMu, p);
  if (!forth) return std::nullopt;
  auto other = contained(back_, Which::kMu, space::negated(p));
  if (!other) return std::nullopt;
  other = exchanged_back(*std::move(other), p);
  return forth->value->value < other->value->value ? other : forth;
}

std::optional<Decided> SurfacePair::back(Which which, const RealVector& p) const {
  auto found = contained(back_, which, space::negated(p));
  if (found) found = exchanged_back(*std::move(found), p);
  return found;
}

std::optional<Decided> SurfacePair::value(Which which, const RealVector& p) const {
  const auto depth = [&](const Side& of, const RealVector& at) -> std::optional<Decided> {
    if (of.fixed->convex && of.moving->outline) return cut(contained(of, Which::kEta1, at), true);
    if (!of.fixed->surface || !of.fixed->surface->one_sheet()) return std::nullopt;
    std::optional<Answer> gap;
    const auto found = relation(of, at, gap);
    if (!found) return std::nullopt;
    return *found == Relation::kInside ? cut(Decided{gap}, true) : Decided{Answer{}};
  };
  switch (which) {
    case Which::kGamma1:
    case Which::kD1:
    case Which::kPenetration:
      return apart(which, p);
    case Which::kGamma2:
    case Which::kDiameter:
      if (!a_.outline || !b_.outline) return std::nullopt;
      return Decided{SolidPair(b_.outline, a_.outline).value(which, p)};
    case Which::kEta1:
    case Which::kEta2:
    case Which::kMu:
      return contained(forth_, which, p);
    case Which::kH:
      return cut(contained(forth_, Which::kMu, p), false);
    case Which::kDelta1:
      return back(Which::kEta1, p);
    case Which::kDelta2:
      return back(Which::kEta2, p);
    case Which::kMuBack:
      return back(Which::kMu, p);
    case Which::kHBack:
      return cut(back(Which::kMu, p), false);
    case Which::kHausdorff:
      return larger(p);
    case Which::kDstarBack:
      return depth(forth_, p);
    case Which::kDstar: {
      auto found = depth(back_, space::negated(p));
      if (found) found = exchanged_back(*std::move(found), p);
      return found;
    }
  }
  return std::nullopt;
}

}  // namespace findspace::distance
