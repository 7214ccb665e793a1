// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Shapes of what an Outline has drawn. Closed chains and circles nest by the even-odd rule or are one ring and its
// holes; open chains are polylines. Each function throws Error(kGeometry) where rings cross; the context counts points
// that come twice and what rounding moved. Cost: O(n log n). Keywords: even-odd rule, contour.
#pragma once

#include <string>
#include <vector>

#include "io/text/read_outline.h"

namespace findspace::io {

/// Joins open chains whose ends are the same grid point; throws Error(kGeometry) where an odd number above one meets.
/// `step`: of the grid, for the message.
void join_open_chains(Drawing& drawing, double step);
int open_chains(const Drawing& drawing);
/// Whether it has segments without length alone.
bool is_point(const Chain& chain);

/// What the rules say of open chains: joins ends that are the same grid point, then those no farther apart than the
/// gap, the nearest first, and notes how many and the widest gap. Throws Error(kGeometry) for chains that stay open,
/// with the least gap that is left, unless the rules take them for lines. `name`: what notes call the drawing.
void close_outlines(Drawing& drawing, ReadContext& context, const std::string& name);

/// Closed chains and circles by even-odd nesting, each outer ring with its holes one shape, or all as one where rings
/// touch in common corners (plane/build/touching_rings.h); then the open chains as polylines, then the points.
std::vector<plane::ShapePtr> parts_of(Drawing drawing, ReadContext& context, const std::string& place);
/// The same as one shape: the part, or the union of the parts.
plane::ShapePtr shape_of(Drawing drawing, ReadContext& context, const std::string& place);
/// The parts of a whole drawing, whose open chains are closed as the rules say; where each outline is a part, it has
/// the name that the file says. Errors name the drawing.
std::vector<plane::ShapePtr> closed_parts(Drawing drawing, ReadContext& context, const std::string& name);
/// Whether an outline of one drawing lies within that of another. (No statement where outlines cross.)
bool any_within_another(const std::vector<Drawing>& drawings, const ReadContext& context);
/// Whether the outlines enclose the same where they count by their direction: where no other part is enclosed by the
/// rule nonzero than by even-odd. (No statement where outlines cross.)
bool encloses_alike(const Drawing& drawing, const ReadContext& context);
/// What is drawn besides.
void append(Drawing& all, const Drawing& more);
/// All chains as polylines, also those that come back to their first point, and the points.
plane::ShapePtr lines_of(Drawing drawing, ReadContext& context, const std::string& place);
/// The closed chains: the first as outer ring, the others as its holes.
plane::ShapePtr polygon_of(Drawing drawing, ReadContext& context, const std::string& place);

/// The shapes as one: a single one is itself, several are a union (a collection whose parts keep their names if asked).
plane::ShapePtr united(std::vector<plane::ShapePtr> parts, const std::string& place, bool collection = false);

}  // namespace findspace::io
