// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The maps of a CsgSide on lines: by the least values on stretches of functions (near_rays.h), of balls by the features
// of A (csg_features.h), or by values. And the least values along a direction.
#include <algorithm>
#include <cmath>
#include <vector>

#include "distance/csg/csg_features.h"
#include "distance/csg/csg_pair.h"
#include "distance/rays/ray_directional_least.h"
#include "distance/search/boundary_search.h"
#include "distance/search/convex_distance.h"
#include "exact/margins/space_distance.h"
#include "exact/number/interval.h"
#include "plane/base/search_work.h"
#include "space/body/body.h"
#include "space/body/body_boxes.h"
#include "space/rays/ray_sources.h"

namespace findspace::distance {

using exact::Real;
using space::BodyPart;
using space::dot;
using space::Point;
using space::RealVector;
using space::Vector;

/// What a convex part covers on its way along a stretch of a line: its sum with a segment. The planes of the sum are
/// those of the part and those along the way through its edges. So a search finds what comes near the part anywhere on
/// a stretch at once. In doubles; of rounding the sum is rather too large.
class SweptPart {
 public:
  /// `unit`: the direction of the way, of length 1.
  SweptPart(const space::BodyPart& part, const space::Vector& unit);

  /// The distance to the part on its way from start + from * unit to start + to * unit, less its radius; inside a part
  /// without one minus how deep.
  TouchingConstraint gap(const space::Vector& start, double from, double to) const;

 private:
  void add_silhouette(std::span<const space::Point> corners, const space::Vector& corner, const space::Vector& edge);

  space::Vector unit_, center_;
  double radius_ = 0;
  bool point_ = false;
  std::vector<NearPlane> planes_, along_;  // along: those that only the way has
};

/// The distance to the segment from start + from * unit to start + to * unit.
TouchingConstraint distance_to_segment(const space::Vector& start, const space::Vector& unit, double from, double to);

SweptPart::SweptPart(const space::BodyPart& part, const Vector& unit)
    : unit_(unit), center_(exact::approx(part.center)), radius_(part.radius.to_double()), point_(part.point()) {
  if (point_) return;
  for (const space::HalfSpace& h : part.planes()) planes_.push_back({h.unit, h.shift});
  const auto corners = part.vertices();
  const auto add = [&](const Point& from, const Point& to) {
    add_silhouette(corners, exact::approx(from), exact::approx(to - from));
  };
  if (part.core) {
    for (const space::HalfEdge& h : part.core->half_edges())
      add(corners[static_cast<std::size_t>(h.origin)], corners[static_cast<std::size_t>(h.target)]);
    return;
  }
  for (std::size_t k = 0; k < corners.size(); ++k) {
    for (std::size_t n = 0; n < corners.size(); ++n) {
      if (n != k) add(corners[k], corners[n]);
    }
  }
}

/// The plane along the edge and the way, if all is on one side of it. An edge comes once each way.
void SweptPart::add_silhouette(std::span<const Point> corners, const Vector& corner, const Vector& edge) {
  Vector n = space::cross(edge, unit_);
  const double size = space::length(n);
  if (size <= margin::kSameNormal * space::length(edge)) return;  // nothing new: the edge is swept along itself
  n = space::scaled(1 / size, n);
  double most = -exact::kInfinity, wide = 0;
  for (const Point& p : corners) {
    const Vector v = exact::approx(p);
    most = std::max(most, dot(n, v));
    wide = std::max(wide, space::size_of(v));
  }
  if (most > dot(n, corner) + margin::kSameNormal * wide) return;
  const auto same = [&](const NearPlane& h) { return space::length(h.unit - n) < margin::kSameNormal; };
  if (std::any_of(planes_.begin(), planes_.end(), same) || std::any_of(along_.begin(), along_.end(), same)) return;
  along_.push_back({n, -most});
}

TouchingConstraint SweptPart::gap(const Vector& start, double from, double to) const {
  if (point_) return less_radius(distance_to_segment(space::plus(start, center_), unit_, from, to), radius_);
  std::vector<NearPlane> planes = planes_;
  for (NearPlane& h : planes) {
    const double ahead = dot(h.unit, unit_);
    h.shift -= std::max(from * ahead, to * ahead);
  }
  if (from < to) planes.insert(planes.end(), along_.begin(), along_.end());
  TouchingConstraint away = touching_way(way_to(planes), start, radius_);
  if (radius_ > 0) return away;
  return [planes = std::move(planes), away = std::move(away), start](const Vector& x) {
    const Touching inside = highest_of(planes, x - start);
    return inside.value < 0 ? inside : away(x);
  };
}

TouchingConstraint distance_to_segment(const Vector& start, const Vector& unit, double from, double to) {
  return [=](const Vector& x) {
    Vector off = x - start;
    off = off - space::scaled(std::clamp(dot(off, unit), from, to), unit);
    const double d = space::length(off);
    return Touching{d, d > 0 ? space::scaled(1 / d, off) : Vector{}};
  };
}

/// Of the blur that is wanted.
constexpr double kDeepEnough = 4;

/// gamma1 less a level from 0 on, inside minus how deep a place of A is in a part of B.
class CsgSide::GapNear : public NearRule {
 public:
  GapNear(std::shared_ptr<const CsgSide> side, double level, const Vector& unit)
      : side_(std::move(side)), level_(level) {
    bool points = false;
    for (const BodyPart& s : side_->b_->parts) {
      Moving& moving =
          parts_.emplace_back(Moving{SweptPart(s, unit), space::rounded(bounds(space::body_of_part(s))), {}, 0});
      if (!s.point()) continue;
      points = true;
      moving.center = exact::approx(s.center);
      moving.radius = s.radius.to_double();
    }
    for (const CsgPartSearch& part : side_->parts_)
      features_.push_back(points ? CsgFeatures::of(*part.sets, side_->size_) : nullptr);
  }

