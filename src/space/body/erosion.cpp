// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/body/erosion.h"

#include <findspace/error.h>

#include <algorithm>
#include <string>

#include "plane/base/search_work.h"
#include "space/body/cell_parts.h"
#include "space/body/outside_cells.h"
#include "space/body/union_frontier.h"
#include "space/polytope/polytope_sets.h"

namespace findspace::space {

using exact::Real;
using exact::Refusal;
using exact::Tried;

namespace {

Refusal nothing_left() { return Refusal(Error(ErrorCode::kGeometry, "nothing with interior is left of the shape")); }

Body of_part(BodyPart part) {
  Body out;
  out.parts.push_back(std::move(part));
  return out;
}

/// A body of cells with interior.
Tried<Body> in_cells(const CellCorners& cells) {
  Tried<ConvexParts> made = all_parts(cells);
  if (!made) return made.refusal();
  return body_of(*std::move(made));
}

/// Where a box moved by all of b is; nothing if that has no interior.
std::optional<ConvexRegion> box_of(const Bounds3& a, const Body& b) {
  const Bounds3 by = bounds(b);
  RealVector low, high;
  for (std::size_t k = 0; k < 3; ++k) {
    low[k] = a.low[k] + by.high[k];
    high[k] = a.high[k] + by.low[k];
    if (high[k] <= low[k]) return std::nullopt;
  }
  return ConvexRegion(low, high);
}

/// Of a polytope.
Tried<Body> between_planes(const Polytope& a, const Body& b) {
  std::optional<ConvexRegion> out = box_of(bounds(of_part({a, {}, {}, {}})), b);
  if (!out) return nothing_left();
  for (const Plane& plane : a.planes()) {
    const HalfSpace h(plane);
    out->cut(HalfSpace(h.normal, h.offset + support(b, negated(h.normal))));
  }
  if (out->dimension() < 3) return nothing_left();
  return in_cells(cell_corners({*std::move(out)}));
}

/// Of one convex part: a copy for each corner of the parts of b that are less round; by the others the core shrinks.
Tried<std::vector<Body>> containers(const BodyPart& a, const Body& b) {
  std::vector<Body> out;
  Body rounder;
  for (const BodyPart& q : b.parts) {
    const Real left = a.radius - q.radius;
    if (left.sign() > 0 || (left.sign() == 0 && a.point())) {
      for (const Point& v : q.vertices()) out.push_back(translated(of_part({a.core, a.center, left, a.flat}), v));
    } else {
      if (!a.core) return nothing_left();
      rounder.parts.push_back({q.core, q.center, -left, q.flat});
    }
  }
  if (rounder.parts.empty()) return out;
  Tried<Body> between = between_planes(*a.core, rounder);
  if (!between) return between.refusal();
  out.push_back(*std::move(between));
  return out;
}

/// Of one convex part: containers alone.
Tried<Erosion> of_convex(const BodyPart& a, const Body& b) {
  Tried<std::vector<Body>> all = containers(a, b);
  if (!all) return all.refusal();
  return Erosion{*std::move(all)};
}

/// Of polytopes: the box about them, and the cells outside it that are kept out.
Tried<Erosion> of_union(const Body& a, const Body& b) {
  const auto round = [](const BodyPart& p) { return p.radius.sign() > 0; };
  if (std::any_of(a.parts.begin(), a.parts.end(), round))
    return Refusal("a union with round parts is not shrunk in 3D");
  CellCorners corners;
  for (OutsideCell& cell : outside_cells(a)) {
    if (cell.bounded()) corners.push_back(std::move(cell.vertices));
  }
  std::optional<ConvexRegion> within = box_of(bounds(a), b);
  if (!within) return nothing_left();
  Tried<Body> box = in_cells(cell_corners({*std::move(within)}));
  if (!box) return box.refusal();
  Erosion out{{*std::move(box)}};
  const Tried<Body> left = in_cells(corners);
  if (!left) return left.refusal();
  if (!left->parts.empty()) out.obstacles = minkowski_sum(*left, b);
  return out;
}

Body at(Body body, std::int64_t scale) {
  body.moved /= static_cast<double>(scale);
  body.scale *= scale;
  return body;
}

}  // namespace

Refusal shrunk_by_complement() { return Refusal("a Minkowski difference by a complement is empty or all of space"); }

Refusal thin_left_over() { return thin_part("what is left of the shape"); }

Tried<Erosion> erosion(const Body& a, const Body& b) {
  if (b.outside) return shrunk_by_complement();
  const std::int64_t scale = joint_scale(a.scale, b.scale);
  Body p = at_scale(a, scale), q = at_scale(b, scale);
  p.scale = q.scale = 1;  // finer steps from here on
  for (Body* body : {&p, &q}) body->moved *= static_cast<double>(scale);
  if (a.outside) {
    p.outside = false;
    Body sum = minkowski_sum(p, q);
    sum.outside = true;
    return Erosion{{at(std::move(sum), scale)}};
  }
  Tried<Erosion> out = p.parts.size() == 1 ? of_convex(p.parts[0], q) : of_union(p, q);
  if (!out) return out;
  for (Body& tolerance : out->containers) {
    tolerance = at(std::move(tolerance), scale);
    tolerance.rounded += a.rounded + b.rounded;
    tolerance.moved = std::max({tolerance.moved, a.moved, b.moved});
  }
  if (out->obstacles) out->obstacles = at(*std::move(out->obstacles), scale);
  return out;
}

namespace {

/// At the common scale of two bodies without radii.
Tried<std::vector<Polytope>> polytopes(const Body& body, std::int64_t scale) {
  std::vector<Polytope> out;
  for (const BodyPart& part : at_scale(body, scale).parts) {
    if (part.radius.sign() > 0 || !part.core)
      return Refusal("what is left of this shape is not a union of convex parts");
    out.push_back(*part.core);
  }
  return out;
}

/// Whether one of the pieces is not in the closed sets.
bool any_stays(const std::vector<ConvexRegion>& thin, std::span<const Body> taken, std::int64_t scale) {
  if (thin.empty()) return false;
  std::vector<ConvexRegion> regions;
  for (const Body& body : taken) {
    if (scale % body.scale != 0) continue;  // others may hold it
    const Tried<std::vector<Polytope>> parts = polytopes(body, scale);
    if (!parts) continue;
    for (const Polytope& p : *parts) regions.push_back(common_region({&p, 1}));
  }
  return std::any_of(thin.begin(), thin.end(),
                     [&](const ConvexRegion& piece) { return !uncovered(piece, regions).empty(); });
}

struct Cut {
  const Body& by;
  bool inside;                    // what is kept
  std::span<const Body> taken{};  // closed sets that are not kept
};

/// What both bodies have in common, or what is left of the first one, which is convex.
Tried<Body> cut(const Body& body, const Cut& how) {
  const Body& by = how.by;
  const std::int64_t scale = joint_scale(body.scale, by.scale);
  const Tried<std::vector<Polytope>> p = polytopes(body, scale), q = polytopes(by, scale);
  if (!p) return p.refusal();
  if (!q) return q.refusal();
  Tried<std::vector<ConvexRegion>> cells = how.inside ? intersection_cells(*p, *q) : difference_cells(*p, *q);
  if (!cells) return cells.refusal();
  if (cells->empty()) return nothing_left();
  if (!how.inside && any_stays(thin_pieces(*p, *q, *cells), how.taken, scale)) return thin_left_over();
  Tried<Body> made = in_cells(cell_corners(*cells));
  if (!made) return made;
  Body next = at(*std::move(made), scale);
  next.rounded += body.rounded + by.rounded;
  next.moved = std::max({next.moved, body.moved, by.moved});
  return next;
}

}  // namespace

Tried<Body> eroded(const Body& a, const Body& b, std::span<const Body> lacking) {
  Tried<Erosion> made = erosion(a, b);
  if (!made) return made.refusal();
  Body out = std::move(made->containers[0]);
  if (made->containers.size() == 1 && !made->obstacles) return out;
  for (std::size_t k = 1; k < made->containers.size(); ++k) {
    Tried<Body> next = cut(out, {made->containers[k], true});
    if (!next) return next;
    out = *std::move(next);
  }
  if (!made->obstacles) return out;
  std::vector<Body> taken;
  for (const Body& set : lacking) taken.push_back(minkowski_sum(set, b));
  return cut(out, {*made->obstacles, false, taken});
}

Body ball(const Real& radius) { return of_part({std::nullopt, {}, radius, {}}); }

/// The first corners of each pair are paid with the pair, which who reads the scene charges.
void require_few_corners(const plane::Shape& sum, double corners, double pairs) {
  constexpr double kCorner = 2, kPaidWithPair = 64;
  const long most = plane::allowed(plane::kUsualWorkBudget);
  if (kCorner * (corners - kPaidWithPair * pairs) <= double(most)) return;
  throw Error(ErrorCode::kLimit,
              "a Minkowski sum of so many corners costs more than the work limit of " + std::to_string(most) +
                  " units, which --work-limit raises",
              sum.place.empty() ? sum.name : sum.place);
}

}  // namespace findspace::space
