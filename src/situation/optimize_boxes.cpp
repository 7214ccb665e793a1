// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The extreme coordinate, or the least distance to a point, over a region of boxes, and where it is taken; exact.
#include "findspace/error.h"
#include "situation/solve_space.h"

namespace findspace::situation {

using exact::Real;
using space::BoxComplex;
using space::dot;
using space::Mark;
using space::RealVector;

SpaceOptimum SpaceSolver::optimize(const BoxComplex& region, const Objective& objective, distance::Sense sense) const {
  const bool greatest = sense == distance::Sense::kMaximum;
  const std::vector<space::IntervalBox> boxes = region.boxes();
  SpaceOptimum out;
  BoxComplex best;
  if (objective.kind == Objective::Kind::kDistanceToPoint && !greatest) {
    RealVector p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = objective.point.at(k) / world_.step;
    const auto q = space::nearest(boxes, p);
    if (!q) return out;
    const RealVector off = space::minus(*q, p);
    const Real square = dot(off, off);
    out.value = sqrt(square) * world_.step;
    // Boxes may share the nearest point, or have one each.
    std::vector<space::IntervalBox> points;
    for (const space::IntervalBox& box : boxes) {
      const RealVector r = *space::nearest(std::array<space::IntervalBox, 1>{box}, p), e = space::minus(r, p);
      if (dot(e, e) != square) continue;
      points.push_back({{{r[0], r[0], true, true}, {r[1], r[1], true, true}, {r[2], r[2], true, true}}});
    }
    best = BoxComplex::of_boxes(points);
  } else if (objective.kind == Objective::Kind::kX || objective.kind == Objective::Kind::kY ||
             objective.kind == Objective::Kind::kZ) {
    const std::size_t k = objective.kind == Objective::Kind::kX ? 0 : objective.kind == Objective::Kind::kY ? 1 : 2;
    std::optional<Real> end;
    for (const space::IntervalBox& box : boxes) {
      const auto& c = greatest ? box[k].to : box[k].from;
      if (!c) {
        out.unbounded = true;
        return out;
      }
      if (!end || (greatest ? *end < *c : *c < *end)) end = c;
    }
    if (!end) return out;
    out.value = *end * world_.step;
    space::IntervalBox slab;
    slab[k] = {end, end, true, true};
    best = BoxComplex::of_boxes(std::array<space::IntervalBox, 1>{slab});
  } else {
    throw Error(ErrorCode::kUnsupported, "in 3D the objectives are x, y, z and the distance to a point (minimised)");
  }
  const auto within = [&](const BoxComplex& set) {
    return overlay(std::array<const BoxComplex*, 2>{&set, &best},
                   [](std::span<const Mark> m) { return Mark(m[0] && m[1]); })
        .simplified();
  };
  out.at = within(region);
  out.attained = !out.at.empty();
  if (!out.attained) out.at = within(region.closure());
  return out;
}

}  // namespace findspace::situation
