// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Whole maps against direct tests of single positions: a part, a sheet and 20 obstacles of 100 vertices. Every position
// is classified by overlap tests of triangles in 128-bit integers, at random lattice places and at the exact rational
// vertices of the map itself, where everything touches.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "formula/language/parse.h"
#include "formula/planar/solve.h"
#include "plane/complex/primitives.h"
#include "plane/query/locate.h"
#include "plane/walk/unite.h"

namespace findspace::formula {
namespace formula_scenes {

using exact::int128;
using plane::GridPoint;
using Ring = std::vector<GridPoint>;

struct Star {
  GridPoint center;
  Ring ring;  // counter-clockwise, star-shaped about the centre
};

/// A position (x, y) / w, w > 0.
struct Position {
  int128 x, y, w;
};

struct Corner {
  int128 x, y;
};
using Triangle = std::array<Corner, 3>;

/// The triangles of a star, all coordinates times w and moved by (x, y).
std::vector<Triangle> triangles(const Star& s, int128 w, int128 x, int128 y) {
  auto at = [&](const GridPoint& p) { return Corner{p.x * w + x, p.y * w + y}; };
  std::vector<Triangle> out;
  for (std::size_t k = 0; k < s.ring.size(); ++k)
    out.push_back({at(s.center), at(s.ring[k]), at(s.ring[(k + 1) % s.ring.size()])});
  return out;
}

bool separated(const Triangle& p, const Triangle& q, bool open) {
  for (int k = 0; k < 3; ++k) {
    const Corner &a = p[std::size_t(k)], &b = p[std::size_t((k + 1) % 3)];
    int128 nx = b.y - a.y, ny = a.x - b.x, edge = nx * a.x + ny * a.y, least = nx * q[0].x + ny * q[0].y;
    for (const Corner& c : q) least = std::min(least, nx * c.x + ny * c.y);
    if (open ? least >= edge : least > edge) return true;
  }
  return false;
}

/// Do the interiors (open) or the closed sets meet?
bool meet(const Star& a, const Star& b, const Position& p, bool open) {
  auto fixed = triangles(a, p.w, 0, 0), moving = triangles(b, p.w, p.x, p.y);
  for (const Triangle& s : fixed)
    for (const Triangle& t : moving)
      if (!separated(s, t, open) && !separated(t, s, open)) return true;
  return false;
}

Star random_star(std::mt19937& rng, GridPoint center, int vertices, double size) {
  Star s{center, {}};
  for (int k = 0; k < vertices; ++k) {
    double r = size * (0.5 + 0.5 * double(rng() % 1000) / 1000), angle = 6.283185307179586 * k / vertices;
    s.ring.push_back({center.x + std::int64_t(std::lround(r * std::cos(angle))),
                      center.y + std::int64_t(std::lround(r * std::sin(angle)))});
  }
  return s;
}

plane::Region region(const Ring& ring) {
  plane::Contour c;
  for (auto& p : ring) c.push_back({.start = p});
  return plane::region_of_rings(std::array{c});
}

constexpr std::int64_t kSheet = 4000;

struct Case {
  std::vector<Star> obstacles;
  Star part;
  World world() const {
    World w;
    w.step = 1;
    w.moving = {"B"};
    w.shapes.emplace("B", region(part.ring));
    w.shapes.emplace("R", region({{0, 0}, {kSheet, 0}, {kSheet, kSheet}, {0, kSheet}}));
    std::vector<plane::Region> all;
    std::vector<const plane::Region*> operands;
    for (auto& o : obstacles) all.push_back(region(o.ring));
    for (auto& r : all) operands.push_back(&r);
    w.shapes.emplace("A", plane::unite(operands));
    return w;
  }
  bool inside(const Position& p) const {
    for (auto& v : part.ring) {
      int128 x = v.x * p.w + p.x, y = v.y * p.w + p.y;
      if (x < 0 || y < 0 || x > kSheet * p.w || y > kSheet * p.w) return false;
    }
    return true;
  }
  bool near(const Star& o,
            const Position& p) const {  // only to save time: both are smaller than 400 about their centres
    double dx = double(p.x) / double(p.w) + double(part.center.x - o.center.x),
           dy = double(p.y) / double(p.w) + double(part.center.y - o.center.y);
    return std::hypot(dx, dy) < 800;
  }
  bool holds(const Position& p, bool closed) const {
    if (!inside(p)) return false;
    for (auto& o : obstacles)
      if (near(o, p) && meet(o, part, p, closed)) return false;
    return true;
  }
};

Case random_case(unsigned seed) {
  std::mt19937 rng(seed);
  Case c;
  for (int k = 0; k < 20; ++k)
    c.obstacles.push_back(random_star(rng, {std::int64_t(rng() % kSheet), std::int64_t(rng() % kSheet)}, 100, 390));
  c.part = random_star(rng, {0, 0}, 8 + int(rng() % 8), 200);
  return c;
}

/// The vertices of the map that are crossings of grid lines, or grid points.
std::vector<Position> vertices(const plane::Region& map) {
  std::vector<Position> out;
  for (const plane::Vertex& v : map.vertices) {
    const exact::Point& p = map.geometry.points[v.point];
    if (p.kind == exact::Point::Kind::kGrid) out.push_back({p.gx, p.gy, 1});
    if (p.kind != exact::Point::Kind::kCross) continue;
    const exact::SupportingCurve &s = map.geometry.supporting_curves[p.i], &t = map.geometry.supporting_curves[p.j];
    if (s.circle || t.circle || !s.grid || !t.grid) continue;
    int128 w = int128(s.a) * t.b - int128(s.b) * t.a, x = s.c * t.b - t.c * s.b, y = s.a * t.c - t.a * s.c;
    out.push_back(w > 0 ? Position{x, y, w} : Position{-x, -y, -w});
  }
  return out;
}

void check(unsigned seed, bool closed, int& positions) {
  Case c = random_case(seed);
  Solver solver(c.world());
  Context context;
  context.shapes = {"A", "B", "R"};
  context.moving = {"B"};
  plane::Region map = solver.feasible(
      parse_formula(closed ? "inside(B, R) and clear(B, A)" : "inside(B, R) and disjoint(B, A)", context));
  plane::Locator locator(map);
  std::mt19937 rng(seed + 1000);
  std::vector<Position> at = vertices(map);
  std::shuffle(at.begin(), at.end(), rng);
  if (at.size() > 40) at.resize(40);
  for (int k = 0; k < 40; ++k) at.push_back({std::int64_t(rng() % kSheet), std::int64_t(rng() % kSheet), 1});
  for (const Position& p : at) {
    exact::Real w(p.w);
    bool got = locator.mark({exact::Real(p.x) / w, exact::Real(p.y) / w}) > 0;
    ASSERT_EQ(got, c.holds(p, closed)) << "seed " << seed << " at " << double(p.x) / double(p.w) << ", "
                                       << double(p.y) / double(p.w);
    ++positions;
  }
}

TEST(Scenes, TwentyObstaclesOfHundredVertices) {
  int positions = 0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    check(seed, seed % 2 == 0, positions);
    if (HasFatalFailure()) return;
  }
  EXPECT_GE(positions, 10000);
}

}  // namespace formula_scenes
}  // namespace findspace::formula
