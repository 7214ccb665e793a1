// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The sign maps of Minkowski operations against their definition: shapes are unions of triangles and unit squares on a
// small lattice, and at every lattice position of a window "do the interiors meet", "do the closed sets meet", "is B
// inside" are decided piece by piece in integers. The lattice is fine enough to hit faces, edges, slots and single
// points.

#include <gtest/gtest.h>

#include <array>
#include <random>

#include "plane/complex/primitives.h"
#include "plane/offset/level.h"
#include "plane/query/locate.h"
#include "plane/sum/minkowski.h"
#include "plane/walk/unite.h"

namespace findspace::plane {
namespace plane_minkowski_oracle {

using Convex = std::vector<GridPoint>;  // counter-clockwise
using Pieces = std::vector<Convex>;

/// Separating axis test: do two convex polygons meet (closed), or do their interiors (open)?
bool meet(const Convex& p, const Convex& q, std::int64_t dx, std::int64_t dy, bool open) {
  for (int side = 0; side < 2; ++side) {
    const Convex& s = side ? q : p;
    for (std::size_t k = 0; k < s.size(); ++k) {
      GridPoint a = s[k], b = s[(k + 1) % s.size()];
      std::int64_t nx = b.y - a.y, ny = a.x - b.x, top = INT64_MIN, low = INT64_MAX;
      for (auto v : p) top = std::max(top, (side ? -1 : 1) * (nx * v.x + ny * v.y));
      for (auto v : q) low = std::min(low, (side ? -1 : 1) * (nx * (v.x + dx) + ny * (v.y + dy)));
      // Outward normal of p's edge: q beyond the top of p. For q's edge the roles and the sign change.
      if (open ? low >= top : low > top) return false;
    }
  }
  return true;
}

bool any_meet(const Pieces& a, const Pieces& b, std::int64_t x, std::int64_t y, bool open) {
  for (auto& p : a)
    for (auto& q : b)
      if (meet(p, q, x, y, open)) return true;
  return false;
}

Region region(const Convex& c) {
  Contour ring;
  for (auto& p : c) ring.push_back({.start = p});
  return region_of_rings(std::array{ring});
}

Region region(const Pieces& pieces) {
  std::vector<Region> parts;
  for (auto& c : pieces) parts.push_back(region(c));
  std::vector<const Region*> all;
  for (auto& r : parts) all.push_back(&r);
  return unite(all);
}

Convex square(std::int64_t x, std::int64_t y, std::int64_t s) {
  return {{x, y}, {x + s, y}, {x + s, y + s}, {x, y + s}};
}

Pieces random_squares(std::mt19937& rng, int cells, int count) {
  Pieces out;
  for (int k = 0; k < count; ++k) out.push_back(square(4 * (rng() % cells), 4 * (rng() % cells), 4));
  return out;
}

Pieces random_triangles(std::mt19937& rng, int size, int count) {
  Pieces out;
  while (int(out.size()) < count) {
    GridPoint p[3];
    for (auto& v : p) v = {std::int64_t(rng() % size), std::int64_t(rng() % size)};
    std::int64_t area = (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[1].y - p[0].y) * (p[2].x - p[0].x);
    if (area == 0) continue;
    if (area < 0) std::swap(p[1], p[2]);
    out.push_back({p[0], p[1], p[2]});
  }
  return out;
}

Mark mark_at(const CellComplex& c, std::int64_t x, std::int64_t y) {
  Cell cell = locate(c, exact::RealPoint{exact::Real(x), exact::Real(y)});
  return cell.dimension == 0   ? c.vertices[cell.index].mark
         : cell.dimension == 1 ? c.edges[cell.index].mark
                               : c.faces[cell.index].mark;
}

/// The pieces of the frame minus A, for containment: unit lattice squares not in A.
Pieces complement_squares(const Pieces& a, int cells, int margin) {
  Pieces out;
  for (int x = -margin; x < cells + margin; ++x)
    for (int y = -margin; y < cells + margin; ++y) {
      bool in = false;
      for (auto& s : a) in = in || (s[0].x == 4 * x && s[0].y == 4 * y);
      if (!in) out.push_back(square(4 * x, 4 * y, 4));
    }
  return out;
}

void compare_contact(const Pieces& a, const Pieces& b, int window, const std::string& what) {
  SignMap map = contact_map(region(a), region(b));
  for (int x = -window; x <= window; ++x)
    for (int y = -window; y <= window; ++y) {
      int expected = any_meet(a, b, x, y, true) ? -1 : any_meet(a, b, x, y, false) ? 0 : 1;
      ASSERT_EQ(mark_at(map, x, y), expected) << what << " at " << x << "," << y;
    }
}

TEST(MinkowskiOracle, ContactOfSquares) {
  for (unsigned seed = 0; seed < 150; ++seed) {
    std::mt19937 rng(seed);
    Pieces a = random_squares(rng, 4, 3 + rng() % 9), b = random_squares(rng, 3, 1 + rng() % 6);
    compare_contact(a, b, 17, "seed " + std::to_string(seed));
    if (HasFatalFailure()) return;
  }
}

TEST(MinkowskiOracle, ContactOfTriangles) {
  for (unsigned seed = 0; seed < 150; ++seed) {
    std::mt19937 rng(seed);
    Pieces a = random_triangles(rng, 9, 1 + rng() % 4), b = random_triangles(rng, 7, 1 + rng() % 3);
    compare_contact(a, b, 9, "seed " + std::to_string(seed));
    if (HasFatalFailure()) return;
  }
}

TEST(MinkowskiOracle, ContainmentOfSquares) {
  for (unsigned seed = 0; seed < 150; ++seed) {
    std::mt19937 rng(seed);
    int cells = 4;
    Pieces a = random_squares(rng, cells, 6 + rng() % 14), b = random_squares(rng, 2, 1 + rng() % 2);
    Pieces rest = complement_squares(a, cells, 5);
    SignMap map = containment_map(region(a), region(b));
    for (int x = -9; x <= 17; ++x)
      for (int y = -9; y <= 17; ++y) {
        int expected = any_meet(rest, b, x, y, true) ? 1 : any_meet(rest, b, x, y, false) ? 0 : -1;
        ASSERT_EQ(mark_at(map, x, y), expected) << "seed " << seed << " at " << x << "," << y;
      }
  }
}

/// The convex polygon {a - b}.
Convex difference(const Convex& a, const Convex& b) {
  std::vector<GridPoint> all;
  for (auto& p : a)
    for (auto& q : b) all.push_back({p.x - q.x, p.y - q.y});
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  auto rotation = [](GridPoint o, GridPoint p, GridPoint q) {
    return (p.x - o.x) * (q.y - o.y) - (p.y - o.y) * (q.x - o.x);
  };
  Convex hull;
  for (int pass = 0; pass < 2; ++pass) {
    std::size_t base = hull.size();
    for (auto& p : all) {
      while (hull.size() >= base + 2 && rotation(hull[hull.size() - 2], hull.back(), p) <= 0) hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(all.begin(), all.end());
  }
  return hull;
}

/// Sign of (distance from p to the closed convex polygon) - r, exactly.
int sign_of_distance(const Convex& c, GridPoint p, std::int64_t r) {
  bool inside = true;
  int least = 1;
  for (std::size_t k = 0; k < c.size(); ++k) {
    GridPoint a = c[k], b = c[(k + 1) % c.size()];
    std::int64_t dx = b.x - a.x, dy = b.y - a.y, px = p.x - a.x, py = p.y - a.y;
    std::int64_t cross = dx * py - dy * px, dot = dx * px + dy * py, n = dx * dx + dy * dy;
    inside = inside && cross >= 0;
    std::int64_t left, right;  // squared distance against squared radius, times a common positive factor
    if (dot <= 0) {
      left = px * px + py * py;
      right = r * r;
    } else if (dot >= n) {
      left = (p.x - b.x) * (p.x - b.x) + (p.y - b.y) * (p.y - b.y);
      right = r * r;
    } else {
      left = cross * cross;
      right = r * r * n;
    }
    least = std::min(least, (left > right) - (left < right));
  }
  return inside ? -1 : least;
}

TEST(MinkowskiOracle, LevelsOfTriangles) {
  for (unsigned seed = 0; seed < 120; ++seed) {
    std::mt19937 rng(seed);
    Pieces a = random_triangles(rng, 9, 1 + rng() % 3), b = random_triangles(rng, 7, 1 + rng() % 2), sums;
    for (auto& p : a)
      for (auto& q : b) sums.push_back(difference(p, q));
    SignMap base = contact_map(region(a), region(b));
    for (std::int64_t r : {1, 2, 5}) {
      SignMap map = level_map(base, exact::Real(r));
      for (int x = -14; x <= 16; ++x)
        for (int y = -14; y <= 16; ++y) {
          int expected = 1;
          for (auto& c : sums) expected = std::min(expected, sign_of_distance(c, {x, y}, r));
          ASSERT_EQ(mark_at(map, x, y), expected) << "seed " << seed << " level " << r << " at " << x << "," << y;
        }
    }
  }
}

/// The same through squares, whose gaps and holes have critical levels: squares of side 4 on a lattice of 4 give gaps
/// of 4.
TEST(MinkowskiOracle, LevelsOfSquares) {
  for (unsigned seed = 0; seed < 120; ++seed) {
    std::mt19937 rng(seed);
    Pieces a = random_squares(rng, 5, 3 + rng() % 10), b = random_squares(rng, 1, 1), sums;
    for (auto& p : a)
      for (auto& q : b) sums.push_back(difference(p, q));
    SignMap base = contact_map(region(a), region(b));
    for (std::int64_t r : {1, 2, 3, 4}) {
      SignMap map = level_map(base, exact::Real(r));
      for (int x = -10; x <= 26; ++x)
        for (int y = -10; y <= 26; ++y) {
          int expected = 1;
          for (auto& c : sums) expected = std::min(expected, sign_of_distance(c, {x, y}, r));
          ASSERT_EQ(mark_at(map, x, y), expected) << "seed " << seed << " level " << r << " at " << x << "," << y;
        }
    }
  }
}

}  // namespace plane_minkowski_oracle
}  // namespace findspace::plane
