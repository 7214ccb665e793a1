// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/csg/csg_part.h"

#include <findspace/error.h>

#include <algorithm>
#include <cmath>

#include "distance/search/convex_distance.h"
#include "distance/search/solid_protrusion.h"
#include "exact/margins/space_distance.h"
#include "plane/base/search_work.h"
#include "space/body/name_place.h"
#include "space/polytope/convex_region.h"

namespace findspace::distance {

using exact::Real;
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

TouchingConstraint gap_to(const BodyPart& set, const Vector& p) {
  return touching_boundary(set, p, set.radius.to_double());
}

TouchingConstraint convex_constraint(const BodyPart& set, const Vector& p) {
  return flat_sided(set) ? highest_plane(set.planes(), p) : gap_to(set, p);
}

ConvexDistance reverse_convex_constraint(const BodyPart& set, const Vector& p) {
  return [rule = grown_distance(grown_set(set)), p](const Vector& x) { return rule(x - p); };
}

CsgPartSearch csg_part_search(const CsgPart& part, double size) {
  Constraints constraints;
  for (const BodyPart& set : part.within) constraints.convex.push_back(convex_constraint(set, {}));
  for (const BodyPart& set : part.without) constraints.reverse_convex.push_back(reverse_convex_constraint(set, {}));
  CsgPartSearch out{&part, PositionSet::of_constraints(std::move(constraints),
                                                       grown(space::rounded(bounds(part)), margin::kAroundPart * size),
                                                       size, [&part](const RealVector& x) { return holds(part, x); })};
  const double none = margin::kNoInterior * size;
  const Slack most = out.places.deepest({none});
  out.empty = most.value <= none &&
              (most.bound <= none || std::any_of(part.within.begin(), part.within.end(),
                                                 [&](const BodyPart& set) { return in_a_cut(set, part, {}); }));
  return out;
}

namespace {

/// How far the set moved by p protrudes from the set that is cut out which holds most of it.
std::optional<Real> out_of_cuts(const BodyPart& set, const CsgPart& part, const RealVector& p) {
  const Body body = space::body_of_part(set);
  std::optional<Real> least;
  for (const BodyPart& cut : part.without) {
    const Real out = protrusion_of_convex(body, cut, p).value;
    if (!least || out < *least) least = out;
  }
  return least;
}

}  // namespace

bool in_a_cut(const BodyPart& set, const CsgPart& part, const RealVector& p) {
  const std::optional<Real> out = out_of_cuts(set, part, p);
  return out && out->sign() <= 0;
}

double depth_in_cuts(const BodyPart& set, const CsgPart& part, const RealVector& p, double size) {
  const std::optional<Real> out = out_of_cuts(set, part, p);
  return out ? std::max(0.0, -out->to_double() - margin::kPlaceNoise * size) : 0;
}

exact::Refusal not_found_in_part() {
  return plane::search_spent(
      "whether there is a place in a part of a shape that round ones are cut out of was not found");
}

bool came_to_end(const BoundaryPlace& found, double size) {
  return std::fabs(found.value - found.bound) <= margin::kSearchesAgree * margin::kFoundError * size;
}

void BoundOfParts::add(const BoundaryPlace& found, double more) {
  double& least = found.found ? found_ : missed_;
  least = std::min(least, sense_ * (found.bound + more));
}

TriedAnswer BoundOfParts::best(std::optional<Answer> of) const {
  if (!of && missed_ == exact::kInfinity)
    throw Error(ErrorCode::kGeometry, "nothing with interior is left of the shape");
  if (!of) return not_found_in_part();
  const double value = sense_ * of->value.to_double(), rounding = margin::kSearchesAgree * margin::kFoundError * size_;
  if (missed_ < value - std::max(of->error, rounding)) return not_found_in_part();
  if (found_ < value - std::max(of->error, rounding)) {
    of->set_unproven();
    of->error = value - found_;
    of->enclosed.reset();
  }
  return of;
}

NearSet CsgPartSearch::near_set() const {
  NearSet out{&places};
  for (const BodyPart& set : sets->within) {
    if (set.point()) out.outer.push_back(NearSet::ball(set));
    if (set.radius.sign() > 0) continue;
    const std::vector<HalfSpace> planes = set.planes();
    out.planes.insert(out.planes.end(), planes.begin(), planes.end());
    out.ways.push_back(way_to(planes));
  }
  for (const BodyPart& set : sets->without) out.take_away(set);
  return out;
}

exact::Refusal no_depth() {
  return exact::Refusal("how deep shapes without interior are in one that round ones are cut out of is not computed");
}

exact::Tried<std::vector<MeetSet>> meet_sets(const BodyPart& part) {
  if (part.point() && part.radius.sign() > 0)
    return std::vector<MeetSet>{{true, exact::approx(part.center), part.radius.to_double()}};
  if (part.radius.sign() > 0) {
    const double radius = part.radius.to_double();
    return std::vector<MeetSet>{
        {false, {}, radius, std::make_shared<const TouchingConstraint>(touching_boundary(part, {}, radius))}};
  }
  if (!part.core) return no_depth();
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
         std::none_of(part.without.begin(), part.without.end(),
                      [&](const BodyPart& set) { return grown_set(set).holds(x); });
}

namespace {

/// What the distance of a convex body to a part of a solid is at places that square roots name. Whether such a place
/// belongs to the part is decided exactly; the search says which is the nearest.
class Names {
 public:
  Names(const CsgPart& a, const BodyPart& s, const RealVector& p, const Vector& place, double size)
      : a_(a), s_(s), p_(p), place_(place), blur_(margin::kNamedPlace * size) {}

