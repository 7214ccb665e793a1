// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/rotation/rotation_motion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>
#include <utility>

#include "distance/planar_features/boundary_features.h"
#include "distance/rotation/rated_gap.h"
#include "exact/margins/planar_distance.h"
#include "exact/margins/rounding.h"
#include "plane/base/subdivide.h"
#include "plane/build/transform.h"
#include "plane/offset/plain_sum.h"
#include "plane/query/scaled.h"
#include "plane/query/topology.h"

namespace findspace::distance {

using exact::Real;
using exact::RealPoint;

namespace {

constexpr int kRefinements = 60;

/// How many instants are looked at between the first ones; a fine search looks at more of small shapes, whose distances
/// take less time.
int most_instants(std::size_t edges, RotatingMotion::Effort effort) {
  constexpr std::size_t kLeast = 400, kMost = 4000, kEdges = 200'000;
  if (effort == RotatingMotion::Effort::kCoarse) return kLeast;
  return static_cast<int>(std::clamp(kEdges / std::max<std::size_t>(edges, 1), kLeast, kMost));
}

/// As fine as the reach allows within the grid's 2^40 steps.
std::int64_t refinement(double reach) {
  std::int64_t factor = 1;
  while (factor < (1 << 20) && reach * double(2 * factor) < double(std::int64_t{1} << 39)) factor *= 2;
  return factor;
}

/// gamma (rated_gap.h) and mu change no faster than the shapes, eta1 and delta1 where they are not positive; but the
/// places where a shape fits (eta, delta) may come and go at once. `most`: of the values found, and of the bound of a
/// supremum.
bool has_rate(Which which, double most) {
  if (which == Which::kEta2 || which == Which::kDelta2) return false;
  return (which != Which::kEta1 && which != Which::kDelta1) || most <= 0;
}

/// Of places where one shape fits into the other.
bool is_of_fits(Which which) {
  return which == Which::kEta1 || which == Which::kEta2 || which == Which::kDelta1 || which == Which::kDelta2;
}

bool fits_into_fixed(Which which) { return which == Which::kEta1 || which == Which::kEta2; }

/// Nothing where undefined; in steps of the pair.
std::optional<ValueRange> range_at(const ShapePair& pair, Which which, const RealPoint& p) {
  const auto v = pair.distance(which)->value(p);
  if (!v) return std::nullopt;
  if (v->minus_infinity) return ValueRange{-exact::kInfinity, -exact::kInfinity};
  const OutwardEnds ends = outward(v->bounds());
  return ValueRange{ends.lower, ends.upper};
}

bool none_turns(const std::vector<RotatingPose>& poses) {
  return std::all_of(poses.begin(), poses.end(),
                     [&](const RotatingPose& p) { return p.moving == poses[0].moving && p.fixed == poses[0].fixed; });
}

/// max(0, -gap)
ValueRange penetration(const ValueRange& gap) { return {std::max(0.0, -gap.high), std::max(0.0, -gap.low)}; }

constexpr double kNone = std::numeric_limits<double>::infinity();

/// An instant that was looked at. f is rotated round for suprema, so that the least value is looked for.
struct Sample {
  std::size_t leg;
  double s, f;
  double rated;  // not above f: what bounds it beside
};

/// Looks for the least f at instants of the motion: first evenly, then where it may be least (Piyavskii 1972), then
/// beside the best one.
class LeastSearch {
 public:
  LeastSearch(const RotatingMotion& motion, const RealPoint& p, bool least)
      : motion_(motion), p_(p), sign_(least ? 1 : -1) {}

  void look_evenly(std::size_t legs) {
    constexpr int kFirst = 8;
    for (std::size_t leg = 0; leg < legs; ++leg) {
      Sample before = look(leg, 0);
      for (int k = 1; k <= kFirst; ++k) {
        const Sample next = look(leg, double(k) / kFirst);
        add(before, next);
        before = next;
      }
      scale_ = std::max(scale_, motion_.rate(leg));
    }
  }

