// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Random plain sets for the laws of the plane, small on purpose: on a lattice of a few steps almost everything meets
// everything in some degenerate way (shared edges, corners on edges, tangent circles, slits, lonely points).
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "law/plane_invariants.h"
#include "law/plane_same_set.h"
#include "plane/build/build.h"
#include "plane/complex/overlay.h"
#include "plane/contour/contour.h"
#include "plane/query/topology.h"

namespace findspace::plane {

class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed * 0x9e3779b97f4a7c15u + 1) {}
  std::uint64_t next() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  /// Uniform in low ... high.
  std::int64_t pick(std::int64_t low, std::int64_t high) {
    return low + std::int64_t(next() % std::uint64_t(high - low + 1));
  }
  GridPoint point(std::int64_t size) {
    std::int64_t x = pick(0, size);
    return {x, pick(0, size)};
  }

 private:
  std::uint64_t state_;
};

inline ShapePtr share(Shape s) { return std::make_shared<const Shape>(std::move(s)); }

inline ShapePtr node(Shape::Kind kind, std::vector<ShapePtr> children) {
  Shape s;
  s.kind = kind;
  s.children = std::move(children);
  return share(std::move(s));
}

inline ShapePtr points_of(std::vector<GridPoint> points) {
  Shape s;
  s.kind = Shape::Kind::kPoints;
  s.points = std::move(points);
  return share(std::move(s));
}

inline ShapePtr disc_of(GridPoint center, const exact::Real& radius) {
  Shape s;
  s.kind = Shape::Kind::kDisc;
  s.points = {center};
  s.amount = radius;
  return share(std::move(s));
}

inline Contour contour_of(const std::vector<GridPoint>& points) {
  Contour c;
  for (const GridPoint& p : points) c.push_back({.start = p});
  return c;
}

inline ShapePtr polygon_of(const std::vector<GridPoint>& points) {
  Shape s;
  s.kind = Shape::Kind::kRings;
  s.contours = make_rings({contour_of(points)}, 1).contours;
  return share(std::move(s));
}

inline ShapePtr box_of(std::int64_t x0, std::int64_t y0, std::int64_t x1, std::int64_t y1) {
  return polygon_of({{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}});
}

inline ShapePtr chain_of(const std::vector<GridPoint>& points) {
  Shape s;
  s.kind = Shape::Kind::kPolyline;
  std::int64_t repeated = 0;
  s.contours = {make_chain(contour_of(points), repeated)};
  return share(std::move(s));
}

inline ShapePtr translate_of(ShapePtr child, GridPoint by) {
  Shape s;
  s.kind = Shape::Kind::kTranslate;
  s.children = {std::move(child)};
  s.points = {by};
  return share(std::move(s));
}

inline ShapePtr rotate_of(ShapePtr child, GridPoint about, const exact::Real& degrees) {
  Shape s;
  s.kind = Shape::Kind::kRotate;
  s.children = {std::move(child)};
  s.points = {about};
  s.degrees = degrees;
  return share(std::move(s));
}

inline ShapePtr offset_of(ShapePtr child, const exact::Real& amount) {
  Shape s;
  s.kind = Shape::Kind::kOffset;
  s.children = {std::move(child)};
  s.amount = amount;
  return share(std::move(s));
}

/// What leaves of random trees may be.
struct Variety {
  std::int64_t size = 6;  // coordinates 0 ... size
  bool flat = true;       // points and chains
  bool arcs = true;
  bool plain = true;  // interiors and differences among the leaves
};

inline ShapePtr random_triangle(Random& random, std::int64_t size) {
  for (;;) {
    GridPoint p = random.point(size), q = random.point(size), r = random.point(size);
    if ((q.x - p.x) * (r.y - p.y) != (q.y - p.y) * (r.x - p.x)) return polygon_of({p, q, r});
  }
}

inline ShapePtr random_box(Random& random, std::int64_t size) {
  GridPoint p = random.point(size - 1);
  std::int64_t w = random.pick(1, size - p.x), h = random.pick(1, size - p.y);
  return box_of(p.x, p.y, p.x + w, p.y + h);
}

