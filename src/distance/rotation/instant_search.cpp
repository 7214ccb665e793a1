// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/rotation/instant_search.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "exact/margins/planar_distance.h"
#include "plane/base/stop_check.h"

namespace findspace::distance {

using exact::Real;

namespace {

constexpr int kRefinements = 60;

}  // namespace

void InstantSearch::look_evenly(std::size_t legs) {
  constexpr int kFirst = 8;
  for (std::size_t leg = 0; leg < legs; ++leg) {
    Sample before = look(leg, 0);
    for (int k = 1; k <= kFirst; ++k) {
      const Sample next = look(leg, double(k) / kFirst);
      add({before, next, {}, {}, 0});
      before = next;
    }
    scale_ = std::max(scale_, motion_.rate(leg));
  }
}

void InstantSearch::narrow(double enough, double floor) {
  least_gap_ = std::max(enough, scale_ * margin::kMotionGap);
  const PairsTaken taken = motion_.pairs_taken();
  // A bound lacks what its ends are off, and by a chord that ends beyond three times that.
  const bool beyond = taken != PairsTaken::kNone && (sign_ > 0) != (taken == PairsTaken::kNearest);
  const double lacking = beyond ? 3 : 1;  // no sign: when to stop
  const auto settled = [&](const Gap& gap) { return !(best_.f - gap.low > least_gap_ + lacking * gap.off()); };
  gaps_.run([&](const Gap& gap) { return spent() || best_.f <= floor || settled(gap); },
            [&](const Gap& gap) {
              const Sample middle = look(gap.a.leg, (gap.a.s + gap.b.s) / 2);
              add({gap.a, middle, gap.before, gap.b, 0});
              add({middle, gap.b, gap.a, gap.after, 0});
            });
}

void InstantSearch::refine() {
  constexpr double kGolden = 0.6180339887498949;  // no sign: where to look next
  double from = 0, to = 0;
  std::tie(from, to) = beside_best();
  const std::size_t leg = best_.leg;
  const auto inner = [&](bool first) {
    return look(leg, first ? to - kGolden * (to - from) : from + kGolden * (to - from), true);
  };
  most_work_ += most_work_ / 2;
  Sample low = inner(true), high = inner(false);
  for (int k = 0; k < kRefinements && (to - from) * scale_ > least_gap_; ++k) {
    keep_better(low);
    keep_better(high);
    if (spent()) return;
    if (low.most() < high.most()) {
      to = high.s;
      high = low;
      low = inner(true);
    } else {
      from = low.s;
      low = high;
      high = inner(false);
    }
  }
  keep_better(low);
  keep_better(high);
}

InstantSearch::Sample InstantSearch::look(std::size_t leg, double s, bool refining) {
  if (plane::StopCheck* const check = plane::stop_check()) check->poll();
  RotatingMotion::Need need{sign_ > 0 ? RotatingMotion::Bounded::kBelow : RotatingMotion::Bounded::kAbove};
  // Above what is known f plays no part, and a bound of it does.
  if (sign_ < 0 && !refining) need.more_than = -best_.f;
  const RotatingMotion::Looked v = motion_.look(p_, leg, Real::from_double(s), need);
  work_ += v.work;
  plane::count_cells(v.work);
  if (!v.look) return undefined_.emplace_back(Sample{leg, s, kNone, kNone});
  most_ = std::max(most_, v.look->f);
  if (sign_ > 0) return {leg, s, v.look->f, v.look->rated, v.look->off};
  return {leg, s, -v.look->f, -v.look->rated, v.look->off};
}

double InstantSearch::low_between(const Gap& gap) const {
  const auto &a = gap.a, &b = gap.b;
  const double drop = motion_.rate(a.leg) * (b.s - a.s);
  const double at_a = a.rated - a.off, at_b = b.rated - b.off;
  // Where f is undefined nothing is known of it beside: the other end bounds it.
  if (std::isinf(at_a) && std::isinf(at_b)) return kNone;
  if (std::isinf(at_a)) return at_b - drop;
  if (std::isinf(at_b)) return at_a - drop;
  const double low = (at_a + at_b - drop) / 2;
  const auto squared = [&](const Sample& k) { return SquaredSample{k.s, sign_ * k.f, k.off}; };
  const auto beside = [&](const std::optional<Sample>& k) {
    return k && !std::isinf(k->f) ? std::optional(squared(*k)) : std::nullopt;
  };
  const auto bound = squared_bound(motion_.pairs_taken(), sign_ > 0, motion_.pair_motion(p_, a.leg), squared(a),
                                   squared(b), beside(gap.before), beside(gap.after));
  return bound ? std::max(low, *bound) : low;
}

void InstantSearch::add(Gap gap) {
  gap.low = low_between(gap);
  keep_better(gap.a);
  keep_better(gap.b);
  gaps_.push(gap);
}

std::pair<double, double> InstantSearch::beside_best() const {
  double from = best_.s, to = best_.s;
  for (const Gap& g : gaps_.left()) {
    if (g.a.leg != best_.leg) continue;
    if (g.b.s == best_.s) from = g.a.s;
    if (g.a.s == best_.s) to = g.b.s;
  }
  return {from, to};
}

}  // namespace findspace::distance
