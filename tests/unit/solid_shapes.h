// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Shape trees of solids for tests.
#pragma once

#include <algorithm>
#include <memory>
#include <vector>

#include "space/polytope/solid.h"

namespace findspace::space {

inline plane::ShapePtr primitive(Solid solid) {
  plane::Shape shape;
  shape.solid = std::make_shared<const Solid>(std::move(solid));
  return std::make_shared<const plane::Shape>(std::move(shape));
}

inline plane::ShapePtr ball(const Point& center, std::int64_t radius) {
  Solid solid;
  solid.form = Solid::Form::kBall;
  solid.mesh.vertices = {center};
  solid.radius = exact::Real(radius);
  return primitive(std::move(solid));
}

inline plane::ShapePtr hull(std::vector<Point> points) {
  Solid solid;
  solid.mesh.vertices = std::move(points);
  return primitive(std::move(solid));
}

/// Turned inside out where it is hollow.
inline void add_box(Mesh& mesh, const Point& low, const Point& high, bool hollow = false) {
  const int base = static_cast<int>(mesh.vertices.size());
  for (int i = 0; i < 8; ++i)
    mesh.vertices.push_back({i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z});
  for (std::vector<int> f :
       {std::vector{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
    for (int& v : f) v += base;
    if (hollow) std::reverse(f.begin(), f.end());
    mesh.faces.push_back(f);
  }
}

inline plane::ShapePtr node(plane::Shape::Kind kind, std::vector<plane::ShapePtr> children, const Point& by = {}) {
  plane::Shape shape;
  shape.kind = kind;
  shape.children = std::move(children);
  shape.points = {{by.x, by.y}};
  shape.lift = by.z;
  return std::make_shared<const plane::Shape>(std::move(shape));
}

}  // namespace findspace::space
