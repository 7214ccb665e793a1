// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/rotation/rotation_motion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "distance/planar_features/feature_pair_search.h"
#include "distance/rotation/instant_search.h"
#include "distance/rotation/rated_gap.h"
#include "exact/margins/planar_distance.h"
#include "exact/margins/rounding.h"
#include "plane/offset/plain_sum.h"
#include "plane/query/topology.h"

namespace findspace::distance {

using exact::Real;
using exact::RealPoint;

namespace {

/// Cells of work: a coarse search is one of many.
long most_work(RotatingMotion::Effort effort) {
  constexpr long kCoarse = 4000, kFine = 20'000;
  return plane::allowed(effort == RotatingMotion::Effort::kCoarse ? kCoarse : kFine);
}

/// What a look takes where boundaries tell the distance; where a map of positions does.
long work_of_boundaries(const TurningShapes& shapes) { return 2 + long(shapes.edges()) / 8; }
long work_of_map(const TurningShapes& shapes, bool convex) {
  constexpr long kOfMap = 50, kOfPair = 4, kOfConvex = 10, kOfEdge = 2;
  if (convex) return kOfConvex + kOfEdge * long(shapes.edges());
  return kOfMap + kOfPair * long(shapes.b().edges.size() * shapes.a().edges.size());
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

/// d* is 0, or minus the mu the other way: a shape lies in the other where no point of it is outside.
Which plain_of_covered(Which which) { return which == Which::kDstar ? Which::kMuBack : Which::kMu; }
bool is_covered(Which which) { return which == Which::kDstar || which == Which::kDstarBack; }

/// Of both shapes, the greater one: it stays while they move.
ValueRange own_diameter(const TurningShapes& shapes) {
  const FeatureTree b(shapes.b()), a(shapes.a());
  const Real own = std::max(farthest_pair(b, b, {}).distance, farthest_pair(a, a, {}).distance);
  const auto ends = (own / Real::from_double(shapes.factor())).interval();
  return {ends.lo, ends.hi};
}

ValueRange greater(const ValueRange& v, const ValueRange& w) {
  return {std::max(v.low, w.low), std::max(v.high, w.high)};
}

bool may_be_negative(Which which) {
  return which == Which::kGamma1 || which == Which::kMu || which == Which::kMuBack || is_of_fits(which);
}

}  // namespace

RotatingMotion::RotatingMotion(const plane::Region& b, const plane::Region& a, Which which,
                               std::vector<RotatingPose> poses, double step)
    : RotatingMotion(std::make_shared<TurningShapes>(b, a, std::move(poses), step), which) {}

RotatingMotion::RotatingMotion(std::shared_ptr<const TurningShapes> shapes, Which which)
    : shapes_(std::move(shapes)),
      which_(which == Which::kPenetration ? Which::kGamma1 : which),
      negated_(which == Which::kPenetration),
      keeps_rate_(which_ == Which::kGamma1 && shapes_->b_is_convex() && shapes_->a_is_convex()),
      pairs_taken_(pairs_of(which_)) {
  if (which_ == Which::kGamma1 && !keeps_rate_ && none_turns(shapes_->poses()))
    keeps_rate_ = shapes_->standing(0, Real(0)).rounding == 0;
}

RotatingMotion RotatingMotion::of(Which which) const {
  RotatingMotion out = *this;
  out.which_ = which;
  out.negated_ = false;
  out.pairs_taken_ = pairs_of(which);
  return out;
}

double RotatingMotion::rate(std::size_t leg) const {
  const RotatingPose &p = shapes_->poses()[leg], &q = shapes_->poses()[leg + 1];
  const double way = std::hypot(near_value(q.at.x - p.at.x), near_value(q.at.y - p.at.y));
  const double radians = std::numbers::pi / 180;
  return way + radians * (std::abs(near_value(q.moving - p.moving)) * shapes_->b_reach() +
                          std::abs(near_value(q.fixed - p.fixed)) * shapes_->a_reach());
}

PairsTaken RotatingMotion::pairs_of(Which which) const {
  const bool bounded = plane::is_bounded(shapes_->b()) && plane::is_bounded(shapes_->a());
  switch (which) {
    case Which::kGamma2:
      return PairsTaken::kFarthest;
    case Which::kD1:
      return bounded ? PairsTaken::kNearest : PairsTaken::kNone;
    case Which::kMu:
    case Which::kH:
      return shapes_->a_is_convex() ? PairsTaken::kFarthestLine : PairsTaken::kNone;
    case Which::kMuBack:
    case Which::kHBack:
      return shapes_->b_is_convex() ? PairsTaken::kFarthestLine : PairsTaken::kNone;
    case Which::kHausdorff:
      return shapes_->a_is_convex() && shapes_->b_is_convex() ? PairsTaken::kFarthestLine : PairsTaken::kNone;
    default:
      return PairsTaken::kNone;
  }
}

PairMotion RotatingMotion::pair_motion(const RealPoint& at, std::size_t leg) const {
  const RotatingPose &p = shapes_->poses()[leg], &q = shapes_->poses()[leg + 1];
  const double radians = std::numbers::pi / 180, of_b = std::abs(radians * near_value(q.moving - p.moving)),
               of_a = std::abs(radians * near_value(q.fixed - p.fixed));
  const double b_reach = shapes_->b_reach(), a_reach = shapes_->a_reach();
  if (pairs_taken_ != PairsTaken::kFarthestLine)
    return {rate(leg) * margin::kUpward, (of_b * of_b * b_reach + of_a * of_a * a_reach) * margin::kUpward};
  // As seen from the convex shape, what turns is all that is between the origins as well.
  const auto length = [](const Real& x, const Real& y) { return std::hypot(near_value(x), near_value(y)); };
  const double way = length(q.at.x - p.at.x, q.at.y - p.at.y),
               apart = std::max(length(at.x + p.at.x, at.y + p.at.y), length(at.x + q.at.x, at.y + q.at.y));
  const double turns = of_a + of_b;
  const auto seen = [&](double of_container, double reach) {
    return turns * turns * reach + of_container * (of_container * apart + 2 * way);
  };
  const bool back = which_ == Which::kMuBack || which_ == Which::kHBack, both = which_ == Which::kHausdorff;
  const double most = std::max(back ? 0.0 : seen(of_a, b_reach), back || both ? seen(of_b, a_reach) : 0.0);
  return {rate(leg) * margin::kUpward, most * margin::kUpward};
}

RotatingMotion::Look RotatingMotion::look_of(const Standing& standing, const PlanarAnswer& v) const {
  const double factor = shapes_->factor();
  if (v.minus_infinity) return {-kNone, -kNone, standing.rounding / factor};
  const double value = v.value.to_double();
  const OutwardEnds ends = outward(v.bounds());
  const double open = v.proven ? 0 : std::max({0.0, ends.upper - value, value - ends.lower});
  const double f = value / factor;
  return {f, f, (standing.rounding + open) / factor + std::abs(f) * margin::kFewRoundings};
}

RotatingMotion::Look RotatingMotion::look_of_depth(const Standing& standing, const RealPoint& at,
                                                   const Need& need) const {
  const bool rated = !rated_below_zero() && need.bounded == Bounded::kAbove;
  std::optional<double> bound;
  if (rated) bound = RatedGap(standing.pair(), false).value(at) / shapes_->factor();
  if (bound && *bound <= need.more_than) return {*bound, *bound, standing.rounding / shapes_->factor()};
  // Its maps are not kept with the shapes.
  const ShapePair& pair = standing.pair();
  const auto v = AtPosition(std::make_shared<ShapePair>(pair.moving(), pair.fixed())).measure(Which::kGamma1, at);
  Look out = look_of(standing, *v);
  if (bound) out.rated = *bound;
  return out;
}

RotatingMotion::Looked RotatingMotion::look(const RealPoint& p, std::size_t leg, const Real& s,
                                            const Need& need) const {
  const Standing here = shapes_->standing(leg, s);
  const RealPoint at = shapes_->place(p, leg, s);
  const bool convex = keeps_rate_ && shapes_->a_is_convex() && shapes_->b_is_convex();
  const long light = work_of_boundaries(*shapes_), heavy = light + work_of_map(*shapes_, convex);
  if (which_ == Which::kGamma1) {
    const auto apart = here.measured->measure(Which::kD1, at);
    if (!apart) return {std::nullopt, light};
    if (apart->minus_infinity || apart->value.sign() > 0) return {look_of(here, *apart), light};
    return {look_of_depth(here, at, need), heavy};
  }
  if (is_covered(which_)) {
    const auto v = here.measured->measure(plain_of_covered(which_), at);
    const auto covered = cut_off(v, true);
    return {covered ? std::optional(look_of(here, *covered)) : std::nullopt, light};
  }
  if (!is_of_fits(which_)) {
    const auto v = here.measured->measure(which_, at);
    return {v ? std::optional(look_of(here, *v)) : std::nullopt, light};
  }
  const ShapePair& pair = here.pair();
  const auto v = AtPosition(std::make_shared<ShapePair>(pair.moving(), pair.fixed())).measure(which_, at);
  return {v ? std::optional(look_of(here, *v)) : std::nullopt, heavy};
}

std::optional<ValueRange> RotatingMotion::plain_instant(const RealPoint& p, std::size_t leg, const Real& s) const {
  const Standing here = shapes_->standing(leg, s);
  const RealPoint at = shapes_->place(p, leg, s);
  const double factor = shapes_->factor();
  const auto v = look(p, leg, s, Need{}).look;
  const bool second = which_ == Which::kEta2 || which_ == Which::kDelta2;
  if (is_of_fits(which_) && here.rounding > 0 && (second || !v || v->f + v->off > 0)) {
    const double least = v ? std::min(v->f, 0.0) - v->off : -here.rounding / factor;
    return second ? farthest_fit(here, at) : nearest_fit(here, at, least);
  }
  if (!v) return std::nullopt;
  if (v->f >= 0 || rated_below_zero() || here.rounding == 0) return ValueRange{v->f - v->off, v->f + v->off};
  const ValueRange depth = RatedGap(here.pair(), false).depth(at, Real::from_double(here.rounding));
  return ValueRange{depth.low / factor - v->off, std::min(depth.high / factor, v->rated) + v->off};
}

ShapePair RotatingMotion::with_container(const ShapePair& pair, double grown) const {
  const Real by = Real::from_double(grown);
  if (fits_into_fixed(which_)) return {pair.moving(), plane::plain_offset(pair.fixed(), by)};
  return {plane::plain_offset(pair.moving(), by), pair.fixed()};
}

std::optional<ValueRange> RotatingMotion::nearest_fit(const Standing& here, const RealPoint& at, double least) const {
  const auto all = range_at(with_container(here.pair(), here.rounding), which_, at);
  if (!all) return std::nullopt;
  const auto certain = range_at(with_container(here.pair(), -here.rounding), which_, at);
  return ValueRange{std::max(all->low / shapes_->factor(), least), certain ? certain->high / shapes_->factor() : kNone};
}

std::optional<ValueRange> RotatingMotion::farthest_fit(const Standing& here, const RealPoint& at) const {
  const double factor = shapes_->factor();
  const ShapePair large = with_container(here.pair(), here.rounding);
  const auto all = range_at(large, which_, at);
  if (!all) return std::nullopt;
  const auto certain = range_at(with_container(here.pair(), -here.rounding), which_, at);
  if (certain) return ValueRange{certain->low / factor, all->high / factor};
  const auto nearest = range_at(large, fits_into_fixed(which_) ? Which::kEta1 : Which::kDelta1, at);
  return ValueRange{nearest ? std::max(0.0, nearest->low / factor) : 0.0, kNone};
}

std::optional<ValueRange> RotatingMotion::instant(const RealPoint& p, std::size_t leg, const Real& s) const {
  const auto v = plain_instant(p, leg, s);
  return v && negated_ ? penetration(*v) : v;
}

std::optional<ValueRange> RotatingMotion::extremum(const RealPoint& p, Sense sense, double enough,
                                                   Effort effort) const {
  if (shapes_->poses().size() == 1) return instant(p, 0, Real(0));
  auto v = plain_extremum(p, {(sense == Sense::kMinimum) != negated_, enough, effort});
  if (v && negated_) return penetration(*v);
  if (v && !may_be_negative(which_)) v = ValueRange{std::max(0.0, v->low), std::max(0.0, v->high)};
  return v;
}

std::optional<ValueRange> RotatingMotion::plain_extremum(const RealPoint& p, const Searched& search) const {
  return shapes_->extremum({which_, search.least, search.enough, search.effort == Effort::kFine, p},
                           [&] { return searched_extremum(p, search); });
}

std::optional<ValueRange> RotatingMotion::searched_extremum(const RealPoint& p, const Searched& search) const {
  if (auto v = composed_extremum(p, search)) return v;
  if (auto v = extremum_by_boundaries(p, search)) return v;
  return extremum_of_all(p, search);
}

std::optional<ValueRange> RotatingMotion::composed_extremum(const RealPoint& p, const Searched& search) const {
  const auto known = [&](Which which, bool least) {
    auto v = of(which).plain_extremum(p, {least, search.enough, search.effort});
    return v && std::isfinite(v->low) && std::isfinite(v->high) ? v : std::nullopt;
  };
  if (which_ == Which::kDiameter) {
    const auto v = known(Which::kGamma2, search.least);
    return v ? std::optional(greater(*v, own_diameter(*shapes_))) : std::nullopt;
  }
  if (which_ == Which::kH || which_ == Which::kHBack) {
    const auto v = known(which_ == Which::kH ? Which::kMu : Which::kMuBack, search.least);
    return v ? std::optional(greater(*v, {0, 0})) : std::nullopt;
  }
  if (is_covered(which_)) {
    const auto v = known(plain_of_covered(which_), !search.least);
    return v ? std::optional(penetration(*v)) : std::nullopt;
  }
  if (which_ != Which::kHausdorff || search.least) return std::nullopt;
  const auto v = known(Which::kH, false), w = known(Which::kHBack, false);
  return v && w ? std::optional(greater(*v, *w)) : std::nullopt;
}

std::optional<ValueRange> RotatingMotion::extremum_by_boundaries(const RealPoint& p, const Searched& search) const {
  if (which_ == Which::kGamma1) return extremum_apart(p, search);
  if (!search.least || (which_ != Which::kEta1 && which_ != Which::kDelta1)) return std::nullopt;
  const RotatingMotion mu = of(which_ == Which::kEta1 ? Which::kMu : Which::kMuBack);
  const auto found = [&](Effort effort) {
    const auto v = mu.plain_extremum(p, {true, search.enough, effort});
    return v && v->high <= 0 ? v : std::nullopt;
  };
  return search.effort == Effort::kCoarse || found(Effort::kCoarse) ? found(search.effort) : std::nullopt;
}

/// A least gap above 0 is that of all instants; a greatest one that of those at which the shapes are apart.
std::optional<ValueRange> RotatingMotion::extremum_apart(const RealPoint& p, const Searched& search) const {
  const RotatingMotion d1 = of(Which::kD1);
  InstantSearch instants(d1, p, search.least, most_work(search.effort));
  const auto apart = [&] { return instants.undefined().empty() && std::abs(instants.best().f) > 0; };
  instants.look_evenly(legs());
  if (!apart()) return std::nullopt;
  instants.narrow(search.enough, search.least ? 0 : -kNone);
  if (!apart()) return std::nullopt;
  instants.refine();
  if (!apart()) return std::nullopt;
  const double found = instants.best().most(), below = instants.certain();
  if (!search.least) return ValueRange{-found, -below};
  if (below < 0 && !rated_below_zero()) return ValueRange{std::min(below, least_gap()), found};
  return ValueRange{below, found};
}

std::optional<ValueRange> RotatingMotion::extremum_of_all(const RealPoint& p, const Searched& asked) const {
  const bool least = asked.least;
  InstantSearch search(*this, p, least, most_work(asked.effort));
  search.look_evenly(legs());
  const auto at = [&](const InstantSearch::Sample& k) { return plain_instant(p, k.leg, Real::from_double(k.s)); };
  const std::vector<InstantSearch::Sample>& undefined = search.undefined();
  // Whether what was rounded plays no part in it, at some of the instants from the first one on.
  const auto is_certain = [&](std::size_t first) {
    constexpr std::ptrdiff_t kMost = 10;
    const auto from = undefined.begin() + std::ptrdiff_t(first);
    return std::any_of(from, from + std::min(kMost, undefined.end() - from),
                       [&](const InstantSearch::Sample& k) { return !at(k); });
  };
  const bool of_fits = is_of_fits(which_);
  if (!of_fits && !undefined.empty()) return std::nullopt;  // at all times, of a complement
  if (!least && is_certain(0)) return std::nullopt;
  const std::size_t evenly = undefined.size();
  search.narrow(asked.enough);
  if (search.best().f == -kNone) return ValueRange{-kNone, at(search.best())->high};
  const bool none = search.best().f == kNone && !undefined.empty();
  if (!none) search.refine();
  if (!least && is_certain(evenly)) return std::nullopt;
  double found = search.best().most(), from_below = search.certain();
  const double most = least ? search.most() : std::max(search.most(), -from_below);
  const bool rated = undefined.empty() && has_rate(which_, most);
  if (!rated) from_below = -kNone;
  if (of_fits || (!rated_below_zero() && search.best().f != kNone)) {
    const auto best = at(none ? undefined.front() : search.best());
    found = !best ? kNone : least ? best->high : -best->low;
  }
  if (least && of_fits && !rated) from_below = least_protrusion(p, asked.enough);
  if (from_below == kNone) return std::nullopt;
  if (!rated_below_zero() && least && from_below < 0) from_below = std::min(from_below, least_gap());
  return least ? ValueRange{from_below, found} : ValueRange{-found, -from_below};
}

double RotatingMotion::least_protrusion(const RealPoint& p, double enough) const {
  const auto v =
      of(fits_into_fixed(which_) ? Which::kMu : Which::kMuBack).plain_extremum(p, {true, enough, Effort::kCoarse});
  return v ? v->low : kNone;
}

double RotatingMotion::least_gap() const {
  if (!plane::is_bounded(shapes_->a()) || !plane::is_bounded(shapes_->b())) return -kNone;
  return -(shapes_->b_reach() + shapes_->a_reach()) * margin::kUpward - margin::kUpwardSteps;
}

}  // namespace findspace::distance