  exact::Tried<Least> least(const NearLine& line, double from, double to, const Until& until) const override {
    Least out{exact::kInfinity, exact::kInfinity, {}, true};
    const double error = margin::kFoundError * side_->size_;
    const Until wanted{level_, until.share, until.blur};
    const Vector &start = line.start, &unit = line.unit;
    const PointWay way{start, unit, from, to};
    for (const PairOfParts& pair : pairs(way)) {
      const Moving& s = *pair.moving;
      const double least = pair.least - error - level_;
      // A place that is so deep is enough to go on from.
      if (least > 0 || least > out.low || out.high < (until.share > 0 ? -kDeepEnough * until.blur : 0)) {
        out.low = std::min(out.low, least);
        break;
      }
      std::optional<BoundaryPlace> by_features = nearest_by_features(s, pair.part, way, wanted);
      out.quick = out.quick && by_features;
      const BoundaryPlace found = by_features ? *std::move(by_features) : nearest(s, pair.part, way, wanted);
      out.low = std::min(out.low, found.bound - error - level_);
      const double high = found.value + error - level_;
      if (!found.found || !(high < out.high)) continue;
      out.high = high;
      out.beyond = beyond(s, start, unit, found.place, level_ - error);
    }
    return out;
  }

 private:
  struct Moving {
    SweptPart swept;
    space::Extent box;
    std::optional<Vector> center;  // of a ball
    double radius = 0;
  };

  /// A part of B and one of A: by their boxes the function is nowhere on a stretch less.
  struct PairOfParts {
    const Moving* moving;
    std::size_t part;
    double least;
  };
  /// By that.
  std::vector<PairOfParts> pairs(const PointWay& way) const {
    std::vector<PairOfParts> out;
    for (const Moving& s : parts_) {
      const space::Extent swept = swept_box(s, way);
      for (std::size_t k = 0; k < features_.size(); ++k)
        out.push_back({&s, k, apart_or_deep(swept, side_->parts_[k].box())});
    }
    std::stable_sort(out.begin(), out.end(),
                     [](const PairOfParts& a, const PairOfParts& b) { return a.least < b.least; });
    return out;
  }
  /// How far two boxes are from each other; of those that meet minus how deep a place of one is in the other at most.
  static double apart_or_deep(const space::Extent& a, const space::Extent& b) {
    const double apart = space::distance(a, b);
    if (apart > 0) return apart;
    const Vector ahead = b.high - a.low, behind = a.high - b.low;
    return -std::min({ahead.x, ahead.y, ahead.z, behind.x, behind.y, behind.z});
  }

