// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/rays/value_rays.h"

#include <algorithm>
#include <cmath>

#include "distance/search/solid_protrusion.h"
#include "exact/margins/space_distance.h"
#include "plane/base/search_work.h"
#include "space/rays/ray_sources.h"

namespace findspace::distance {

using exact::Real;
using space::Body;
using space::RayRow;
using space::RealVector;

namespace {

/// Values of a line before the coarser certainty is enough, and at most.
constexpr int kFineValues = 600, kMostValues = 60000;

bool balls(const Body& b, const Body& a) {
  return a.convex() && b.convex() && a.parts[0].point() && b.parts[0].point();
}

bool eta1_by_values(const Real& level, const Body& b, const Body& a) {
  if (!a.round()) return level.sign() > 0 && b.round() && !a.convex();
  if (!a.convex()) return level.sign() != 0 || !polyhedra_and_balls(b);
  return level.sign() > 0 && !balls(b, a) && !without_radius(b, a);
}

bool eta2_by_values(const Body& b, const Body& a) {
  if (!a.convex()) return b.round() || a.round();
  return a.round() && !balls(b, a) && !without_radius(b, a);
}

}  // namespace

bool by_values(Which which, const Real& level, const Body& b, const Body& a) {
  switch (which) {
    case Which::kGamma1:
      if (a.outside) return by_values(Which::kEta1, -level, b, inside_of(a));
      return level.sign() < 0 && (a.round() || b.round()) && !(a.convex() && b.convex());
    case Which::kEta1:
      if (a.outside) return by_values(Which::kGamma1, -level, b, inside_of(a));
      return eta1_by_values(level, b, a);
    case Which::kEta2:
      return !a.outside && eta2_by_values(b, a);
    default:
      if (a.convex()) return false;
      if (level.sign() < 0 || (level.sign() == 0 && (a.outside || !a.round())))
        return by_values(Which::kEta1, level, b, a);
      return a.outside || !polyhedra_and_balls(b);
  }
}

std::unique_ptr<space::RaySource> by_values_map(Which which, const Real& level, const Body& b, const Body& a,
                                                const space::RayGrid& grid) {
  // Where mu is below 0 it is eta1; of a union of round parts only that is known.
  if (which == Which::kEta1 && level.sign() <= 0) which = Which::kMu;
  const PairDistances pair = solid_pair(std::make_shared<const Body>(b), std::make_shared<const Body>(a));
  const space::Bounds3 of_a = bounds(a), of_b = bounds(b);
  const space::Vector low = space::rounded(space::minus(of_a.low, of_b.high)),
                      high = space::rounded(space::minus(of_a.high, of_b.low));
  // Beyond this the bodies are farther apart than the level, and every distance is more than that.
  const double size = space::length(high - low) + std::fabs(level.to_double()) + 1;
  const bool outside = a.outside;  // then they are less than any
  // Above 0 it does not matter how deep B lies in A: max(0, eta1) has the same signs.
  const bool not_deep = which == Which::kEta1 && a.round() && !a.convex() && !outside;
  const RayRule rule = [pair, which, level, outside, not_deep](const RealVector& p) -> TriedBetween {
    if (not_deep) {
      const TriedAnswer inside = pair.try_value(Which::kH, p);
      if (!inside) return inside.refusal();
      if ((*inside)->value.sign() == 0) return Between{-level.to_double(), -level.to_double()};
    }
    const TriedAnswer found = pair.try_value(which, p);
    if (!found) return found.refusal();
    const std::optional<Answer>& v = *found;
    if (!v) return std::nullopt;
    const double gap = (outside ? level - v->value : v->value - level).to_double();
    return about(gap, v->error);
  };
  auto rays = std::make_unique<ValueRays>(rule, space::scaled(0.5, space::plus(low, high)), size, b.scale, grid);
  return outside ? space::negated_rays(std::move(rays)) : std::move(rays);
}

/// The signs between two places; what is known comes by growing place.
void ValueRays::look(Walk& walk, double from, double to) const {
  if (walk.refused) return;
  const double blur = size_ * (walk.values < kFineValues ? kCertain : kCoarse), middle = (from + to) / 2;
  if (!(from < middle && middle < to)) {
    walk.known.push_back({from, to, 0});
    return;
  }
  if (++walk.values > plane::allowed(kMostValues) || plane::cells_left() <= 0) {
    walk.refused.emplace(plane::search_spent("the signs along a line were not found"));
    return;
  }
  const TriedBetween found = rule_(space::along(walk.line.start, Real::from_double(middle), walk.line.unit));
  if (!found) {
    walk.refused = found.refusal();
    return;
  }
  const std::optional<Between>& v = *found;
  if (!v) {
    walk.known.push_back({from, to, 1});
    return;
  }
  // Numbers of the line are as exact as the value: what they lose is less than the blur.
  const double reach = std::max({v->low, -v->high, size_ * margin::kPlaceNoise}) - size_ * margin::kPlaceNoise;
  // What is left between stretches whose signs are known is often less than the blur, and mostly not near the boundary.
  const bool near = reach < std::min(blur, to - from) / 2;
  const double part = near ? blur / 2 : reach;
  std::vector<SignStretch> decided;
  if (v->ball) decided = chords(walk, *v->ball);
  const bool in_ball = std::any_of(decided.begin(), decided.end(),
                                   [&](const SignStretch& s) { return s.from < middle && middle < s.to; });
  if (!near || !in_ball) decided.push_back({middle - part, middle + part, near ? 0 : v->high < 0 ? -1 : 1});
  std::sort(decided.begin(), decided.end(), [](const SignStretch& s, const SignStretch& t) { return s.from < t.from; });
  double done = from;
  for (const SignStretch& s : decided) {
    if (!(s.to > done) || !(s.from < to)) continue;
    if (s.from > done) look(walk, done, s.from);
    walk.known.push_back({std::max(s.from, done), std::min(s.to, to), s.sign});
    done = std::min(s.to, to);
  }
  if (done < to) look(walk, done, to);
}

std::vector<SignStretch> ValueRays::chords(const Walk& walk, const SignBall& ball) const {
  const space::Vector start = space::rounded(walk.line.start), unit = space::rounded(walk.line.unit);
  const space::Vector way = ball.center - start;
  const double at = space::dot(way, unit), apart = space::length(way - space::scaled(at, unit)),
               tolerance = margin::kRayNoise * (size_ + space::length(start));
  const double radius = ball.radius + (ball.beyond ? tolerance : -tolerance);
  const bool meets = radius > apart;
  const double half = meets ? std::sqrt((radius - apart) * (radius + apart)) : 0;
  if (!ball.beyond) {
    if (!(half > tolerance)) return {};
    return {{at - half + tolerance, at + half - tolerance, ball.sign}};
  }
  if (!meets) return {{-exact::kInfinity, exact::kInfinity, ball.sign}};
  return {{-exact::kInfinity, at - half - tolerance, ball.sign}, {at + half + tolerance, exact::kInfinity, ball.sign}};
}

exact::Tried<RayRow> ValueRays::try_row(int j) const {
  RayRow out;
  for (int i = 0; i < grid_.nu; ++i) {
    const plane::SearchQuestion line_is_one;
    Walk walk{position_line(grid_, unit_, i, j), {}};
    const double place = space::dot(middle_ - space::rounded(walk.line.start), space::rounded(walk.line.unit));
    look(walk, place - 2 * size_, place + 2 * size_);
    if (walk.refused) return *walk.refused;
    put_line(walk.known, unit_, out);
  }
  return out;
}

}  // namespace findspace::distance
