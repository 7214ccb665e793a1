// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The distances of SolidSide that say how a body fits into another: eta1 and eta2, and with the roles exchanged delta1
// and delta2. E, the positions at which it does:
//   in a ball             an intersection of balls;
//   in an offset polytope A = P (+) r, of parts no rounder than that: part by part and vertex by vertex an intersection
//                         of rounded polytopes; else that of the parts less r in P, as (P (+) r) (-) r = P;
//   in polyhedra          what is farther from the cover of outside cells less B's cores than their radii;
//   in a union of round parts   where it lies in a single part, exactly, or where the search through all others
//                         (union_fit.h) finds better ones, to 2^-36 of the sizes; where a fit of zero clearance, and
//                         is none in a single part, may be nearer, the value lies from that to the best place known.
// Guarantee: as solid_pair.h; boundaries that are round are searched (position_set.h). Keywords: erosion, Minkowski
// difference, containment.

#include <algorithm>
#include <cmath>

#include "distance/answer/answer.h"
#include "distance/search/position_set.h"
#include "distance/search/solid_protrusion.h"
#include "distance/search/union_fit.h"
#include "distance/solid/fitting_places.h"
#include "distance/solid/solid_pair.h"
#include "exact/margins/space_distance.h"
#include "plane/base/search_work.h"
#include "space/body/body_boxes.h"
#include "space/body/complement_search.h"

