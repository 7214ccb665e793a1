// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Shape trees of solids for tests.
#pragma once

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

inline plane::ShapePtr node(plane::Shape::Kind kind, std::vector<plane::ShapePtr> children, const Point& by = {}) {
  plane::Shape shape;
  shape.kind = kind;
  shape.children = std::move(children);
  shape.points = {{by.x, by.y}};
  shape.lift = by.z;
  return std::make_shared<const plane::Shape>(std::move(shape));
}

}  // namespace findspace::space
