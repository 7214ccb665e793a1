// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Shapes of the plane and of space as values: point sets given by exact decimal numbers on a grid. Primitive ones are
// closed. Operations are the plain ones of point sets, not regularised: what they make may lack parts of its boundary,
// or be a curve or a point. Guarantee: exact, but for points that are off the grid, which are rounded to it once, and
// for rotations by other angles than multiples of 90 degrees, which round each vertex once. Cost: primitives are
// checked where they are made; constructions are computed once, when they are first looked at. Copies are cheap, and
// reading one from many threads is safe. Errors: findspace::Error that names ring, vertex and edge: kGeometry,
// kBadValue, kOutOfRange, kSyntax, kUnsupported. Source: docs/scene.md. Keywords: polygon with holes, disc, path,
// polytope, mesh, height field, Boolean operation, Minkowski sum, offset.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "findspace/contour.h"
#include "findspace/number.h"
#include "findspace/surface.h"

namespace findspace {

class Region;

/// Ground, as heights over a grid of columns and rows. A square of four heights is two triangles; its diagonal goes
/// from the corner of least x and y to that of greatest.
struct HeightField {
  /// Row by row, from the row of least y; each row from the least x.
  std::span<const double> heights;
  /// Heights in a row: 2 at least, as there are rows.
  std::size_t columns = 0;
  /// From a column to the next, and from a row to the next; above 0.
  Point step = {1, 1};
  /// Where the solid ends below; less than all heights.
  Number floor = 0;
  /// Where the first column meets the first row.
  Point at = {0, 0};
  /// What stands for a height that is missing, such as NaN: there is nothing over squares with such a corner.
  std::optional<double> missing = {};
};

class Shape {
 public:
  // ---- the plane
  /// The closed set within the ring and outside the holes: their interiors are left out. Rings are simple and run
  /// either way; holes lie inside the ring and touch neither it nor each other.
  static Shape polygon(const Ring& ring, const std::vector<Ring>& holes = {}, const Grid& grid = {});
  static Shape polygon(std::span<const Position> ring, const std::vector<std::span<const Position>>& holes = {},
                       const Grid& grid = {});
  template <std::integral T>
  static Shape polygon(std::span<const std::array<T, 2>> ring,
                       const std::vector<std::span<const std::array<T, 2>>>& holes = {}, const Grid& grid = {}) {
    std::vector<Ring> inner;
    for (const auto& hole : holes) inner.push_back(ring_of(hole));
    return polygon(ring_of(ring), inner, grid);
  }
  /// The same of rings that may have arcs.
  static Shape polygon(const Contour& ring, const std::vector<Contour>& holes = {}, const Grid& grid = {});
  /// A polygon of each ring, made side by side; the place of an error begins with "polygon K".
  static std::vector<Shape> polygons(std::span<const std::span<const Position>> rings, const Grid& grid = {});
  /// Closed; the radius is more than 0.
  static Shape disc(const Point& center, const Number& radius, const Grid& grid = {});
  /// Closed, with sides along the axes and an area.
  static Shape box(const Point& min, const Point& max, const Grid& grid = {});
  /// SVG path data of M L H V A C S Q T Z; y points upwards. Rings nest by the even-odd rule, open parts are chains
  /// (docs/scene.md, "Paths").
  static Shape path(std::string_view data, const Grid& grid = {});
  /// Isolated points.
  static Shape points(const std::vector<Point>& points, const Grid& grid = {});
  static Shape points(std::span<const Position> points, const Grid& grid = {});
  /// A chain of closed segments and arcs, a set without interior; it may cross itself.
  static Shape polyline(const std::vector<Point>& points, const Grid& grid = {});
  static Shape polyline(std::span<const Position> points, const Grid& grid = {});
  static Shape polyline(const Contour& chain, const Grid& grid = {});

  // ---- space
  /// The convex hull of the points, which have a volume.
  static Shape polytope(std::span<const Position3> points, const Grid& grid = {});
  static Shape box(const Point3& min, const Point3& max, const Grid& grid = {});
  static Shape ball(const Point3& center, const Number& radius, const Grid& grid = {});
  /// A polygon of the plane, without arcs or with, between two heights.
  static Shape prism(const Shape& polygon, const Number& low, const Number& high);
  /// What lies between a height field and its floor.
  static Shape height_field(const HeightField& field, const Grid& grid = {});
  /// What a closed surface encloses; faces are circuits of vertices, counted from 0.
  static Shape mesh(std::span<const Position3> vertices, std::span<const std::array<std::int32_t, 3>> triangles,
                    const Grid& grid = {});
  static Shape mesh(std::span<const Position3> vertices, const std::vector<std::vector<std::int32_t>>& faces,
                    const Grid& grid = {});

