// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A 3D shape tree as closed surfaces and balls whose union is the shape, for ray maps: polytope, box, prism, mesh,
// ball, and union, translate, mirror, closure, regularize of such. Nothing is cut into convex parts. Guarantee: exact.
// Keywords: boundary representation.
#pragma once

#include <memory>
#include <vector>

#include "exact/number/real.h"
#include "exact/number/tried.h"
#include "space/convolution/ray_boxes.h"

namespace findspace::space {

struct RaySolid {
  Triangles surface;  // empty for a ball
  Point center;
  exact::Real radius{};  // of a ball, in grid steps
  /// Of the surface, where it was made to see that it is simple; null where something has been done to the surface.
  std::shared_ptr<const RaySheet> sheet{};
  bool inner_walls = false;  // faces lie on each other, the solid on both sides: they are no frontier of it
  bool ball() const { return surface.faces.empty(); }
};

/// Triangles from which on a solid that is not convex is taken by its surface: its convex parts are many, and their
/// corners off the grid.
inline constexpr std::size_t kManyFaces = 120;

RaySolid moved(RaySolid solid, const Point& by);
/// In the origin.
RaySolid mirrored(RaySolid solid);
/// Its sheet, made where it is missing; of no ball.
std::shared_ptr<const RaySheet> sheet_of(const RaySolid& solid);

/// A surface, of one piece without holes, with no edge bent inward.
bool is_convex(const RaySolid& solid);

/// Refuses other nodes and what lies too far out with kUnsupported, surfaces that cross themselves or are not closed
/// with kGeometry.
exact::Tried<std::vector<RaySolid>> try_ray_solids(const plane::Shape& shape);
/// The same; throws the error of a refusal.
std::vector<RaySolid> ray_solids(const plane::Shape& shape);

/// The smallest box on the grid that holds them too.
void extend_box(const Point& point, Point& low, Point& high, bool& any);
void extend_box(const std::vector<RaySolid>& solids, Point& low, Point& high, bool& any);

}  // namespace findspace::space
