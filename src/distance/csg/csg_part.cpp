// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/csg/csg_part.h"

#include <findspace/error.h>

#include <algorithm>
#include <cmath>

#include "distance/search/solid_protrusion.h"
#include "exact/margins/space_distance.h"

namespace findspace::distance {

using space::Body;
using space::BodyPart;
using space::CsgPart;
using space::dot;
using space::HalfSpace;
using space::RealVector;
using space::Vector;

namespace {

double size_of(const Body& body) {
  if (body.parts.empty()) return 0;
  const space::Bounds3 box = bounds(body);
  return std::max(space::length(space::rounded(box.low)), space::length(space::rounded(box.high)));
}

bool flat_sided(const BodyPart& part) { return part.core && part.radius.sign() == 0; }

}  // namespace

double cut_size(const Body& b, const space::CsgSolid& a) {
  double size = 1 + size_of(b);
  const auto take = [&](const BodyPart& part) { size = std::max(size, 1 + size_of(space::body_of_part(part))); };
  for (const CsgPart& part : a.parts) {
    std::for_each(part.within.begin(), part.within.end(), take);
    std::for_each(part.without.begin(), part.without.end(), take);
  }
  return size;
}

TouchingConstraint convex_constraint(const BodyPart& set, const Vector& p) {
  return flat_sided(set) ? highest_plane(set.planes(), p) : touching_distance(set, p, set.radius.to_double());
}

TouchingConstraint gap_to(const BodyPart& set, const Vector& p) {
  TouchingConstraint away = touching_distance(set, p, set.radius.to_double());
  if (!flat_sided(set)) return away;
  return [inside = highest_plane(set.planes(), p), away = std::move(away)](const Vector& x) {
    const Touching at = inside(x);
    return at.value < 0 ? at : away(x);
  };
}

ConvexDistance reverse_convex_constraint(const BodyPart& set, const Vector& p) {
  return [rule = grown_distance({set.planes(), space::real(set.center), set.radius}), p](const Vector& x) {
    return rule(x - p);
  };
}

CsgPartSearch csg_part_search(const CsgPart& part, double size) {
  const space::Bounds3 box = bounds(part);
  const double slack = margin::kAroundPart * size;
  const Vector by{slack, slack, slack};
  Constraints constraints;
  for (const BodyPart& set : part.within) constraints.convex.push_back(convex_constraint(set, {}));
  for (const BodyPart& set : part.without) constraints.reverse_convex.push_back(reverse_convex_constraint(set, {}));
  CsgPartSearch out{
      &part, PositionSet::of_constraints(std::move(constraints),
                                         {space::rounded(box.low) - by, space::plus(space::rounded(box.high), by)},
                                         size, [&part](const RealVector& x) { return holds(part, x); })};
  const double none = margin::kNoInterior * size;
  out.empty = out.places.deepest({none}).value <= none;
  return out;
}

NearSet CsgPartSearch::near_set() const {
  NearSet out{&places};
  for (const BodyPart& set : sets->within) {
    if (set.radius.sign() > 0) continue;
    const std::vector<HalfSpace> planes = set.planes();
    out.planes.insert(out.planes.end(), planes.begin(), planes.end());
  }
  for (const BodyPart& set : sets->without) {
    if (set.point()) out.add_ball(set);
  }
  return out;
}

exact::Tried<std::vector<MeetSet>> meet_sets(const BodyPart& part) {
  if (part.point() && part.radius.sign() > 0)
    return std::vector<MeetSet>{{true, exact::approx(part.center), part.radius.to_double()}};
  if (!part.core || part.radius.sign() != 0)
    return exact::Refusal(
        "how deep round polyhedra, or shapes without interior, are in one that round ones are cut out of is "
        "not computed");
  std::vector<MeetSet> out;
  for (const space::HalfSpace& h : part.planes()) out.push_back({false, h.unit, h.shift});
  return out;
}

bool is_empty(const space::CsgSolid& body) {
  const double size = cut_size({}, body);
  return std::all_of(body.parts.begin(), body.parts.end(),
                     [&](const CsgPart& part) { return csg_part_search(part, size).empty; });
}

namespace {

bool in_closed(const BodyPart& set, const RealVector& x, const Vector& near) {
  if (set.point()) {
    const RealVector off = space::minus(x, space::real(set.center));
    return dot(off, off) <= set.radius * set.radius;
  }
  const std::vector<HalfSpace> planes = set.planes();
  if (std::all_of(planes.begin(), planes.end(), [&](const HalfSpace& h) { return h.sign(x, near) <= 0; })) return true;
  if (set.radius.sign() == 0) return false;
  const RealVector off = space::minus(x, *nearest_in(planes, x));
  return dot(off, off) <= set.radius * set.radius;
}

}  // namespace

bool holds(const CsgPart& part, const RealVector& x) {
  const Vector near = space::rounded(x);
  return std::all_of(part.within.begin(), part.within.end(),
                     [&](const BodyPart& set) { return in_closed(set, x, near); }) &&
         std::none_of(part.without.begin(), part.without.end(), [&](const BodyPart& set) {
           return GrownSet{set.planes(), space::real(set.center), set.radius}.holds(x);
         });
}

}  // namespace findspace::distance