  // ---- from elsewhere
  /// What a scene file would say, e.g. R"({"file": "part.svg"})" or a region's "cells". Files are looked for in the
  /// current folder. Error(kSyntax) with line and column.
  static Shape json(std::string_view text, const Grid& grid = {});
  /// A drawing or a mesh (docs/scene.md, "Files"), in its own unit. Error(kFile) where it cannot be read.
  static Shape file(const std::string& path, const Grid& grid = {});
  /// A region is a shape again, with all its open and closed ends.
  Shape(const Region& region);  // NOLINT: implicit on purpose

  // ---- made of others; of shapes on different grids on one that holds both
  /// The union of parts that keep their names in witnesses.
  static Shape collection(const std::vector<std::pair<std::string, Shape>>& parts);
  /// What belongs to any of them, or to all.
  static Shape unite(const std::vector<Shape>& shapes);
  static Shape intersect(const std::vector<Shape>& shapes);
  /// The first without the others; of closed sets it is not closed.
  static Shape subtract(const std::vector<Shape>& shapes);
  static Shape complement(const Shape& shape);
  static Shape interior(const Shape& shape);
  static Shape closure(const Shape& shape);
  static Shape boundary(const Shape& shape);
  /// The closure of the interior.
  static Shape regularize(const Shape& shape);
  /// {a + b}: no reflection. The positions in which B + p meets A are A + (-B).
  static Shape minkowski_sum(const Shape& a, const Shape& b);
  /// {p : b + p lies in a} of a reflected b: the intersection of all a + q, q in b.
  static Shape minkowski_difference(const Shape& a, const Shape& b);
  /// All points no farther than the radius from it, with true arcs; where that is negative, eroded: {p : the closed
  /// disc or ball about p lies in it}.
  static Shape offset(const Shape& shape, const Number& radius);
  /// The convex hull; of arcs of different radii only where common tangents have directions in ratios of integers.
  static Shape hull(const Shape& shape);
  /// Reflected through the origin.
  static Shape reflect(const Shape& shape);
  Shape translated(const Point& by) const;
  Shape translated(const Point3& by) const;
  /// Counter-clockwise about a point. Exact for multiples of 90 degrees; other angles round each vertex once to the
  /// nearest grid point.
  Shape rotated(const Number& degrees, const Point& about = {0, 0}) const;
  /// Of space: about an axis through a point, counter-clockwise seen from its positive end.
  enum class Axis { kX, kY, kZ };
  Shape rotated(const Number& degrees, Axis axis, const Point3& about = {0, 0, 0}) const;

  // ---- what it is
  /// 2 or 3.
  int dimension() const;
  /// The grid of its coordinates.
  Grid grid() const;
  /// How many of the points given were off the grid, and the farthest that one was moved, in the shape's unit.
  struct Rounded {
    /// How many points.
    std::size_t points = 0;
    /// How far the farthest was moved.
    double largest = 0;
  };
  /// What was rounded when it was made.
  Rounded rounded() const;
  /// Of the plane: the vertices that rotations by other angles than multiples of 90 degrees put on the grid. Makes the
  /// region.
  Rounded rotated_points() const;
  /// The set itself, of the plane only (Error(kUnsupported)); made when first asked for.
  const Region& region() const;

  /// Of space: the boundary as flat faces. Error(kUnsupported) of what has other faces and of what is made of several
  /// solids; World::surface has theirs as found on lines.
  Surface surface() const;
  /// Of space: how it looks, for a program that draws it itself: what is unbounded is left open, and what has no volume
  /// is left out. What has other faces is as found on so many lines each way; with 0 lines there are no faces of it.
  Surface drawn_surface(int lines = 48) const;
  /// A drawing in true size of a shape of the plane (Error(kUnsupported) where it is unbounded), or a view of a solid.
  std::string svg() const;

  /// The set as text that Shape::json brings back on the same grid: the boundary in the plane, the construction in
  /// space. Error(kUnsupported) for prisms with arcs.
  std::string exact_json() const;

  struct Data;
  explicit Shape(std::shared_ptr<const Data> data) : data_(std::move(data)) {}
  const Data& data() const { return *data_; }

 private:
  template <std::integral T>
  static Ring ring_of(std::span<const std::array<T, 2>> points) {
    Ring ring;
    for (const auto& p : points) ring.push_back({p[0], p[1]});
    return ring;
  }

  std::shared_ptr<const Data> data_;
};

}  // namespace findspace
