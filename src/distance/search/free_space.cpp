// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/search/free_space.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "distance/search/convex_distance.h"
#include "distance/search/solid_protrusion.h"
#include "exact/margins/space_distance.h"

namespace findspace::distance {

using exact::Real;
using space::HalfSpace;
using space::RealVector;
using space::Vector;

namespace {

/// The nearest complete number, or a simple part, where it is as near as the place is known.
Real even(double c, double blur) {
  for (const int parts : {1, 2, 3, 4, 5, 6, 8}) {
    const Real rounded = Real(exact::round(Real::from_double(c) * Real(parts))) / Real(parts);
    if (std::fabs(rounded.to_double() - c) <= blur) return rounded;  // no sign: the place is tested
  }
  return Real::from_double(c);
}

double greatest_value(std::span<const HalfSpace> planes, const Vector& x) {
  double most = -exact::kInfinity;
  for (const HalfSpace& h : planes) most = std::max(most, h.approx_value(x));
  return most;
}

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

/// B's vertex v in A's planes moved inward by `by`.
TouchingRule eroded_rule(std::vector<HalfSpace> planes, const Vector& v, double by) {
  return [planes = std::move(planes), v, by](const Vector& x) {
    Touching best{-exact::kInfinity, {}};
    for (const HalfSpace& h : planes) {
      const double value = h.approx_value(space::plus(x, v)) + by;
      if (value > best.value) best = {value, h.unit};
    }
    return best;
  };
}

}  // namespace

ConvexDistance grown_distance(const GrownSet& set) {
  const double radius = set.radius.to_double();
  if (set.planes.empty())
    return
        [center = space::rounded(set.center), radius](const Vector& x) { return space::length(x - center) - radius; };
  return [planes = set.planes, distance = distance_to(set.planes), radius](const Vector& x) {
    const double most = greatest_value(planes, x);
    return (most < 0 ? most : distance(x)) - radius;
  };
}

TouchingRule touching_distance(const space::BodyPart& part, const Vector& p, double radius) {
  if (part.point()) {
    return [center = space::plus(exact::approx(part.center), p), radius](const Vector& x) {
      const Vector off = x - center;
      const double d = space::length(off);
      return Touching{d - radius, d > 0 ? space::scaled(1 / d, off) : Vector{}};
    };
  }
  return [way = way_to(part.planes()), p, radius](const Vector& x) {
    const Vector at = x - p, off = way(at);
    const double d = space::length(off);
    // So near the core the slope is rounding; 0 is one as well.
    if (d <= margin::kNoSlope * (space::size_of(at) + 1)) return Touching{-radius, {}};
    return Touching{d - radius, space::scaled(-1 / d, off)};
  };
}

bool GrownSet::holds(const RealVector& p) const {
  const Vector near = space::rounded(p);
  if (planes.empty()) {
    const RealVector off = space::minus(p, center);
    return space::dot(off, off) < radius * radius;
  }
  const bool inside =
      std::all_of(planes.begin(), planes.end(), [&](const HalfSpace& h) { return h.sign(p, near) < 0; });
  if (inside || radius.sign() == 0) return inside;
  const RealVector off = space::minus(p, *nearest_in(planes, p));
  return space::dot(off, off) < radius * radius;
}

Answer GrownSet::to_boundary(const RealVector& p) const {
  RealVector projection = center;
  bool inside = false;
  if (!planes.empty()) {
    space::OpenUnion core;
    core.add(space::everywhere(), planes);
    inside = core.covers(p);
    projection = *(inside ? core.nearest_in_complement(p) : nearest_in(planes, p));
  }
  const RealVector w = space::minus(p, projection);
  const Real d = sqrt(space::dot(w, w));
  Answer out;
  out.value = (inside ? -d : d) - radius;
  // The boundary lies a radius further out, on the line through p; at d = 0 the line is not known.
  if (out.value.sign() != 0 && d.sign() != 0)
    out.nearest = space::along(projection, (inside ? -radius : radius) / d, w);
  return out;
}

FreeSpace FreeSpace::outside(std::vector<GrownSet> sets, const RealVector& low, const RealVector& high) {
  FreeSpace out;
  out.low_ = low;
  out.high_ = high;
  out.box_low_ = space::rounded(low);
  out.box_high_ = space::rounded(high);
  out.size_ = std::max(space::length(out.box_low_), space::length(out.box_high_)) + 1;
  for (const GrownSet& set : sets) out.rules_.keep_out.push_back(grown_distance(set));
  out.sharp_ = sharp_cover(sets);
  out.sets_ = std::move(sets);
  out.allows_ = [sets = out.sets_, rules = out.rules_.keep_out, size = out.size_](const RealVector& p) {
    const Vector near = space::rounded(p);
    for (std::size_t k = 0; k < sets.size(); ++k) {
      if (rules[k](near) > margin::kOutOfSet * size) continue;
      if (sets[k].holds(p)) return false;
    }
    return true;
  };
  return out;
}

FreeSpace FreeSpace::inside(const space::Body& b, const space::BodyPart& a, const RealVector& low,
                            const RealVector& high) {
  FreeSpace out;
  out.low_ = low;
  out.high_ = high;
  out.box_low_ = space::rounded(low);
  out.box_high_ = space::rounded(high);
  out.size_ = std::max(space::length(out.box_low_), space::length(out.box_high_)) + 1;
  for (const space::BodyPart& part : b.parts) {
    const double tolerance = (a.radius - part.radius).to_double();
    for (const space::Point& v : part.vertices()) {
      out.size_ = std::max(out.size_, space::length(exact::approx(v)));
      const bool round = a.point() || tolerance > 0;  // else planes say how deep a place is, distances do not
      out.rules_.keep_in.push_back(round ? touching_distance(a, exact::approx(-v), tolerance)
                                         : eroded_rule(a.planes(), exact::approx(v), -tolerance));
    }
  }
  out.allows_ = [b, a](const RealVector& p) { return protrusion_of_convex(b, a, p).value.sign() <= 0; };
  return out;
}

FreeSpace FreeSpace::common(std::span<const FreeSpace> spaces, const RealVector& low, const RealVector& high) {
  FreeSpace out;
  out.low_ = low;
  out.high_ = high;
  std::tie(out.box_low_, out.box_high_) = askew(space::rounded(low), space::rounded(high));
  std::vector<std::function<bool(const RealVector&)>> all;
  for (const FreeSpace& one : spaces) {
    out.size_ = std::max(out.size_, one.size_);
    out.rules_.keep_out.insert(out.rules_.keep_out.end(), one.rules_.keep_out.begin(), one.rules_.keep_out.end());
    out.rules_.keep_in.insert(out.rules_.keep_in.end(), one.rules_.keep_in.begin(), one.rules_.keep_in.end());
    out.sets_.insert(out.sets_.end(), one.sets_.begin(), one.sets_.end());
    all.push_back(one.allows_);
  }
  out.allows_ = [all](const RealVector& p) {
    return std::all_of(all.begin(), all.end(), [&](const auto& allows) { return allows(p); });
  };
  return out;
}

/// A place of zero clearance that belongs all the same, with simple coordinates.
std::optional<RealVector> FreeSpace::even_place(const BoundaryPlace& found) const {
  if (!found.unresolved) return std::nullopt;
  const double blur = margin::kEvenPlace * size_;
  const RealVector p{even(found.unresolved->x, blur), even(found.unresolved->y, blur), even(found.unresolved->z, blur)};
  return allows_(p) ? std::optional(p) : std::nullopt;
}

/// Asks `find` for a place that belongs; the objective there is its distance to p, times the sense.
Incumbent FreeSpace::known_at(std::function<std::optional<RealVector>()> find, const RealVector& p, int sense,
                              std::optional<RealVector>& known) const {
  return [this, find = std::move(find), p, sense, &known]() -> std::optional<double> {
    const auto place = find();
    if (!place || !allows_(*place)) return std::nullopt;
    known = place;
    return sense * space::length(space::rounded(space::minus(*place, p)));
  };
}

TriedAnswer FreeSpace::settled(const BoundaryPlace& found, const RealVector& p,
                               const std::optional<RealVector>& known) const {
  Answer out;
  const double slack = margin::kFoundError * (size_ + std::fabs(found.bound)),
               off = std::fabs(found.value - found.bound);
  const RealVector place = space::real(found.place);
  if (found.found && off <= margin::kMostFoundError * size_ && allows_(place)) {
    out.value = Real::from_double(found.value);
    out.nearest = place;
    out.proven = false;
    out.error = slack + off;
    return out;
  }
  if (!found.found && !found.known && !found.unresolved && found.complete) return std::nullopt;
  for (const auto& exact : {found.known ? known : std::nullopt, even_place(found)}) {
    if (!exact) continue;
    const RealVector w = space::minus(*exact, p);
    const Real d = sqrt(space::dot(w, w));
    if (std::fabs(d.to_double() - found.bound) > 16 * slack) continue;  // no sign: something may be better
    out.value = d;
    out.nearest = *exact;
    return out;
  }
  if (found.found && !found.unresolved && allows_(place))
    return exact::Refusal("how far a round shape is from fitting was not found within the limit of the search");
  return exact::Refusal("whether a round shape fits with zero clearance is not decided");
}

double FreeSpace::deepest_at(const Vector& near) const {
  double deepest = 0;
  for (std::size_t k = 0; k < sets_.size(); ++k) deepest = std::min(deepest, rules_.keep_out[k](near));
  return deepest;
}

/// The search for the nearest place.
BoundaryPlace FreeSpace::searched(const Vector& near, bool open, const Incumbent& ask, const Until* until) const {
  const double tolerance = margin::kAroundBox * size_;
  Vector low = box_low_ - Vector{tolerance, tolerance, tolerance},
         high = space::plus(box_high_, {tolerance, tolerance, tolerance});
  if (open) {
    double known = exact::kInfinity;
    for (const double d :
         {near.x - low.x, high.x - near.x, near.y - low.y, high.y - near.y, near.z - low.z, high.z - near.z})
      known = std::min(known, d);
    const Vector by{known, known, known};
    low = near - by;
    high = space::plus(near, by);
  }
  const TouchingRule away = [near](const Vector& x) {
    const double d = space::length(x - near);
    return Touching{d, d > 0 ? space::scaled(1 / d, x - near) : Vector{}};
  };
  return nearest_allowed(tetrahedra_of_box(low, high), rules_, away, size_, -deepest_at(near), ask, until);
}

double FreeSpace::beyond(const Vector& p) const {
  double most = -exact::kInfinity;
  for (const ConvexDistance& f : rules_.keep_out) most = std::max(most, -f(p));
  for (const TouchingRule& f : rules_.keep_in) most = std::max(most, f(p).value);
  return most;
}

BoundaryPlace FreeSpace::nearly(const RealVector& p, const Until& until) const {
  return searched(space::rounded(p), false, {}, &until);
}

TriedAnswer FreeSpace::nearest(const RealVector& p, bool open) const {
  // The boundary of a set that holds p is not nearer to what all sets leave; where nothing else holds it, it is the
  // place.
  const Vector near = space::rounded(p);
  const double deepest = deepest_at(near);
  for (std::size_t k = 0; k < sets_.size(); ++k) {
    if (rules_.keep_out[k](near) > deepest + margin::kDeepestSets * size_) continue;
    Answer v = sets_[k].to_boundary(p);
    if (!v.nearest || !allows_(*v.nearest)) continue;
    v.value = -v.value;
    return v;
  }
  std::optional<RealVector> known;
  const Incumbent ask = known_at([&] { return sharp_ ? sharp_->nearest_in_complement(p) : std::nullopt; }, p, 1, known);
  return settled(searched(near, open, ask, nullptr), p, known);
}

exact::Tried<Answer> FreeSpace::nearest_to(const TouchingRule& to) const {
  const double tolerance = margin::kAroundBox * size_;
  const BoundaryPlace found =
      nearest_allowed(tetrahedra_of_box(box_low_ - Vector{tolerance, tolerance, tolerance},
                                        space::plus(box_high_, {tolerance, tolerance, tolerance})),
                      rules_, to, size_, -exact::kInfinity);
  const double off = std::fabs(found.value - found.bound);
  if (!found.found || off > margin::kMostFoundError * size_ || !allows_(space::real(found.place)))
    return exact::Refusal("the depth of the shape was not found within the limit of the search");
  Answer out;
  out.value = Real::from_double(found.value);
  out.proven = false;
  out.error = margin::kFoundError * size_ + off;
  return out;
}

TriedAnswer FreeSpace::farthest(const RealVector& p) const {
  const double tolerance = margin::kAroundBox * size_;
  std::optional<RealVector> known;
  const Incumbent ask = known_at(
      [&] { return sharp_ ? space::farthest_in_complement(*sharp_, low_, high_, p) : std::nullopt; }, p, -1, known);
  return settled(
      farthest_allowed(
          tetrahedra_of_box(box_low_ - Vector{tolerance, tolerance, tolerance},
                            space::plus(box_high_, {tolerance, tolerance, tolerance})),
          rules_, [from = space::rounded(p)](const Vector& x) { return space::length(x - from); }, size_, ask),
      p, known);
}

}  // namespace findspace::distance
