// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Pads of footprints: circles, rectangles, ovals, trapezoids, rectangles with round corners, and custom shapes as the
// union of their anchor and primitives. A pad stands where its footprint's rotation brings it; its own angle counts
// from the board's axes. Guarantee: exact at multiples of 90 degrees, else points are put on the grid once.
#pragma once

#include <optional>

#include "io/board/board_graphics.h"
#include "io/board/sexpr.h"
#include "io/text/read_context.h"
#include "io/text/read_transform.h"
#include "plane/contour/shape.h"

namespace findspace::io {

struct PadShapes {
  plane::ShapePtr copper;
  plane::ShapePtr hole;  // null: not drilled
};

/// `footprint` maps the footprint's coordinates to the board's.
PadShapes read_pad(const Sexpr& pad, const Affine& footprint, ReadContext& context);
/// A box about the copper of a pad, in the pad's own coordinates: about its place, not turned.
Extent pad_extent(const Sexpr& pad);

/// (at x y [angle]) as a map: the point, and the rotation counter-clockwise as it is seen where y runs downwards.
Affine placement_of(const Sexpr& at);
exact::Real angle_of(const Sexpr& at);

/// The points no farther than `width` / 2 from a chain of points (in grid steps): a track.
plane::ShapePtr stroke(plane::Contour chain, const exact::Real& width, const std::string& place);
/// The disc about a point.
plane::ShapePtr disc(plane::GridPoint center, const exact::Real& radius, const std::string& place);

}  // namespace findspace::io
