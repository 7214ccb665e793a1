// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/polytope/polytope_sets.h"

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

std::vector<Cell> cells_of(std::span<const Polytope> polytopes) {
  std::vector<Cell> out;
  for (const Polytope& p : polytopes) out.push_back(cell_of(p));
  return out;
}

/// Takes a convex set away from the pieces, all of dimension d; what is left of less is dropped, being in the others.
void take_away(std::span<const HalfSpace> set, int d, std::vector<ConvexRegion>& pieces) {
  std::vector<ConvexRegion> left;
  for (ConvexRegion& piece : pieces) {
    for (const HalfSpace& below : set) {
      if (!piece.sides(below).outside) continue;
      ConvexRegion beyond = piece;
      beyond.cut(below.opposite());
      if (beyond.dimension() == d) left.push_back(std::move(beyond));
      piece.cut(below);
      if (piece.dimension() < d) break;
    }
  }
  pieces = std::move(left);
}

bool is_covered(const ConvexRegion& thin, std::span<const Cell> cells) {
  std::vector<ConvexRegion> left{thin};
  for (std::size_t k = 0; k < cells.size() && !left.empty(); ++k) {
    const std::vector<HalfSpace> planes(cells[k].planes.begin(), cells[k].planes.end());
    take_away(planes, thin.dimension(), left);
  }
  return left.empty();
}

struct Common {
  std::vector<Cell> cells;
  std::vector<ConvexRegion> thin;  // without interior
};

Common common(std::span<const Cell> a, std::span<const Cell> b) {
  Common out;
  for (const Cell& p : a) {
    for (const Cell& q : b) {
      Cell both = p;
      for (const Plane& plane : q.planes) both.region.cut(HalfSpace(plane));
      both.planes.insert(both.planes.end(), q.planes.begin(), q.planes.end());
      if (both.region.dimension() == 3)
        out.cells.push_back(std::move(both));
      else if (!both.region.empty())
        out.thin.push_back(std::move(both.region));
    }
  }
  return out;
}

/// The refusal of a thin piece that no cell covers.
std::optional<exact::Refusal> thin_left(std::span<const ConvexRegion> thin, std::span<const Cell> cells,
                                        const char* of) {
  if (std::all_of(thin.begin(), thin.end(), [&](const ConvexRegion& t) { return is_covered(t, cells); }))
    return std::nullopt;
  return thin_part(std::string("the ") + of);
}

std::vector<Cell> without(std::vector<Cell> cells, std::span<const Polytope> b) {
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
  return cells;
}

/// A box with all of the polytopes in its interior.
Cell around(std::span<const Polytope> a, std::span<const Polytope> b) {
  Point low = a[0].vertices()[0], high = low;
  const auto extend = [&](std::span<const Polytope> polytopes) {
    for (const Polytope& p : polytopes) {
      for (const Point& v : p.vertices()) {
        low = {std::min(low.x, v.x), std::min(low.y, v.y), std::min(low.z, v.z)};
        high = {std::max(high.x, v.x), std::max(high.y, v.y), std::max(high.z, v.z)};
      }
    }
  };
  extend(a);
  extend(b);
  const Point one{1, 1, 1};
  return {ConvexRegion(real(low - one), real(high + one)), {}};
}

/// Whether the plane of a facet of p has all of q beyond it.
bool is_beyond_facet(const Polytope& p, const Polytope& q) {
  return std::any_of(p.planes().begin(), p.planes().end(), [&](const Plane& plane) {
    return std::all_of(q.vertices().begin(), q.vertices().end(),
                       [&](const Point& v) { return exact::dot(plane.normal, v) + plane.offset >= 0; });
  });
}

std::vector<ConvexRegion> regions_of(std::vector<Cell> cells) {
  std::vector<ConvexRegion> out;
  for (Cell& c : cells) out.push_back(std::move(c.region));
  return out;
}

}  // namespace

exact::Refusal thin_part(const std::string& of) {
  return exact::Refusal(of +
                        " has a part without interior (a sheet, a line or a point); in 3D that is computed only "
                        "where all faces of all shapes are flat and parallel to the axes");
}

exact::Tried<std::vector<ConvexRegion>> intersection_cells(std::span<const Polytope> a, std::span<const Polytope> b,
                                                           std::span<const Polytope> beside) {
  Common both = common(cells_of(a), cells_of(b));
  if (!both.thin.empty()) {
    std::vector<Cell> covers = cells_of(beside);
    covers.insert(covers.end(), both.cells.begin(), both.cells.end());
    if (auto why = thin_left(both.thin, covers, "intersection")) return *std::move(why);
  }
  return regions_of(std::move(both.cells));
}

std::vector<ConvexRegion> difference_cells(std::span<const Polytope> a, std::span<const Polytope> b) {
  return regions_of(without(cells_of(a), b));
}

exact::Tried<std::vector<ConvexRegion>> outside_cells(std::span<const Polytope> a, std::span<const Polytope> b,
                                                      std::span<const Polytope> beside) {
  std::vector<Cell> left = without(cells_of(a), b);
  if (!a.empty()) {
    const Common both = common(cells_of(a), without({around(a, b)}, b));
    std::vector<Cell> covers = cells_of(beside);
    covers.insert(covers.end(), left.begin(), left.end());
    if (auto why = thin_left(both.thin, covers, "difference")) return *std::move(why);
  }
  return regions_of(std::move(left));
}

ConvexRegion common_region(std::span<const Polytope> polytopes) {
  ConvexRegion region = cell_of(polytopes[0]).region;
  for (const Polytope& p : polytopes.subspan(1)) {
    for (const Plane& plane : p.planes()) region.cut(HalfSpace(plane));
  }
  return region;
}

std::vector<ConvexRegion> uncovered(const ConvexRegion& thin, std::span<const ConvexRegion> by) {
  std::vector<ConvexRegion> left{thin};
  for (std::size_t k = 0; k < by.size() && !left.empty(); ++k) take_away(by[k].planes(), thin.dimension(), left);
  return left;
}

/// What each has and those before it lack.
Real six_volumes_of_union(std::span<const Polytope> polytopes) {
  Real sum;
  for (std::size_t k = 0; k < polytopes.size(); ++k) {
    std::vector<Polytope> before;
    for (const Polytope& p : polytopes.first(k))
      if (!is_beyond_facet(p, polytopes[k]) && !is_beyond_facet(polytopes[k], p)) before.push_back(p);
    for (const ConvexRegion& cell : difference_cells(polytopes.subspan(k, 1), before)) sum += cell.six_volumes();
  }
  return sum;
}

}  // namespace findspace::space
