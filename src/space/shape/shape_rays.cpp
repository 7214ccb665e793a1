// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/shape/shape_rays.h"

#include <findspace/error.h>

#include <algorithm>

#include "space/body/csg_solid.h"
#include "space/body/shape_topology.h"
#include "space/convolution/ray_ball.h"
#include "space/convolution/ray_pair.h"
#include "space/convolution/ray_solids.h"
#include "space/mesh/placing.h"
#include "space/polytope/solid.h"
#include "space/rays/piece_rays.h"

namespace findspace::space {
namespace {

using exact::Real;
using Kind = plane::Shape::Kind;
using Signs = std::span<const std::int8_t>;

/// Which of its points count.
enum class Topology { kPlain, kInterior, kClosure };

/// Sets are wanted grown by `by`, or shrunk by -`by` where that is less than 0.
struct Wanted {
  const RayGrid& grid;
  Real by;
  Topology topology = Topology::kPlain;

  bool interior() const { return topology == Topology::kInterior; }
  Wanted with(Topology t) const { return {grid, by, t}; }
  Wanted grown(const Real& more) const { return {grid, by + more, topology}; }
  /// Of the complement.
  Wanted complemented() const {
    return {grid, -by,
            interior()                       ? Topology::kClosure
            : topology == Topology::kClosure ? Topology::kInterior
                                             : Topology::kPlain};
  }
};

[[noreturn]] void refuse(const plane::Shape& shape, const char* what) {
  throw Error(ErrorCode::kUnsupported, what, shape.place);
}

/// A part of a body grown or shrunk; false where nothing is left.
bool change_part(BodyPart& part, const Real& by, std::vector<HalfSpace>& planes) {
  part.radius += by;
  if (part.radius.sign() >= 0) return true;
  for (HalfSpace& h : planes) h = HalfSpace(h.normal, h.offset - part.radius * sqrt(dot(h.normal, h.normal)));
  part.radius = Real();
  return part.core.has_value();
}

/// The parts of a body, closed or (of a single one) open; each is shrunk by itself, so of a shrunk union less is left
/// than could be.
RaySourcePointer body_rays(const Body& body, const Placing& placing, const Wanted& wanted) {
  const Real scale(body.scale), change = (body.outside ? -wanted.by : wanted.by) * scale;
  const RealVector by = scaled(scale, real(placing.by));
  const auto placed = [&](const RealVector& p) { return plus(placing.factor < 0 ? negated(p) : p, by); };
  std::vector<LinePiece> pieces;
  for (BodyPart part : body.parts) {
    std::vector<HalfSpace> planes;
    for (const HalfSpace& p : part.planes()) {
      const RealVector n = placing.factor < 0 ? negated(p.normal) : p.normal;
      planes.emplace_back(n, p.offset - dot(n, by));
    }
    if (!change_part(part, change, planes)) continue;
    if (part.point()) {
      pieces.push_back(ball_piece(placed(real(part.center)), part.radius));
      continue;
    }
    RealVector low = placed(real(part.vertices()[0])), high = low;
    for (const Point& v : part.vertices()) {
      const RealVector p = placed(real(v));
      for (int k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], p[k]);
        high[k] = std::max(high[k], p[k]);
      }
    }
    ConvexRegion region(low, high);
    for (const HalfSpace& h : planes) region.cut(h);
    if (region.empty()) continue;
    pieces.push_back(polytope_piece(std::move(planes), rounded(low), rounded(high)));
    if (part.radius.sign() > 0) add_round_pieces(region, part.radius, pieces);
  }
  const int inside = body.outside ? 1 : -1, frontier = wanted.interior() ? 1 : -1;
  auto rays = std::make_unique<PieceRays>(pieces, body.scale, wanted.grid);
  return mapped_rays(std::move(rays), [=](int s) { return s == 0 ? frontier : s < 0 ? inside : -inside; });
}

