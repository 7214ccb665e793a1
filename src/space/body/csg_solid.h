// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A solid that round ones are cut out of or cut off by (a bowl, a shell, a dome, a lens), which no union of convex
// parts is: the closure of the interior of
//     the union of `parts`, each the closed convex sets `within` less the open convex sets `without`;
//     also what all of `containers` have in common, less the interior of all of `obstacles`.
// The first form serves distances to the solid, the second containment in it. Nodes: those of body.h, and
// intersection, difference and complements in an intersection of any of them, minkowski_difference and offset by a
// negative amount of these and of bodies (erosion.h); translate, mirror, union (then there are no containers).
// Guarantee: exact, but for vertices rounded and counted as in body.h. Cost: an intersection has a part for each pair
// of parts whose boxes meet, a difference one for each part of the first shape and each way out of the second.
// Keywords: constructive solid geometry, disjunctive normal form.
#pragma once

#include <cstdint>
#include <vector>

#include "space/body/body.h"

namespace findspace::space {

struct CsgPart {
  std::vector<BodyPart> within, without;  // at least one within
};

struct CsgSolid {
  std::vector<CsgPart> parts;
  std::vector<Body> containers, obstacles;
  std::int64_t scale = 1;  // coordinates and radii are in steps / scale
  bool walls = false;      // `parts` may hold flat walls besides; the second form has none
  int rounded = 0;         // vertices that had to be rounded, and the farthest move in grid steps
  double moved = 0;
};

/// Refuses as try_body() nodes that have neither form or hold nothing round, and more than 10,000 parts.
exact::Tried<CsgSolid> try_csg_solid(const plane::Shape& shape);
CsgSolid csg_solid(const plane::Shape& shape);
/// Of a minkowski_difference or an offset by a negative amount, also where it is a body: of a shape with flat faces the
/// plain set, sheets and single points included.
exact::Tried<CsgSolid> cut_erosion(const plane::Shape& shape);
/// A bounded body in that form.
CsgSolid uncut(Body body);
/// The union; it has no containers.
CsgSolid united(const CsgSolid& first, const CsgSolid& second);
/// What becomes of parts without interior; kRefused: polytopes that have such a piece in common, which no other part
/// holds, are refused.
enum class FlatParts { kDropped, kKept, kRefused };
/// What both have in common; more than 10,000 parts are refused.
exact::Tried<CsgSolid> common(const CsgSolid& first, const CsgSolid& second, FlatParts flats);
/// The first less the second; more than 10,000 parts are refused.
exact::Tried<CsgSolid> less(const CsgSolid& first, const CsgSolid& second, FlatParts flats);
/// Whether a face of the first and one of the sets of the second may lie on each other.
bool may_be_flush(const CsgSolid& first, const CsgSolid& second);
/// The closure of the interior. Polytopes that are taken away are cut out as cells where they touch each other or are
/// flush with a face of what they are taken from. Where round surfaces do so `walls` is set. Still left are an edge or
/// a corner on a round face of what is taken away, and lines and points in which only faces of several sets meet. So is
/// what is flush where cells do not come to lie on a grid.
exact::Tried<CsgSolid> without_flat_places(const CsgSolid& body);
CsgSolid translated(const CsgSolid& body, const Point& by);
CsgSolid mirrored(const CsgSolid& body);
/// What the solid leaves of a box; without containers, in the same steps. More than 10,000 parts are refused.
exact::Tried<CsgSolid> left_in_box(const CsgSolid& body, const Point& low, const Point& high);
/// The same set in finer steps; `scale` is a multiple of its own.
CsgSolid at_scale(const CsgSolid& body, std::int64_t scale);

/// The smallest box that holds what the boxes of all its sets `within` have in common.
Bounds3 bounds(const CsgPart& part);
/// A box that holds all parts.
Bounds3 bounds(const CsgSolid& body);

}  // namespace findspace::space
