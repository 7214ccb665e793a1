// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The extreme coordinate, or the least distance to a point, over a region of boxes, and where it is taken; exact.
#include "findspace/error.h"
#include "formula/solid/solve_space.h"
#include "space/box/box_operations.h"
#include "space/box/box_topology.h"

namespace findspace::formula {

using exact::Real;
using space::BoxComplex;
using space::dot;
using space::Mark;
using space::RealVector;

namespace {

using Boxes = std::span<const space::IntervalBox>;

/// The place of the best value, whole, in or beside the region; none: there is no value.
struct Best {
  std::optional<Real> value;
  BoxComplex at{};
  bool unbounded = false;
};

/// The points of closed boxes nearest to a point: boxes may share one, or have one each.
Best nearest_points(Boxes boxes, const RealVector& p) {
  const auto q = space::nearest(boxes, p);
  if (!q) return {};
  const RealVector off = space::minus(*q, p);
  const Real square = dot(off, off);
  std::vector<space::IntervalBox> points;
  for (const space::IntervalBox& box : boxes) {
    const RealVector r = *space::nearest(std::array<space::IntervalBox, 1>{box}, p), e = space::minus(r, p);
    if (dot(e, e) != square) continue;
    points.push_back({{{r[0], r[0], true, true}, {r[1], r[1], true, true}, {r[2], r[2], true, true}}});
  }
  return {sqrt(square), BoxComplex::of_boxes(points).checked().or_throw(), false};
}

/// The plane across axis @p k through the last points along it.
Best last_plane(Boxes boxes, std::size_t k, bool greatest) {
  std::optional<Real> end;
  for (const space::IntervalBox& box : boxes) {
    const auto& c = greatest ? box[k].to : box[k].from;
    if (!c) return {std::nullopt, BoxComplex(), true};
    if (!end || (greatest ? *end < *c : *c < *end)) end = c;
  }
  if (!end) return {};
  space::IntervalBox slab;
  slab[k] = {end, end, true, true};
  return {end, BoxComplex::of_boxes(std::array<space::IntervalBox, 1>{slab}), false};
}

std::optional<std::size_t> axis_of(Objective::Kind kind) {
  if (kind == Objective::Kind::kX) return 0;
  if (kind == Objective::Kind::kY) return 1;
  if (kind == Objective::Kind::kZ) return 2;
  return std::nullopt;
}

}  // namespace

distance::OptimumOf<BoxComplex> optimize(const BoxComplex& region, const Real& step, const Objective& objective,
                                         distance::Sense sense) {
  const bool greatest = sense == distance::Sense::kMaximum;
  const std::vector<space::IntervalBox> boxes = region.boxes();
  const auto axis = axis_of(objective.kind);
  if (!axis && (objective.kind != Objective::Kind::kDistanceToPoint || greatest))
    throw Error(ErrorCode::kUnsupported, "in 3D the objectives are x, y, z and the distance to a point (minimised)");
  RealVector p;
  if (!axis)
    for (std::size_t k = 0; k < 3; ++k) p[k] = objective.point.at(k) / step;
  const Best best = axis ? last_plane(boxes, *axis, greatest) : nearest_points(boxes, p);
  auto out = distance::no_optimum<BoxComplex>(sense, best.unbounded);
  if (!best.value) return out;
  out.set_exact(*best.value * step, distance::Way::kBoxes);
  const auto within = [&](const BoxComplex& set) {
    return overlay(std::array<const BoxComplex*, 2>{&set, &best.at},
                   [](std::span<const Mark> m) { return Mark(m[0] && m[1]); })
        .checked()
        .or_throw()
        .simplified();
  };
  out.at = within(region);
  out.attained = !out.at.empty();
  if (!out.attained) out.at = within(closure(region));
  return out;
}

}  // namespace findspace::formula