  /// The place of a part of A; nothing where it has no features or they do not tell.
  std::optional<BoundaryPlace> nearest_by_features(const Moving& s, std::size_t part, const PointWay& way,
                                                   const Until& until) const {
    if (!s.center || !features_[part]) return std::nullopt;
    const auto found = features_[part]->nearest({space::plus(way.start, *s.center), way.unit, way.from, way.to},
                                                {until.level + s.radius, until.share, until.blur});
    if (!found) return std::nullopt;
    BoundaryPlace out;
    out.found = true;
    out.value = found->high - s.radius;
    out.bound = found->low - s.radius;
    out.place = found->place;
    return out;
  }

  /// Places of it that are farther by an eighth of B than the level are not looked for.
  BoundaryPlace nearest(const Moving& s, std::size_t part, const PointWay& way, const Until& until) const {
    const TouchingConstraint gap = s.swept.gap(way.start, way.from, way.to);
    const double far = until.level + space::length(s.box.high - s.box.low) / 8 + 2 * margin::kFoundError * side_->size_;
    const PositionSet& places = side_->parts_[part].places;
    const space::Extent near = in_both(places.box(), grown(swept_box(s, way), far));
    BoundaryPlace out = places.nearest_to(gap, {-exact::kInfinity, {}, &until, near});
    out.bound = std::min(out.bound, far);
    return out;
  }

  static space::Extent swept_box(const Moving& s, const PointWay& way) {
    space::Extent out = moved(s.box, space::plus(way.start, space::scaled(way.from, way.unit)));
    out.add(moved(s.box, space::plus(way.start, space::scaled(way.to, way.unit))));
    return out;
  }

  static std::function<AlongPlace(double)> beyond(const Moving& s, const Vector& start, const Vector& unit,
                                                  const Vector& place, double level) {
    return [gap = s.swept.gap(start, 0, 0), unit, place, level](double t) {
      const Touching at = gap(place - space::scaled(t, unit));
      return AlongPlace{at.value - level, -space::dot(at.slope, unit)};
    };
  }

  std::shared_ptr<const CsgSide> side_;
  double level_;
  std::vector<Moving> parts_;
  std::vector<std::unique_ptr<const CsgFeatures>> features_;  // of the parts of A, where B has balls
};

/// How far the nearest position is at which B is free of A, less how far that is to be.
class CsgSide::FreeNear : public NearRule {
 public:
  FreeNear(std::shared_ptr<const CsgSide> side, double depth, const Vector& unit, const NearRange& range)
      : side_(side), depth_(depth), range_(range), free_(std::move(side), 0, unit) {}

  /// Where B is free, and up to the depth from there.
  exact::Tried<Known> known(const NearLine& line) const override {
    Known out;
    const exact::Tried<std::vector<SignStretch>> stretches = near_stretches(free_, line, range_);
    if (!stretches) return stretches.refusal();
    const double reach = depth_ - 2 * margin::kFoundError * side_->size_;
    for (const SignStretch& s : *stretches) {
      if (s.sign <= 0) continue;
      if (!out.empty() && s.from - reach <= out.back().second)
        out.back().second = s.to + reach;
      else
        out.emplace_back(s.from - reach, s.to + reach);
    }
    return out;
  }

  exact::Tried<Least> least(const NearLine& line, double from, double to, const Until& until) const override {
    const double error = margin::kFoundError * side_->size_;
    const Vector &start = line.start, &unit = line.unit;
    const Vector p = space::plus(start, space::scaled(from, unit)), q = space::plus(start, space::scaled(to, unit));
    const double reach = depth_ * margin::kNearReach + error;
    space::Extent way{p, p};
    way.add({q, q});
    std::optional<Vector> out_of_one;
    const Incumbent ask = [&] { return out_of_set(p, q, out_of_one); };
    const exact::Tried<PositionSet>& free = side_->free();
    if (!free) return free.refusal();
    const Until wanted{depth_, until.share, until.blur};
    const BoundaryPlace found =
        free->nearest_to(distance_to_segment(start, unit, from, to), {0, ask, &wanted, grown(way, reach)});
    Least out{found.bound - error - depth_, exact::kInfinity, {}};
    if (!found.found && !(found.known && out_of_one)) return out;
    out.high = found.value + error - depth_;
    const Vector place = found.found ? found.place : *out_of_one;
    out.beyond = [away = distance_to_segment(place, {}, 0, 0), start, unit, by = depth_ - error](double t) {
      const Touching at = away(space::plus(start, space::scaled(t, unit)));
      return AlongPlace{at.value - by, space::dot(at.slope, unit)};
    };
    return out;
  }