  /// Until the best value is as near its bound as `enough`, and roundings allow, or `most` more instants are known.
  void narrow(double enough, int most) {
    least_gap_ = std::max(enough, scale_ * margin::kMotionGap);
    gaps_.run(
        most, [&](const Gap& gap) { return !(best_.f - gap.low > least_gap_); },
        [&](const Gap& gap) {
          const Sample middle = look(gap.a.leg, (gap.a.s + gap.b.s) / 2);
          add(gap.a, middle);
          add(middle, gap.b);
        });
  }

  /// f is smooth or has one kink near its extremum: golden sections of the gaps beside the best instant.
  void refine() {
    constexpr double kGolden = 0.6180339887498949;  // no sign: where to look next
    double from = 0, to = 0;
    std::tie(from, to) = beside_best();
    const std::size_t leg = best_.leg;
    const auto inner = [&](bool first) {
      return look(leg, first ? to - kGolden * (to - from) : from + kGolden * (to - from));
    };
    Sample low = inner(true), high = inner(false);
    for (int k = 0; k < kRefinements && (to - from) * scale_ > least_gap_; ++k) {
      if (low.f < high.f) {
        to = high.s;
        high = low;
        low = inner(true);
      } else {
        from = low.s;
        low = high;
        high = inner(false);
      }
      keep_better(low);
      keep_better(high);
    }
  }

  const std::vector<Sample>& undefined() const { return undefined_; }  // instants that were looked at
  const Sample& best() const { return best_; }
  double certain() const { return gaps_.best().low; }  // f is nowhere less, if it keeps to its rate
  double rounding() const { return rounding_; }
  double most() const { return most_; }  // of the plain f

 private:
  struct Gap {
    Sample a, b;
    double low;
    bool operator<(const Gap& other) const { return low > other.low; }
  };

  Sample look(std::size_t leg, double s) {
    const auto v = motion_.look(p_, leg, Real::from_double(s));
    if (!v) return undefined_.emplace_back(Sample{leg, s, kNone, kNone});
    rounding_ = std::max(rounding_, v->off);
    most_ = std::max(most_, v->f);
    if (sign_ > 0) return {leg, s, v->f, v->f};
    return {leg, s, -v->f, -v->rated};
  }

  void keep_better(const Sample& k) {
    if (k.f < best_.f) best_ = k;
  }

  void add(const Sample& a, const Sample& b) {
    const double drop = motion_.rate(a.leg) * (b.s - a.s);
    // Where f is undefined nothing is known of it beside: the other end bounds it.
    const double low = std::isinf(a.rated) && std::isinf(b.rated) ? kNone
                       : std::isinf(a.rated)                      ? b.rated - drop
                       : std::isinf(b.rated)                      ? a.rated - drop
                                                                  : (a.rated + b.rated - drop) / 2;
    gaps_.push({a, b, low});
    keep_better(a);
    keep_better(b);
  }

  /// The instants looked at before and after the best one, on its leg.
  std::pair<double, double> beside_best() const {
    double from = best_.s, to = best_.s;
    for (const Gap& g : gaps_.left()) {
      if (g.a.leg != best_.leg) continue;
      if (g.b.s == best_.s) from = g.a.s;
      if (g.a.s == best_.s) to = g.b.s;
    }
    return {from, to};
  }

