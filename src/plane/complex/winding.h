// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Winding numbers on every cell of an arrangement of directed closed curves, each curve thought to be displaced by an
// infinitesimal to one of its sides, so that the cells of the curves themselves have a number too.
//
// A piece adds +1 to the faces on the left of its direction against those on its right, and lies displaced to its left
// or right
// (`Chain::displaced_left`). The number of an edge is that of the side its chains do not lie on, counted chain by
// chain; the number of a vertex counts the chains and corners that pass between it and a neighbouring face. This is
// how open (displaced inwards) and closed (displaced outwards) sums are decided apart on slots and single points.
// Guarantee: exact. Cost: linear. Source: docs/decisions/0002-displaced-winding-numbers.md.
#pragma once

#include <cstdint>
#include <vector>

#include "plane/complex/arrangement.h"

namespace findspace::plane {

/// How a piece is travelled; one per piece.
struct Chain {
  bool forward = true;         // from p0 to p1
  bool displaced_left = true;  // of the direction of travel
  std::int32_t weight = 1;     // how often it counts
};

/// The path turns from piece `in` into piece `out` at the end of `in`. Around the common point the displaced path
/// runs from the back direction of `in` to the direction of `out`: clockwise if both lie displaced to the left,
/// counter-clockwise if both to the right, else as `rotation` says (+1 counter-clockwise, -1 clockwise, 0 not at all;
/// at a cusp, whose ends have one tangent, the way on which they are next to each other).
struct Corner {
  Index in = 0, out = 0;
  std::int8_t rotation = 0;
  std::int8_t extra = 0;  // whole counter-clockwise rounds beyond that; only where arcs of one radius lie in each other
  std::int32_t weight =
      1;  // how often it counts; those of the corners at an end of a piece add up to that of the piece
};

struct Windings {
  std::vector<std::int32_t> faces, edges, vertices;
};

/// Which vertices get a number: all, or only those where all faces and edges around have a positive number (an open set
/// is decided by its neighbours everywhere else); the others get kUnwanted.
enum class VertexScope { kInside, kAll };
inline constexpr std::int32_t kUnwanted = INT32_MIN;

/// `base`: number of the unbounded face.
Windings windings(const Arrangement& a, const std::vector<Chain>& chains, const std::vector<Corner>& corners,
                  std::int32_t base, VertexScope scope = VertexScope::kInside);

/// A part of the plane where all numbers are known to be positive, and where curves may be missing. Outside it all
/// curves are there.
struct InnerPart {
  /// A point of each connected piece of what lies outside, with the number of the face it lies in.
  struct Seed {
    Index point;
    std::int32_t number;
  };

  std::vector<Seed> seeds;
  Index first_border = 0;         // pieces from here on are the border of the part and have no weight
  std::vector<char> left_inside;  // of each of these: the part lies on the left from p0 to p1
};

/// Numbers inside the part are only some that are positive.
Windings windings(const Arrangement& a, const std::vector<Chain>& chains, const std::vector<Corner>& corners,
                  const InnerPart& inner);

/// Winding numbers of the faces alone.
std::vector<std::int32_t> face_windings(const Arrangement& a, const std::vector<char>& forward, std::int32_t base);

}  // namespace findspace::plane