 private:
  /// From one of the ends by taking B out of one container, or into one obstacle. Between them that is not nearer.
  std::optional<double> out_of_set(const Vector& p, const Vector& q, std::optional<Vector>& place) const {
    std::optional<double> best;
    for (const Vector& from : {p, q}) {
      const std::optional<Answer> free = side_->free_of_sets(space::real(from));
      if (!free || !free->nearest || free->value.sign() <= 0) continue;
      const Vector there = space::rounded(*free->nearest);
      const double d = space::length(there - from);
      if (!best || d < *best) {
        best = d;
        place = there;
      }
    }
    return best;
  }

  std::shared_ptr<const CsgSide> side_;
  double depth_;
  NearRange range_;
  GapNear free_;
};

std::unique_ptr<const NearRule> CsgSide::nearness(std::shared_ptr<const CsgSide> side, Which which, double level,
                                                  const Vector& unit, const NearRange& range) {
  if (which != Which::kGamma1 || side->a_->walls || side->points_) return nullptr;
  if (level >= 0) return std::make_unique<GapNear>(std::move(side), level, unit);
  return std::make_unique<FreeNear>(std::move(side), -level, unit, range);
}

namespace {

/// About all positions at which the two can be nearer than the level.
NearRange meeting_range(const CsgSide& side, const Real& level) {
  const space::Bounds3 box = space::meeting(bounds(side.complete()), bounds(side.cut()));
  const Vector low = space::rounded(box.low), high = space::rounded(box.high);
  return {space::scaled(0.5, space::plus(low, high)), space::length(high - low) + std::fabs(level.to_double()) + 1};
}

}  // namespace

std::unique_ptr<space::RaySource> cut_map(Which which, const Real& level, std::shared_ptr<const CsgSide> side,
                                          std::int64_t scale, const space::RayGrid& grid) {
  if (const auto cut = cut_off_of(which); cut && cut->base == Which::kGamma1) {
    if (level.sign() < 0) return space::constant_rays(grid, 1);
    return space::cut_off_rays(cut_map(cut->base, cut->negated ? -level : level, std::move(side), scale, grid),
                               cut->negated, level);
  }
  const NearRange range = meeting_range(*side, level);
  if (auto near = CsgSide::nearness(side, which, level.to_double(), line_direction(grid), range)) {
    const bool deep = which == Which::kGamma1 && level.sign() < 0;
    auto rays = std::make_unique<NearRays>(std::move(near), range, deep ? -1 : 1, scale, grid);
    if (deep) return space::negated_rays(std::move(rays));
    return rays;
  }
  const RayRule rule = [side, which, level](const space::RealVector& p) { return between(side, which, level, p); };
  return std::make_unique<ValueRays>(rule, range.middle, range.size, scale, grid);
}

std::unique_ptr<space::RaySource> cut_map_along(Which which, const Real& level, const AlongWay& way,
                                                std::shared_ptr<const CsgSide> side, std::int64_t scale,
                                                const space::RayGrid& grid) {
  if (const auto cut = cut_off_of(which); cut && cut->base == Which::kGamma1) {
    if (level.sign() < 0) return space::constant_rays(grid, 1);
    auto base = cut_map_along(cut->base, cut->negated ? -level : level, way, std::move(side), scale, grid);
    return base ? space::cut_off_rays(std::move(base), cut->negated, level) : nullptr;
  }
  const bool gap = which == Which::kGamma1;
  if (gap && level.sign() == 0) return cut_map(which, level, std::move(side), scale, grid);
  if (which == Which::kGamma2 && level.sign() < 0) return space::constant_rays(grid, 1);
  if ((!gap && which != Which::kGamma2) || level.sign() < 0) return nullptr;
  const NearRange range = meeting_range(*side, level);
  const Vector unit = space::scaled(1 / space::length(space::rounded(way.direction)), space::rounded(way.direction));
  std::shared_ptr<const NearRule> near = CsgSide::nearness(std::move(side), Which::kGamma1, 0, unit, range);
  if (!near) return nullptr;
  // How far B is from A on a stretch of its way.
  const auto on_way = [near, unit](const RealVector& p, double from, double to) -> exact::Tried<exact::Interval> {
    const auto least = near->least({space::rounded(p), unit}, from, to, {0, margin::kRoughShare});
    if (!least) return least.refusal();
    return exact::Interval{least->low, least->high};
  };
  const double at = level.to_double(), far = 2 * range.size;  // beyond which they do not meet
  const RayRule rule = [=, both = way.both](const RealVector& p) -> TriedBetween {
    const auto all = on_way(p, both ? -(gap ? at : far) : 0, gap ? at : far);
    if (!all) return all.refusal();
    if (gap || all->lo > 0) return Between{all->lo, all->hi};
    // They meet: beyond the level or not.
    auto beyond = on_way(p, at, far);
    if (!beyond) return beyond.refusal();
    if (both) {
      const auto back = on_way(p, -far, -at);
      if (!back) return back.refusal();
      beyond = exact::Interval{std::min(beyond->lo, back->lo), std::min(beyond->hi, back->hi)};
    }
    return Between{std::max(all->lo, -beyond->hi), std::max(all->hi, -beyond->lo)};
  };
  return std::make_unique<ValueRays>(rule, range.middle, range.size, scale, grid);
}

namespace {

constexpr int kLinesAcross = 8;  // each way, that are tried for the longest overlap

/// The longest stretch of a line on which the function is less than 0, by its ends.
exact::Tried<std::pair<double, double>> longest_below(const NearRule& rule, const NearLine& line,
                                                      const NearRange& range) {
  const exact::Tried<std::vector<SignStretch>> all = near_stretches(rule, line, range);
  if (!all) return all.refusal();
  std::pair<double, double> best{0, 0};
  std::optional<double> from;
  for (const SignStretch& s : *all) {
    if (s.sign >= 0) {
      from.reset();
      continue;
    }
    if (!from) from = s.from;
    if (s.to - *from > best.second - best.first) best = {*from, s.to};
  }
  return best;
}

}  // namespace

/// No stretch is longer than that of what holds A. The line of that, and others across it, have one that is nearly so.
TriedAnswer CsgSide::least_gap_along(const std::shared_ptr<const CsgSide>& side, const RealVector& direction,
                                     bool both_ways) {
  if (side->a_->walls) return left_walls();
  if (side->points_) return no_depth();
  const plane::SearchQuestion question;
  const TriedAnswer held =
      ray_directional_least(Which::kGamma1, direction, both_ways, side->complete(), side->holding_sets());
  if (!held || !*held) return held;
  const Real bound = *(*held)->bounds().lower;
  const Vector along = space::rounded(direction), unit = space::scaled(1 / space::length(along), along);
  const NearRange range = meeting_range(*side, Real());
  const GapNear rule(side, 0, unit);
  const Vector across = distance::across(unit), upward = space::cross(unit, across);
  double longest = 0;
  Vector middle = range.middle, best = range.middle;
  const double most = -bound.to_double() * (both_ways ? 2 : 1), blur = 4 * ValueRays::kCertain * range.size;
  const auto look = [&](const Vector& start) {
    if (question.work().spent() || most - longest <= blur) return;
    const exact::Tried<std::pair<double, double>> found = longest_below(rule, {start, unit}, range);
    if (!found || !(found->second - found->first > longest)) return;  // another line may tell
    longest = found->second - found->first;
    best = start;
    middle = space::plus(start, space::scaled((found->first + found->second) / 2, unit));
  };
  const auto aside = [&](const Vector& from, double x, double y) {
    return space::plus(from, space::plus(space::scaled(x * range.size, across), space::scaled(y * range.size, upward)));
  };
  look(space::rounded((*held)->at));
  for (int i = 0; i < kLinesAcross; ++i) {
    for (int j = 0; j < kLinesAcross; ++j)
      look(aside(range.middle, (i + 0.5) / kLinesAcross - 0.5, (j + 0.5) / kLinesAcross - 0.5));
  }
  for (double step = 0.5 / kLinesAcross; step * range.size > margin::kDeepestGap * side->size_; step /= 2) {
    const Vector from = best;
    for (const auto& [x, y] : {std::pair{step, 0.0}, {-step, 0.0}, {0.0, step}, {0.0, -step}}) look(aside(from, x, y));
  }
  const Real value = -Real::from_double(longest) / Real(both_ways ? 2 : 1);
  Answer out = least_answer(value, std::min(bound, value), false, space::real(middle));
  if (!both_ways) out.side = Side::kNone;
  return out;
}

}  // namespace findspace::distance
