// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Shapes of the plane, and the operations that both dimensions share.

#include "findspace/shape.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "api/values/region_data.h"
#include "api/values/shape_data.h"
#include "findspace/error.h"
#include "plane/base/parallel.h"
#include "plane/build/build.h"
#include "plane/contour/contour.h"
#include "plane/contour/grid_points.h"
#include "space/shape/rotated_shape.h"

namespace findspace {

using plane::GridPoint;
using plane::RoundingLog;
using Tree = plane::Shape;
using api::make_shape;

namespace api {

Shape make_shape(plane::ShapePtr tree, const plane::Grid& grid, int dimension, const RoundingLog& rounding,
                 std::uint64_t work, std::string unit) {
  return Shape(std::make_shared<const Shape::Data>(std::move(tree), grid, dimension, rounding, work, std::move(unit)));
}

}  // namespace api

namespace {

/// Points on their way to the grid; errors say which.
class Reader {
 public:
  explicit Reader(const Grid& grid) : grid_(api::grid_of(grid)) {}

  const plane::Grid& grid() const { return grid_; }
  GridPoint point(const Point& p) { return grid_.nearest(api::real_of(p.x), api::real_of(p.y), rounding_); }
  exact::Real length(const Number& n) const { return grid_.steps(api::real_of(n)); }

  /// Those of a ring may end with the first one again.
  plane::Contour contour(const std::vector<Point>& points, const std::string& name, bool ring) {
    plane::Contour out;
    out.reserve(points.size());
    for (const Point& p : points) {
      try {
        out.push_back({.start = point(p)});
      } catch (const Error& e) {
        throw e.within(fmt::format("{}, vertex {}", name, out.size()));
      }
    }
    return ring ? once_round(std::move(out)) : out;
  }
  plane::Contour contour(std::span<const Position> points, const std::string& name, bool ring) {
    plane::Contour out = plane::grid_contour(grid_, points, name.c_str(), rounding_);
    return ring ? once_round(std::move(out)) : out;
  }

  /// With arcs. Of a chain the last edge is only its end point.
  plane::Contour contour(const Contour& given, const std::string& name, bool ring) {
    plane::Contour out;
    GridPoint at = point(given.start());
    for (const Contour::Step& step : given.steps()) {
      try {
        const GridPoint end = point(step.end);
        if (end != at) out.push_back(edge(at, step, end));
        at = end;
      } catch (const Error& e) {
        throw e.within(fmt::format("{}, edge {}", name, &step - given.steps().data()));
      }
    }
    if (!ring || (!out.empty() && out.front().start != at)) out.push_back({.start = at});
    return out;
  }

  Shape shape(Tree tree, int dimension = 2) const {
    return make_shape(std::make_shared<const Tree>(std::move(tree)), grid_, dimension, rounding_);
  }
  Shape shape(plane::ShapePtr tree) const { return make_shape(std::move(tree), grid_, 2, rounding_); }

 private:
  static plane::Contour once_round(plane::Contour ring) {
    if (ring.size() > 1 && ring.front().start == ring.back().start) ring.pop_back();
    return ring;
  }

  plane::ContourEdge edge(GridPoint at, const Contour::Step& step, GridPoint end) {
    using Kind = Contour::Step::Kind;
    switch (step.kind) {
      case Kind::kLine:
        break;
      case Kind::kBulge: {
        const exact::Real bulge = api::real_of(step.by.x);
        if (bulge.sign() == 0) break;
        return plane::bulge_arc(at, end, bulge);
      }
      case Kind::kThrough: {
        const GridPoint middle = point(step.by);
        if (middle == at || middle == end)
          throw Error(ErrorCode::kGeometry, "the third point of an arc is one of its ends");
        return plane::three_point_arc(at, middle, end);
      }
      case Kind::kAboutLeft:
      case Kind::kAboutRight:
        return about(at, end, point(step.by), step.kind == Kind::kAboutLeft);
    }
    return {.start = at};
  }