namespace findspace::distance {

using exact::Real;
using space::Body;
using space::BodyPart;
using space::real;
using space::RealVector;

namespace {

/// Sets of a cover: of fewer a search is done soon.
constexpr std::size_t kManySets = 4096;

/// The place nearest to p that the cover of the complement of E leaves; no radius.
space::NearestOutside nearest_fit(const Body& b, const Body& a, const space::OpenUnion& cover,
                                  std::span<const space::Extent> places, const RealVector& p) {
  // B may fit a hair beyond parts that were rounded.
  if (cover.size() <= kManySets || a.rounded > 0) return cover.nearest_in_complement(p, places);
  const CornersOut corners(b, a);
  space::ComplementSearch search(cover, p, places.empty() ? std::span(&corners.around(), 1) : places);
  search.leave_out([&](const space::Extent& box) { return corners.at(box); });
  return search.run();
}

std::optional<space::Bounds3> fit_box(const Body& b, const Body& a) { return space::fitting(bounds(b), bounds(a)); }

}  // namespace

const PositionSet& SolidSide::boundary_of(const Fit& fit) const {
  return *fit.boundary.of([&] {
    const space::Bounds3 box = *fit_box(*b_, *a_);
    if (a_->convex())
      return std::make_shared<const PositionSet>(PositionSet::inside(*b_, a_->parts[0], box.low, box.high));
    std::vector<GrownSet> sets;
    for (const Fit::Group& group : fit.groups) {
      for (std::size_t k = 0; k < group.cover.size(); ++k) sets.push_back({group.cover.planes(k), {}, group.radius});
    }
    return std::make_shared<const PositionSet>(PositionSet::outside(std::move(sets), box.low, box.high));
  });
}

std::unique_ptr<SolidSide::Fit> SolidSide::made_fit() const {
  auto made = std::make_unique<Fit>();
  const Body &b = *b_, &a = *a_;
  if (a.convex() && a.parts[0].point()) {
    std::vector<space::Ball> balls;
    for (const BodyPart& part : b.parts) {
      for (const space::Point& v : part.vertices())
        balls.push_back({real(a.parts[0].center - v), a.parts[0].radius - part.radius});
    }
    made->balls.emplace(std::move(balls));
    return made;
  }
  if (a.round() && !a.convex()) {
    const auto box = fit_box(b, a);
    made->none = !box;
    if (box) made->in_union = union_containers(*box);
    return made;
  }
  if (a.convex()) {
    const auto plain = without_radius(b, a);
    if (!plain) {
      made->round = true;
      made->none = !fit_box(b, a);
      return made;
    }
    Fit::Group& group = made->groups.emplace_back();
    group.core = plain->first;
    made->cells = space::outside_cells(plain->second);
    group.cover = space::outside_cover(group.core, made->cells);
    return made;
  }
  const auto places = fitting_places(b, a);
  if (places) made->places = *places;
  // B may fit a hair beyond parts that were rounded (outside_cells.h).
  const bool boxes_tell = b.round() || a.rounded == 0;
  made->none = (boxes_tell && !fit_box(b, a)) || (places && places->empty());
  if (made->none) return made;
  std::vector<Real> radii;
  for (const BodyPart& part : b.parts) {
    if (std::find(radii.begin(), radii.end(), part.radius) == radii.end()) radii.push_back(part.radius);
  }
  made->groups.resize(radii.size());
  for (std::size_t k = 0; k < radii.size(); ++k) {
    Fit::Group& group = made->groups[k];
    group.core.scale = b.scale;
    group.radius = radii[k];
    for (const BodyPart& part : b.parts) {
      if (part.radius != radii[k]) continue;
      group.core.parts.push_back(part);
      group.core.parts.back().radius = Real();
    }
    group.cover = space::outside_cover(group.core, outside_of_fixed());
  }
  made->round = b.round();
  return made;
}

/// The nearest position of E, which does not hold p.
TriedAnswer SolidSide::to_fit(const RealVector& p) const {
  const Fit& f = positions();
  if (f.none) return std::nullopt;
  if (f.round) return boundary_of(f).nearest(p, false);
  const space::NearestOutside found =
      f.balls ? space::NearestOutside{f.balls->nearest(p)} : nearest_fit(*b_, *a_, f.groups[0].cover, f.places, p);
  return nearest_value(p, found, 1, "how far a shape is from fitting into another was not found");
}

TriedAnswer SolidSide::fit(const RealVector& p) const {
  const bool in_round = a_->round() && !(a_->convex() && a_->parts[0].point());
  if (!in_round) {
    const Fit& f = positions();
    if (f.balls && f.balls->holds(p)) return protrusion(p, Depth::kValue);  // inside E both distances agree
    if (auto v = inside_polyhedra(p)) return v;
    return to_fit(p);
  }
  TriedAnswer tried = protrusion(p, Depth::kValue);
  if (!tried || (*tried)->value.sign() <= 0) return tried;
  const Answer& v = **tried;
  const Fit& f = positions();
  if (f.in_union) return into_union(f, p, v);
  // Moved by as much, the way that B protrudes by, it often fits.
  if (f.round && !f.none && !v.witness.empty()) {
    const RealVector q = space::minus(p, space::minus(v.witness[0].at, v.witness[1].at));
    if (boundary_of(f).holds(q)) return signed_value(p, q, 1);
  }
  return to_fit(p);
}

std::optional<Answer> SolidSide::inside_polyhedra(const RealVector& p) const {
  std::optional<Answer> least;
  for (const Fit::Group& group : positions().groups) {
    if (group.cover.covers(p)) return std::nullopt;
    const RealVector q = *group.cover.nearest_touching(p);
    Answer v = signed_value(p, q, -1);
    if (group.radius.sign() > 0) {
      // The ball fits where it is no deeper than that; so much less is the way to where it does not.
      const Real d = -v.value;
      v.value = group.radius - d;
      if (v.value.sign() > 0) return std::nullopt;
      v.nearest.reset();
      if (v.value.sign() < 0) v.nearest = space::along(q, group.radius / d, space::minus(p, q));
    }
    if (!least || least->value < v.value) least = std::move(v);
  }
  return least;
}

TriedAnswer SolidSide::farthest_fit(const RealVector& p) const {
  const Fit& f = positions();
  if (f.none) return std::nullopt;
  if (f.in_union) return farthest_in_union(f, p);
  if (f.round) return boundary_of(f).farthest(p);
  std::optional<RealVector> q;
  if (f.balls) {
    if (!f.balls->few()) return fit_box(*b_, *a_) ? boundary_of(f).farthest(p) : std::nullopt;
    q = f.balls->farthest(p);
  } else {
    const auto box = fit_box(*b_, *a_);
    if (!box) return std::nullopt;
    exact::Tried<std::optional<RealVector>> found = farthest_in_complement(f.groups[0].cover, box->low, box->high, p);
    if (!found) return found.refusal();
    q = *std::move(found);
  }
  if (!q) return std::nullopt;
  Answer out;
  out.value = sqrt(space::dot(space::minus(*q, p), space::minus(*q, p)));
  return std::optional(std::move(out));
}

TriedAnswer SolidSide::clearance(const RealVector& p) const {
  if (a_->round() && !a_->convex()) {
    const TriedAnswer out = protrusion(p, Depth::kSign);
    if (!out) return out;
    if ((*out)->value.sign() > 0) return Answer{};
  }
  return PairSide::clearance(p);
}

TriedAnswer SolidSide::depth_inside(const RealVector& p) const {
  const PositionSet free = PositionSet::outside_of(*a_);
  std::optional<Answer> most;
  for (const BodyPart& part : b_->parts) {
    Answer v = minus(free.least(touching_distance(part, space::rounded(p), part.radius.to_double())));
    most = most ? greatest(*std::move(most), std::move(v)) : std::move(v);
  }
  return most;
}

/// What is kept from position to position.
struct UnionContainers {
  std::vector<std::unique_ptr<SolidSide>> alone;  // with each part of A
  PositionSet fits;                               // E
};

namespace {

/// The nearest (farthest) place in a single part, where that is known.
std::optional<Answer> in_one_part(const UnionContainers& containers, const RealVector& p, bool farthest) {
  std::optional<Answer> best;
  for (const auto& pair : containers.alone) {
    TriedAnswer tried = farthest ? pair->farthest_fit(p) : pair->fit(p);
    if (!tried || !*tried) continue;  // the search will tell
    Answer& v = **tried;
    if (!(v.error < exact::kInfinity)) continue;  // it may fit nowhere
    if (!best || (farthest ? best->value < v.value : v.value < best->value)) best = std::move(v);
  }
  return best;
}

}  // namespace

std::shared_ptr<const UnionContainers> SolidSide::union_containers(const space::Bounds3& box) const {
  auto out = std::make_shared<UnionContainers>(UnionContainers{{}, fits_in_union(*b_, *a_, space::rounded(box))});
  for (const space::BodyPart& part : a_->parts) {
    auto one = std::make_shared<space::Body>();
    one->scale = a_->scale;
    one->parts.push_back(part);
    out->alone.push_back(std::make_unique<SolidSide>(b_, std::move(one)));
  }
  return out;
}

TriedAnswer SolidSide::into_union(const Fit& fit, const RealVector& p, const Answer& outside) const {
  // Moved by as much, the way that B protrudes by, it often fits, and no shorter way leads to where it does.
  if (!outside.witness.empty() && outside.proven) {
    const RealVector q = space::minus(p, space::minus(outside.witness[0].at, outside.witness[1].at));
    const TriedAnswer there = protrusion(q, Depth::kSign);
    if (!there) return there;
    if ((*there)->value.sign() <= 0) return std::optional(signed_value(p, q, 1));
  }
  const UnionContainers& containers = *fit.in_union;
  const auto known = in_one_part(containers, p, false);
  return containers.fits.nearest(
      p, false, [&] { return known; }, outside.value.to_double() - outside.error);
}

TriedAnswer SolidSide::farthest_in_union(const Fit& fit, const RealVector& p) {
  const UnionContainers& containers = *fit.in_union;
  const auto known = in_one_part(containers, p, true);
  TriedAnswer out = containers.fits.farthest(p, [&] { return known; });
  if (out && *out) (*out)->farthest.reset();
  return out;
}

}  // namespace findspace::distance
