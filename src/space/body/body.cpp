// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/body/body.h"

#include <findspace/error.h>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

#include "exact/margins/rounding.h"
#include "space/body/cell_parts.h"
#include "space/body/erosion.h"
#include "space/body/open_union.h"
#include "space/body/shape_topology.h"
#include "space/polytope/flat_core.h"

namespace findspace::space {

using exact::Real;
using exact::Refusal;
using exact::Tried;
using Kind = plane::Shape::Kind;

namespace {

void append(Body& sum, const Body& more) {
  const std::int64_t scale = joint_scale(sum.scale, more.scale);
  if (sum.scale != scale) sum = at_scale(sum, scale);
  Body next = at_scale(more, scale);
  append(sum.around, std::move(next.around), sum.parts.size());
  std::move(next.parts.begin(), next.parts.end(), std::back_inserter(sum.parts));
  sum.rounded += next.rounded;
  sum.moved = std::max(sum.moved, next.moved);
}

std::int64_t in_range(int128 c) {
  if (c > kCoordinateLimit || c < -kCoordinateLimit)
    throw Error(ErrorCode::kOutOfRange, "a coordinate exceeds 2^40 grid steps");
  return static_cast<std::int64_t>(c);
}

/// Of parts of one radius: the hull of the cores, grown by it.
Tried<Body> hull_of_cores(Body body) {
  std::vector<Point> points;
  for (const BodyPart& part : body.parts) {
    if (part.radius != body.parts[0].radius)
      return Refusal("the hull of parts of different radii is not computed in 3D");
    points.insert(points.end(), part.vertices().begin(), part.vertices().end());
  }
  body.parts = {part_of(points, body.parts[0].radius)};
  body.around.clear();
  return body;
}

/// Of a complement what is outside moves the other way.
Tried<Body> offset(Body body, const Real& by) {
  const int sign = body.outside ? -by.sign() : by.sign();
  if (sign < 0) {
    const bool outside = std::exchange(body.outside, false);
    Tried<Body> left = eroded(body, ball(abs(by)));
    if (left) left->outside = outside;
    return left;
  }
  if (sign > 0) {
    for (BodyPart& part : body.parts) part.radius += abs(by) * Real(body.scale);
    body.around.clear();
  }
  return body;
}

/// Whether the shape is no union of polytopes for this or another reason.
bool holds_ball(const plane::Shape& shape) {
  if (const Solid* solid = solid_of(shape)) return solid->form == Solid::Form::kBall;
  if (shape.kind == Kind::kIntersection) {
    return std::any_of(shape.children.begin(), shape.children.end(),
                       [](const auto& c) { return holds_ball(c->kind == Kind::kComplement ? *c->children[0] : *c); });
  }
  return shape.kind == Kind::kOffset || shape.kind == Kind::kComplement ||
         std::any_of(shape.children.begin(), shape.children.end(), [](const auto& c) { return holds_ball(*c); });
}

Tried<Body> children_in_one(const plane::Shape& shape) {
  Body sum;
  for (const plane::ShapePtr& c : shape.children) {
    const Tried<Body> part = try_body(*c);
    if (!part) return part;
    if (part->outside)
      return Refusal("a union or hull with a complement is not computed in 3D for slanted or round shapes");
    append(sum, *part);
  }
  return sum;
}

double corners_of(const Body& body) {
  const auto more = [](double sum, const BodyPart& part) { return sum + double(part.vertices().size()); };
  return std::accumulate(body.parts.begin(), body.parts.end(), 0.0, more);
}

Tried<Body> sum_of(const plane::Shape& sum, const Body& a, const Body& b) {
  if (a.outside || b.outside) return Refusal("a Minkowski sum with a complement is not computed in 3D");
  require_few_corners(sum, corners_of(a) * corners_of(b), double(a.parts.size()) * double(b.parts.size()));
  return minkowski_sum(a, b);
}

/// The node over the body of its first child.
Tried<Body> changed(const plane::Shape& shape, Body body) {
  switch (shape.kind) {
    case Kind::kMinkowskiSum:
    case Kind::kMinkowskiDifference: {
      const Tried<Body> b = try_body(*shape.children[1]);
      if (!b) return b;
      if (shape.kind == Kind::kMinkowskiDifference && may_lack_walls(*shape.children[0])) return walls_are_lacking();
      return shape.kind == Kind::kMinkowskiSum ? sum_of(shape, body, *b) : eroded(body, *b);
    }
    case Kind::kComplement:
      if (may_lack_walls(*shape.children[0])) return walls_are_lacking();
      body.outside = !body.outside;
      return body;
    case Kind::kTranslate:
      return translated(std::move(body), {shape.points[0].x, shape.points[0].y, shape.lift});
    case Kind::kMirror:
      return mirrored(std::move(body));
    case Kind::kOffset:
      if (shape.amount.sign() < 0 && may_lack_walls(*shape.children[0])) return walls_are_lacking();
      return offset(std::move(body), shape.amount);
    default:
      return body;
  }
}

/// The node, where it is not one of polytopes alone.
Tried<Body> mixed(const plane::Shape& shape) {
  if (const Solid* solid = solid_of(shape)) {
    Body ball;
    ball.parts.push_back({std::nullopt, solid->mesh.vertices[0], solid->radius});
    return ball;
  }
  switch (shape.kind) {
    case Kind::kUnion:
      return children_in_one(shape);
    case Kind::kHull: {
      Tried<Body> all = children_in_one(shape);
      return all ? hull_of_cores(*std::move(all)) : all;
    }
    case Kind::kMinkowskiSum:
    case Kind::kMinkowskiDifference:
    case Kind::kComplement:
    case Kind::kInterior:
    case Kind::kClosure:
    case Kind::kRegularize:
    case Kind::kTranslate:
    case Kind::kMirror:
    case Kind::kOffset: {
      Tried<Body> child = try_body(*shape.children[0]);
      return child ? changed(shape, *std::move(child)) : child;
    }
    default:
      break;
  }
  return Refusal("this kind of shape with round parts is not a union of convex parts; state it as one");
}

}  // namespace

std::vector<HalfSpace> BodyPart::planes() const {
  std::vector<HalfSpace> out;
  if (!core) return flat.empty() ? out : flat_planes(flat);
  for (const Plane& p : core->planes()) out.emplace_back(p);
  return out;
}

BodyPart part_of(std::span<const Point> points, Real radius) {
  BodyPart part{std::nullopt, points[0], std::move(radius)};
  auto corners = flat_corners(points);
  if (!corners || (corners->size() > 1 && part.radius.sign() == 0))
    part.core = Polytope::hull(points);
  else if (corners->size() > 1)
    part.flat = *std::move(corners);
  return part;
}

bool Body::round() const {
  return std::any_of(parts.begin(), parts.end(), [](const BodyPart& p) { return p.radius.sign() > 0; });
}

Body body_of(ConvexParts parts) {
  Body body;
  body.scale = parts.scale;
  body.rounded = parts.rounded;
  body.moved = parts.moved;
  body.around = std::move(parts.around);
  for (Polytope& p : parts.parts) body.parts.push_back({std::move(p), {}, Real()});
  return body;
}

Tried<Body> try_body(const plane::Shape& shape) {
  try {
    if (holds_ball(shape)) {
      Tried<Body> made = mixed(shape);
      return made ? std::move(made) : made.refusal().at(shape.place);
    }
    Tried<ConvexParts> parts = try_convex_parts(shape);
    if (!parts) return parts.refusal().at(shape.place);
    return body_of(*std::move(parts));
  } catch (const Error& e) {
    if (shape.place.empty() || !e.place().empty()) throw;
    throw e.within(shape.place);
  }
}

Body body(const plane::Shape& shape) { return try_body(shape).or_throw(); }

Body translated(Body body, const Point& t) {
  const auto by = [&](std::int64_t c, std::int64_t d) { return in_range(c + int128(d) * body.scale); };
  displace(body.around, {t.x * body.scale, t.y * body.scale, t.z * body.scale});
  for (BodyPart& part : body.parts) {
    const auto moved = [&](const Point& p) { return Point{by(p.x, t.x), by(p.y, t.y), by(p.z, t.z)}; };
    part.center = moved(part.center);
    for (Point& v : part.flat) v = moved(v);
    if (!part.core) continue;
    for (const Point& v : part.core->vertices()) {
      by(v.x, t.x);
      by(v.y, t.y);
      by(v.z, t.z);
    }
    part.core = part.core->translated({t.x * body.scale, t.y * body.scale, t.z * body.scale});
  }
  return body;
}

Body at_scale(const Body& body, std::int64_t scale) {
  const std::int64_t factor = scale / body.scale;
  if (factor == 1) return body;
  Body out = body;
  out.scale = scale;
  enlarge(out.around, factor);
  const auto finer = [&](std::int64_t c) {
    if (c > kCoordinateLimit / factor || c < -kCoordinateLimit / factor) throw too_fine();
    return c * factor;
  };
  const auto times = [&](const Point& p) { return Point{finer(p.x), finer(p.y), finer(p.z)}; };
  for (BodyPart& part : out.parts) {
    part.center = times(part.center);
    part.radius *= Real(factor);
    for (Point& v : part.flat) v = times(v);
    if (!part.core) continue;
    std::vector<Point> points;
    for (const Point& v : part.core->vertices()) points.push_back(times(v));
    part.core = Polytope::hull(points);
  }
  return out;
}

Tried<Body> try_united(const std::vector<const Body*>& bodies) {
  Body sum = *bodies[0];
  for (std::size_t i = 1; i < bodies.size(); ++i) {
    if (sum.outside || bodies[i]->outside)
      return Refusal("a list with a complement is not computed in 3D for slanted or round shapes");
    append(sum, *bodies[i]);
  }
  return sum;
}

Body united(const std::vector<const Body*>& bodies) { return try_united(bodies).or_throw(); }

Body minkowski_sum(const Body& a, const Body& b) {
  Body sum;
  sum.scale = joint_scale(a.scale, b.scale);
  sum.rounded = a.rounded + b.rounded;
  sum.moved = std::max(a.moved, b.moved);
  const Body p = at_scale(a, sum.scale), q = at_scale(b, sum.scale);
  for (const BodyPart& x : p.parts) {
    for (const BodyPart& y : q.parts) {
      std::vector<Point> points;
      for (const Point& v : x.vertices())
        for (const Point& w : y.vertices()) points.push_back(v + w);
      sum.parts.push_back(part_of(points, x.radius + y.radius));
    }
  }
  return sum;
}

Body mirrored(Body body) {
  for (BodyPart& part : body.parts) {
    part.center = -part.center;
    for (Point& v : part.flat) v = -v;
    if (part.core) part.core = part.core->mirrored();
  }
  enlarge(body.around, -1);
  return body;
}

int side(const BodyPart& part, const RealVector& at) {
  const std::vector<HalfSpace> planes = part.planes();
  const Vector near = space::rounded(at);
  int most = part.core ? -1 : 0;  // of a core without interior all is surface
  for (const HalfSpace& h : planes) most = std::max(most, h.sign(at, near));
  if (most < 0 || part.radius.sign() == 0) return part.point() ? (at == real(part.center) ? 0 : 1) : most;
  const RealVector off = minus(at, part.point() ? real(part.center) : *nearest_in(planes, at));
  return (dot(off, off) - part.radius * part.radius).sign();
}

Real support(const BodyPart& part, const RealVector& n) {
  const Vector near = space::rounded(n);
  double highest = -exact::kInfinity, size = 0;
  for (const Point& v : part.vertices()) {
    const Vector at = exact::approx(v);
    highest = std::max(highest, dot(near, at));
    size = std::max(size, std::fabs(near.x * at.x) + std::fabs(near.y * at.y) + std::fabs(near.z * at.z));
  }
  std::optional<Real> best;
  for (const Point& v : part.vertices()) {
    if (dot(near, exact::approx(v)) < highest - margin::kRoundings32 * size) continue;
    const Real value = dot(n, real(v));
    if (!best || *best < value) best = value;
  }
  return part.radius.sign() > 0 ? *best + part.radius * sqrt(dot(n, n)) : *best;
}

Real support(const Body& body, const RealVector& n) {
  std::optional<Real> best;
  for (const BodyPart& part : body.parts) {
    const Real value = support(part, n);
    if (!best || *best < value) best = value;
  }
  return *best;
}

namespace {

template <class Set>
Bounds3 bounds_by_support(const Set& set) {
  Bounds3 box;
  for (int k = 0; k < 3; ++k) {
    RealVector n;
    n[k] = Real(1);
    box.high[k] = support(set, n);
    n[k] = Real(-1);
    box.low[k] = -support(set, n);
  }
  return box;
}

}  // namespace

Bounds3 bounds(const BodyPart& part) { return bounds_by_support(part); }
Bounds3 bounds(const Body& body) { return bounds_by_support(body); }

}  // namespace findspace::space
