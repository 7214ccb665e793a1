// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/shape_rays.h"

#include <findspace/error.h>

#include <algorithm>

#include "space/body.h"
#include "space/piece_rays.h"
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

/// The closed parts of a body.
RaySourcePointer body_rays(const Body& body, const Placing& placing, const RayGrid& grid) {
  const Real scale(body.scale);
  const RealVector by = scaled(scale, real(placing.by));
  const auto placed = [&](const RealVector& p) { return plus(placing.factor < 0 ? negated(p) : p, by); };
  std::vector<LinePiece> pieces;
  for (const BodyPart& part : body.parts) {
    if (!part.core) {
      pieces.push_back(ball_piece(placed(real(part.center)), part.radius));
      continue;
    }
    RealVector low = placed(real(part.vertices()[0])), high = low;
    for (const Point& v : part.vertices()) {
      const RealVector p = placed(real(v));
      for (int k = 0; k < 3; ++k) low[k] = std::min(low[k], p[k]), high[k] = std::max(high[k], p[k]);
    }
    std::vector<HalfSpace> planes;
    ConvexRegion region(low, high);
    for (const Plane& p : part.core->planes()) {
      const RealVector n = placing.factor < 0 ? negated(real(p.normal)) : real(p.normal);
      planes.emplace_back(n, Real(p.offset) - dot(n, by));
      region.cut(planes.back());
    }
    pieces.push_back(polytope_piece(std::move(planes), rounded(low), rounded(high)));
    if (part.radius.sign() > 0) add_round_pieces(region, part.radius, pieces);
  }
  const int inside = body.outside ? 1 : -1;
  auto rays = std::make_unique<PieceRays>(pieces, body.scale, grid);
  // The closure of a complement keeps the frontier, too.
  return mapped_rays(std::move(rays), [=](int s) { return s == 0 ? -1 : s < 0 ? inside : -inside; });
}

RaySourcePointer rays_of(const plane::Shape& shape, const Placing& placing, const RayGrid& grid) {
  if (solid_of(shape)) return body_rays(body(shape), placing, grid);
  const auto child = [&](const Placing& at) { return rays_of(*shape.children[0], at, grid); };
  const auto all = [&] {
    std::vector<RaySourcePointer> sources;
    for (const plane::ShapePtr& c : shape.children) sources.push_back(rays_of(*c, placing, grid));
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
      return negated_rays(child(placing));
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
      return body_rays(body(shape), placing, grid);
    default:
      refuse(shape, "this kind of shape is not computed on lines");
  }
}

struct Bounds {
  Point low, high;
  bool any = false;
};

void extend(const plane::Shape& shape, const Placing& placing, Bounds& box) {
  const bool inner = shape.kind == Kind::kHull || shape.kind == Kind::kMinkowskiSum || shape.kind == Kind::kOffset;
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
  const Placing at = shape.kind == Kind::kMirror ? placing.mirrored()
                     : shape.kind == Kind::kTranslate
                         ? placing.moved({shape.points[0].x, shape.points[0].y, shape.lift})
                         : placing;
  for (const plane::ShapePtr& c : shape.children) extend(*c, at, box);
}

bool goes_on(const plane::Shape& shape) {
  const auto child = [](const auto& c) { return goes_on(*c); };
  const auto& c = shape.children;
  if (shape.kind == Kind::kComplement) return !goes_on(*c[0]);
  if (shape.kind == Kind::kIntersection) return std::all_of(c.begin(), c.end(), child);
  if (shape.kind == Kind::kDifference) return goes_on(*c[0]) && std::none_of(c.begin() + 1, c.end(), child);
  return std::any_of(c.begin(), c.end(), child);
}

}  // namespace

RaySourcePointer shape_rays(const plane::Shape& shape, const RayGrid& grid) { return rays_of(shape, {}, grid); }

ShapeBox shape_box(const plane::Shape& shape) {
  Bounds box;
  extend(shape, {}, box);
  return {box.low, box.high, goes_on(shape)};
}

}  // namespace findspace::space
