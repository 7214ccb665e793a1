// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// SolidSide: numbers between which its distances lie, for searches that ask at many positions. The signed distance f
// of a position to each difference of two convex parts is convex and quickly known:
//   gamma1   the least f; where that is below 0 no more than it, and equal only of a single pair;
//   eta1     that to E of a ball in a ball, and in one polytope; else the greatest -f over the cover of what is outside
//            E, beyond E no less than it;
//   mu       in a convex A: the greatest signed distance of a vertex of B. Where B fits, eta1 is mu; else no less;
//   gamma2   the farthest vertex.
// Guarantee: the true value is in the interval, which is wider than rounding by margin::kNumbersOff. Cost: some hundred
// nanoseconds for each pair.

#include <algorithm>
#include <optional>

#include "distance/search/grown_set.h"
#include "distance/solid/solid_pair.h"
#include "exact/margins/space_distance.h"
#include "plane/base/search_work.h"
#include "space/body/body_boxes.h"

namespace findspace::distance {

using space::Body;
using space::BodyPart;
using space::real;
using space::Vector;

namespace {

std::size_t count_vertices(const Body& body) {
  std::size_t count = 0;
  for (const BodyPart& part : body.parts) count += part.vertices().size();
  return count;
}

double farthest_out(const Body& body) {
  double size = 0;
  for (const BodyPart& part : body.parts) {
    for (const space::Point& v : part.vertices())
      size = std::max(size, space::size_of(exact::approx(v)) + part.radius.to_double());
  }
  return size;
}

template <class Functions>
double least_of(const Functions& functions, const Vector& x) {
  double least = exact::kInfinity;
  for (const ConvexDistance& f : functions) least = std::min(least, f(x));
  return least;
}

}  // namespace

SolidSide::SolidSide(std::shared_ptr<const Body> b, std::shared_ptr<const Body> a)
    : b_(std::move(b)), a_(std::move(a)) {
  near_.size = farthest_out(*b_) + farthest_out(*a_);
}

exact::Interval SolidSide::about(double value, const Vector& p) const {
  const double off = margin::kNumbersOff * (near_.size + space::size_of(p));
  return {value - off, value + off};
}

exact::Interval SolidSide::gap_within(const Vector& p) const {
  const Distances& all = near_.gap.of([&] {
    Distances made;
    if (a_->parts.size() * b_->parts.size() > kMostNear) return made;
    for (const GrownSet& set : differences_of_parts(*a_, *b_)) made.push_back(grown_distance(set));
    return made;
  });
  if (all.empty()) return exact::whole_line();
  exact::Interval out = about(least_of(all, p), p);
  if (all.size() > 1 && !(out.lo > 0)) out.lo = -exact::kInfinity;
  return out;
}

exact::Interval SolidSide::reach_within(const Vector& p) const {
  if (count_vertices(*a_) * count_vertices(*b_) > kMostNear * kMostNear) return exact::whole_line();
  double most = 0;
  for (const BodyPart& t : a_->parts) {
    for (const BodyPart& s : b_->parts) {
      const double radius = t.radius.to_double() + s.radius.to_double();
      for (const space::Point& v : t.vertices()) {
        for (const space::Point& w : s.vertices())
          most = std::max(most, space::length(exact::approx(v) - exact::approx(w) - p) + radius);
      }
    }
  }
  return about(most, p);
}

exact::Interval SolidSide::protrusion_within(const Vector& p) const {
  if (!a_->convex()) return exact::whole_line();
  const Distances& all = near_.protrusion.of([&] {
    Distances made;
    if (count_vertices(*b_) > kMostNear) return made;
    const BodyPart& part = a_->parts[0];
    for (const BodyPart& s : b_->parts) {
      const ConvexDistance f = grown_distance({part.planes(), real(part.center), part.radius - s.radius});
      for (const space::Point& v : s.vertices())
        made.push_back([f, at = exact::approx(v)](const Vector& x) { return f(space::plus(x, at)); });
    }
    return made;
  });
  if (all.empty()) return exact::whole_line();
  double most = -exact::kInfinity;
  for (const ConvexDistance& f : all) most = std::max(most, f(p));
  return about(most, p);
}

namespace {

/// The signed distance to the polytope of positions at which B lies in A, which is one; nothing where there are none.
std::optional<ConvexDistance> fit_of_polytopes(const Body& b, const Body& a, const space::OpenUnion& outside) {
  const plane::ScopedSearchWork of_no_question(nullptr);  // kept: not of the one that comes first
  if (!outside.nearest_in_complement({}).settled().or_throw()) return std::nullopt;
  GrownSet fits;
  for (const space::HalfSpace& h : a.parts[0].planes())
    fits.planes.emplace_back(h.normal, h.offset + space::support(b, h.normal));
  return grown_distance(fits);
}

}  // namespace

exact::Interval SolidSide::fit_within(const Vector& p) const {
  const NearFit& fit = near_.fit.of([&] { return made_near_fit(); });
  if (fit.known) return fit.all.empty() ? exact::Interval{exact::kInfinity, exact::kInfinity} : about(fit.all[0](p), p);
  exact::Interval out = a_->convex() ? protrusion_within(p) : exact::whole_line();
  if (!fit.all.empty()) out = about(-least_of(fit.all, p), p);
  if (!(out.hi < 0)) out.hi = exact::kInfinity;
  return out;
}

/// Of a ball in a ball, and in one polytope, the distance itself.
SolidSide::NearFit SolidSide::made_near_fit() const {
  NearFit out;
  const BodyPart &s = b_->parts[0], &t = a_->parts[0];
  if (a_->convex() && t.point()) {
    out.known = b_->convex() && s.point();
    if (out.known && t.radius >= s.radius)
      out.all.push_back(grown_distance({{}, real(t.center - s.center), t.radius - s.radius}));
    return out;
  }
  if (a_->round()) return out;
  const std::vector<Fit::Group>& groups = positions().groups;
  std::size_t count = 0;
  for (const Fit::Group& group : groups) count += group.cover.size();
  if (count > kMostNear) return out;
  if (a_->convex() && t.core && groups.size() == 1 && groups[0].radius.sign() == 0) {
    out.known = true;
    if (auto f = fit_of_polytopes(*b_, *a_, groups[0].cover)) out.all.push_back(*std::move(f));
    return out;
  }
  for (const Fit::Group& group : groups) {
    for (std::size_t k = 0; k < group.cover.size(); ++k)
      out.all.push_back(grown_distance({group.cover.planes(k), {}, group.radius}));
  }
  return out;
}

}  // namespace findspace::distance
