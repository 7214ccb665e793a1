// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/body/cell_parts.h"

#include <findspace/error.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "space/mesh/mesh.h"
#include "space/polytope/flat_core.h"
#include "space/polytope/polytope_sets.h"

namespace findspace::space {

using exact::Real;
using exact::Refusal;
using exact::Tried;

Error too_fine() {
  return {ErrorCode::kOutOfRange,
          "the common grid of convex parts exceeds 2^40 steps; choose a coarser grid, or corners with fewer digits"};
}

std::int64_t joint_scale(std::int64_t a, std::int64_t b) {
  const int128 scale = int128(a) / std::gcd(a, b) * b;
  if (scale > kCoordinateLimit) throw too_fine();
  return static_cast<std::int64_t>(scale);
}

Real six_volumes(const Polytope& p) {
  Mesh mesh{{p.vertices().begin(), p.vertices().end()}, {}};
  for (int f = 0; f < p.facet_count(); ++f) mesh.faces.push_back(p.circuit(f));
  return six_volumes(mesh);
}

namespace {

/// The least number by which all coordinates become whole, or 0 if that exceeds `limit`.
std::int64_t common_scale(const CellCorners& cells, std::int64_t limit) {
  int128 scale = 1;
  for (const std::vector<RealVector>& cell : cells) {
    for (const RealVector& v : cell) {
      for (const Real& c : v) {
        const auto fraction = c.fraction();
        if (!fraction || (*fraction)[1] > limit) return 0;
        scale = scale / exact::gcd(scale, (*fraction)[1]) * (*fraction)[1];
        if (scale > limit) return 0;
      }
    }
  }
  return static_cast<std::int64_t>(scale);
}

std::int64_t largest_coordinate(const CellCorners& cells) {
  double largest = 1;
  for (const std::vector<RealVector>& cell : cells) {
    for (const RealVector& v : cell) {
      const Vector near = rounded(v);
      for (const double c : {near.x, near.y, near.z}) largest = std::max(largest, std::ceil(std::fabs(c)));
    }
  }
  return static_cast<std::int64_t>(largest);
}

/// The union of two parts without common interior if it is convex: then they share a plane, and the hull adds nothing.
std::optional<Polytope> joined(const Polytope& p, const Polytope& q) {
  const bool touch = std::any_of(p.planes().begin(), p.planes().end(), [&](const Plane& a) {
    return std::any_of(q.planes().begin(), q.planes().end(),
                       [&](const Plane& b) { return a.normal == -b.normal && a.offset == -b.offset; });
  });
  if (!touch) return std::nullopt;
  std::vector<Point> points(p.vertices().begin(), p.vertices().end());
  points.insert(points.end(), q.vertices().begin(), q.vertices().end());
  Polytope hull = Polytope::hull(points);
  if (six_volumes(hull) != six_volumes(p) + six_volumes(q)) return std::nullopt;
  return hull;
}

void join_neighbours(std::vector<Polytope>& parts) {
  for (std::size_t i = 0; i < parts.size(); ++i) {
    for (std::size_t j = i + 1; j < parts.size();) {
      std::optional<Polytope> whole = joined(parts[i], parts[j]);
      if (!whole) {
        ++j;
        continue;
      }
      parts[i] = std::move(*whole);
      parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(j));
      j = i + 1;
    }
  }
}

}  // namespace

CellCorners cell_corners(const std::vector<ConvexRegion>& cells) {
  CellCorners corners;
  for (const ConvexRegion& cell : cells) {
    std::vector<RealVector>& of = corners.emplace_back();
    for (const ConvexRegion::Vertex& v : cell.vertices()) of.push_back(v.at);
  }
  return corners;
}

