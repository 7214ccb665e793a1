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

}  // namespace

/// Not negative: 0 where they meet.
Answer CsgSide::apart(const RealVector& p) const {
  std::optional<Answer> best;
  const Vector by = space::rounded(p);
  for (const BodyPart& s : b_->parts) {
    const space::Extent box = box_of(s, by);
    for (const CsgPartSearch& part : parts_) {
      if (best && space::distance(box, part.box()) > best->value.to_double()) continue;
      const TouchingConstraint to = gap_to(s, by);
      const BoundaryPlace found = part.places.nearest_to(to, {});
      if (!found.found) continue;
      Answer v = searched_answer(found, size_);
      const double near = found.value, error = v.error;
      if (near < error) v.value = Real();
      const Touching at = to(found.place);
      v.witness = point_pair(space::real(found.place - space::scaled(at.value, at.slope)), space::real(found.place));
      if (near > error) v.nearest = space::plus(p, space::minus(v.witness[1].at, v.witness[0].at));
      if (best && best->value.to_double() < near - error) continue;
      for (Answer& named : named_gaps(*part.sets, s, p, found.place, size_)) {
        if (std::fabs(named.value.to_double() - near) <= error) v = std::move(named);  // no sign: the same value
      }
      if (!best || v.value < best->value || (v.proven && !best->proven && !(best->value.to_double() < near - error)))
        best = std::move(v);
    }
  }
  if (!best) throw Error(ErrorCode::kGeometry, "nothing with interior is left of the shape");
  return *std::move(best);
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

double CsgSide::common_depth(const RealVector& p, double enough) const {
  const Vector by = space::rounded(p);
  double most = 0;
  for (const BodyPart& s : b_->parts) {
    const space::Extent box = box_of(s, by);
    for (const CsgPartSearch& part : parts_) {
      if (space::distance(box, part.box()) > 0) continue;
      most = std::max(most, part.places.also_in(convex_constraint(s, by)).deepest({enough * size_}).value);
    }
  }
  return most > enough * size_ ? most : 0;
}

CsgSide::Gap CsgSide::gap_at(const RealVector& p) const {
  Gap out;
  out.value = apart(p);
  const double v = out.value.value.to_double();
  if (v > out.value.error + margin::kFoundError * size_) return out;
  out.depth = common_depth(p, margin::kNoInterior);
  if (out.depth > 0) out.value = Answer{};
  return out;
}

TriedAnswer CsgSide::reach(const RealVector& p) const {
  if (a_->walls) return left_walls();
  std::optional<Answer> best;
  for (const BodyPart& s : b_->parts) {
    for (const space::Point& v : s.vertices()) {
      const RealVector at = space::plus(space::real(v), p);
      const Vector near = space::rounded(at);
      const double radius = s.radius.to_double();
      for (const CsgPartSearch& part : parts_) {
        if (best && part.box().farthest(near) + radius < best->value.to_double()) continue;
        const BoundaryPlace found = part.places.farthest_from(near);
        if (!found.found || (best && found.value + radius <= best->value.to_double())) continue;
        best = named_reach(*part.sets, at, found);
        best->value += s.radius;
      }
    }
  }
  if (!best) throw Error(ErrorCode::kGeometry, "nothing with interior is left of the shape");
  return best;
}

/// At a corner of a set of the part, or on its sphere, where that belongs to the part: exactly.
Answer CsgSide::named_reach(const space::CsgPart& part, const RealVector& from, const BoundaryPlace& found) const {
  Answer out = searched_answer(found, size_);
  for (const BodyPart& set : part.within) {
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

/// At a corner of B, and to a place that square roots name, exactly.
Answer CsgSide::protrusion_out(const RealVector& p) const {
  const SetProtrusion out = set_protrusion(solids_of(*b_, p), near_sets(), size_, margin::kProtrudesTo * size_);
  Answer v = out.answer(size_);
  const auto at = corner_at(sharp_corners(*b_), p, out.found.place, size_);
  if (!at) return v;
  for (Answer& named : named_gaps(*parts_[out.set].sets, BodyPart{}, *at, out.nearest, size_)) {
    if (std::fabs((named.value - v.value).to_double()) > v.error) continue;  // no sign: the same value
    named.nearest.reset();
    return std::move(named);
  }
  return v;
}

TriedBetween CsgSide::nearly_protrudes(const RealVector& p, double level) const {
  const Solids solids = solids_of(*b_, p);
  const std::vector<NearSet> sets = near_sets();
  const double error = margin::kFoundError * size_;
  for (double near = size_ / 16;; near /= 8) {
    const SolidMaxMin found = set_protrusion(solids, sets, size_, near).found;
    const Between out{std::max(0.0, found.value) - error - level, found.bound + error - level};
    const double decided = std::max(out.low, -out.high);
    if ((decided > 0 && out.high - out.low <= decided) || (found.complete && near < margin::kMostFoundError * size_))
      return std::optional(out);
    if (!found.complete) {
      if (decided > 0) return std::optional(out);
      return exact::Refusal(
          "the protrusion from a shape that round ones are cut out of was not found within the limit of the search");
    }
  }
}

}  // namespace findspace::distance
