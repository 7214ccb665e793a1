// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A solid that round ones are cut out of or cut off by (a bowl, a shell, a dome, a lens), which no union of convex
// parts is: the closure of the interior of
//     the union of `parts`, each the closed convex sets `within` less the open convex sets `without`;
//     also what all of `rooms` have in common, less the interior of all of `pillars`.
// The first form serves distances to the solid, the second containment in it. Nodes: those of body.h, and
// intersection, difference and complements in an intersection of any of them, minkowski_difference and offset by a
// negative amount of these and of bodies (erosion.h); translate, mirror, union (then there are no rooms). Guarantee:
// exact, but for vertices rounded and counted as in body.h. Cost: an intersection has a part for each pair of parts
// whose boxes meet, a difference one for each part of the first shape and each way out of the second. Keywords:
// constructive solid geometry, disjunctive normal form.
#pragma once

#include <cstdint>
#include <vector>

#include "space/body/body.h"

namespace findspace::space {

struct CutPart {
  std::vector<BodyPart> within, without;  // at least one within
};

struct CutBody {
  std::vector<CutPart> parts;
  std::vector<Body> rooms, pillars;
  std::int64_t scale = 1;  // coordinates and radii are in steps / scale
};

/// Throws Error(kUnsupported) as body() for nodes that have neither form or hold nothing round, and beyond 10,000
/// parts.
CutBody cut_body(const plane::Shape& shape);
/// Of a minkowski_difference or an offset by a negative amount, also where it is a body: of a shape with flat faces the
/// plain set, sheets and single points included.
CutBody cut_erosion(const plane::Shape& shape);
/// A bounded body in that form.
CutBody uncut(Body body);
/// The union; it has no rooms.
CutBody united(const CutBody& first, const CutBody& second);
CutBody common(const CutBody& first, const CutBody& second);
/// The first less the second.
CutBody less(const CutBody& first, const CutBody& second);
CutBody translated(const CutBody& body, const Point& by);
CutBody mirrored(const CutBody& body);
/// What the solid leaves of a box; without rooms.
CutBody left_in_box(const CutBody& body, const Point& low, const Point& high);
/// The same set in finer steps; `scale` is a multiple of its own.
CutBody at_scale(const CutBody& body, std::int64_t scale);

/// The smallest box that holds what the boxes of all its sets `within` have in common.
Bounds3 bounds(const CutPart& part);
/// A box that holds all parts.
Bounds3 bounds(const CutBody& body);

}  // namespace findspace::space