  std::vector<Answer> all() {
    for (const BodyPart& set : a_.within) on_set(set);
    on_spheres();
    return std::move(found_);
  }

 private:
  /// From the point b of s without its radius to the place, if that belongs.
  void offer(const RealVector& b, const RealVector& place) {
    const RealVector way = space::minus(place, b);
    offer(b, place, sqrt(dot(way, way)));
  }
  /// At that distance.
  void offer(const RealVector& b, const RealVector& place, const Real& d) {
    if (!holds(a_, place)) return;
    const RealVector way = space::minus(place, b);
    Answer v;
    v.value = d - s_.radius;
    if (d.sign() > 0) {
      const RealVector from = space::along(b, s_.radius / d, way);
      v.witness = point_pair(from, place);
      if (v.value.sign() > 0) v.nearest = space::plus(p_, space::minus(place, from));
    }
    found_.push_back(std::move(v));
  }

  /// The nearest places of one set of A alone.
  void on_set(const BodyPart& set) {
    const std::vector<HalfSpace> planes = space::difference_planes(set, s_);
    RealVector q = space::real(set.center - s_.center);
    if (!planes.empty()) {
      const auto nearest = nearest_in(planes, p_);
      if (!nearest) return;
      q = *nearest;
    }
    const RealVector away = space::minus(p_, q);
    const Real d = sqrt(dot(away, away));
    if (d.sign() == 0) return;
    for (const space::ConvexRegion::Vertex& v : shared_corners(set, q)) {
      const RealVector b = space::plus(v.at, away);
      offer(b, space::along(v.at, set.radius / d, away));
    }
  }

  /// The corners of what the core of the set has in common with that of s moved by q.
  std::vector<space::ConvexRegion::Vertex> shared_corners(const BodyPart& set, const RealVector& q) const {
    const auto box = [](const BodyPart& part) {
      Body one = space::body_of_part(part);
      one.parts[0].radius = Real();
      return bounds(one);
    };
    const space::Bounds3 of_set = box(set);
    space::ConvexRegion region(of_set.low, of_set.high);
    for (const HalfSpace& h : set.planes()) region.cut(h);
    for (const std::vector<HalfSpace>& planes : {space::walls(box(s_)), s_.planes()}) {
      for (const HalfSpace& h : planes) region.cut(HalfSpace(h.normal, h.offset - dot(h.normal, q)));
    }
    return {region.vertices().begin(), region.vertices().end()};
  }

  bool near(const RealVector& x) const { return space::length(space::rounded(x) - place_) < blur_; }

  /// The planes of facets and the spheres that come near the place.
  void surfaces(std::vector<HalfSpace>& planes, std::vector<space::Ball>& spheres) const {
    for (const std::vector<BodyPart>* sets : {&a_.within, &a_.without}) {
      for (const BodyPart& set : *sets) {
        if (set.point()) {
          const RealVector center = space::real(set.center);
          const double off = space::length(place_ - space::rounded(center)) - set.radius.to_double();
          if (std::fabs(off) < blur_) spheres.push_back({center, set.radius});  // no sign: places are tested
        }
        if (set.radius.sign() > 0) continue;
        for (HalfSpace& h : set.planes()) {
          if (std::fabs(h.approx_value(place_)) < blur_) planes.push_back(std::move(h));  // no sign, either
        }
      }
    }
  }

  /// Where a corner of s is nearest to a sphere, from inside, or to what one has in common with another or a plane.
  void on_spheres() {
    std::vector<HalfSpace> planes;
    std::vector<space::Ball> spheres;
    surfaces(planes, spheres);
    for (const space::Ball& sphere : spheres) from_corners({}, {sphere});
    for (std::size_t k = 1; k < spheres.size(); ++k) from_corners({}, {spheres[0], spheres[k]});
    if (spheres.empty()) return;
    for (const HalfSpace& h : planes) from_corners({h}, {spheres[0]});
  }

  void from_corners(const std::vector<HalfSpace>& planes, const std::vector<space::Ball>& spheres) {
    for (const space::Point& v : s_.vertices()) {
      const RealVector b = space::plus(space::real(v), p_);
      const bool from_centre = planes.empty() && spheres.size() == 1 && b == spheres[0].center;
      for (const RealVector& place : space::name_places(planes, spheres, b)) {
        if (near(place))
          offer(b, place);
        else if (from_centre)
          offer_beside(spheres[0]);
      }
    }
  }

  /// From the centre, to which all of the sphere is as near: the place of it beside the one found.
  void offer_beside(const space::Ball& sphere) {
    const RealVector way = space::minus(space::real(place_), sphere.center);
    const Real size = sqrt(dot(way, way));
    if (size.sign() > 0) offer(sphere.center, space::along(sphere.center, sphere.radius / size, way), sphere.radius);
  }

  const CsgPart& a_;
  const BodyPart& s_;
  RealVector p_;
  Vector place_;
  double blur_;
  std::vector<Answer> found_;
};

}  // namespace

std::vector<Answer> named_gaps(const CsgPart& a, const BodyPart& s, const RealVector& p, const Vector& place,
                               double size) {
  return Names(a, s, p, place, size).all();
}

}  // namespace findspace::distance
