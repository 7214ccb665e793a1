// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/shape_rays.h"

#include <findspace/error.h>

#include <algorithm>

#include "space/body.h"
#include "space/piece_rays.h"
#include "space/ray_ball.h"
#include "space/ray_pair.h"
#include "space/ray_solids.h"
#include "space/solid.h"

namespace findspace::space {
namespace {

using exact::Real;
using Kind = plane::Shape::Kind;
using Signs = std::span<const std::int8_t>;

/// Where a node stands: at factor * x + by, in grid steps.
struct Placing {
  std::int64_t factor = 1;
  Point by;

  Placing moved(const Point& t) const { return {factor, by + Point{factor * t.x, factor * t.y, factor * t.z}}; }
  Placing mirrored() const { return {-factor, by}; }
};

/// Whether the set is closed and without sheets, lines and seams of its own.
bool is_solid(const plane::Shape& shape) {
  if (solid_of(shape)) return true;
  const bool keeps = shape.kind == Kind::kUnion || shape.kind == Kind::kTranslate || shape.kind == Kind::kMirror ||
                     shape.kind == Kind::kHull || shape.kind == Kind::kMinkowskiSum || shape.kind == Kind::kOffset ||
                     shape.kind == Kind::kClosure || shape.kind == Kind::kRegularize;
  return keeps && std::all_of(shape.children.begin(), shape.children.end(), [](const auto& c) { return is_solid(*c); });
}

[[noreturn]] void refuse(const plane::Shape& shape, const char* what) {
  throw Error(ErrorCode::kUnsupported, what, shape.place);
}

/// Sets are wanted grown by `by`, or shrunk by -`by` where that is less than 0.
struct Wanted {
  const RayGrid& grid;
  Real by;

  Wanted turned() const { return {grid, -by}; }
};

/// A part of a body grown or shrunk; false where nothing is left.
bool change_part(BodyPart& part, const Real& by, std::vector<HalfSpace>& planes) {
  part.radius += by;
  if (part.radius.sign() >= 0) return true;
  for (HalfSpace& h : planes) h = HalfSpace(h.normal, h.offset - part.radius * sqrt(dot(h.normal, h.normal)));
  part.radius = Real();
  return part.core.has_value();
}

/// The closed parts of a body; each is shrunk by itself, so of a shrunk union less is left than could be.
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
      for (int k = 0; k < 3; ++k) low[k] = std::min(low[k], p[k]), high[k] = std::max(high[k], p[k]);
    }
    ConvexRegion region(low, high);
    for (const HalfSpace& h : planes) region.cut(h);
    if (region.empty()) continue;
    pieces.push_back(polytope_piece(std::move(planes), rounded(low), rounded(high)));
    if (part.radius.sign() > 0) add_round_pieces(region, part.radius, pieces);
  }
  const int inside = body.outside ? 1 : -1;
  auto rays = std::make_unique<PieceRays>(pieces, body.scale, wanted.grid);
  // The closure of a complement keeps the frontier, too.
  return mapped_rays(std::move(rays), [=](int s) { return s == 0 ? -1 : s < 0 ? inside : -inside; });
}

/// Solids by their surfaces, without convex parts; null where they have none.
RaySourcePointer surface_rays(const plane::Shape& shape, const Placing& placing, const Wanted& wanted) {
  const Solid::Form form = solid_of(shape)->form;
  if (form != Solid::Form::kMesh && form != Solid::Form::kPrism) return nullptr;
  std::vector<RaySolid> solids;
  try {
    solids = ray_solids(shape);
  } catch (const Error& e) {
    // A surface that meets itself in edges or faces may still have convex parts.
    if (e.code() != ErrorCode::kGeometry && e.code() != ErrorCode::kUnsupported) throw;
    return nullptr;
  }
  const Triangles surface = moved(scaled(std::move(solids[0].surface), placing.factor), placing.by);
  const int sign = wanted.by.sign();
  if (sign == 0) {
    auto rays = std::make_unique<PairRays>(surface, wanted.grid);
    return mapped_rays(std::move(rays), [](int s) { return s <= 0 ? -1 : 1; });
  }
  auto rays = std::make_unique<BallRays>(surface, abs(wanted.by), wanted.grid,
                                         sign > 0 ? BallRays::Side::kSolid : BallRays::Side::kComplement);
  return mapped_rays(std::move(rays), [](int s) { return s <= 0 ? -1 : 1; });
}

