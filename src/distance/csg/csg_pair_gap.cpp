// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The distances of CsgSide between places: the nearest and the farthest of B and A, and how far B protrudes from A.

#include <findspace/error.h>

#include <algorithm>
#include <cmath>

#include "distance/answer/answer.h"
#include "distance/csg/csg_pair.h"
#include "distance/search/solid_protrusion.h"
#include "exact/margins/protrusion.h"
#include "exact/margins/space_distance.h"

namespace findspace::distance {

using exact::Real;
using space::Body;
using space::BodyPart;
using space::RealVector;
using space::Vector;

namespace {

space::Extent box_of(const BodyPart& part, const Vector& p) {
  return moved(space::rounded(bounds(space::body_of_part(part))), p);
}

/// Nothing of the part is farther, as all of it is in each of these.
double farthest_in_balls(const space::CsgPart& part, const Vector& from) {
  double least = exact::kInfinity;
  for (const BodyPart& set : part.within) {
    if (set.point()) least = std::min(least, space::length(exact::approx(set.center) - from) + set.radius.to_double());
  }
  return least;
}

}  // namespace

/// Not negative: 0 where they meet.
TriedAnswer CsgSide::apart(const RealVector& p) const {
  std::optional<Answer> best;
  BoundOfParts bound(1, size_);
  const Vector by = space::rounded(p);
  for (const BodyPart& s : b_->parts) {
    const space::Extent box = box_of(s, by);
    for (const CsgPartSearch& part : parts_) {
      if (best && space::distance(box, part.box()) > best->value.to_double()) continue;
      const TouchingConstraint to = gap_to(s, by);
      const BoundaryPlace found = part.places.nearest_to(to, {depth_in_cuts(s, *part.sets, p, size_)});
      bound.add(found);
      if (!found.found) continue;
      Answer v = searched_answer(found, size_);
      const double near = found.value, error = v.error;
      if (near < error) v.value = Real();
      const Touching at = to(found.place);
      v.witness = point_pair(space::real(found.place - space::scaled(at.value, at.slope)), space::real(found.place));
      if (near > error) v.nearest = space::plus(p, space::minus(v.witness[1].at, v.witness[0].at));
      if (best && best->value.to_double() < near - error) continue;
      if (came_to_end(found, size_)) {
        for (Answer& named : named_gaps(*part.sets, s, p, found.place, size_)) {
          if (std::fabs(named.value.to_double() - near) <= error) v = std::move(named);  // no sign: the same value
        }
      }
      if (!best || v.value < best->value || (v.proven && !best->proven && !(best->value.to_double() < near - error)))
        best = std::move(v);
    }
  }
  return bound.best(std::move(best));
}

/// What the gap less the level is between; where B + p is not surely nearer than the level, or farther.
Between CsgSide::nearly_apart(const RealVector& p, double level) const {
  Between out{exact::kInfinity, exact::kInfinity};
  const Vector by = space::rounded(p);
  const Until until{level, margin::kRoughShare};
  for (const BodyPart& s : b_->parts) {
    const space::Extent box = box_of(s, by);
    const TouchingConstraint to = gap_to(s, by);
    for (const CsgPartSearch& part : parts_) {
      const double least = space::distance(box, part.box());
      if (least > out.low) continue;
      if (least - level > margin::kFarByBoxes * size_) {
        out.low = least;
        continue;
      }
      const BoundaryPlace found = part.places.nearest_to(to, {0, {}, &until});
      out.low = std::min(out.low, found.bound);
      out.high = std::min(out.high, found.value);
    }
  }
  const double error = margin::kFoundError * size_;
  return {out.low - error - level, out.high + error - level};
}

exact::Tried<double> CsgSide::common_depth(const RealVector& p, double enough) const {
  const Vector by = space::rounded(p);
  double most = 0;
  bool decided = true;
  for (const BodyPart& s : b_->parts) {
    const space::Extent box = box_of(s, by);
    for (const CsgPartSearch& part : parts_) {
      if (space::distance(box, part.box()) > 0) continue;
      const Slack common = part.places.also_in(convex_constraint(s, by)).deepest({enough * size_});
      most = std::max(most, common.value);
      const bool none = common.value > enough * size_ || common.bound <= enough * size_;
      decided = decided && (none || in_a_cut(s, *part.sets, p));
    }
  }
  if (most > enough * size_) return most;
  if (decided) return 0.0;
  return exact::Refusal(
      "whether a shape overlaps one that round ones are cut out of was not found within the limit of the search");
}

/// Surely.
bool CsgSide::away(const Answer& apart) const {
  return apart.value.to_double() > apart.error + margin::kFoundError * size_;
}

exact::Tried<CsgSide::Gap> CsgSide::gap_at(const RealVector& p) const {
  Gap out;
  TriedAnswer apart = this->apart(p);
  if (!apart) return apart.refusal();
  out.value = **std::move(apart);
  if (away(out.value) || point_) return out;
  if (points_) return no_depth();  // what a point has in common with A has no slack
  const exact::Tried<double> depth = common_depth(p, margin::kNoInterior);
  if (!depth) return depth.refusal();
  out.depth = *depth;
  if (out.depth > 0) out.value = Answer{};
  return out;
}

TriedAnswer CsgSide::reach(const RealVector& p) const {
  if (a_->walls) return left_walls();
  std::optional<Answer> best;
  BoundOfParts bound(-1, size_);
  for (const BodyPart& s : b_->parts) {
    for (const space::Point& v : s.vertices()) {
      const RealVector at = space::plus(space::real(v), p);
      const Vector near = space::rounded(at);
      const double radius = s.radius.to_double();
      for (const CsgPartSearch& part : parts_) {
        if (best && part.box().farthest(near) + radius < best->value.to_double()) continue;
        BoundaryPlace found = part.places.farthest_from(near);
        found.bound = std::min(found.bound, farthest_in_balls(*part.sets, near) + margin::kPlaceNoise * size_);
        bound.add(found, radius);
        if (!found.found || (best && found.value + radius <= best->value.to_double())) continue;
        best = named_reach(*part.sets, at, found);
        best->value += s.radius;
      }
    }
  }
  return bound.best(std::move(best));
}

/// At a corner of a set of the part, or on its sphere, where that belongs to the part: exactly.
Answer CsgSide::named_reach(const space::CsgPart& part, const RealVector& from, const BoundaryPlace& found) const {
  Answer out = searched_answer(found, size_);
  const bool ended = came_to_end(found, size_);
  for (const BodyPart& set : part.within) {
    if (!ended && !set.point()) continue;  // nothing of the part is farther than its sphere, whatever was searched
    for (const space::Point& v : set.vertices()) {
      RealVector way = space::minus(space::real(v), from);
      const Real d = sqrt(space::dot(way, way)), value = d + set.radius;
      // From the centre all of a sphere is as far.
      if (d.sign() == 0) way = space::minus(space::real(found.place), from);
      if (space::is_zero(way)) continue;
      const Real size = d.sign() == 0 ? sqrt(space::dot(way, way)) : d;
      const RealVector place = space::along(space::real(v), set.radius / size, way);
      if (std::fabs(value.to_double() - found.value) > out.error || !holds(part, place)) continue;  // no sign
      Answer v_exact;
      v_exact.value = value;
      return v_exact;
    }
  }
  return out;
}

std::vector<NearSet> CsgSide::near_sets() const {
  std::vector<NearSet> out;
  for (const CsgPartSearch& part : parts_) out.push_back(part.near_set());
  return out;
}

/// At a corner of B, and to a place that square roots name, exactly: where no other place is farther out by more than
/// rounding.
TriedAnswer CsgSide::protrusion_out(const RealVector& p) const {
  const Solids solids = solids_of(*b_, p);
  const std::vector<NearSet> sets = near_sets();
  const std::vector<space::Point> corners = sharp_corners(*b_);
  const auto corner = [&](const SolidMaxMin& found) {
    return found.complete ? corner_at(corners, p, found.place, size_) : std::nullopt;
  };
  exact::Tried<SetProtrusion> out = set_protrusion(solids, sets, size_, margin::kProtrudesTo * size_);
  if (out && corner(out->found)) {
    const SolidMaxMin rough = out->found;
    out = set_protrusion(solids, sets, size_, margin::kFoundError * size_, &rough);
  }
  if (!out) return out.refusal();
  Answer v = out->answer(size_);
  const auto at = corner(out->found);
  if (!at) return std::optional(std::move(v));
  for (Answer& named : named_gaps(*parts_[out->set].sets, BodyPart{}, *at, out->nearest, size_)) {
    if (std::fabs((named.value - v.value).to_double()) > v.error) continue;  // no sign: the same value
    named.nearest.reset();
    return std::optional(std::move(named));
  }
  return std::optional(std::move(v));
}

TriedBetween CsgSide::nearly_protrudes(const RealVector& p, double level) const {
  const Solids solids = solids_of(*b_, p);
  const std::vector<NearSet> sets = near_sets();
  const double error = margin::kFoundError * size_;
  for (double near = size_ / 16;; near /= 8) {
    const exact::Tried<SetProtrusion> searched = set_protrusion(solids, sets, size_, near);
    if (!searched) return searched.refusal();
    const SolidMaxMin& found = searched->found;
    const Between out{std::max(0.0, found.value) - error - level, found.bound + error - level};
    const double decided = std::max(out.low, -out.high);
    if ((decided > 0 && out.high - out.low <= decided) || (found.complete && near < margin::kMostFoundError * size_))
      return std::optional(out);
    if (!found.complete) {
      if (decided > 0) return std::optional(out);
      return not_protruding();
    }
  }
}

}  // namespace findspace::distance