/// What all convex sets of a part have in common outside the open ones, and so for all parts.
RaySourcePointer csg_rays(const CsgSolid& cut, const Placing& placing, const Wanted& wanted) {
  std::vector<RaySourcePointer> parts;
  for (const CsgPart& part : cut.parts) {
    std::vector<RaySourcePointer> sets;
    const auto add = [&](const BodyPart& set, bool outside) {
      Body one;
      one.parts.push_back(set);
      one.outside = outside;
      one.scale = cut.scale;
      sets.push_back(body_rays(one, placing, wanted));
    };
    for (const BodyPart& set : part.within) add(set, false);
    for (const BodyPart& set : part.without) add(set, true);
    parts.push_back(greatest_rays(std::move(sets)));
  }
  return parts.empty() ? constant_rays(wanted.grid, 1) : least_rays(std::move(parts));
}

/// What is left of a solid, shrunk by -`wanted.by`, by its convex parts.
RaySourcePointer shrunk_rays(const plane::Shape& solid, const Placing& placing, const Wanted& wanted) {
  plane::Shape offset;
  offset.kind = Kind::kOffset;
  offset.place = solid.place;
  offset.children = {std::make_shared<const plane::Shape>(solid)};
  offset.amount = wanted.by;
  return csg_rays(cut_erosion(offset).or_throw(), placing, {wanted.grid, Real(), wanted.topology});
}

/// Solids by their surfaces, without convex parts; null where they have none. Walls within would count as frontier.
RaySourcePointer surface_rays(const plane::Shape& shape, const Placing& placing, const Wanted& wanted) {
  const Solid::Form form = solid_of(shape)->form;
  if (form != Solid::Form::kMesh && form != Solid::Form::kPrism) return nullptr;
  exact::Tried<std::vector<RaySolid>> solids = try_ray_solids(shape);
  if (!solids) return nullptr;  // a surface that meets itself in edges or faces may still have convex parts
  const int sign = wanted.by.sign(), frontier = wanted.interior() ? 1 : -1;
  if ((*solids)[0].inner_walls && sign <= 0) {
    if (wanted.interior())
      refuse(shape, "neither the interior nor the boundary of a mesh with walls within is computed on lines");
    if (sign < 0) return shrunk_rays(shape, placing, wanted);
  }
  const Triangles surface = moved(scaled(std::move((*solids)[0].surface), placing.factor), placing.by);
  const auto with_frontier = [=](int s) { return s == 0 ? frontier : s; };
  if (sign == 0) return mapped_rays(std::make_unique<PairRays>(surface, wanted.grid), with_frontier);
  auto rays = std::make_unique<BallRays>(surface, abs(wanted.by), wanted.grid,
                                         sign > 0 ? BallRays::Side::kSolid : BallRays::Side::kComplement);
  return mapped_rays(std::move(rays), with_frontier);
}

/// Whether growing (or shrinking) the parts of the tree one by one gives the grown (shrunk) set.
bool part_by_part(const plane::Shape& shape, bool grows) {
  const auto& c = shape.children;
  const auto each = [&](const auto& child) { return part_by_part(*child, grows); };
  switch (shape.kind) {
    case Kind::kUnion:
      return grows && std::all_of(c.begin(), c.end(), each);
    case Kind::kIntersection:
      return !grows && std::all_of(c.begin(), c.end(), each);
    case Kind::kDifference:
      return !grows && each(c[0]) &&
             std::all_of(c.begin() + 1, c.end(), [](const auto& o) { return part_by_part(*o, true); });
    case Kind::kComplement:
      return part_by_part(*c[0], !grows);
    case Kind::kTranslate:
    case Kind::kMirror:
      return each(c[0]);
    case Kind::kHull:
      return true;
    default:
      return solid_of(shape) != nullptr;
  }
}

RaySourcePointer rays_of(const plane::Shape& shape, const Placing& placing, const Wanted& wanted);

RaySourcePointer difference_rays(const plane::Shape& shape, const Placing& placing, const Wanted& wanted) {
  if (wanted.interior() && !is_open(shape)) refuse(shape, "the interior of this kind is not computed on lines");
  const plane::Shape& child = *shape.children[0];
  if (shape.kind == Kind::kOffset && part_by_part(child, false))
    return rays_of(child, placing, wanted.with(Topology::kPlain).grown(shape.amount));
  if (!is_closed(child)) refuse(shape, "what is left of a set that is not closed is not computed on lines");
  return csg_rays(cut_erosion(shape).or_throw(), placing, wanted);
}

