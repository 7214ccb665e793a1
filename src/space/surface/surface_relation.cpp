// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// SurfaceGaps: whether the sets lie apart, or B in A.

#include <algorithm>

#include "space/surface/surface_gap.h"
#include "space/surface/surface_side.h"

namespace findspace::space {

using exact::Real;
using Relation = SurfaceGaps::Relation;
using Sheet = SurfaceSet::Sheet;

namespace {

/// The boxes about the sheets, A's less B's and the other way: {low of A - high of B, high of A - low of B} and so on.
struct BoxWays {
  Vector low_high, high_low, low_low, high_high;
};

BoxWays box_ways(const Sheet& a, const Sheet& b) {
  const auto way = [](const Point& p, const Point& q) { return exact::approx(p) - exact::approx(q); };
  return {way(a.body.low, b.body.high), way(a.body.high, b.body.low), way(a.body.low, b.body.low),
          way(a.body.high, b.body.high)};
}

bool beyond(const Vector& p, const Vector& least, const Vector& most) {
  return p.x < least.x - 1 || p.x > most.x + 1 || p.y < least.y - 1 || p.y > most.y + 1 || p.z < least.z - 1 ||
         p.z > most.z + 1;
}

}  // namespace

const RealOverlap& SurfaceGaps::overlap(std::size_t i, std::size_t j, bool complement) const {
  const std::lock_guard lock(guard_);
  auto& slot = overlaps_[i * b_->sheets().size() + j][complement ? 1 : 0];
  if (!slot) slot = std::make_unique<const RealOverlap>(*a_->sheets()[i], *b_->sheets()[j], complement);
  return *slot;
}

bool SurfaceGaps::sheets_meet(std::size_t i, std::size_t j, bool complement, const RealVector& p) const {
  const BoxWays ways = box_ways(*a_->sheets()[i], *b_->sheets()[j]);
  const Vector near = space::rounded(p);
  if (complement ? beyond(near, ways.low_low, ways.high_high) : beyond(near, ways.low_high, ways.high_low))
    return complement;
  return overlap(i, j, complement).interiors_meet(p);
}

Relation SurfaceGaps::relation(const RealVector& p) const {
  const Relation balls = with_balls(p);
  if (balls == Relation::kOther) return balls;
  const bool no_balls = b_->balls().empty();
  const auto none_meets = [&](bool complement) {
    for (std::size_t i = 0; i < a_->sheets().size(); ++i) {
      for (std::size_t j = 0; j < b_->sheets().size(); ++j) {
        if (sheets_meet(i, j, complement, p)) return false;
      }
    }
    return true;
  };
  for (const Relation wanted : {Relation::kApart, Relation::kInside}) {
    if (wanted == Relation::kInside && !a_->one_frontier()) break;
    if (!no_balls && balls != wanted) continue;
    if (none_meets(wanted == Relation::kInside)) return wanted;
  }
  return Relation::kOther;
}

namespace {

/// A ball on no side of a surface: one that meets it counts as `other`.
Relation ball_relation(const RealVector& center, const Real& radius, const Sheet& sheet) {
  const RealVector way = way_to(sheet, center);
  if (dot(way, way) < radius * radius) return Relation::kOther;
  const bool held = side_of(sheet.body, sheet.tree, center, space::rounded(center)) == SurfaceSide::kInside;
  return held ? Relation::kInside : Relation::kApart;
}

}  // namespace

/// What the balls of both allow: apart from all of the other set, or all in A. Apart where there are none.
Relation SurfaceGaps::with_balls(const RealVector& p) const {
  Relation all = Relation::kApart;
  bool first = true;
  for (const SurfaceSet::Ball& ball : b_->balls()) {
    const RealVector center = plus(real(ball.center), p);
    for (const auto& sheet : a_->sheets()) {
      const Relation next = ball_relation(center, ball.radius, *sheet);
      const bool fits = next == Relation::kApart || (next == Relation::kInside && a_->one_frontier());
      if (!fits || (!first && next != all)) return Relation::kOther;
      all = next;
      first = false;
    }
    for (const SurfaceSet::Ball& other : a_->balls()) {
      const RealVector way = minus(real(other.center), center);
      const Real reach = ball.radius + other.radius;
      if (dot(way, way) < reach * reach) return Relation::kOther;
    }
  }
  for (const SurfaceSet::Ball& ball : a_->balls()) {
    for (const auto& sheet : b_->sheets()) {
      if (ball_relation(minus(real(ball.center), p), ball.radius, *sheet) != Relation::kApart) return Relation::kOther;
    }
  }
  return all;
}

}  // namespace findspace::space