namespace {

struct RoundedCells {
  ConvexParts made;
  std::vector<std::vector<Point>> flat;  // the vertices of those without interior
};

RoundedCells rounded_cells(const CellCorners& cells, std::int64_t scale) {
  RoundedCells out;
  ConvexParts& made = out.made;
  made.scale = scale;
  for (const std::vector<RealVector>& cell : cells) {
    std::vector<Point> points;
    for (const RealVector& v : cell) {
      std::array<std::int64_t, 3> c{};
      double square = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const Real at = v[k] * Real(scale);
        c[k] = static_cast<std::int64_t>(round(at));
        const double rest = (at - Real(c[k])).to_double();
        square += rest * rest;
      }
      if (square > 0) {
        ++made.rounded;
        made.moved = std::max(made.moved, std::sqrt(square) / static_cast<double>(scale));
      }
      points.push_back({c[0], c[1], c[2]});
    }
    if (auto hull = Polytope::try_hull(points))
      made.parts.push_back(*std::move(hull));
    else
      out.flat.push_back(std::move(points));
  }
  return out;
}

ConvexRegion box_of_points(std::span<const Point> points) {
  Point low = points[0], high = low;
  for (const Point& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  return {real(low), real(high)};
}

bool beside(const Polytope& p, const ConvexRegion& flat) {
  return std::any_of(p.planes().begin(), p.planes().end(), [&](const Plane& plane) {
    const ConvexRegion::Sides sides = flat.sides(HalfSpace(plane));
    return !sides.inside && !sides.on;
  });
}

/// Whether the parts hold the hull of points that lie in one plane.
bool hold(const std::vector<Polytope>& parts, std::span<const Point> points) {
  const std::vector<Point> corners = *flat_corners(points);
  ConvexRegion flat = box_of_points(corners);
  if (corners.size() > 1) {
    for (const HalfSpace& h : flat_planes(corners)) flat.cut(h);
  }
  std::vector<ConvexRegion> near;
  for (const Polytope& p : parts) {
    if (!beside(p, flat)) near.push_back(common_region({&p, 1}));
  }
  return uncovered(flat, near).empty();
}

}  // namespace

ConvexParts parts_of_cells(const std::vector<ConvexRegion>& cells) {
  const CellCorners corners = cell_corners(cells);
  const std::int64_t scale = common_scale(corners, kCoordinateLimit / largest_coordinate(corners));
  ConvexParts made = rounded_cells(corners, std::max<std::int64_t>(scale, 1)).made;
  if (scale > 0) join_neighbours(made.parts);
  return made;
}

Tried<ConvexParts> rounded_corners(const CellCorners& cells, std::int64_t scale) {
  RoundedCells out = rounded_cells(cells, scale);
  const bool all = std::all_of(out.flat.begin(), out.flat.end(),
                               [&](const std::vector<Point>& flat) { return hold(out.made.parts, flat); });
  if (!all)
    return Refusal(
        "a part of the shape is thinner than the steps that its coordinates allow; let faces that lie flush overlap, "
        "or choose a coarser grid");
  return std::move(out.made);
}

Tried<ConvexParts> all_parts(const CellCorners& cells) {
  const std::int64_t limit = kCoordinateLimit / largest_coordinate(cells), scale = common_scale(cells, limit);
  if (scale > 0) {
    ConvexParts made = rounded_cells(cells, scale).made;
    join_neighbours(made.parts);
    return made;
  }
  constexpr std::int64_t kFiner = 1000;
  Tried<ConvexParts> made = rounded_corners(cells, 1);
  for (std::int64_t finer = kFiner; !made && finer <= limit; finer *= kFiner) made = rounded_corners(cells, finer);
  return made;
}

double surface_area(const Polytope& p) {
  double twice = 0;
  for (int f = 0; f < p.facet_count(); ++f) {
    for (int h = p.first_half_edge(f) + 1; h + 1 < p.first_half_edge(f + 1); ++h) {
      const Point base = p.vertices()[p.half_edges()[p.first_half_edge(f)].origin];
      const Approx3 n =
          exact::approx(exact::cross(p.vertices()[p.half_edges()[h].origin] - base, p.vertices()[p.target(h)] - base));
      twice += std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
    }
  }
  return twice / 2;
}

}  // namespace findspace::space
