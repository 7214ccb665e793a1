// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/polytope_sets.h"

#include <findspace/error.h>

#include <algorithm>

namespace findspace::space {

using exact::Real;

namespace {

struct Cell {
  ConvexRegion region;
  std::vector<Plane> planes;
};

Cell cell_of(const Polytope& p) {
  RealVector low = real(p.vertices()[0]), high = low;
  for (const Point& v : p.vertices()) {
    const RealVector at = real(v);
    for (std::size_t k = 0; k < 3; ++k) {
      if (at[k] < low[k]) low[k] = at[k];
      if (high[k] < at[k]) high[k] = at[k];
    }
  }
  Cell cell{ConvexRegion(low, high), {p.planes().begin(), p.planes().end()}};
  for (const Plane& plane : p.planes()) cell.region.cut(HalfSpace(plane));
  return cell;
}

bool within(const ConvexRegion& thin, const Cell& cell) {
  return std::none_of(cell.planes.begin(), cell.planes.end(),
                      [&](const Plane& p) { return thin.sides(HalfSpace(p)).outside; });
}

std::vector<ConvexRegion> regions_of(std::vector<Cell> cells) {
  std::vector<ConvexRegion> out;
  for (Cell& c : cells) out.push_back(std::move(c.region));
  return out;
}

}  // namespace

std::vector<ConvexRegion> intersection_cells(std::span<const Polytope> a, std::span<const Polytope> b) {
  std::vector<Cell> cells;
  std::vector<ConvexRegion> thin;
  for (const Polytope& p : a) {
    const Cell whole = cell_of(p);
    for (const Polytope& q : b) {
      Cell both = whole;
      for (const Plane& plane : q.planes()) both.region.cut(HalfSpace(plane));
      both.planes.insert(both.planes.end(), q.planes().begin(), q.planes().end());
      if (both.region.dimension() == 3)
        cells.push_back(std::move(both));
      else if (!both.region.empty())
        thin.push_back(std::move(both.region));
    }
  }
  for (const ConvexRegion& t : thin) {
    if (std::any_of(cells.begin(), cells.end(), [&](const Cell& c) { return within(t, c); })) continue;
    throw Error(ErrorCode::kUnsupported,
                "the intersection has a part without interior; in 3D only shapes with axis-parallel faces may");
  }
  return regions_of(std::move(cells));
}

std::vector<ConvexRegion> difference_cells(std::span<const Polytope> a, std::span<const Polytope> b) {
  std::vector<Cell> cells;
  for (const Polytope& p : a) cells.push_back(cell_of(p));
  for (const Polytope& q : b) {
    std::vector<Cell> left;
    for (Cell& c : cells) {
      Cell inside = c;
      for (const Plane& plane : q.planes()) inside.region.cut(HalfSpace(plane));
      if (inside.region.dimension() < 3) {
        left.push_back(std::move(c));
        continue;
      }
      for (const Plane& plane : q.planes()) {
        const HalfSpace below(plane);
        if (!c.region.sides(below).outside) continue;
        Cell beyond = c;
        beyond.region.cut(below.opposite());
        beyond.planes.push_back({-plane.normal, -plane.offset});
        left.push_back(std::move(beyond));
        c.region.cut(below);
        c.planes.push_back(plane);
      }
    }
    cells = std::move(left);
  }
  return regions_of(std::move(cells));
}

}  // namespace findspace::space