  const RotatingMotion& motion_;
  const RealPoint& p_;
  double sign_;
  plane::Subdivision<Gap> gaps_;  // the lowest first
  Sample best_{0, 0, kNone, kNone};
  double scale_ = 0, least_gap_ = 0, rounding_ = 0, most_ = -kNone;
  std::vector<Sample> undefined_;
};

}  // namespace

double reach(const plane::Region& r) {
  double most = 0;
  for (const BoundaryFeature& s : features(r, [](plane::Mark m) { return m > 0; }))
    most = std::max(most, s.farthest(0, 0));
  return most;
}

RotatingMotion::RotatingMotion(const plane::Region& b, const plane::Region& a, Which which,
                               std::vector<RotatingPose> poses, double step)
    : b_reach_(reach(b)),
      a_reach_(reach(a)),
      step_(step),
      which_(which == Which::kPenetration ? Which::kGamma1 : which),
      negated_(which == Which::kPenetration),
      keeps_rate_(which_ == Which::kGamma1 && is_convex(b) && is_convex(a)),
      poses_(std::move(poses)) {
  const std::int64_t factor = refinement(std::max(b_reach_, a_reach_));
  b_ = plane::scaled(b, factor);
  a_ = plane::scaled(a, factor);
  factor_ = double(factor);
  if (which_ == Which::kGamma1 && !keeps_rate_ && none_turns(poses_))
    keeps_rate_ = standing({}, 0, Real(0)).rounding == 0;
}

double RotatingMotion::rate(std::size_t leg) const {
  const RotatingPose &p = poses_[leg], &q = poses_[leg + 1];
  const double way = std::hypot(near_value(q.at.x - p.at.x), near_value(q.at.y - p.at.y));
  const double radians = std::numbers::pi / 180;
  return way + radians * (std::abs(near_value(q.moving - p.moving)) * b_reach_ +
                          std::abs(near_value(q.fixed - p.fixed)) * a_reach_);
}

RotatingMotion::Standing RotatingMotion::standing(const RealPoint& p, std::size_t leg, const Real& s) const {
  const RotatingPose& from = poses_[leg];
  const RotatingPose& to = poses_[std::min(leg + 1, poses_.size() - 1)];
  plane::Rounding rounding;
  auto rotated = [&](const plane::Region& r, const Real& degrees) {
    return plane::rotated(r, {0, 0}, degrees, step_ / factor_, rounding);
  };
  const plane::Region b = rotated(b_, between(from.moving, to.moving, s)),
                      a = rotated(a_, between(from.fixed, to.fixed, s));
  const Real f = Real::from_double(factor_);
  const RealPoint at{f * (p.x + between(from.at.x, to.at.x, s)), f * (p.y + between(from.at.y, to.at.y, s))};
  // Two shapes; ends of an arc carry its bulge along: twice what they moved.
  return {ShapePair(b, a), at, 4 * rounding.largest};
}

std::optional<RotatingMotion::Look> RotatingMotion::look(const Standing& standing) const {
  const auto v = standing.pair.distance(which_)->value(standing.at);
  if (!v) return std::nullopt;
  const double found = v->value.to_double() / factor_, value = v->minus_infinity ? -kNone : found;
  const double off = standing.rounding / factor_ + std::abs(found) * margin::kFewRoundings;
  const bool rated = value >= 0 || rated_below_zero();
  return Look{value, rated ? value : RatedGap(standing.pair, false).value(standing.at) / factor_, off};
}

std::optional<RotatingMotion::Look> RotatingMotion::look(const RealPoint& p, std::size_t leg, const Real& s) const {
  return look(standing(p, leg, s));
}

std::optional<ValueRange> RotatingMotion::plain_instant(const RealPoint& p, std::size_t leg, const Real& s) const {
  const Standing here = standing(p, leg, s);
  const auto v = look(here);
  const bool second = which_ == Which::kEta2 || which_ == Which::kDelta2;
  if (is_of_fits(which_) && here.rounding > 0 && (second || !v || v->f + v->off > 0)) {
    const double least = v ? std::min(v->f, 0.0) - v->off : -here.rounding / factor_;
    return second ? farthest_fit(here) : nearest_fit(here, least);
  }
  if (!v) return std::nullopt;
  if (v->f >= 0 || rated_below_zero() || here.rounding == 0) return ValueRange{v->f - v->off, v->f + v->off};
  const ValueRange depth = RatedGap(here.pair, false).depth(here.at, Real::from_double(here.rounding));
  return ValueRange{depth.low / factor_ - v->off, std::min(depth.high / factor_, v->rated) + v->off};
}

ShapePair RotatingMotion::with_container(const ShapePair& pair, double grown) const {
  const Real by = Real::from_double(grown);
  if (fits_into_fixed(which_)) return {pair.moving(), plane::plain_offset(pair.fixed(), by)};
  return {plane::plain_offset(pair.moving(), by), pair.fixed()};
}

std::optional<ValueRange> RotatingMotion::nearest_fit(const Standing& here, double least) const {
  const auto all = range_at(with_container(here.pair, here.rounding), which_, here.at);
  if (!all) return std::nullopt;
  const auto certain = range_at(with_container(here.pair, -here.rounding), which_, here.at);
  return ValueRange{std::max(all->low / factor_, least), certain ? certain->high / factor_ : kNone};
}

std::optional<ValueRange> RotatingMotion::farthest_fit(const Standing& here) const {
  const ShapePair large = with_container(here.pair, here.rounding);
  const auto all = range_at(large, which_, here.at);
  if (!all) return std::nullopt;
  const auto certain = range_at(with_container(here.pair, -here.rounding), which_, here.at);
  if (certain) return ValueRange{certain->low / factor_, all->high / factor_};
  const auto nearest = range_at(large, fits_into_fixed(which_) ? Which::kEta1 : Which::kDelta1, here.at);
  return ValueRange{nearest ? std::max(0.0, nearest->low / factor_) : 0.0, kNone};
}

std::optional<ValueRange> RotatingMotion::instant(const RealPoint& p, std::size_t leg, const Real& s) const {
  const auto v = plain_instant(p, leg, s);
  return v && negated_ ? penetration(*v) : v;
}

std::optional<ValueRange> RotatingMotion::extremum(const RealPoint& p, Sense sense, double enough,
                                                   Effort effort) const {
  if (poses_.size() == 1) return instant(p, 0, Real(0));
  const auto v = plain_extremum(p, (sense == Sense::kMinimum) != negated_, enough, effort);
  return v && negated_ ? penetration(*v) : v;
}

std::optional<ValueRange> RotatingMotion::plain_extremum(const RealPoint& p, bool least, double enough,
                                                         Effort effort) const {
  LeastSearch search(*this, p, least);
  search.look_evenly(poses_.size() - 1);
  const auto at = [&](const Sample& k) { return plain_instant(p, k.leg, Real::from_double(k.s)); };
  const std::vector<Sample>& undefined = search.undefined();
  // Whether what was rounded plays no part in it, at some of the instants from the first one on.
  const auto is_certain = [&](std::size_t first) {
    constexpr std::ptrdiff_t kMost = 10;
    const auto from = undefined.begin() + std::ptrdiff_t(first);
    return std::any_of(from, from + std::min(kMost, undefined.end() - from), [&](const Sample& k) { return !at(k); });
  };
  const bool of_fits = is_of_fits(which_);
  if (!of_fits && !undefined.empty()) return std::nullopt;  // at all times, of a complement
  if (!least && is_certain(0)) return std::nullopt;
  const std::size_t evenly = undefined.size();
  search.narrow(enough, most_instants(b_.edges.size() + a_.edges.size(), effort));
  if (search.best().f == -kNone) return ValueRange{-kNone, at(search.best())->high};
  const double certain = search.certain();
  const bool none = search.best().f == kNone && !undefined.empty();
  if (!none) search.refine();
  if (!least && is_certain(evenly)) return std::nullopt;
  double found = search.best().f + search.rounding();
  double from_below = std::min(search.best().f, certain) - search.rounding();
  const double most = least ? search.most() : std::max(search.most(), -from_below);
  const bool rated = undefined.empty() && has_rate(which_, most);
  if (!rated) from_below = -kNone;
  if (of_fits || (!rated_below_zero() && search.best().f != kNone)) {
    const auto best = at(none ? undefined.front() : search.best());
    found = !best ? kNone : least ? best->high : -best->low;
  }
  if (least && of_fits && !rated) from_below = least_protrusion(p, enough);
  if (from_below == kNone) return std::nullopt;
  if (!rated_below_zero() && least && from_below < 0) from_below = std::min(from_below, least_gap());
  return least ? ValueRange{from_below, found} : ValueRange{-found, -from_below};
}

double RotatingMotion::least_protrusion(const RealPoint& p, double enough) const {
  RotatingMotion mu = *this;
  mu.which_ = fits_into_fixed(which_) ? Which::kMu : Which::kMuBack;
  const auto v = mu.plain_extremum(p, true, enough, Effort::kCoarse);
  return v ? v->low : kNone;
}

double RotatingMotion::least_gap() const {
  if (!plane::is_bounded(a_) || !plane::is_bounded(b_)) return -kNone;
  return -(b_reach_ + a_reach_) * margin::kUpward - margin::kUpwardSteps;
}

}  // namespace findspace::distance
