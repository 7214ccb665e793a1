// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/body/cell_parts.h"

#include <findspace/error.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "space/mesh/mesh.h"

namespace findspace::space {

using exact::Real;

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
std::int64_t common_scale(const std::vector<std::vector<RealVector>>& cells, std::int64_t limit) {
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

std::int64_t largest_coordinate(const std::vector<std::vector<RealVector>>& cells) {
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

ConvexParts parts_of_cells(const std::vector<ConvexRegion>& cells) {
  std::vector<std::vector<RealVector>> corners;
  for (const ConvexRegion& cell : cells) {
    std::vector<RealVector>& of = corners.emplace_back();
    for (const ConvexRegion::Vertex& v : cell.vertices()) of.push_back(v.at);
  }
  return parts_of_corners(corners);
}

ConvexParts rounded_corners(const std::vector<std::vector<RealVector>>& cells, std::int64_t scale) {
  ConvexParts result;
  result.scale = scale;
  for (const std::vector<RealVector>& cell : cells) {
    std::vector<Point> points;
    for (const RealVector& v : cell) {
      std::array<std::int64_t, 3> c{};
      double square = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const Real at = v[k] * Real(result.scale);
        c[k] = static_cast<std::int64_t>(round(at));
        const double rest = (at - Real(c[k])).to_double();
        square += rest * rest;
      }
      if (square > 0) {
        ++result.rounded;
        result.moved = std::max(result.moved, std::sqrt(square));
      }
      points.push_back({c[0], c[1], c[2]});
    }
    // A cell without volume, of a mesh that crosses itself or made flat by rounding, is left out. The volume check has
    // the last word.
    if (auto hull = Polytope::try_hull(points)) result.parts.push_back(*std::move(hull));
  }
  return result;
}

ConvexParts parts_of_corners(const std::vector<std::vector<RealVector>>& cells) {
  const std::int64_t scale = common_scale(cells, kCoordinateLimit / largest_coordinate(cells));
  if (scale == 0) return rounded_corners(cells, 1);
  ConvexParts result = rounded_corners(cells, scale);
  join_neighbours(result.parts);
  return result;
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
