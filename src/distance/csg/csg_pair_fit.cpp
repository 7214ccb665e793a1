// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// How deep B of a CsgSide is in A. And where it fits into a union of solids that balls are cut out of: it is in the
// union where it is free of what that leaves of a box about both.
#include <algorithm>
#include <cmath>

#include "distance/csg/csg_pair.h"
#include "distance/csg/csg_part.h"
#include "exact/margins/space_distance.h"

namespace findspace::distance {

using exact::Real;
using exact::Tried;
using space::Point;
using space::RealVector;
using space::Vector;

/// The distance to the nearest position at which B is free of a container, or in an obstacle, and so free of A.
TriedAnswer CsgSide::free_of_sets(const RealVector& p) const {
  std::optional<Answer> best;
  const auto take = [&](std::optional<Answer> v, bool negated) {
    if (!v || !v->proven) return;
    if (negated) v->value = -v->value;
    if (!best || v->value < best->value) best = std::move(v);
  };
  for (std::size_t k = 0; k < containers_.size(); ++k) {
    if (!a_->containers[k].convex()) continue;
    TriedAnswer v = containers_[k].try_value(Which::kGamma1, p);
    if (!v) return v;
    take(*std::move(v), true);
  }
  for (std::size_t k = 0; k < obstacles_.size(); ++k) {
    if (!a_->obstacles[k].convex()) continue;
    TriedAnswer v = obstacles_[k].try_value(Which::kEta1, p);
    if (!v) return v;
    take(*std::move(v), false);
  }
  return best;
}

TriedAnswer CsgSide::overlapping(const RealVector& p) const {
  const Tried<PositionSet>& free = this->free();
  if (!free) return free.refusal();
  const TriedAnswer known = free_of_sets(p);
  if (!known) return known;
  TriedAnswer found = free->nearest(p, true, [&] { return *known; });
  if (!found) return found;
  return minus(**std::move(found));
}

namespace {

bool inside(const RealVector& p, const space::Bounds3& box) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (p[k] < box.low[k] || box.high[k] < p[k]) return false;
  }
  return true;
}

}  // namespace

struct CsgSide::Among {
  space::Bounds3 places;  // beyond this B protrudes from the box about A
  std::unique_ptr<const CsgSide> left;

  /// Of B in A.
  Tried<PositionSet> fits() const {
    const Tried<PositionSet>& free = left->free();
    if (!free) return free.refusal();
    return free->within(space::rounded(places));
  }
};

CsgSide::TriedAmong CsgSide::made_among() const {
  const space::Bounds3 outer = bounds(*a_), inner = bounds(*b_);
  auto out = std::make_shared<Among>();
  const auto places = space::fitting(inner, outer);
  if (!places) return std::shared_ptr<const Among>();
  out->places = *places;
  std::array<std::int64_t, 3> low{}, high{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double from = outer.low[k].to_double(), to = outer.high[k].to_double(), tolerance = (to - from) / 4 + 2;
    low[k] = static_cast<std::int64_t>(std::floor(from - tolerance));
    high[k] = static_cast<std::int64_t>(std::ceil(to + tolerance));
  }
  auto left = left_in_box(*a_, Point{low[0], low[1], low[2]}, Point{high[0], high[1], high[2]});
  if (!left) return left.refusal();
  if (left->walls) return left_walls();
  out->left = std::make_unique<const CsgSide>(b_, std::make_shared<const space::CsgSolid>(*std::move(left)));
  return std::shared_ptr<const Among>(std::move(out));
}

/// Whether B + p is in A, and how deep.
Tried<bool> CsgSide::in_union(const Among& all, const RealVector& p, Answer& depth) const {
  if (!inside(p, all.places)) return false;
  Tried<Gap> gap = all.left->gap_at(p);
  if (!gap) return gap.refusal();
  if (gap->depth > 0) return false;
  depth = std::move(gap->value);
  depth.value = -depth.value;
  return true;
}

TriedAnswer CsgSide::contained_in_union(const RealVector& p) const {
  const TriedAmong& made = among();
  if (!made) return made.refusal();
  const std::shared_ptr<const Among>& all = *made;
  if (!all) return std::nullopt;
  if (point_) {
    // What A leaves says how deep a point lies in A; else it is as far from A.
    if (a_->walls) return left_walls();
    TriedAnswer apart = this->apart(p);
    if (!apart || away(**apart)) return apart;
  }
  Answer out;
  const Tried<bool> in = in_union(*all, p, out);
  if (!in) return in.refusal();
  if (*in) return std::optional(std::move(out));
  const Tried<PositionSet> fits = all->fits();
  if (!fits) return fits.refusal();
  return fits->nearest(p, false);
}

TriedAnswer CsgSide::farthest_in_union(const RealVector& p) const {
  const TriedAmong& made = among();
  if (!made) return made.refusal();
  const std::shared_ptr<const Among>& all = *made;
  if (!all) return std::nullopt;
  const Tried<PositionSet> fits = all->fits();
  if (!fits) return fits.refusal();
  TriedAnswer v = fits->farthest(p);
  if (v && *v) (*v)->nearest.reset();
  return v;
}

/// eta1 less the level; for levels up to 0 the slack of what protrudes takes the place of how far that is from none.
TriedBetween CsgSide::nearly_in_union(const RealVector& p, double level) const {
  const TriedAmong& made = among();
  if (!made) return made.refusal();
  const std::shared_ptr<const Among>& all = *made;
  if (!all) return std::nullopt;
  const double error = margin::kFoundError * size_, least = space::rounded(all->places).distance(space::rounded(p));
  if (level <= 0 && least > 0) return Between{least - error - level, exact::kInfinity};
  if (least - error > level) return Between{least - error - level, exact::kInfinity};
  if (inside(p, all->places)) {
    const Tried<double> slack = all->left->common_depth(p, margin::kDepthOnLines);
    if (!slack) return slack.refusal();
    if (!(*slack > 0)) {
      const Between gap = all->left->nearly_apart(p, -level);  // the gap, plus the level
      return Between{-gap.high, -gap.low};
    }
    if (level <= 0) return Between{*slack - level, exact::kInfinity};
  }
  const Until until{level, 0.5};
  const Tried<PositionSet> fits = all->fits();
  if (!fits) return fits.refusal();
  const BoundaryPlace found = fits->nearest_to(distance_to_point(space::rounded(p)), {0, {}, &until});
  if (!found.found && !found.unresolved && found.complete && found.bound == exact::kInfinity) return std::nullopt;
  return Between{found.bound - error - level, found.value + error - level};
}

}  // namespace findspace::distance