RaySourcePointer rays_of(const plane::Shape& shape, const Placing& placing, const Wanted& wanted) {
  if (solid_of(shape)) {
    if (auto rays = surface_rays(shape, placing, wanted)) return rays;
    return body_rays(body(shape), placing, wanted);
  }
  const auto child = [&](const Placing& at) { return rays_of(*shape.children[0], at, wanted); };
  const auto all = [&] {
    std::vector<RaySourcePointer> sources;
    for (std::size_t k = 0; k < shape.children.size(); ++k) {
      const bool without = shape.kind == Kind::kDifference && k > 0;
      sources.push_back(rays_of(*shape.children[k], placing, without ? wanted.turned() : wanted));
    }
    return sources;
  };
  switch (shape.kind) {
    case Kind::kUnion:
      return combined_rays(all(), [](Signs s) { return *std::min_element(s.begin(), s.end()); });
    case Kind::kIntersection:
      return greatest_rays(all());
    case Kind::kDifference:
      return combined_rays(all(), [](Signs s) {
        return std::int8_t(s[0] < 0 && *std::min_element(s.begin() + 1, s.end()) > 0 ? -1 : 1);
      });
    case Kind::kComplement:
      return negated_rays(rays_of(*shape.children[0], placing, wanted.turned()));
    case Kind::kTranslate:
      return child(placing.moved({shape.points[0].x, shape.points[0].y, shape.lift}));
    case Kind::kMirror:
      return child(placing.mirrored());
    case Kind::kClosure:
    case Kind::kRegularize:
      if (!is_solid(*shape.children[0])) refuse(shape, "closure and regularize are computed on lines for solids only");
      return child(placing);
    case Kind::kHull:
    case Kind::kMinkowskiSum:
    case Kind::kOffset:
      return body_rays(body(shape), placing, wanted);
    default:
      refuse(shape, "this kind of shape is not computed on lines");
  }
}

struct Bounds {
  Point low, high;
  bool any = false;
};

/// Of all forms but balls.
std::vector<Point> corners(const Solid& solid) {
  std::vector<Point> out = solid.mesh.vertices;
  for (const plane::Contour& ring : solid.contours) {
    for (const plane::ContourEdge& edge : ring) {
      for (const std::int64_t z : {solid.low, solid.high}) out.push_back({edge.start.x, edge.start.y, z});
    }
  }
  return out;
}

bool goes_on(const plane::Shape& shape) {
  const auto child = [](const auto& c) { return goes_on(*c); };
  const auto& c = shape.children;
  if (shape.kind == Kind::kComplement) return !goes_on(*c[0]);
  if (shape.kind == Kind::kIntersection) return std::all_of(c.begin(), c.end(), child);
  if (shape.kind == Kind::kDifference) return goes_on(*c[0]) && std::none_of(c.begin() + 1, c.end(), child);
  return std::any_of(c.begin(), c.end(), child);
}

void extend(const plane::Shape& shape, const Placing& placing, Bounds& box);

/// What all bounded sets of an intersection have in common; of a difference the first set.
void extend_by_common(const plane::Shape& shape, const Placing& placing, Bounds& box) {
  const std::size_t count = shape.kind == Kind::kDifference ? 1 : shape.children.size();
  Bounds common;
  for (std::size_t k = 0; k < count; ++k) {
    if (goes_on(*shape.children[k])) continue;
    Bounds one;
    extend(*shape.children[k], placing, one);
    if (!common.any) common = one;
    const auto larger = [](const Point& p, const Point& q) {
      return Point{std::max(p.x, q.x), std::max(p.y, q.y), std::max(p.z, q.z)};
    };
    const Point low = larger(common.low, one.low), high = -larger(-common.high, -one.high);
    if (low.x <= high.x && low.y <= high.y && low.z <= high.z) common.low = low, common.high = high;
  }
  extend_box(common.low, box.low, box.high, box.any);
  extend_box(common.high, box.low, box.high, box.any);
}

void extend(const plane::Shape& shape, const Placing& placing, Bounds& box) {
  const bool inner = shape.kind == Kind::kHull || shape.kind == Kind::kMinkowskiSum || shape.kind == Kind::kOffset;
  if (const Solid* solid = solid_of(shape); solid && solid->form != Solid::Form::kBall) {
    for (const Point& p : corners(*solid))
      extend_box(placing.by + Point{placing.factor * p.x, placing.factor * p.y, placing.factor * p.z}, box.low,
                 box.high, box.any);
    return;
  }
  if (solid_of(shape) || inner) {
    const Body made = body(shape);
    const Bounds3 bounds = space::bounds(made);
    const auto corner = [&](const RealVector& p, int up) {
      const auto c = [&](int k) { return static_cast<std::int64_t>(exact::floor(p[k] / Real(made.scale))) + up; };
      const Point at{c(0), c(1), c(2)};
      return placing.by + Point{placing.factor * at.x, placing.factor * at.y, placing.factor * at.z};
    };
    extend_box(corner(bounds.low, 0), box.low, box.high, box.any);
    extend_box(corner(bounds.high, 1), box.low, box.high, box.any);
    return;
  }
  const bool narrows =
      shape.kind == Kind::kIntersection || (shape.kind == Kind::kDifference && !goes_on(*shape.children[0]));
  if (narrows && !goes_on(shape)) return extend_by_common(shape, placing, box);
  const Placing at = shape.kind == Kind::kMirror ? placing.mirrored()
                     : shape.kind == Kind::kTranslate
                         ? placing.moved({shape.points[0].x, shape.points[0].y, shape.lift})
                         : placing;
  for (const plane::ShapePtr& c : shape.children) extend(*c, at, box);
}

}  // namespace

RaySourcePointer shape_rays(const plane::Shape& shape, const RayGrid& grid, const Real& by) {
  return rays_of(shape, {}, {grid, by});
}

ShapeBox shape_box(const plane::Shape& shape) {
  Bounds box;
  extend(shape, {}, box);
  return {box.low, box.high, goes_on(shape)};
}

}  // namespace findspace::space
