// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A 2D shape as the scene states it: a tree of primitives on the decimal grid and constructive nodes over them.
// Nothing is computed here; `build(shape)` in build.h turns a tree into the exact point set (`Region`).
// All coordinates are integers in grid steps; radii, offsets and the centre of an arc are exact reals in grid steps.
#pragma once

#include <compare>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "exact/number/real.h"

namespace findspace::plane {

/// A point of the decimal grid, in grid steps; |x|, |y| <= 2^40.
struct GridPoint {
  std::int64_t x = 0, y = 0;
  friend auto operator<=>(const GridPoint&, const GridPoint&) = default;
};

/// The circle of an arc: its centre (cx, cy) and its radius r > 0.
struct ArcCircle {
  exact::Real cx, cy, r;
};

/// One edge of a contour, from `start` to the start of the next edge: a segment, or the arc of a circle,
/// counter-clockwise if `ccw`. Both ends of an arc lie exactly on its circle.
struct ContourEdge {
  GridPoint start;
  std::shared_ptr<const ArcCircle> arc{};  // null: a segment
  bool ccw = true;
};

/// A closed ring (or, as a polyline, an open chain whose last edge is only its end point).
using Contour = std::vector<ContourEdge>;

struct CellComplex;
struct Shape;
using ShapePtr = std::shared_ptr<const Shape>;

struct Shape {
  enum class Kind {
    kRings,     // contours[0] the outer ring, the rest holes: the closed set between them. Validated, outer ring
                // counter-clockwise, holes clockwise.
    kDisc,      // closed disc about points[0] with radius `amount`
    kPoints,    // isolated points
    kPolyline,  // open chain contours[0], a set without interior
    kCells,     // the set `cells`
    kUnion,
    kIntersection,
    kDifference,
    kComplement,
    kInterior,
    kClosure,
    kBoundary,
    kRegularize,
    kTranslate,  // by points[0], in 3D and by `lift` along z
    kRotate,     // `degrees` counter-clockwise about points[0]; multiples of 90 are exact, others round vertices once
    kMirror,     // reflection through the origin
    kMinkowskiSum,
    kMinkowskiDifference,  // a (+) b ; a (-) b = AND_{q in b} (a + q)   (distances.md 1.3)
    kOffset,               // by `amount`: > 0 all points no farther from it, < 0 erodes by the closed ball
    kHull                  // of all children together
  };
  Kind kind = Kind::kPoints;
  std::string name;                // its name in the scene, empty for an inline shape
  std::string place;               // where the scene states it, for messages
  std::vector<ShapePtr> children;  // of constructive nodes, in order
  std::vector<Contour> contours;
  std::vector<GridPoint> points;
  exact::Real amount{};  // radius or offset, in grid steps
  exact::Real degrees{};
  std::int64_t lift = 0;                     // of kTranslate in 3D
  std::shared_ptr<const CellComplex> cells;  // of kCells: a Region
  bool collection = false;                   // a kUnion written as a list: its parts keep their names for reports
  std::shared_ptr<const void> solid;         // a 3D primitive: a space::Solid, opaque to this layer; null in 2D
};

}  // namespace findspace::plane