inline ShapePtr random_disc(Random& random, std::int64_t size) {
  GridPoint c = random.point(size);
  switch (random.pick(0, 3)) {
    case 0:
      return disc_of(c, sqrt(exact::Real(random.pick(1, size))));
    case 1:
      return disc_of(c, exact::Real::ratio(random.pick(1, size), 2));
    default:
      return disc_of(c, exact::Real(random.pick(1, size / 2 + 1)));
  }
}

inline ShapePtr random_flat(Random& random, std::int64_t size) {
  std::vector<GridPoint> p;
  for (std::int64_t k = random.pick(1, 3); k >= 0; --k) p.push_back(random.point(size));
  if (random.pick(0, 1)) return points_of(p);
  p.push_back({p[0].x + 1, p[0].y});  // so that two points differ
  return chain_of(p);
}

inline ShapePtr random_leaf(Random& random, const Variety& variety) {
  switch (random.pick(0, variety.plain ? 7 : 4)) {
    case 0:
      return random_triangle(random, variety.size);
    case 1:
    case 2:
      return random_box(random, variety.size);
    case 3:
      return variety.arcs ? random_disc(random, variety.size) : random_triangle(random, variety.size);
    case 4:
      return variety.flat ? random_flat(random, variety.size) : random_box(random, variety.size);
    case 5:
      return node(Shape::Kind::kInterior, {random_leaf(random, variety)});
    case 6:
      return node(Shape::Kind::kClosure, {random_leaf(random, variety)});
    default:
      return node(Shape::Kind::kDifference, {random_leaf(random, variety), random_leaf(random, variety)});
  }
}

/// A union of one to three leaves, some of them taken away again.
inline ShapePtr random_shape(Random& random, const Variety& variety) {
  std::vector<ShapePtr> parts;
  for (std::int64_t k = random.pick(1, 3); k > 0; --k) parts.push_back(random_leaf(random, variety));
  ShapePtr all = parts.size() == 1 ? parts[0] : node(Shape::Kind::kUnion, parts);
  if (variety.plain && random.pick(0, 2) == 0)
    return node(Shape::Kind::kDifference, {all, random_leaf(random, variety)});
  return all;
}

inline Region region_of(const ShapePtr& shape) { return build(*shape).region; }

inline bool is_subset(const Region& a, const Region& b) {
  return is_empty(subtract(std::vector<const Region*>{&a, &b}));
}

/// A shape as text, to copy into a reproducer.
inline std::string show(const Shape& s) {
  static const char* const names[] = {"rings",
                                      "disc",
                                      "points",
                                      "polyline",
                                      "union",
                                      "intersection",
                                      "difference",
                                      "complement",
                                      "interior",
                                      "closure",
                                      "boundary",
                                      "regularize",
                                      "translate",
                                      "rotate",
                                      "mirror",
                                      "minkowski_sum",
                                      "minkowski_difference",
                                      "offset",
                                      "hull"};
  std::string text = names[int(s.kind)];
  text += '(';
  auto write = [&](const GridPoint& p) { text += fmt::format("{{{},{}}} ", p.x, p.y); };
  for (const Contour& c : s.contours)
    for (const ContourEdge& e : c) write(e.start);
  for (const GridPoint& p : s.points) write(p);
  if (s.kind == Shape::Kind::kDisc || s.kind == Shape::Kind::kOffset) text += s.amount.text();
  if (s.kind == Shape::Kind::kRotate) text += s.degrees.text();
  for (const ShapePtr& c : s.children) text.append(show(*c)).append(" ");
  return text.append(")");
}

/// The cells of two minimal complexes of one set agree in number.
inline bool same_counts(const Region& a, const Region& b) {
  return a.vertices.size() == b.vertices.size() && a.edges.size() == b.edges.size() && a.faces.size() == b.faces.size();
}

}  // namespace findspace::plane