/// The interior or the closure of the child, and of that what is wanted.
RaySourcePointer part_of_rays(const plane::Shape& shape, const Placing& placing, const Wanted& wanted) {
  const plane::Shape& child = *shape.children[0];
  const bool open = shape.kind == Kind::kInterior;
  const bool same = open ? wanted.topology != Topology::kClosure : !wanted.interior();
  if (shape.kind != Kind::kRegularize && same)
    return rays_of(child, placing, wanted.with(open ? Topology::kInterior : Topology::kClosure));
  if (!is_solid(child)) refuse(shape, "this is computed on lines for the interior and the closure of solids only");
  return rays_of(child, placing, wanted);
}

/// The closure without the interior.
RaySourcePointer boundary_rays(const plane::Shape& shape, const Placing& placing, const Wanted& wanted) {
  if (wanted.interior()) refuse(shape, "the interior of a boundary is not computed on lines");
  const Wanted closed = wanted.with(Topology::kClosure);
  std::vector<RaySourcePointer> sources;
  sources.push_back(rays_of(*shape.children[0], placing, closed));
  sources.push_back(negated_rays(rays_of(*shape.children[0], placing, closed.complemented())));
  return greatest_rays(std::move(sources));
}

/// Whether the wanted points of the node are made of the wanted points of its children.
void check_topology(const plane::Shape& shape, const Wanted& wanted) {
  const bool joins = shape.kind == Kind::kUnion;
  if (wanted.interior() && joins && !is_open(shape))
    refuse(shape, "the interior of a union is computed on lines for open sets only");
  if (wanted.topology == Topology::kClosure && !joins && !is_closed(shape))
    refuse(shape, "the closure of this kind is computed on lines for closed sets only");
}

RaySourcePointer joined_rays(const plane::Shape& shape, const Placing& placing, const Wanted& wanted) {
  check_topology(shape, wanted);
  std::vector<RaySourcePointer> sources;
  for (std::size_t k = 0; k < shape.children.size(); ++k) {
    const bool without = shape.kind == Kind::kDifference && k > 0;
    auto rays = rays_of(*shape.children[k], placing, without ? wanted.complemented() : wanted);
    sources.push_back(without ? negated_rays(std::move(rays)) : std::move(rays));
  }
  return shape.kind == Kind::kUnion ? least_rays(std::move(sources)) : greatest_rays(std::move(sources));
}

RaySourcePointer rays_of(const plane::Shape& shape, const Placing& placing, const Wanted& wanted) {
  if (solid_of(shape)) {
    if (auto rays = surface_rays(shape, placing, wanted)) return rays;
  }
  const auto child = [&](const Placing& at) { return rays_of(*shape.children[0], at, wanted); };
  switch (shape.kind) {
    case Kind::kUnion:
    case Kind::kIntersection:
    case Kind::kDifference:
      return joined_rays(shape, placing, wanted);
    case Kind::kComplement:
      return negated_rays(rays_of(*shape.children[0], placing, wanted.complemented()));
    case Kind::kTranslate:
      return child(placing.moved({shape.points[0].x, shape.points[0].y, shape.lift}));
    case Kind::kMirror:
      return child(placing.mirrored());
    case Kind::kInterior:
    case Kind::kClosure:
    case Kind::kRegularize:
      return part_of_rays(shape, placing, wanted);
    case Kind::kBoundary:
      return boundary_rays(shape, placing, wanted);
    case Kind::kMinkowskiDifference:
      return difference_rays(shape, placing, wanted);
    case Kind::kOffset:
      if (shape.amount.sign() < 0) return difference_rays(shape, placing, wanted);
      break;
    default:
      break;
  }
  const Body whole = body(shape);
  const bool open = wanted.topology == Topology::kPlain && is_open(shape);
  const Wanted points = open ? wanted.with(Topology::kInterior) : wanted;
  if (points.interior() != whole.outside && whole.parts.size() > 1)  // seams between parts would be frontier
    refuse(shape, "the interior of a union is computed on lines for open sets only");
  return body_rays(whole, placing, points);
}

}  // namespace

RaySourcePointer shape_rays(const plane::Shape& shape, const RayGrid& grid, const Real& by) {
  return rays_of(shape, {}, {grid, by});
}

}  // namespace findspace::space
