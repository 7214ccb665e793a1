// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/rotation/turning_shapes.h"

#include <algorithm>
#include <optional>

#include "distance/planar_features/boundary_features.h"
#include "distance/rotation/rated_gap.h"
#include "plane/base/search_work.h"
#include "plane/build/transform.h"
#include "plane/query/scaled.h"

namespace findspace::distance {

using exact::Real;
using exact::RealPoint;

namespace {

/// As fine as the reach allows within the grid's 2^40 steps.
std::int64_t refinement(double reach) {
  std::int64_t factor = 1;
  while (factor < (1 << 20) && reach * double(2 * factor) < double(std::int64_t{1} << 39)) factor *= 2;
  return factor;
}

/// The part of a leg in parts that halving leads to; nothing for the others.
std::optional<int> halved_part(const Real& s) {
  constexpr int kParts = 64;
  const Real part = s * Real(kParts);
  const auto whole = part.integer();
  return whole ? std::optional(int(*whole)) : std::nullopt;
}

}  // namespace

double reach(const plane::Region& r) {
  double most = 0;
  for (const BoundaryFeature& s : features(r, [](plane::Mark m) { return m > 0; }))
    most = std::max(most, s.farthest(0, 0));
  return most;
}

TurningShapes::TurningShapes(const plane::Region& b, const plane::Region& a, std::vector<RotatingPose> poses,
                             double step)
    : b_reach_(reach(b)), a_reach_(reach(a)), step_(step), poses_(std::move(poses)) {
  const std::int64_t factor = refinement(std::max(b_reach_, a_reach_));
  b_ = plane::scaled(b, factor);
  a_ = plane::scaled(a, factor);
  factor_ = double(factor);
}

bool TurningShapes::convex(const plane::Region& r, std::optional<bool>& known) const {
  const std::lock_guard lock(guard_);
  if (!known) known = is_convex(r);
  return *known;
}

RealPoint TurningShapes::place(const RealPoint& p, std::size_t leg, const Real& s) const {
  const RotatingPose &from = poses_[leg], &to = poses_[std::min(leg + 1, poses_.size() - 1)];
  const Real f = Real::from_double(factor_);
  return {f * (p.x + between(from.at.x, to.at.x, s)), f * (p.y + between(from.at.y, to.at.y, s))};
}

TurningShapes::Standing TurningShapes::made(std::size_t leg, const Real& s) const {
  const RotatingPose &from = poses_[leg], &to = poses_[std::min(leg + 1, poses_.size() - 1)];
  plane::Rounding rounding;
  const auto rotated = [&](const plane::Region& r, const Real& degrees) {
    return plane::rotated(r, {0, 0}, degrees, step_ / factor_, rounding);
  };
  plane::Region b = rotated(b_, between(from.moving, to.moving, s)), a = rotated(a_, between(from.fixed, to.fixed, s));
  // Two shapes; ends of an arc carry its bulge along: twice what they moved.
  return {std::make_shared<AtPosition>(std::make_shared<ShapePair>(std::move(b), std::move(a))), 4 * rounding.largest};
}

bool TurningShapes::ExtremumAsked::operator==(const ExtremumAsked& other) const {
  // no sign: the same number is asked for
  return which == other.which && least == other.least && enough == other.enough && fine == other.fine &&
         at.x == other.at.x && at.y == other.at.y;
}

std::optional<ValueRange> TurningShapes::extremum(const ExtremumAsked& asked,
                                                  const std::function<std::optional<ValueRange>()>& search) const {
  constexpr std::size_t kMostExtrema = 64;
  const plane::SearchQuestion question;
  const long left = question.work().left;
  {
    const std::lock_guard lock(guard_);
    for (const FoundExtremum& k : extrema_) {
      if (!(k.asked == asked) || k.work >= left) continue;
      plane::count_cells(k.work);
      return k.found;
    }
  }
  const std::optional<ValueRange> out = search();
  if (question.work().spent()) return out;  // perhaps it was cut short
  const std::lock_guard lock(guard_);
  if (extrema_.size() < kMostExtrema) extrema_.push_back({asked, out, left - question.work().left});
  return out;
}

TurningShapes::Standing TurningShapes::standing(std::size_t leg, const Real& s) const {
  constexpr std::size_t kMostEdges = 6000;  // of all that are kept
  const std::optional<int> part = halved_part(s);
  if (!part) return made(leg, s);
  const Instant instant{leg, *part};
  {
    const std::lock_guard lock(guard_);
    const auto found = kept_.find(instant);
    if (found != kept_.end()) return found->second;
  }
  Standing out = made(leg, s);
  const std::lock_guard lock(guard_);
  if ((kept_.size() + 1) * edges() <= kMostEdges) kept_.emplace(instant, out);
  return out;
}

}  // namespace findspace::distance
