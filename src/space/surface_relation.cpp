// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// SurfaceGaps: whether the sets lie apart, or B in A.

#include <algorithm>

#include "space/surface_gap.h"

namespace findspace::space {

using exact::Real;
using Relation = SurfaceGaps::Relation;
using Sheet = SurfaceSet::Sheet;

namespace {

constexpr double kRoundable = 4;  // steps between surfaces: rounding a position moves it by less than one
constexpr std::int64_t kMostParts = std::int64_t{1} << 20;

std::optional<std::int64_t> whole(const Real& c) {
  const auto number = c.integer();
  if (!number || *number > exact::kRayLimit || *number < -exact::kRayLimit) return std::nullopt;
  return static_cast<std::int64_t>(*number);
}

/// The grid point next to p.
std::optional<Point> rounded_point(const RealVector& p) {
  std::array<std::int64_t, 3> c{};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto number = whole(Real(exact::round(p[k])));
    if (!number) return std::nullopt;
    c[k] = *number;
  }
  return Point{c[0], c[1], c[2]};
}

std::optional<RayPlace> exact_place(const RealVector& p) {
  const auto x = whole(p[0]), y = whole(p[1]), z = whole(Real(exact::floor(p[2])));
  const auto fraction = p[2].fraction();
  if (!x || !y || !z || !fraction || (*fraction)[1] > kMostParts) return std::nullopt;
  return ray_place(*x, *y, {(*fraction)[0], (*fraction)[1]});
}

/// The boxes about the sheets, A's less B's and the other way: {low of A - high of B, high of A - low of B} and so on.
struct BoxWays {
  Vector low_high, high_low, low_low, high_high;
};

BoxWays box_ways(const Sheet& a, const Sheet& b) {
  const auto way = [](const Point& p, const Point& q) { return exact::shadow(p) - exact::shadow(q); };
  return {way(a.body.low, b.body.high), way(a.body.high, b.body.low), way(a.body.low, b.body.low),
          way(a.body.high, b.body.high)};
}

bool beyond(const Vector& p, const Vector& least, const Vector& most) {
  return p.x < least.x - kRoundable || p.x > most.x + kRoundable || p.y < least.y - kRoundable ||
         p.y > most.y + kRoundable || p.z < least.z - kRoundable || p.z > most.z + kRoundable;
}

/// Whether the point, the square of whose distance from the surface is given, lies in the solid; nothing near the
/// surface off the grid.
std::optional<bool> solid_holds(const Sheet& sheet, const RealVector& at, const Real& square) {
  const bool clear = square > Real::from_double(kRoundable * kRoundable);
  if (beyond(space::rounded(at), exact::shadow(sheet.body.low), exact::shadow(sheet.body.high))) return false;
  const auto q = rounded_point(at);
  if (!q || (!clear && real(*q) != at)) return std::nullopt;
  return holds(sheet.body, sheet.tree, *q);
}

}  // namespace

const RayOverlap& SurfaceGaps::overlap(std::size_t i, std::size_t j, bool complement) const {
  const std::lock_guard lock(guard_);
  auto& slot = overlaps_[i * b_->sheets().size() + j][complement ? 1 : 0];
  if (!slot) {
    Triangles surface{a_->sheets()[i]->body.points, a_->sheets()[i]->body.faces};
    if (complement) surface = turned_inside_out(std::move(surface));
    slot = std::make_unique<const Overlap>(std::move(surface), b_->sheets()[j]->body, complement);
  }
  return slot->with;
}

std::optional<bool> SurfaceGaps::sheets_meet(std::size_t i, std::size_t j, bool complement, const RealVector& p,
                                             double apart) const {
  const BoxWays ways = box_ways(*a_->sheets()[i], *b_->sheets()[j]);
  const Vector near = space::rounded(p);
  if (complement ? beyond(near, ways.low_low, ways.high_high) : beyond(near, ways.low_high, ways.high_low))
    return complement;
  std::optional<RayPlace> place;
  if (const auto q = rounded_point(p); q && apart > kRoundable) place = RayPlace{*q, {0, 1}};
  if (!place) place = exact_place(p);
  if (!place) return std::nullopt;
  return overlap(i, j, complement).interiors_meet(*place);
}

std::optional<Relation> SurfaceGaps::relation(const RealVector& p, const Near& near) const {
  const auto balls = with_balls(p);
  if (!balls || *balls == Relation::kOther) return balls;
  const double apart = near.value - near.error;
  const bool no_balls = b_->balls().empty();
  const auto none_meets = [&](bool complement) -> std::optional<bool> {
    for (std::size_t i = 0; i < a_->sheets().size(); ++i) {
      for (std::size_t j = 0; j < b_->sheets().size(); ++j) {
        const auto meet = sheets_meet(i, j, complement, p, apart);
        if (!meet) return std::nullopt;
        if (*meet) return false;
      }
    }
    return true;
  };
  for (const Relation wanted : {Relation::kApart, Relation::kInside}) {
    if (wanted == Relation::kInside && !a_->one_sheet()) break;
    if (!no_balls && *balls != wanted) continue;
    const auto holds = none_meets(wanted == Relation::kInside);
    if (!holds) return std::nullopt;
    if (*holds) return wanted;
  }
  return Relation::kOther;
}

namespace {

/// A ball on no side of a surface: one that meets it counts as `other`.
std::optional<Relation> ball_relation(const RealVector& center, const Real& radius, const Sheet& sheet) {
  const RealVector way = way_to(sheet, center);
  const Real square = dot(way, way);
  if (square < radius * radius) return Relation::kOther;
  const auto held = solid_holds(sheet, center, square);
  if (!held) return std::nullopt;
  return *held ? Relation::kInside : Relation::kApart;
}

}  // namespace

/// What the balls of both allow: apart from all of the other set, or all in A. Apart where there are none.
std::optional<Relation> SurfaceGaps::with_balls(const RealVector& p) const {
  Relation all = Relation::kApart;
  bool first = true;
  for (const SurfaceSet::Ball& ball : b_->balls()) {
    const RealVector center = plus(real(ball.center), p);
    for (const auto& sheet : a_->sheets()) {
      const auto next = ball_relation(center, ball.radius, *sheet);
      if (!next) return next;
      const bool fits = *next == Relation::kApart || (*next == Relation::kInside && a_->one_sheet());
      if (!fits || (!first && *next != all)) return Relation::kOther;
      all = *next, first = false;
    }
    for (const SurfaceSet::Ball& other : a_->balls()) {
      const RealVector way = minus(real(other.center), center);
      const Real reach = ball.radius + other.radius;
      if (dot(way, way) < reach * reach) return Relation::kOther;
    }
  }
  for (const SurfaceSet::Ball& ball : a_->balls()) {
    for (const auto& sheet : b_->sheets()) {
      const auto next = ball_relation(minus(real(ball.center), p), ball.radius, *sheet);
      if (!next) return next;
      if (*next != Relation::kApart) return Relation::kOther;
    }
  }
  return all;
}

}  // namespace findspace::space
