// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/search/position_set.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "distance/search/solid_protrusion.h"
#include "exact/margins/space_distance.h"
#include "plane/base/search_work.h"

namespace findspace::distance {

using exact::Real;
using space::HalfSpace;
using space::RealVector;
using space::Vector;

/// The nearest complete number, or a simple part, where it is as near as the place is known.
Real simple(double c, double blur) {
  for (const int parts : {1, 2, 3, 4, 5, 6, 8}) {
    const Real rounded = Real(exact::round(Real::from_double(c) * Real(parts))) / Real(parts);
    if (std::fabs(rounded.to_double() - c) <= blur) return rounded;  // no sign: the place is tested
  }
  return Real::from_double(c);
}

namespace {

/// Polyhedra that hold the sets, with faces along theirs; of balls there is none.
std::shared_ptr<const space::OpenUnion> sharp_cover(const std::vector<GrownSet>& sets) {
  auto out = std::make_shared<space::OpenUnion>();
  for (const GrownSet& set : sets) {
    if (set.planes.empty()) continue;
    out->add(space::everywhere(), [planes = set.planes, radius = set.radius] {
      space::OpenUnion::Planes moved;
      for (const HalfSpace& h : planes)
        moved.emplace_back(h.normal, h.offset - radius * sqrt(space::dot(h.normal, h.normal)));
      return moved;
    });
  }
  return out;
}

}  // namespace

Answer unproven_answer(double value, double error) {
  Answer out;
  out.value = Real::from_double(value);
  out.set_unproven();
  out.error = error;
  return out;
}

Answer unproven_answer(Real value, Enclosure ends) {
  Answer out;
  out.value = std::move(value);
  out.set_unproven();
  out.error = ends.width();
  out.enclosed = std::move(ends);
  return out;
}

Answer searched_answer(const BoundaryPlace& found, double size) {
  return unproven_answer(found.value, margin::kFoundError * size + std::fabs(found.value - found.bound));
}

Answer searched_place(const BoundaryPlace& found, const RealVector& p, double slack) {
  Answer out = signed_value(p, space::real(found.place), 1);
  out.set_unproven();
  out.error = slack;
  return out;
}

Answer ended_before(const BoundaryPlace& found, double slack, std::span<const Answer> places, bool farthest) {
  const Real bound = Real::from_double(std::max(0.0, found.bound + (farthest ? slack : -slack)));
  const auto worse = [farthest](const Answer& a, const Answer& b) {
    return farthest ? a.value < b.value : b.value < a.value;
  };
  const auto best = std::max_element(places.begin(), places.end(), worse);
  Answer out = best == places.end() ? Answer{} : *best;
  if (best == places.end()) {
    if (!farthest) out.value = bound;
    out.enclosed = Enclosure{out.value, std::nullopt};
    out.error = exact::kInfinity;
  } else {
    const Enclosure taken = out.bounds();
    out.enclosed = farthest ? Enclosure{taken.lower, std::max(*taken.lower, bound)}
                            : Enclosure{std::min(*taken.upper, bound), taken.upper};
    out.error = out.enclosed->width();
  }
  out.set_unproven();
  return out;
}

PositionSet::PositionSet(const RealVector& low, const RealVector& high)
    : low_(low), high_(high), box_{space::rounded(low), space::rounded(high)} {}

PositionSet PositionSet::outside(std::vector<GrownSet> sets, const RealVector& low, const RealVector& high) {
  PositionSet out(low, high);
  out.size_ = std::max(space::length(out.box_.low), space::length(out.box_.high)) + 1;
  for (const GrownSet& set : sets) out.constraints_.reverse_convex.push_back(grown_distance(set));
  out.sharp_ = sharp_cover(sets);
  out.sets_ = std::move(sets);
  out.holds_ = [sets = out.sets_, constraints = out.constraints_.reverse_convex,
                size = out.size_](const RealVector& p) {
    const Vector near = space::rounded(p);
    for (std::size_t k = 0; k < sets.size(); ++k) {
      if (constraints[k](near) > margin::kOutOfSet * size) continue;
      if (sets[k].holds(p)) return false;
    }
    return true;
  };
  return out;
}

PositionSet PositionSet::outside_of(const space::Body& body) {
  const space::Bounds3 box = bounds(body);
  std::vector<GrownSet> sets;
  for (const space::BodyPart& part : body.parts) sets.push_back(grown_set(part));
  return outside(std::move(sets), box.low, box.high);
}

PositionSet PositionSet::inside(const space::Body& b, const space::BodyPart& a, const RealVector& low,
                                const RealVector& high) {
  PositionSet out(low, high);
  out.size_ = std::max(space::length(out.box_.low), space::length(out.box_.high)) + 1;
  for (const space::BodyPart& part : b.parts) {
    const double tolerance = (a.radius - part.radius).to_double();
    for (const space::Point& v : part.vertices()) {
      out.size_ = std::max(out.size_, space::length(exact::approx(v)));
      const bool round = a.point() || tolerance > 0;  // else planes say how deep a place is, distances do not
      out.constraints_.convex.push_back(round ? touching_boundary(a, exact::approx(-v), tolerance)
                                              : highest_plane(a.planes(), exact::approx(-v), -tolerance));
    }
  }
  out.holds_ = [b, a](const RealVector& p) { return protrusion_of_convex(b, a, p).value.sign() <= 0; };
  return out;
}

PositionSet PositionSet::common(std::span<const PositionSet> sets, const RealVector& low, const RealVector& high) {
  PositionSet out(low, high);
  out.askew_ = true;
  std::vector<Holds> all;
  for (const PositionSet& one : sets) {
    out.size_ = std::max(out.size_, one.size_);
    out.constraints_.reverse_convex.insert(out.constraints_.reverse_convex.end(),
                                           one.constraints_.reverse_convex.begin(),
                                           one.constraints_.reverse_convex.end());
    out.constraints_.convex.insert(out.constraints_.convex.end(), one.constraints_.convex.begin(),
                                   one.constraints_.convex.end());
    out.sets_.insert(out.sets_.end(), one.sets_.begin(), one.sets_.end());
    all.push_back(one.holds_);
  }
  out.box_ = out.around_box(out.box_);
  out.holds_ = [all](const RealVector& p) {
    return std::all_of(all.begin(), all.end(), [&](const Holds& holds) { return holds(p); });
  };
  return out;
}

PositionSet PositionSet::of_constraints(Constraints constraints, const Box& box, double size, Holds holds) {
  PositionSet out(space::real(box.low), space::real(box.high));
  out.constraints_ = std::move(constraints);
  out.askew_ = true;
  out.size_ = size;
  out.holds_ = std::move(holds);
  return out;
}

PositionSet PositionSet::lazily(MakeLazy lazy, const Box& box, double size, double slack) {
  PositionSet out = of_constraints({}, box, size, {});
  out.lazy_ = std::move(lazy);
  out.slack_ = slack;
  return out;
}

PositionSet PositionSet::within(const Box& box) const {
  PositionSet out = *this;
  out.low_ = space::real(box.low);
  out.high_ = space::real(box.high);
  out.box_ = box;
  return out;
}

PositionSet PositionSet::also_in(TouchingConstraint set) const {
  PositionSet out = *this;
  out.constraints_.convex.push_back(std::move(set));
  return out;
}

std::vector<Tetrahedron> PositionSet::cells(const Box& box) const {
  return tetrahedra_of_box(askew_ ? askew(box) : around_box(box));
}

PositionSet::Box PositionSet::around_box(const Box& box) const { return grown(box, margin::kAroundBox * size_); }

/// A cube about p, which is in the box, that reaches out of it.
PositionSet::Box PositionSet::around(const Vector& p) const {
  double out = exact::kInfinity;
  for (const double d :
       {p.x - box_.low.x, box_.high.x - p.x, p.y - box_.low.y, box_.high.y - p.y, p.z - box_.low.z, box_.high.z - p.z})
    out = std::min(out, d);
  return grown({p, p}, std::max(0.0, out) + margin::kAroundCube * size_);
}

BoundaryPlace PositionSet::nearest_to(const TouchingConstraint& to, const Query& query) const {
  const std::vector<Tetrahedron> domain = cells(query.box.value_or(box_));
  if (!lazy_) return nearest_allowed(domain, constraints_, to, size_, query.floor, query.known, query.until);
  const std::unique_ptr<LazyConstraints> lazy = lazy_();
  return nearest_allowed(domain, lazy->constraints(), to, size_, query.floor, query.known, query.until);
}

BoundaryPlace PositionSet::farthest_from(std::span<const ConvexDistance> from, const Incumbent& known,
                                         const FarEnd& end) const {
  if (!lazy_) return farthest_allowed(cells(box_), constraints_, from, size_, known, end);
  const std::unique_ptr<LazyConstraints> lazy = lazy_();
  return farthest_allowed(cells(box_), lazy->constraints(), from, size_, known, end);
}

/// A place of zero clearance that belongs all the same, with simple coordinates. Where boundaries touch the place that
/// is found is as near as the square root of what they are known to.
std::optional<RealVector> PositionSet::even_place(const BoundaryPlace& found) const {
  if (!found.unresolved || !holds_) return std::nullopt;
  for (const double share : {margin::kEvenPlace, std::sqrt(margin::kEvenPlace)}) {
    const double blur = share * size_;
    const RealVector p{simple(found.unresolved->x, blur), simple(found.unresolved->y, blur),
                       simple(found.unresolved->z, blur)};
    if (holds_(p)) return p;
  }
  return std::nullopt;
}

namespace {

Answer at_place(const RealVector& place, const RealVector& p) {
  const RealVector w = space::minus(place, p);
  Answer out;
  out.value = sqrt(space::dot(w, w));
  out.nearest = place;
  return out;
}

}  // namespace

/// Of the sets with sharp edges, if it belongs.
PositionSet::Known PositionSet::sharp_place(std::function<exact::Tried<std::optional<RealVector>>()> find,
                                            const RealVector& p) const {
  return [this, find = std::move(find), p]() -> std::optional<Answer> {
    const auto found = find();
    if (!found || !*found || !holds(**found)) return std::nullopt;
    return at_place(**found, p);
  };
}

/// The nearest place beyond the box.
Answer PositionSet::beyond_box(const RealVector& p) const {
  const Real more = Real::from_double(margin::kAroundCube * size_);
  std::optional<Answer> best;
  for (std::size_t k = 0; k < 3; ++k) {
    for (const Real& wall : {low_[k] - more, high_[k] + more}) {
      RealVector out = p;
      out[k] = wall;
      Answer v = at_place(out, p);
      if (!best || v.value < best->value) best = std::move(v);
    }
  }
  return *std::move(best);
}

/// `beyond`: a place that is known beyond what was searched.
TriedAnswer PositionSet::settled(const BoundaryPlace& found, const RealVector& p, const std::optional<Answer>& known,
                                 const std::optional<Answer>& beyond, bool farthest) const {
  const double slack = slack_ * (size_ + std::fabs(found.bound)), off = std::fabs(found.value - found.bound);
  const RealVector place = space::real(found.place);
  const bool belongs = found.found && holds(place);
  if (off <= margin::kMostFoundError * size_ && (belongs || found.known)) {
    Answer out = unproven_answer(found.value, slack + off);
    const bool same =
        known && off <= margin::kSearchesAgree * slack && abs(known->value - out.value).to_double() <= out.error;
    if (same) {  // no sign: the same value
      out = *known;
      if (!out.proven) {
        out.error += off + slack;
        out.enclosed.reset();
      }
    }
    if (!out.nearest && (belongs || known)) out.nearest = belongs ? place : known->nearest;
    return out;
  }
  if (!found.found && !found.known && !found.unresolved && found.complete) return std::nullopt;
  std::vector<Answer> places;
  if (const auto exact = even_place(found)) {
    Answer out = at_place(*exact, p);
    if (std::fabs(out.value.to_double() - found.bound) <= margin::kSearchesAgree * slack)
      return out;  // no sign: nothing is better
    places.push_back(std::move(out));
  }
  if (belongs) places.push_back(searched_place(found, p, slack));
  for (const auto* place : {&known, &beyond}) {
    if (*place) places.push_back(**place);
  }
  return ended_before(found, slack, places, farthest);
}

double PositionSet::deepest_at(const Vector& p) const {
  double deepest = 0;
  for (std::size_t k = 0; k < sets_.size(); ++k) deepest = std::min(deepest, constraints_.reverse_convex[k](p));
  return deepest;
}

double PositionSet::beyond(const Vector& p) const {
  double most = -exact::kInfinity;
  for (const ConvexDistance& f : constraints_.reverse_convex) most = std::max(most, -f(p));
  for (const TouchingConstraint& f : constraints_.convex) most = std::max(most, f(p).value);
  return most;
}

TriedAnswer PositionSet::nearest(const RealVector& p, bool open, const Known& known, double floor) const {
  // The boundary of a set that holds p is not nearer to what all sets leave; where nothing else holds it, it is the
  // place.
  const Vector near = space::rounded(p);
  const double deepest = deepest_at(near);
  for (std::size_t k = 0; k < sets_.size(); ++k) {
    if (constraints_.reverse_convex[k](near) > deepest + margin::kDeepestSets * size_) continue;
    Answer v = sets_[k].to_boundary(p);
    if (!v.nearest || !holds(*v.nearest)) continue;
    v.value = -v.value;
    return v;
  }
  const Known ask = known    ? known
                    : sharp_ ? sharp_place([&] { return sharp_->nearest_in_complement(p).settled(); }, p)
                             : Known();
  std::optional<Answer> decided;
  Query query{std::max(-deepest, floor)};
  if (ask) {
    query.known = [&]() -> std::optional<double> {
      decided = ask();
      return decided ? std::optional(decided->value.to_double()) : std::nullopt;
    };
  }
  if (open) query.box = around(near);
  return settled(nearest_to(distance_to_point(near), query), p, decided,
                 open ? std::optional(beyond_box(p)) : std::nullopt, false);
}

Answer PositionSet::least(const TouchingConstraint& of) const {
  const BoundaryPlace found = nearest_to(of, {-exact::kInfinity});
  const double off = std::fabs(found.value - found.bound);
  const bool belongs = found.found && holds(space::real(found.place));
  if (belongs && off <= margin::kMostFoundError * size_) return searched_answer(found, size_);
  const double noise = margin::kFoundError * size_;
  double most = belongs ? found.value : exact::kInfinity;
  const Box around = grown(box_, margin::kAroundCube * size_);  // its corners belong
  for (const double x : {around.low.x, around.high.x}) {
    for (const double y : {around.low.y, around.high.y}) {
      for (const double z : {around.low.z, around.high.z}) most = std::min(most, of({x, y, z}).value);
    }
  }
  return unproven_answer(Real::from_double(most),
                         {Real::from_double(found.bound - noise), Real::from_double(most + noise)});
}

TriedAnswer PositionSet::farthest(const RealVector& p, const Known& known) const {
  const Known asked = known    ? known
                      : sharp_ ? sharp_place([&] { return space::farthest_in_complement(*sharp_, low_, high_, p); }, p)
                               : Known();
  std::optional<Answer> decided;
  Incumbent ask;
  if (asked) {
    ask = [&]() -> std::optional<double> {
      decided = asked();
      return decided ? std::optional(-decided->value.to_double()) : std::nullopt;
    };
  }
  const BoundaryPlace found = farthest_from(space::rounded(p), ask);
  // Where many places are nearly as far the search ends before: the value lies between what it found and the bound.
  const bool early = !lazy_ && found.found && !found.complete && !found.unresolved && holds(space::real(found.place));
  TriedAnswer v = early ? TriedAnswer(searched_answer(found, size_)) : settled(found, p, decided, std::nullopt, true);
  if (early) (*v)->nearest = space::real(found.place);
  if (v && *v) (*v)->farthest = std::exchange((*v)->nearest, std::nullopt);
  return v;
}

}  // namespace findspace::distance
