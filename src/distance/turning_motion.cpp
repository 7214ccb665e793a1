// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/turning_motion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "distance/sites.h"
#include "plane/scaled.h"
#include "plane/transform.h"

namespace findspace::distance {

using exact::Real;
using exact::RealPoint;

namespace {

constexpr int kMostInstants = 400, kRefinements = 60;

/// As fine as the reach allows within the grid's 2^40 steps.
std::int64_t refinement(double reach) {
  std::int64_t factor = 1;
  while (factor < (1 << 20) && reach * double(2 * factor) < 0x1p39) factor *= 2;
  return factor;
}

/// gamma and mu change no faster than the shapes, eta1 and delta1 where they are not positive; but the places where a
/// shape fits (eta, delta) may come and go at once.
bool has_rate(Which which, double most) {
  if (which == Which::kEta2 || which == Which::kDelta2) return false;
  return (which != Which::kEta1 && which != Which::kDelta1) || most <= 0;
}

/// An instant that was looked at. f is turned round for suprema, so that the least value is looked for.
struct Sample {
  std::size_t leg;
  double s, f;
};

}  // namespace

double reach(const plane::Region& r) {
  double most = 0;
  for (const Site& s : sites(r, [](plane::Mark m) { return m > 0; })) most = std::max(most, s.farthest(0, 0));
  return most;
}

TurningMotion::TurningMotion(const plane::Region& b, const plane::Region& a, Which which,
                             std::vector<TurningPose> poses)
    : b_reach_(reach(b)), a_reach_(reach(a)), which_(which), poses_(std::move(poses)) {
  const std::int64_t factor = refinement(std::max(b_reach_, a_reach_));
  b_ = plane::scaled(b, factor);
  a_ = plane::scaled(a, factor);
  factor_ = double(factor);
}

double TurningMotion::rate(std::size_t leg) const {
  const TurningPose &p = poses_[leg], &q = poses_[leg + 1];
  const double way = std::hypot(near_value(q.at.x - p.at.x), near_value(q.at.y - p.at.y));
  const double radians = std::numbers::pi / 180;
  return way + radians * (std::abs(near_value(q.moving - p.moving)) * b_reach_ +
                          std::abs(near_value(q.fixed - p.fixed)) * a_reach_);
}

std::optional<ValueRange> TurningMotion::instant(const RealPoint& p, std::size_t leg, const Real& s) const {
  const TurningPose& from = poses_[leg];
  const TurningPose& to = poses_[std::min(leg + 1, poses_.size() - 1)];
  plane::Rounding rounding;
  auto turned = [&](const plane::Region& r, const Real& degrees) {
    return plane::rotated(r, {0, 0}, degrees, 1 / factor_, rounding);
  };
  const ShapePair pair(turned(b_, between(from.moving, to.moving, s)), turned(a_, between(from.fixed, to.fixed, s)));
  const Real f = Real::from_double(factor_);
  const auto v = pair.distance(which_)->value(
      {f * (p.x + between(from.at.x, to.at.x, s)), f * (p.y + between(from.at.y, to.at.y, s))});
  if (!v) return std::nullopt;
  const double value = v->value.to_double() / factor_;
  const double off = 2 * rounding.largest / factor_ + std::abs(value) * 0x1p-50;
  return ValueRange{value - off, value + off};
}

std::optional<ValueRange> TurningMotion::extremum(const RealPoint& p, Sense sense, double enough) const {
  const double sign = sense == Sense::kMinimum ? 1 : -1, none = std::numeric_limits<double>::infinity();
  double rounding = 0;
  bool undefined = false;
  double most = -none;
  auto look = [&](std::size_t leg, double s) {
    const auto v = instant(p, leg, Real::from_double(s));
    undefined |= !v;
    if (!v) return Sample{leg, s, none};
    rounding = std::max(rounding, v->off()), most = std::max(most, v->middle());
    return Sample{leg, s, sign * v->middle()};
  };
  struct Gap {
    Sample a, b;
    double low;
  };
  std::vector<Gap> gaps;
  Sample best{0, 0, none};
  auto add = [&](const Sample& a, const Sample& b) {
    const double drop = rate(a.leg) * (b.s - a.s);
    // Where f is undefined nothing is known of it beside: the other end bounds it.
    const double low = std::isinf(a.f) && std::isinf(b.f) ? none
                       : std::isinf(a.f)                  ? b.f - drop
                       : std::isinf(b.f)                  ? a.f - drop
                                                          : (a.f + b.f - drop) / 2;
    gaps.push_back({a, b, low});
    for (const Sample* k : {&a, &b})
      if (k->f < best.f) best = *k;
  };
  auto by_low = [](const Gap& g, const Gap& h) { return g.low > h.low; };
  if (poses_.size() == 1) return instant(p, 0, Real(0));
  double scale = 0;
  for (std::size_t leg = 0; leg + 1 < poses_.size(); ++leg) {
    constexpr int kFirst = 8;
    Sample before = look(leg, 0);
    for (int k = 1; k <= kFirst; ++k) {
      const Sample next = look(leg, double(k) / kFirst);
      add(before, next);
      before = next;
    }
    scale = std::max(scale, rate(leg));
  }
  if (undefined && sense == Sense::kMaximum) return std::nullopt;
  std::make_heap(gaps.begin(), gaps.end(), by_low);
  const double least_gap = std::max(enough, scale * 0x1p-46);
  for (int k = 0; k < kMostInstants && best.f - gaps.front().low > least_gap; ++k) {
    std::pop_heap(gaps.begin(), gaps.end(), by_low);
    const Gap gap = gaps.back();
    gaps.pop_back();
    const Sample middle = look(gap.a.leg, (gap.a.s + gap.b.s) / 2);
    add(gap.a, middle);
    std::push_heap(gaps.begin(), gaps.end(), by_low);
    add(middle, gap.b);
    std::push_heap(gaps.begin(), gaps.end(), by_low);
  }
  if (std::isinf(best.f)) return std::nullopt;
  const double certain = gaps.front().low;
  // f is smooth or has one kink near its extremum: golden sections of the gaps beside the best instant.
  double from = best.s, to = best.s;
  for (const Gap& g : gaps) {
    if (g.a.leg != best.leg) continue;
    if (g.b.s == best.s) from = g.a.s;
    if (g.a.s == best.s) to = g.b.s;
  }
  constexpr double kGolden = 0.6180339887498949;  // no sign: where to look next
  Sample low = look(best.leg, to - kGolden * (to - from)), high = look(best.leg, from + kGolden * (to - from));
  for (int k = 0; k < kRefinements && (to - from) * scale > least_gap; ++k) {
    if (low.f < high.f) {
      to = high.s, high = low;
      low = look(best.leg, to - kGolden * (to - from));
    } else {
      from = low.s, low = high;
      high = look(best.leg, from + kGolden * (to - from));
    }
    for (const Sample* s : {&low, &high})
      if (s->f < best.f) best = *s;
  }
  if (undefined && sense == Sense::kMaximum) return std::nullopt;
  const bool bounded = !undefined && has_rate(which_, most);
  const double from_below = bounded ? std::min(best.f, certain) - rounding : -none, found = best.f + rounding;
  return sign > 0 ? ValueRange{from_below, found} : ValueRange{-found, -from_below};
}

}  // namespace findspace::distance
