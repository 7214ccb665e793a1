// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/rounded_parts.h"

#include <findspace/error.h>

#include <algorithm>
#include <numeric>

namespace findspace::space {
namespace {

using exact::Real;
using Kind = plane::Shape::Kind;

/// Whether anything round is in the tree.
bool is_round(const plane::Shape& shape) {
  if (const Solid* solid = solid_of(shape)) return solid->form == Solid::Form::kBall;
  return shape.kind == Kind::kOffset || std::any_of(shape.children.begin(), shape.children.end(),
                                                    [](const plane::ShapePtr& child) { return is_round(*child); });
}

RoundedPart part_of(const std::vector<Point>& core, Real radius) {
  RoundedPart part{std::nullopt, core[0], std::move(radius)};
  if (core.size() > 1) part.core = Polytope::hull(core);
  return part;
}

std::int64_t on_grid(int128 c) {
  if (c > kCoordinateLimit || c < -kCoordinateLimit)
    throw Error(ErrorCode::kOutOfRange, "a vertex of a convex part is beyond 2^40 grid steps");
  return static_cast<std::int64_t>(c);
}

/// Every vertex of every core changed.
template <class Change>
RoundedParts changed(RoundedParts parts, Change change) {
  for (RoundedPart& part : parts.parts) {
    std::vector<Point> core;
    for (const Point& p : part.points()) core.push_back(change(p, parts.scale));
    part = part_of(core, part.radius);
  }
  return parts;
}

void take_rounding(RoundedParts& to, const RoundedParts& from) {
  to.rounded += from.rounded;
  to.moved = std::max(to.moved, from.moved);
}

RoundedParts all_children(const plane::Shape& shape) {
  RoundedParts sum;
  for (const plane::ShapePtr& child : shape.children) {
    const RoundedParts more = rounded_parts(*child);
    const std::int64_t scale = std::lcm(sum.scale, more.scale);
    std::vector<RoundedPart> parts = at_scale(sum, scale), others = at_scale(more, scale);
    parts.insert(parts.end(), others.begin(), others.end());
    sum.parts = std::move(parts);
    sum.scale = scale;
    take_rounding(sum, more);
  }
  return sum;
}

RoundedParts hull_of(RoundedParts parts) {
  std::vector<Point> points;
  for (const RoundedPart& part : parts.parts) {
    if (part.radius != parts.parts[0].radius) {
      throw Error(ErrorCode::kUnsupported, "the hull of parts with different radii has no polyhedral core");
    }
    const std::vector<Point> core = part.points();
    points.insert(points.end(), core.begin(), core.end());
  }
  parts.parts = {part_of(points, parts.parts[0].radius)};
  return parts;
}

RoundedParts sum_of(const plane::Shape& a, const plane::Shape& b) {
  const RoundedParts p = rounded_parts(a), q = rounded_parts(b);
  RoundedParts sum;
  sum.scale = std::lcm(p.scale, q.scale);
  take_rounding(sum, p);
  take_rounding(sum, q);
  const std::vector<RoundedPart> qs = at_scale(q, sum.scale);
  for (const RoundedPart& x : at_scale(p, sum.scale)) {
    for (const RoundedPart& y : qs) {
      std::vector<Point> points;
      for (const Point& v : x.points()) {
        for (const Point& w : y.points()) points.push_back(v + w);
      }
      sum.parts.push_back(part_of(points, x.radius + y.radius));
    }
  }
  return sum;
}

RoundedParts offset_of(const plane::Shape& shape) {
  if (shape.amount.sign() < 0)
    throw Error(ErrorCode::kUnsupported, "an offset inwards has no convex parts with a ball; state it as polytopes");
  RoundedParts parts = rounded_parts(*shape.children[0]);
  for (RoundedPart& part : parts.parts) part.radius += shape.amount * Real(parts.scale);
  return parts;
}

RoundedParts of_polytopes(const plane::Shape& shape) {
  ConvexParts parts = convex_parts(shape);
  RoundedParts result;
  result.scale = parts.scale;
  result.rounded = parts.rounded;
  result.moved = parts.moved;
  for (Polytope& p : parts.parts) result.parts.push_back({std::move(p), {}, Real()});
  return result;
}

RoundedParts node_parts(const plane::Shape& shape) {
  switch (shape.kind) {
    case Kind::kUnion:
      return all_children(shape);
    case Kind::kInterior:
    case Kind::kRegularize:
    case Kind::kClosure:
      return rounded_parts(*shape.children[0]);
    case Kind::kHull:
      return hull_of(all_children(shape));
    case Kind::kMinkowskiSum:
      return sum_of(*shape.children[0], *shape.children[1]);
    case Kind::kOffset:
      return offset_of(shape);
    case Kind::kMirror:
      return changed(rounded_parts(*shape.children[0]), [](const Point& p, std::int64_t) { return -p; });
    case Kind::kTranslate:
      return changed(rounded_parts(*shape.children[0]), [&](const Point& p, std::int64_t scale) {
        return Point{on_grid(p.x + int128(shape.points[0].x) * scale), on_grid(p.y + int128(shape.points[0].y) * scale),
                     on_grid(p.z + int128(shape.lift) * scale)};
      });
    default:
      throw Error(ErrorCode::kUnsupported,
                  "this kind of shape with round parts is no union of convex parts; state it as one");
  }
}

}  // namespace

std::vector<Point> RoundedPart::points() const {
  if (!core) return {center};
  return {core->vertices().begin(), core->vertices().end()};
}

RoundedParts rounded_parts(const plane::Shape& shape) {
  if (!is_round(shape)) return of_polytopes(shape);
  try {
    if (const Solid* ball = solid_of(shape)) return {{{std::nullopt, ball->mesh.vertices[0], ball->radius}}, 1, 0, 0};
    return node_parts(shape);
  } catch (const Error& e) {
    if (shape.place.empty() || !e.place().empty()) throw;
    throw e.within(shape.place);
  }
}

std::vector<RoundedPart> at_scale(const RoundedParts& parts, std::int64_t scale) {
  const std::int64_t factor = scale / parts.scale;
  if (factor == 1) return parts.parts;
  std::vector<RoundedPart> scaled;
  for (const RoundedPart& part : parts.parts) {
    std::vector<Point> core;
    for (const Point& p : part.points())
      core.push_back({on_grid(int128(p.x) * factor), on_grid(int128(p.y) * factor), on_grid(int128(p.z) * factor)});
    scaled.push_back(part_of(core, part.radius * Real(factor)));
  }
  return scaled;
}

}  // namespace findspace::space
