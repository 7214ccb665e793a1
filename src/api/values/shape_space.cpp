// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Shapes of space.

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "api/values/shape_data.h"
#include "findspace/error.h"
#include "findspace/shape.h"
#include "space/mesh/height_field.h"
#include "space/mesh/mesh.h"
#include "space/polytope/solid.h"

namespace findspace {

using space::Solid;

namespace {

class SpaceReader {
 public:
  explicit SpaceReader(const Grid& grid) : grid_(api::grid_of(grid)) {}

  const plane::Grid& grid() const { return grid_; }

  space::Point point(const Point3& p) {
    return put([&](int i, double& moved) {
      return grid_.nearest(api::real_of(*std::array{&p.x, &p.y, &p.z}[i]), moved);
    });
  }
  space::Point point(const Position3& p) {
    return put([&](int i, double& moved) { return grid_.nearest(p[std::size_t(i)], moved); });
  }
  std::vector<space::Point> points(std::span<const Position3> given) {
    std::vector<space::Point> out;
    out.reserve(given.size());
    for (const Position3& p : given) {
      try {
        out.push_back(point(p));
      } catch (const Error& e) {
        throw e.within(fmt::format("vertex {}", out.size()));
      }
    }
    return out;
  }

  plane::RoundingLog& rounding() { return rounding_; }
  Shape shape(Solid solid) const {
    solid.step = grid_.step_size();
    plane::Shape tree;
    tree.solid = std::make_shared<const Solid>(std::move(solid));
    return api::make_shape(std::make_shared<const plane::Shape>(std::move(tree)), grid_, 3, rounding_);
  }

 private:
  template <class Coordinate>
  space::Point put(Coordinate coordinate) {
    double x = 0, y = 0, z = 0;
    const space::Point p{coordinate(0, x), coordinate(1, y), coordinate(2, z)};
    rounding_.add(std::hypot(x, y), z);
    return p;
  }

  plane::Grid grid_;
  plane::RoundingLog rounding_;
};

template <class Faces>
Shape mesh_of(std::span<const Position3> vertices, const Faces& faces, const Grid& grid) {
  SpaceReader reader(grid);
  Solid solid;
  solid.form = Solid::Form::kMesh;
  solid.mesh.vertices = reader.points(vertices);
  solid.mesh.faces.reserve(std::size(faces));
  for (const auto& face : faces) {
    for (const std::int32_t v : face) {
      if (v < 0 || std::size_t(v) >= vertices.size())
        throw Error(ErrorCode::kBadValue, fmt::format("there is no vertex {} of {}", v, vertices.size()),
                    fmt::format("face {}", solid.mesh.faces.size()));
    }
    solid.mesh.faces.emplace_back(face.begin(), face.end());
  }
  space::clean(solid.mesh, reader.grid().step_size());
  return reader.shape(std::move(solid));
}

}  // namespace

Shape Shape::polytope(std::span<const Position3> points, const Grid& grid) {
  SpaceReader reader(grid);
  Solid solid;
  solid.mesh.vertices = reader.points(points);
  space::Polytope::hull(solid.mesh.vertices);  // refuses what is flat
  return reader.shape(std::move(solid));
}

Shape Shape::box(const Point3& min, const Point3& max, const Grid& grid) {
  SpaceReader reader(grid);
  const space::Point a = reader.point(min), b = reader.point(max);
  if (a.x >= b.x || a.y >= b.y || a.z >= b.z)
    throw Error(ErrorCode::kGeometry, "the least corner of a box must be less than the greatest in every coordinate");
  Solid solid;
  for (int i = 0; i < 8; ++i) solid.mesh.vertices.push_back({i & 1 ? b.x : a.x, i & 2 ? b.y : a.y, i & 4 ? b.z : a.z});
  return reader.shape(std::move(solid));
}

Shape Shape::ball(const Point3& center, const Number& radius, const Grid& grid) {
  SpaceReader reader(grid);
  Solid solid;
  solid.form = Solid::Form::kBall;
  solid.mesh.vertices = {reader.point(center)};
  solid.radius = reader.grid().steps(api::real_of(radius));
  if (solid.radius.sign() <= 0) throw Error(ErrorCode::kBadValue, "a radius must be more than 0");
  return reader.shape(std::move(solid));
}

Shape Shape::prism(const Shape& polygon, const Number& low, const Number& high) {
  const plane::Shape& base = *api::tree_of(polygon);
  if (polygon.dimension() != 2 || base.kind != plane::Shape::Kind::kRings)
    throw Error(ErrorCode::kBadValue, "the base of a prism is a polygon");
  const plane::Grid& grid = polygon.data().grid;
  plane::RoundingLog rounding = polygon.data().rounding;
  double moved[2] = {0, 0};
  Solid solid;
  solid.form = Solid::Form::kPrism;
  solid.contours = base.contours;
  solid.low = grid.nearest(api::real_of(low), moved[0]);
  solid.high = grid.nearest(api::real_of(high), moved[1]);
  for (const double m : moved) rounding.add(m, 0);
  if (solid.low >= solid.high) throw Error(ErrorCode::kGeometry, "the height of a prism must be more than 0");
  plane::Shape tree;
  tree.solid = std::make_shared<const Solid>(std::move(solid));
  return api::make_shape(std::make_shared<const plane::Shape>(std::move(tree)), grid, 3, rounding);
}

Shape Shape::height_field(const HeightField& given, const Grid& grid) {
  const std::size_t columns = given.columns, rows = columns == 0 ? 0 : given.heights.size() / columns;
  if (columns * rows != given.heights.size())
    throw Error(ErrorCode::kBadValue, fmt::format("{} heights are no rows of {} each", given.heights.size(), columns));
  const auto pair = [](const Point& p) { return std::array{api::real_of(p.x), api::real_of(p.y)}; };
  SpaceReader reader(grid);
  space::HeightField field({columns, rows, pair(given.at), pair(given.step), api::real_of(given.floor)}, reader.grid());
  const auto is_missing = [&](double height) {
    return given.missing && (std::isnan(*given.missing) ? std::isnan(height) : height == *given.missing);
  };
  const auto put = [&](std::size_t row, std::size_t column) {
    const double given_height = given.heights[row * columns + column];
    if (is_missing(given_height)) return;
    try {
      double moved = 0;
      const std::int64_t height = reader.grid().nearest(given_height, moved);
      field.put(column, row, height, moved);
    } catch (const Error& e) {
      throw e.within(fmt::format("row {}, column {}", row, column));
    }
  };
  for (std::size_t row = 0; row < rows; ++row)
    for (std::size_t column = 0; column < columns; ++column) put(row, column);
  std::vector<std::string> notes;
  return reader.shape(field.solid(reader.rounding(), notes));
}

Shape Shape::mesh(std::span<const Position3> vertices, std::span<const std::array<std::int32_t, 3>> triangles,
                  const Grid& grid) {
  return mesh_of(vertices, triangles, grid);
}
Shape Shape::mesh(std::span<const Position3> vertices, const std::vector<std::vector<std::int32_t>>& faces,
                  const Grid& grid) {
  return mesh_of(vertices, faces, grid);
}

}  // namespace findspace
