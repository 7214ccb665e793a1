// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What is around a solid that a mesh encloses: its surface, and convex cells whose union is the closure of the box
// about it less the solid. Convex parts of the solid may be rounded to the grid (convex_parts.h), so that seams between
// them open; these cells never are. Guarantee: exact; cells do not meet in their interiors. Cost: of the cut that makes
// the parts; nothing more. Keywords: complement, exterior, binary space partition.
#pragma once

#include <memory>
#include <vector>

#include "space/polytope/convex_region.h"
#include "space/polytope/solid.h"

namespace findspace::space {

struct Surroundings {
  Mesh surface;
  std::vector<ConvexRegion> cells;
};

/// The surroundings of some of the parts of a body: those from `first` on. What is at x in the mesh is at
/// factor x + shift in the body; factor is negative for a reflected one.
struct PlacedSurroundings {
  std::shared_ptr<const Surroundings> of;
  std::size_t first = 0, count = 0;
  std::int64_t factor = 1;
  Point shift;

  Point at(const Point& x) const { return {factor * x.x + shift.x, factor * x.y + shift.y, factor * x.z + shift.z}; }
  bool in_place() const { return factor == 1 && shift == Point{}; }
  RealVector at(const RealVector& x) const {
    if (in_place()) return x;
    return plus(scaled(exact::Real(factor), x), real(shift));
  }
  /// {at(x) : x in h}.
  HalfSpace at(const HalfSpace& h) const {
    if (in_place()) return h;
    const RealVector n = factor < 0 ? negated(h.normal) : h.normal;
    return {n, h.offset * exact::Real(factor < 0 ? -factor : factor) - dot(n, real(shift))};
  }
};

/// The same around what is `factor` times as large, or moved.
inline void enlarge(std::vector<PlacedSurroundings>& all, std::int64_t factor) {
  for (PlacedSurroundings& s : all) {
    s.factor *= factor;
    s.shift = {s.shift.x * factor, s.shift.y * factor, s.shift.z * factor};
  }
}
inline void displace(std::vector<PlacedSurroundings>& all, const Point& by) {
  for (PlacedSurroundings& s : all) s.shift = s.shift + by;
}
/// Adds those of parts that now come after `before` others.
inline void append(std::vector<PlacedSurroundings>& all, std::vector<PlacedSurroundings> more, std::size_t before) {
  for (PlacedSurroundings& s : more) {
    s.first += before;
    all.push_back(std::move(s));
  }
}

}  // namespace findspace::space
