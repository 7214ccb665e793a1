// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The distances of CsgSide between places: the nearest and the farthest of B and A, those of A farthest from each
// other, and how far B protrudes from A.

#include <findspace/error.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "distance/answer/answer.h"
#include "distance/csg/csg_pair.h"
#include "distance/search/least_in_box.h"
#include "distance/search/solid_protrusion.h"
#include "distance/solid/far_corners.h"
#include "exact/margins/protrusion.h"
#include "exact/margins/space_distance.h"
#include "plane/base/search_work.h"

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

/// A place, and how far it is from another.
struct FarPlace {
  double value = -exact::kInfinity;
  Vector place;
};

FarPlace far_place(const Vector& x, const Vector& place) { return {space::length(place - x), place}; }

/// The place of a sphere behind a plane that is farthest from x; the centre is `high` above the plane. Along the sphere
/// the distance from x falls with the angle.
std::optional<FarPlace> far_on_cap(const NearSet::Ball& ball, const Vector& unit, double high, const Vector& x) {
  const Vector off = ball.center - x;
  const double far = space::length(off);
  const Vector way = far > 0 ? space::scaled(1 / far, off) : space::scaled(-1, unit);
  if (high + ball.radius * space::dot(unit, way) <= 0)
    return far_place(x, space::plus(ball.center, space::scaled(ball.radius, way)));
  const double square = ball.radius * ball.radius - high * high;
  if (!(square > 0)) return std::nullopt;
  Vector along = way;
  for (int times = 0; times < 2; ++times) {  // near the axis the first time leaves rounding
    along = along - space::scaled(space::dot(along, unit), unit);
    // no sign: on the axis any place of the circle is as far
    if (space::length(along) == 0) along = distance::across(unit);
    along = space::scaled(1 / space::length(along), along);
  }
  return far_place(x, space::plus(ball.center, space::scaled(std::sqrt(square), along) - space::scaled(high, unit)));
}

/// Of what two balls have in common.
std::optional<FarPlace> far_in_both(const NearSet::Ball& a, const NearSet::Ball& b, const Vector& x) {
  const Vector way = b.center - a.center;
  const double d = space::length(way);
  if (!(d > 0)) return std::nullopt;
  const double ahead = (d * d + a.radius * a.radius - b.radius * b.radius) / (2 * d);  // of a's centre to the circle
  const auto of_a = far_on_cap(a, space::scaled(-1 / d, way), ahead, x),
             of_b = far_on_cap(b, space::scaled(1 / d, way), d - ahead, x);
  return !of_a || (of_b && of_a->value < of_b->value) ? of_b : of_a;
}

/// The farthest places of the sets that hold a part, and of what two of them have in common: nothing of the part is
/// farther than any of them.
std::vector<FarPlace> far_places(const space::CsgPart& part, const Vector& x) {
  std::vector<FarPlace> out;
  std::vector<NearSet::Ball> balls;
  const auto take = [&](const std::optional<FarPlace>& found) {
    if (found) out.push_back(*found);
  };
  for (const BodyPart& set : part.within) {
    FarPlace most;
    for (const space::Point& v : set.vertices()) {
      const FarPlace far = *far_on_cap({exact::approx(v), set.radius.to_double()}, {1, 0, 0}, -exact::kInfinity, x);
      if (far.value > most.value) most = far;
    }
    take(most);
    if (set.point()) balls.push_back(NearSet::ball(set));
  }
  for (const NearSet::Ball& ball : balls) {
    for (const NearSet::Ball& other : balls) {
      if (&other < &ball) take(far_in_both(ball, other, x));
    }
    for (const BodyPart& set : part.within) {
      if (set.point() || set.radius.sign() > 0) continue;
      for (const space::HalfSpace& h : set.planes()) take(far_on_cap(ball, h.unit, h.approx_value(ball.center), x));
    }
  }
  return out;
}

/// Without a search where one of these belongs to the part.
BoundaryPlace farthest_of_part(const CsgPartSearch& part, const Vector& x, double size) {
  const std::vector<FarPlace> places = far_places(*part.sets, x);
  double least = exact::kInfinity;
  for (const FarPlace& far : places) least = std::min(least, far.value);
  const double noise = margin::kPlaceNoise * size;
  for (const FarPlace& far : places) {
    if (far.value > least + noise || part.places.beyond(far.place) > noise) continue;
    BoundaryPlace out;
    out.found = true;
    out.value = far.value;
    out.bound = least + noise;
    out.place = far.place;
    return out;
  }
  const ConvexDistance from = [x](const Vector& y) { return space::length(y - x); };
  return part.places.farthest_from(from, {}, {least + noise});
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
  return plane::search_spent("whether a shape overlaps one that round ones are cut out of was not found");
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
        const BoundaryPlace found = farthest_of_part(part, near, size_);
        bound.add(found, radius);
        if (!found.found || (best && found.value + radius <= best->value.to_double())) continue;
        best = named_reach(*part.sets, at, found);
        RealVector& from = best->witness[0].at;
        if (s.radius.sign() > 0 && best->value.sign() > 0)
          from = space::along(from, -(s.radius / best->value), space::minus(best->witness[1].at, from));
        best->value += s.radius;
      }
    }
  }
  return bound.best(std::move(best));
}

