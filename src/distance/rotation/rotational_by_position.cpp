// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/rotation/rotational_by_position.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "plane/complex/overlay.h"
#include "plane/query/moved.h"

namespace findspace::distance {

using exact::Real;
using exact::RealPoint;
using plane::CellComplex;
using plane::Mark;
using plane::Region;

namespace {

constexpr int kTimesOfALeg = 12;
constexpr double kDegreesAPiece = 3;  // no sign: how fine the turns are cut
const double kRadians = std::numbers::pi / 180;

RealPoint plus(const RealPoint& p, const RealPoint& q) { return {p.x + q.x, p.y + q.y}; }
RealPoint minus(const RealPoint& p, const RealPoint& q) { return {p.x - q.x, p.y - q.y}; }

/// The nearest point of the grid.
RealPoint rotated(const RealPoint& p, const Real& degrees) {
  if (p.x.sign() == 0 && p.y.sign() == 0) return p;
  const double c = std::cos(degrees.to_double() * kRadians), s = std::sin(degrees.to_double() * kRadians);
  const double x = near_value(p.x), y = near_value(p.y);
  return {Real(std::llround(c * x - s * y)), Real(std::llround(s * x + c * y))};
}

/// B and A between two poses, and A, rotated back about the centre, in place of B rotated about it.
class Rotated {
 public:
  Rotated(const Region& b, const Region& a, Which plain, const RealPoint& centre, const RotatingPose& from,
          const RotatingPose& to, double grid_step)
      : b_(b), a_(a), which_(plain), from_(from), to_(to), grid_step_(grid_step) {
    // What stands still of A's place goes into the shape; A that rotates in time rotates about its own origin.
    const RealPoint place = minus(from.fixed_at, centre);
    const bool rotations = from.fixed.sign() != 0 || to.fixed.sign() != 0;
    if (!rotations) a_ = plane::moved(a_, place);
    place_ = {rotations ? place : RealPoint{},
              rotations ? minus(to.fixed_at, centre) : minus(to.fixed_at, from.fixed_at)};
    b_place_ = {minus(plus(from.at, from.fixed_at), centre), minus(plus(to.at, to.fixed_at), centre)};
    in_time_ = kRadians / 2 *
               (std::abs(near_value(to.moving - from.moving)) * reach(b) +
                std::abs(near_value(to.fixed - from.fixed)) * reach(a));
    const double far = std::max(length(place_[0]), length(place_[1]));
    reach_ = reach(a_) + far;
    if (far > 0) in_time_ += 1;  // rotated() rounds
  }

  /// Bounds of the extremum over the turns from one angle to another: at every time, or (`whole`) of that over the
  /// time.
  BoundedMaps over(const Real& from, const Real& to, Sense sense, bool whole) const {
    const Real mid = Real::ratio(1, 2), step = to - from;
    const int n = std::max(1, int(std::ceil(step.to_double() / kDegreesAPiece)));
    std::vector<RotatingPiece> pieces;
    for (int k = 0; k < n; ++k) {
      const Real back = -(from + Real::ratio(2 * k + 1, 2 * n) * step);
      pieces.push_back({{minus(b_place_[0], rotated(place_[0], back)), minus(b_place_[1], rotated(place_[1], back))},
                        mid * (from_.moving + to_.moving),
                        mid * (from_.fixed + to_.fixed) + back,
                        in_time_,
                        step.to_double() / n * kRadians / 2 * reach_});
    }
    const RotationSenses senses =
        whole ? RotationSenses{sense, sense, sense} : RotationSenses{sense, Sense::kMinimum, Sense::kMaximum};
    return motion_maps(b_, a_, which_, pieces, senses, Real(), grid_step_);
  }

 private:
  static double length(const RealPoint& p) { return std::hypot(near_value(p.x), near_value(p.y)); }

  const Region& b_;
  Region a_;
  Which which_;
  RotatingPose from_, to_;
  std::array<RealPoint, 2> place_, b_place_;
  double grid_step_, in_time_ = 0, reach_ = 0;
};

bool stands(const RotatingPose& p, const RotatingPose& q) {
  const RealPoint d = minus(q.at, p.at), e = minus(q.fixed_at, p.fixed_at);
  return d.x.sign() == 0 && d.y.sign() == 0 && e.x.sign() == 0 && e.y.sign() == 0;
}

plane::SignMap extreme(const std::vector<BoundedMaps>& all, plane::SignMap BoundedMaps::*side, Sense sense) {
  std::vector<const CellComplex*> maps;
  for (const BoundedMaps& m : all) maps.push_back(&(m.*side));
  return plane::overlay(maps, [sense](std::span<const Mark> m) {
    return sense == Sense::kMinimum ? *std::min_element(m.begin(), m.end()) : *std::max_element(m.begin(), m.end());
  });
}

}  // namespace

BoundedMaps rotation_position_maps(const Region& b, const Region& a, Which which, const RealPoint& centre,
                                   const Real& level, double step) {
  const RotatingPose still{};
  return rotation_position_maps(b, a, which, centre, level, {still, still}, Sense::kMinimum, step);
}

BoundedMaps rotation_position_maps(const Region& b, const Region& a, Which which, const RealPoint& centre,
                                   const Real& level, const std::vector<RotatingPose>& poses, Sense over_time,
                                   double step) {
  // The least over the turns and over the time, or the greatest over both: then whole legs can be taken.
  const bool same_order =
      !is_second_kind(which) && (level.sign() == 0 || (level.sign() > 0) == (over_time == Sense::kMinimum));
  std::vector<BoundedMaps> all;
  for (std::size_t leg = 0; leg + 1 < poses.size(); ++leg) {
    const RotatingPose &from = poses[leg], &to = poses[leg + 1];
    const int n = std::max(pieces_of_leg(from, to), same_order || stands(from, to) ? 1 : kTimesOfALeg);
    for (int k = 0; k < n; ++k) {
      const Rotated rotated(b, a, plain_of(which), centre, between(from, to, Real::ratio(k, n)),
                            between(from, to, Real::ratio(k + 1, n)), step);
      all.push_back(rotational_bounds(which, level, plane::SignMap::uniform(1),
                                      [&](const Real& first, const Real& last, Sense sense) {
                                        return rotated.over(first, last, same_order ? over_time : sense, same_order);
                                      }));
    }
  }
  if (all.size() == 1) return std::move(all.front());
  return {extreme(all, &BoundedMaps::low, over_time), extreme(all, &BoundedMaps::high, over_time)};
}

}  // namespace findspace::distance
