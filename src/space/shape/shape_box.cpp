// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The box of a shape tree, for the lines that look at it.
#include <findspace/error.h>

#include <algorithm>

#include "space/body/body.h"
#include "space/convolution/ray_solids.h"
#include "space/mesh/placing.h"
#include "space/polytope/solid.h"
#include "space/shape/shape_rays.h"

namespace findspace::space {
namespace {

using exact::Real;
using Kind = plane::Shape::Kind;

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
  if (shape.kind == Kind::kBoundary) return false;  // of a bounded set or of the complement of one
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
    if (low.x <= high.x && low.y <= high.y && low.z <= high.z) {
      common.low = low;
      common.high = high;
    }
  }
  extend_box(common.low, box.low, box.high, box.any);
  extend_box(common.high, box.low, box.high, box.any);
}

/// A Minkowski difference lies in the sum, and so does its frontier.
void extend_by_difference(const plane::Shape& shape, const Placing& placing, Bounds& box) {
  Bounds a, b;
  extend(*shape.children[0], {}, a);
  if (shape.kind == Kind::kOffset) {
    const auto r = static_cast<std::int64_t>(exact::floor(-shape.amount)) + 1;
    b.low = {-r, -r, -r};
    b.high = {r, r, r};
  } else {
    extend(*shape.children[1], {}, b);
  }
  extend_box(placing.at(a.low + b.low), box.low, box.high, box.any);
  extend_box(placing.at(a.high + b.high), box.low, box.high, box.any);
}

void extend(const plane::Shape& shape, const Placing& placing, Bounds& box) {
  const bool shrinks = shape.kind == Kind::kOffset && shape.amount.sign() < 0;
  const bool inner =
      shape.kind == Kind::kHull || shape.kind == Kind::kMinkowskiSum || (shape.kind == Kind::kOffset && !shrinks);
  if (const Solid* solid = solid_of(shape); solid && solid->form != Solid::Form::kBall) {
    for (const Point& p : corners(*solid)) extend_box(placing.at(p), box.low, box.high, box.any);
    return;
  }
  if (solid_of(shape) || inner) {
    const Body made = body(shape);
    const Bounds3 bounds = space::bounds(made);
    const auto corner = [&](const RealVector& p, int up) {
      const auto c = [&](int k) { return static_cast<std::int64_t>(exact::floor(p[k] / Real(made.scale))) + up; };
      return placing.at({c(0), c(1), c(2)});
    };
    extend_box(corner(bounds.low, 0), box.low, box.high, box.any);
    extend_box(corner(bounds.high, 1), box.low, box.high, box.any);
    return;
  }
  if (shrinks || shape.kind == Kind::kMinkowskiDifference) return extend_by_difference(shape, placing, box);
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

ShapeBox shape_box(const plane::Shape& shape) {
  Bounds box;
  extend(shape, {}, box);
  return {box.low, box.high, goes_on(shape)};
}

}  // namespace findspace::space
