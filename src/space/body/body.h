// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A solid shape as the distances of space see it: the closed bounded set that is the union of finitely many parts, each
// the sum of a convex polytope (or a polygon, segment or point) and a ball of radius >= 0. So a ball is a point with a
// radius, a capsule a segment with one, an offset polytope keeps its true round edges, and a mesh is its exact convex
// parts (convex_parts.h). Or, if `outside`, the closure of the complement of that union. Nodes: polytope, box, ball,
// prism, mesh; union, intersection, difference, complement, interior, closure, regularize (the distances take closures,
// so the last three change nothing here), translate, mirror, offset, hull of parts of one radius, minkowski_sum;
// minkowski_difference where erosion.h has a body; intersection and difference of polytopes and meshes only. Guarantee:
// exact, but for vertices rounded and counted by convex_parts.h. Cost: as there. Source: phi.md 7, 10. Keywords: solid
// model, constructive solid geometry, sphere-swept volume, rounded box.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "exact/number/tried.h"
#include "space/body/convex_parts.h"
#include "space/polytope/real_vector.h"

namespace findspace::space {

struct BodyPart {
  std::optional<Polytope> core;  // none: the point `center`, or `flat`
  Point center;
  exact::Real radius;         // in the same steps as the coordinates
  std::vector<Point> flat{};  // the corners of a core without interior, as of flat_corners(): two or more

  bool point() const { return !core && flat.empty(); }
  std::span<const Point> vertices() const {
    return core ? core->vertices() : flat.empty() ? std::span<const Point>(&center, 1) : std::span<const Point>(flat);
  }
  /// The core is {x : every plane <= 0}; none of a point.
  std::vector<HalfSpace> planes() const;
};

/// The hull of the points grown by the radius; without a radius they have to enclose a volume or be one point.
BodyPart part_of(std::span<const Point> points, exact::Real radius);

struct Body {
  std::vector<BodyPart> parts;
  bool outside = false;    // the closure of the complement of the parts
  std::int64_t scale = 1;  // coordinates and radii are in steps / scale
  int rounded = 0;         // vertices that had to be rounded, and the farthest move in grid steps
  double moved = 0;
  std::vector<PlacedSurroundings> around{};  // of those of its parts that make up a mesh

  bool round() const;  // whether a part has a radius
  /// A single part: convex.
  bool convex() const { return parts.size() == 1 && !outside; }
};

/// Refuses a node that such parts cannot represent; throws Error(kGeometry) for one without interior,
/// Error(kOutOfRange) beyond 2^40 steps.
exact::Tried<Body> try_body(const plane::Shape& shape);
/// The same; Error(kUnsupported) instead of a refusal.
Body body(const plane::Shape& shape);
Body body_of(ConvexParts parts);
/// The same set in finer steps; `scale` is a multiple of its own.
Body at_scale(const Body& body, std::int64_t scale);
/// Moved by whole grid steps.
Body translated(Body body, const Point& by);
/// The union; a complement among several is refused.
exact::Tried<Body> try_united(const std::vector<const Body*>& bodies);
Body united(const std::vector<const Body*>& bodies);

/// The parts themselves, whether or not it is their outside.
inline Body inside_of(Body body) {
  body.outside = false;
  return body;
}
/// The reflection through the origin.
Body mirrored(Body body);
/// Part by part: cores add up, and so do radii. Neither `outside`.
Body minkowski_sum(const Body& a, const Body& b);

/// The smallest box with the parts.
struct Bounds3 {
  RealVector low, high;
};
Bounds3 bounds(const BodyPart& part);
Bounds3 bounds(const Body& body);

/// -1 within, 0 on its surface, 1 outside.
int side(const BodyPart& part, const RealVector& at);

/// n . x + offset <= 0 for all x of the part: the least offset.
exact::Real support(const BodyPart& part, const RealVector& n);
/// max n . x over the body.
exact::Real support(const Body& body, const RealVector& n);

}  // namespace findspace::space