/// At a corner of a set of the part, or on its sphere, where that belongs to the part: exactly.
Answer CsgSide::named_reach(const space::CsgPart& part, const RealVector& from, const BoundaryPlace& found) const {
  Answer out = searched_answer(found, size_);
  out.witness = point_pair(from, space::real(found.place));
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
      v_exact.witness = point_pair(from, place);
      return v_exact;
    }
  }
  return out;
}

namespace {

/// The place of all parts that is farthest from x.
BoundaryPlace farthest_place(const std::vector<CsgPartSearch>& parts, const Vector& x, double size) {
  BoundaryPlace out;
  out.value = out.bound = -exact::kInfinity;
  for (const CsgPartSearch& part : parts) {
    if (part.box().farthest(x) <= out.value) continue;
    const BoundaryPlace found = farthest_of_part(part, x, size);
    const double bound = std::max(out.bound, found.bound);
    if (found.found && found.value > out.value) out = found;
    out.bound = bound;
  }
  return out;
}

/// The ball about all parts is nowhere farther from its middle.
double ball_about(const std::vector<CsgPartSearch>& parts, const space::Bounds3& box, double size) {
  const auto value = [&](const RealVector& p) -> exact::Tried<Answer> {
    const BoundaryPlace far = farthest_place(parts, space::rounded(p), size);
    Answer v;
    v.value = Real::from_double(far.value);
    v.set_unproven();
    v.error = far.bound - far.value;
    v.witness = point_pair(p, space::real(far.place));
    return v;
  };
  const TriedAnswer ball = convex_least(value, space::rounded(box.low), space::rounded(box.high));
  if (!ball || !*ball) return exact::kInfinity;
  return farthest_place(parts, space::rounded((*ball)->at), size).bound;
}

constexpr int kTurns = 8;  // from the farthest place to that farthest from it

}  // namespace

/// Whether A holds the ends of the diameter of the sets that hold its parts; of a ball's own along one of the axes.
bool CsgSide::holds_ends(const Answer& widest, const Body& sets) const {
  const auto in = [&](const RealVector& x) {
    return std::any_of(parts_.begin(), parts_.end(), [&](const CsgPartSearch& part) { return holds(*part.sets, x); });
  };
  if (!widest.witness.empty()) return in(widest.witness[0].at) && in(widest.witness[1].at);
  for (const BodyPart& ball : sets.parts) {
    if (ball.radius + ball.radius != widest.value) continue;
    const RealVector center = space::real(ball.center);
    for (std::size_t k = 0; k < 3; ++k) {
      RealVector by;
      by[k] = ball.radius;
      if (in(space::plus(center, by)) && in(space::minus(center, by))) return true;
    }
  }
  return false;
}

/// For each part of A the smallest of the sets that hold it.
Body CsgSide::holding_sets() const {
  Body out;
  for (const CsgPartSearch& part : parts_) {
    const std::vector<BodyPart>& within = part.sets->within;
    out.parts.push_back(*std::min_element(within.begin(), within.end(), [](const BodyPart& s, const BodyPart& t) {
      return distance::diameter(space::body_of_part(s)) < distance::diameter(space::body_of_part(t));
    }));
  }
  return out;
}

/// Else between places that are far from each other and the least of what holds A; where these differ, the search for
/// the place of A that is farthest from another tells.
TriedAnswer CsgSide::made_diameter() const {
  const plane::ScopedSearchWork of_all(nullptr);  // kept: not of the question that comes first
  const auto all = std::make_shared<const Body>(holding_sets());
  const TriedAnswer widest = SolidSide(all, all).reach({});
  if (holds_ends(**widest, *all)) return exact_answer<RealVector>((*widest)->value, Way::kParts);
  const space::Bounds3 box = bounds(*a_);
  const double error = margin::kFoundError * size_;
  const double ceiling = std::min((*widest)->value.to_double(), 2 * ball_about(parts_, box, size_)) + error;
  Vector from = farthest_place(parts_, space::rounded(box).middle(), size_).place;
  double most = 0;
  for (int turn = 0; turn < kTurns; ++turn) {
    const BoundaryPlace next = farthest_place(parts_, from, size_);
    if (!(next.value > most)) break;
    most = next.value;
    from = next.place;
  }
  std::map<std::array<double, 3>, double> known;
  const ConvexDistance far = [&](const Vector& x) {
    const auto [at, added] = known.try_emplace({x.x, x.y, x.z});
    if (added) at->second = farthest_place(parts_, x, size_).bound;
    return at->second;
  };
  double bound = most;
  for (const CsgPartSearch& part : parts_) {
    const BoundaryPlace found =
        part.places.farthest_from(far, [&] { return std::optional(-most); }, {ceiling, margin::kProtrudesTo});
    bound = std::max(bound, found.bound);
    if (found.found) most = std::max(most, farthest_place(parts_, found.place, size_).value);
  }
  return unproven_answer(Real::from_double(most),
                         {Real::from_double(most - error), Real::from_double(std::min(bound, ceiling) + error)});
}

TriedAnswer CsgSide::diameter(const RealVector& p) const {
  TriedAnswer most = reach(p);
  if (!most) return most;
  const TriedAnswer& own = own_diameter();
  if (!own) return own;
  return greatest(greatest(**std::move(most), **own), exact_answer<RealVector>(distance::diameter(*b_), Way::kParts));
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
