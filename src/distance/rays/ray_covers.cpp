// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/rays/ray_covers.h"

#include <array>
#include <cmath>

#include "space/body/position_covers.h"
#include "space/body/union_frontier.h"

namespace findspace::distance {

using exact::Real;
using space::Body;
using space::Bounds3;
using space::ConvexRegion;
using space::HalfSpace;
using space::RealVector;

namespace {

RayCover cover_of(const space::OpenUnion& cover, const Bounds3& a, const Bounds3& b, bool outside) {
  RayCover out;
  for (std::size_t k = 0; k < cover.size(); ++k) {
    out.sets.push_back(cover.planes(k));
    out.extents.push_back(cover.extent(k));
  }
  out.low = outside ? space::minus(a.low, b.low) : space::minus(a.low, b.high);
  out.high = outside ? space::minus(a.high, b.high) : space::minus(a.high, b.low);
  for (int k = 0; k < 3; ++k) {
    out.all = out.all || out.high[k] < out.low[k];
    out.low[k] -= Real(1);
    out.high[k] += Real(1);
  }
  out.beyond = outside;
  return out;
}

}  // namespace

space::OpenUnion RayCover::lazy() const {
  space::OpenUnion out;
  for (std::size_t k = 0; k < sets.size(); ++k) out.add(extents[k], sets[k]);
  return out;
}

RayCover overlap_sets(const Body& b, const Body& a) {
  return cover_of(space::overlap_cover(b, a), bounds(a), bounds(b), false);
}

RayCover outside_sets(const Body& b, const Body& a) {
  const std::vector<space::OutsideCell> cells = space::outside_cells(a);
  return cover_of(space::outside_cover(b, cells), bounds(a), bounds(b), true);
}

namespace {

/// The half spaces that a box leaves.
std::vector<HalfSpace> around(const RealVector& low, const RealVector& high) {
  std::vector<HalfSpace> out;
  for (std::size_t k = 0; k < 3; ++k) {
    RealVector up;
    up[k] = Real(1);
    out.emplace_back(up, -low[k]);
    out.emplace_back(space::negated(up), high[k]);
  }
  return out;
}

/// What the open sets leave.
ClosedSets what_is_left(const RayCover& cover) {
  ClosedSets out;
  for (ConvexRegion& piece : space::complement_pieces(cover.lazy(), cover.low, cover.high))
    out.regions.push_back({std::move(piece), Real()});
  for (ConvexRegion& piece : space::cover_frontier(cover.sets, cover.low, cover.high))
    out.regions.push_back({std::move(piece), Real()});
  if (!cover.beyond) out.beyond = around(cover.low, cover.high);
  return out;
}

}  // namespace

ClosedSets closures(const RayCover& cover) {
  ClosedSets out;
  for (const auto& set : cover.sets) {
    ConvexRegion region = cut_from(cover.low, cover.high, set);
    if (!region.empty()) out.regions.push_back({std::move(region), Real()});
  }
  if (cover.beyond) out.beyond = around(cover.low, cover.high);
  return out;
}

const RayCover& BodiesOnLines::cover(Of of) const {
  return kept(of).cover.of([&] {
    switch (of) {
      case Of::kOverlap:
        return overlap_sets(b_, a_);
      case Of::kOutside:
        return outside_sets(b_, inside_of(a_));
      case Of::kOutsideBack:
        break;
    }
    return outside_sets(mirrored(a_), mirrored(b_));
  });
}

const ClosedSets& BodiesOnLines::rest(Of of) const {
  return kept(of).rest.of([&] { return what_is_left(cover(of)); });
}

ConvexRegion difference_core(const space::BodyPart& a, const space::BodyPart& b) {
  const std::vector<HalfSpace> planes = space::difference_planes(a, b);
  if (planes.empty()) {
    const RealVector center = space::real(a.center - b.center);
    return ConvexRegion(center, center);
  }
  const space::Extent extent = space::difference_extent(a, b);
  const std::array<double, 6> ends{extent.low.x,  extent.low.y,  extent.low.z,
                                   extent.high.x, extent.high.y, extent.high.z};
  RealVector low, high;
  for (std::size_t k = 0; k < 3; ++k) {
    low[k] = Real::from_double(std::floor(ends[k]) - 1);
    high[k] = Real::from_double(std::ceil(ends[k + 3]) + 1);
  }
  return cut_from(low, high, planes);
}

ConvexRegion cut_from(const RealVector& low, const RealVector& high, std::span<const HalfSpace> planes) {
  ConvexRegion set(low, high);
  for (const HalfSpace& h : planes) set.cut(h);
  return set;
}

}  // namespace findspace::distance
