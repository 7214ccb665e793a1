// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/rotation/rotation_in_time.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "distance/rotation/rotated_pair.h"
#include "distance/rotation/rotational_distance.h"
#include "exact/margins/planar_distance.h"
#include "exact/margins/rounding.h"
#include "plane/base/subdivide.h"
#include "plane/build/transform.h"

namespace findspace::distance {

using exact::Angle;
using exact::Real;
using exact::RealPoint;
using plane::Mark;
using plane::Region;
using plane::RotationMap;

namespace {

constexpr int kFirstPartsOfDisc = 4, kPartsOfDisc = 8;
using exact::kInfinity;

double length(const RealPoint& from, const RealPoint& to) {
  return std::hypot(near_value(to.x - from.x), near_value(to.y - from.y));
}

/// Rounded up to whole grid steps, short ones to some thousandth; nothing where there is nothing to round.
Real next_fraction(double r) {
  if (r <= 0) return Real();
  const std::int64_t parts = r < 4096 ? 1 << 12 : 1;
  return Real::ratio(std::int64_t(std::floor(r * double(parts) * margin::kUpward)) + 1, parts);
}

/// There is an angle with contact, or where it fits.
bool is_met(const RotationMap& base) { return farthest_rotation(base, Angle{}) < kInfinity; }

RotationMap base_map(const RotatedPair& pair, Which which, const Real& level) {
  const Which plain = plain_of(which);
  return plain == Which::kGamma1 ? pair.nearest_point(level) : pair.sign_map(plain, level);
}

}  // namespace

RotationInTime::RotationInTime(Region b, Region a, Which which, RealPoint centre, RealPoint p,
                               std::vector<RotatingPose> poses, double step)
    : b_(std::move(b)),
      a_(std::move(a)),
      which_(which),
      centre_(std::move(centre)),
      p_(std::move(p)),
      poses_(std::move(poses)),
      b_reach_(reach(b_)),
      a_reach_(reach(a_)),
      step_(step) {}

BoundedRotations RotationInTime::circles(const PartOfLeg& part) const {
  const RotatingPose &from = poses_[part.leg], &to = poses_[std::min(part.leg + 1, poses_.size() - 1)];
  const Real mid = Real::ratio(1, 2) * (part.from + part.to);
  const double share = near_value(part.to - part.from) / 2;
  const RealPoint a_at = between(from.fixed_at, to.fixed_at, mid),
                  from_b_at{from.at.x + from.fixed_at.x, from.at.y + from.fixed_at.y},
                  to_b_at{to.at.x + to.fixed_at.x, to.at.y + to.fixed_at.y}, b_at = between(from_b_at, to_b_at, mid);
  plane::Rounding rounding;
  const RotatedPair pair(rotated(b_, {0, 0}, between(from.moving, to.moving, mid), step_, rounding),
                         rotated(a_, {0, 0}, between(from.fixed, to.fixed, mid), step_, rounding),
                         {centre_.x - p_.x - b_at.x, centre_.y - p_.y - b_at.y},
                         {centre_.x - a_at.x, centre_.y - a_at.y});
  const double radians = std::numbers::pi / 180;
  const double way = length(from_b_at, to_b_at) + length(from.fixed_at, to.fixed_at) +
                     radians * (std::abs(near_value(to.moving - from.moving)) * b_reach_ +
                                std::abs(near_value(to.fixed - from.fixed)) * a_reach_);
  // Ends of an arc carry its bulge along: twice what they moved, for both shapes.
  const Real off = next_fraction(4 * rounding.largest + share * way + radius_);
  RotationMap low = base_map(pair, which_, off);
  if (off.sign() == 0) return {low, low};
  return {std::move(low), base_map(pair, which_, -off)};
}

SignRange RotationInTime::signs(const PartOfLeg& part, const Real& level) const {
  const BoundedRotations c = circles(part);
  if (!is_second_kind(which_)) {
    const auto sign = [&](const RotationMap& base) { return mark_at(rotation_sign_map(base, level), Angle{}); };
    return {sign(c.low), sign(c.high)};
  }
  const auto sign = [&](const RotationMap& base) { return mark_at(farthest_rotation_sign_map(base, level), Angle{}); };
  if (is_met(c.high)) return {sign(c.high), sign(c.low)};
  return {Mark(is_met(c.low) && level.sign() >= 0 ? -1 : 1), 1};
}

/// The second kind is greater the more angles there are with contact, and infinite without any.
ValueRange RotationInTime::values(const PartOfLeg& part) const {
  const BoundedRotations c = circles(part);
  ValueRange v{rotation_distance(c.low, Angle{}), rotation_distance(c.high, Angle{})};
  if (is_second_kind(which_)) {
    v = is_met(c.high) ? ValueRange{farthest_rotation(c.high, Angle{}), farthest_rotation(c.low, Angle{})}
                       : ValueRange{std::max(0.0, v.low), kInfinity};
  }
  return {v.low - margin::kRoundingOfAngle, v.high + margin::kRoundingOfAngle};
}

ValueRange RotationInTime::instant(std::size_t leg, const Real& s) const { return values({leg, s, s}); }

RotationInTime RotationInTime::around(RealPoint p, double radius) const {
  RotationInTime out = *this;
  out.p_ = std::move(p);
  out.radius_ = radius;
  out.first_parts_ = kFirstPartsOfDisc;
  out.most_parts_ = kPartsOfDisc;
  return out;
}

ValueRange RotationInTime::extremum(Sense sense) const {
  if (poses_.size() == 1) return instant(0, Real());
  // Rotated round for a supremum, so that the least value is looked for.
  const bool least = sense == Sense::kMinimum;
  struct Part {
    PartOfLeg part;
    double low;
    bool operator<(const Part& other) const { return low > other.low; }
  };
  plane::Subdivision<Part> queue;
  double best = kInfinity;
  const auto look = [&](std::size_t leg, const Real& s) {
    const ValueRange there = values({leg, s, s});
    best = std::min(best, least ? there.high : -there.low);
  };
  const auto add = [&](PartOfLeg part) {
    look(part.leg, Real::ratio(1, 2) * (part.from + part.to));
    const ValueRange all = values(part);
    const double low = least ? all.low : -all.high;
    queue.push({std::move(part), low});
  };
  for (std::size_t leg = 0; leg + 1 < poses_.size(); ++leg) {
    look(leg, Real(0));
    look(leg, Real(1));
    for (int k = 0; k < first_parts_; ++k) add({leg, Real::ratio(k, first_parts_), Real::ratio(k + 1, first_parts_)});
  }
  queue.run((most_parts_ + 1) / 2, [&](const Part& top) { return !(best - top.low > margin::kCloseExtremum); },
            [&](const Part& top) {
              const PartOfLeg& part = top.part;
              const Real mid = Real::ratio(1, 2) * (part.from + part.to);
              add({part.leg, part.from, mid});
              add({part.leg, mid, part.to});
            });
  const double low = std::min(queue.best().low, best);
  return least ? ValueRange{low, best} : ValueRange{-best, -low};
}

}  // namespace findspace::distance
