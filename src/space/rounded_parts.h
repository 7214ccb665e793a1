// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A body of space as a finite union of rounded convex parts: a convex polytope or a point, its core, grown by a ball of
// radius >= 0. Polytopes have radius 0, balls are points with a radius; an offset outwards of either, a sum and a hull
// of parts with one radius keep their cores. Guarantee: exact as convex_parts.h, whose parts the cores without balls
// are. Cost: as there. Source: phi.md 7, 10. Keywords: sphere-swept volume, rounded box.
#pragma once

#include <optional>
#include <vector>

#include "space/convex_parts.h"

namespace findspace::space {

struct RoundedPart {
  std::optional<Polytope> core;  // nothing: the point `center`
  Point center;
  exact::Real radius;  // in the same steps; > 0 where the core is a point

  std::vector<Point> points() const;  // the vertices of the core
};

struct RoundedParts {
  std::vector<RoundedPart> parts;
  std::int64_t scale = 1;  // coordinates are in grid steps / scale
  int rounded = 0;         // vertices that had to be rounded
  double moved = 0;        // the farthest, in grid steps
};

/// Of a 3D shape tree: what convex_parts takes, balls, and offset, translate, mirror, union, hull (of one radius) and
/// minkowski_sum of these. Throws Error(kUnsupported) for a shape that is no such union, Error(kGeometry) for flat
/// ones.
RoundedParts rounded_parts(const plane::Shape& shape);

/// The same parts at a scale that is a multiple of theirs. Throws Error(kOutOfRange) beyond 2^40 steps.
std::vector<RoundedPart> at_scale(const RoundedParts& parts, std::int64_t scale);

}  // namespace findspace::space