  static plane::ContourEdge about(GridPoint at, GridPoint end, GridPoint center, bool ccw) {
    const auto square = [&](GridPoint p) {
      const exact::int128 dx = p.x - center.x, dy = p.y - center.y;
      return dx * dx + dy * dy;
    };
    if (square(at) != square(end))
      throw Error(ErrorCode::kGeometry, "the ends of the arc are not equally far from its centre on the grid");
    return plane::center_arc(at, end, center, ccw);
  }

  plane::Grid grid_;
  RoundingLog rounding_;
};

template <class Ring, class Holes>
Shape rings(const Ring& ring, const Holes& holes, const Grid& grid) {
  Reader reader(grid);
  std::vector<plane::Contour> all;
  all.reserve(1 + std::size(holes));
  all.push_back(reader.contour(ring, "ring", true));
  for (const auto& hole : holes) all.push_back(reader.contour(hole, fmt::format("hole {}", all.size() - 1), true));
  const auto tree = std::make_shared<Tree>();
  tree->kind = Tree::Kind::kRings;
  tree->contours = plane::make_rings(std::move(all), reader.grid().step_size()).contours;
  return reader.shape(tree);
}

template <class Points>
Shape chain(const Points& points, const Grid& grid) {
  Reader reader(grid);
  Tree tree;
  tree.kind = Tree::Kind::kPolyline;
  std::int64_t repeated = 0;
  tree.contours = {plane::make_chain(reader.contour(points, "chain", false), repeated)};
  return reader.shape(std::move(tree));
}

template <class Points>
Shape lone_points(const Points& points, const Grid& grid) {
  if (std::size(points) == 0) throw Error(ErrorCode::kGeometry, "no points");
  Reader reader(grid);
  Tree tree;
  tree.kind = Tree::Kind::kPoints;
  for (const plane::ContourEdge& e : reader.contour(points, "points", false)) tree.points.push_back(e.start);
  return reader.shape(std::move(tree));
}

/// Of one dimension and on one grid.
Shape combined(Tree::Kind kind, const std::vector<Shape>& shapes, std::size_t least) {
  if (shapes.size() < least)
    throw Error(ErrorCode::kBadValue,
                fmt::format("{} shape{} at least, not {}", least, least == 1 ? "" : "s", shapes.size()));
  plane::Grid grid = shapes[0].data().grid;
  for (const Shape& s : shapes) {
    if (s.dimension() != shapes[0].dimension())
      throw Error(ErrorCode::kBadValue, "shapes of the plane and of space together");
    grid = api::common_grid(grid, s.data().grid);
  }
  Tree tree;
  tree.kind = kind;
  for (const Shape& s : shapes) tree.children.push_back(api::tree_on(s, grid));
  return make_shape(std::make_shared<const Tree>(std::move(tree)), grid, shapes[0].dimension());
}

Tree over(Tree::Kind kind, const Shape& shape) {
  Tree tree;
  tree.kind = kind;
  tree.children = {api::tree_of(shape)};
  return tree;
}

Shape on_grid_of(const Shape& shape, Tree tree, const RoundingLog& rounding = {}) {
  return make_shape(std::make_shared<const Tree>(std::move(tree)), shape.data().grid, shape.dimension(), rounding);
}

}  // namespace

Shape Shape::polygon(const Ring& ring, const std::vector<Ring>& holes, const Grid& grid) {
  return rings(ring, holes, grid);
}
Shape Shape::polygon(std::span<const Position> ring, const std::vector<std::span<const Position>>& holes,
                     const Grid& grid) {
  return rings(ring, holes, grid);
}
Shape Shape::polygon(const Contour& ring, const std::vector<Contour>& holes, const Grid& grid) {
  return rings(ring, holes, grid);
}

std::vector<Shape> Shape::polygons(std::span<const std::span<const Position>> given, const Grid& grid) {
  constexpr std::size_t kBlock = 64;
  std::vector<std::shared_ptr<const Data>> made(given.size());
  plane::parallel_for((given.size() + kBlock - 1) / kBlock, [&](std::size_t block) {
    for (std::size_t k = block * kBlock; k < std::min(given.size(), (block + 1) * kBlock); ++k) {
      try {
        made[k] = rings(given[k], std::array<std::span<const Position>, 0>{}, grid).data_;
      } catch (const Error& e) {
        throw e.within(fmt::format("polygon {}", k));
      }
    }
  });
  std::vector<Shape> out;
  out.reserve(made.size());
  for (auto& data : made) out.push_back(Shape(std::move(data)));
  return out;
}

Shape Shape::disc(const Point& center, const Number& radius, const Grid& grid) {
  Reader reader(grid);
  Tree tree;
  tree.kind = Tree::Kind::kDisc;
  tree.points = {reader.point(center)};
  tree.amount = reader.length(radius);
  if (tree.amount.sign() <= 0) throw Error(ErrorCode::kBadValue, "a radius must be more than 0");
  return reader.shape(std::move(tree));
}

Shape Shape::box(const Point& min, const Point& max, const Grid& grid) {
  Reader reader(grid);
  const GridPoint a = reader.point(min), b = reader.point(max);
  if (a.x >= b.x || a.y >= b.y)
    throw Error(ErrorCode::kGeometry, "the least corner of a box must be less than the greatest in every coordinate");
  Tree tree;
  tree.kind = Tree::Kind::kRings;
  plane::Contour& ring = tree.contours.emplace_back();
  for (const GridPoint p : {a, GridPoint{b.x, a.y}, b, GridPoint{a.x, b.y}}) ring.push_back({.start = p});
  return reader.shape(std::move(tree));
}

Shape Shape::points(const std::vector<Point>& points, const Grid& grid) { return lone_points(points, grid); }
Shape Shape::points(std::span<const Position> points, const Grid& grid) { return lone_points(points, grid); }
Shape Shape::polyline(const std::vector<Point>& points, const Grid& grid) { return chain(points, grid); }
Shape Shape::polyline(std::span<const Position> points, const Grid& grid) { return chain(points, grid); }
Shape Shape::polyline(const Contour& given, const Grid& grid) { return chain(given, grid); }

Shape::Shape(const Region& region) {
  Tree tree;
  tree.kind = Tree::Kind::kCells;
  tree.cells = std::shared_ptr<const plane::Region>(region.shared_data(), &region.data().cells);
  data_ = std::make_shared<const Data>(std::make_shared<const Tree>(std::move(tree)), region.data().grid, 2);
}

Shape Shape::collection(const std::vector<std::pair<std::string, Shape>>& parts) {
  std::vector<Shape> shapes;
  for (const auto& [name, part] : parts) {
    Tree named = *api::tree_of(part);
    named.name = name;
    shapes.push_back(make_shape(std::make_shared<const Tree>(std::move(named)), part.data().grid, part.dimension()));
  }
  const Shape all = combined(Tree::Kind::kUnion, shapes, 1);
  Tree tree = *api::tree_of(all);
  tree.collection = true;
  return make_shape(std::make_shared<const Tree>(std::move(tree)), all.data().grid, all.dimension());
}

Shape Shape::unite(const std::vector<Shape>& shapes) { return combined(Tree::Kind::kUnion, shapes, 1); }
Shape Shape::intersect(const std::vector<Shape>& shapes) { return combined(Tree::Kind::kIntersection, shapes, 1); }
Shape Shape::subtract(const std::vector<Shape>& shapes) { return combined(Tree::Kind::kDifference, shapes, 2); }
Shape Shape::complement(const Shape& shape) { return on_grid_of(shape, over(Tree::Kind::kComplement, shape)); }
Shape Shape::interior(const Shape& shape) { return on_grid_of(shape, over(Tree::Kind::kInterior, shape)); }
Shape Shape::closure(const Shape& shape) { return on_grid_of(shape, over(Tree::Kind::kClosure, shape)); }
Shape Shape::boundary(const Shape& shape) { return on_grid_of(shape, over(Tree::Kind::kBoundary, shape)); }
Shape Shape::regularize(const Shape& shape) { return on_grid_of(shape, over(Tree::Kind::kRegularize, shape)); }
Shape Shape::hull(const Shape& shape) { return on_grid_of(shape, over(Tree::Kind::kHull, shape)); }
Shape Shape::reflect(const Shape& shape) { return on_grid_of(shape, over(Tree::Kind::kMirror, shape)); }
Shape Shape::minkowski_sum(const Shape& a, const Shape& b) { return combined(Tree::Kind::kMinkowskiSum, {a, b}, 2); }
Shape Shape::minkowski_difference(const Shape& a, const Shape& b) {
  return combined(Tree::Kind::kMinkowskiDifference, {a, b}, 2);
}

Shape Shape::offset(const Shape& shape, const Number& radius) {
  Tree tree = over(Tree::Kind::kOffset, shape);
  tree.amount = shape.data().grid.steps(api::real_of(radius));
  return on_grid_of(shape, std::move(tree));
}

Shape Shape::translated(const Point& by) const { return translated(Point3{by.x, by.y, 0}); }

Shape Shape::translated(const Point3& by) const {
  const exact::Real z = api::real_of(by.z);
  if (dimension() == 2 && z.sign() != 0) throw Error(ErrorCode::kBadValue, "a shape of the plane has no height");
  RoundingLog rounding;
  double moved = 0;
  Tree tree = over(Tree::Kind::kTranslate, *this);
  tree.points = {data_->grid.nearest(api::real_of(by.x), api::real_of(by.y), rounding)};
  tree.lift = data_->grid.nearest(z, moved);
  rounding.add(moved, 0);
  return on_grid_of(*this, std::move(tree), rounding);
}

Shape Shape::rotated(const Number& degrees, const Point& about) const {
  if (dimension() == 3) return rotated(degrees, Axis::kZ, {about.x, about.y, 0});
  RoundingLog rounding;
  Tree tree = over(Tree::Kind::kRotate, *this);
  tree.degrees = api::real_of(degrees);
  tree.points = {data_->grid.nearest(api::real_of(about.x), api::real_of(about.y), rounding)};
  return on_grid_of(*this, std::move(tree), rounding);
}

Shape Shape::rotated(const Number& degrees, Axis axis, const Point3& about) const {
  if (dimension() == 2) throw Error(ErrorCode::kBadValue, "an axis is for shapes of space");
  RoundingLog rounding;
  double moved = 0;
  const GridPoint c = data_->grid.nearest(api::real_of(about.x), api::real_of(about.y), rounding);
  const std::int64_t height = data_->grid.nearest(api::real_of(about.z), moved);
  plane::Rounding moved_points;
  const auto rotation = space::Rotation::about_axis(int(axis), api::real_of(degrees), {c.x, c.y, height});
  plane::ShapePtr tree = space::rotated(*data_->tree, rotation, moved_points);
  rounding.points += moved_points.points;
  rounding.largest = std::max(rounding.largest, moved_points.largest);
  return make_shape(std::move(tree), data_->grid, 3, rounding);
}

int Shape::dimension() const { return data_->dimension; }
Grid Shape::grid() const { return api::public_grid(data_->grid); }
Shape::Rounded Shape::rounded() const {
  return {std::size_t(data_->rounding.points), data_->rounding.largest * data_->grid.step_size()};
}

Shape::Rounded Shape::rotated_points() const {
  region();
  return {std::size_t(data_->rotated.points), data_->rotated.largest * data_->grid.step_size()};
}

const Region& Shape::region() const {
  if (dimension() == 3) throw Error(ErrorCode::kUnsupported, "a shape of space is not a region of the plane");
  std::call_once(data_->made, [&] {
    plane::BuildResult built = plane::build(*data_->tree, data_->grid.step_size(), data_->work);
    data_->rotated = built.rounding;
    data_->region = api::make_region(std::move(built.region), data_->grid, data_->unit);
  });
  return *data_->region;
}

}  // namespace findspace
