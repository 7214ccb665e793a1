// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/solid_problem/container_shape.h"

#include <findspace/error.h>

#include <algorithm>
#include <array>
#include <memory>
#include <utility>
#include <vector>

#include "exact/solid/space_sign.h"

namespace findspace::packing {
namespace {

using space::Point;
using space::Vector;

/// Of one surface; its box begins at the origin.
SolidForm form_of(const plane::Shape& shape) {
  SolidForm form;
  form.body = space::body(shape);
  if (form.body.outside || form.body.round())
    throw Error(ErrorCode::kUnsupported, "a container is a bounded solid with flat faces");
  form.surface = space::ray_solids(shape);
  if (form.surface.size() != 1)
    throw Error(ErrorCode::kUnsupported, "a container is one solid, not a union; state it as a mesh");
  Point low, high;
  bool any = false;
  space::extend_box(form.surface, low, high, any);
  form.body = space::translated(std::move(form.body), -low);
  form.surface[0].surface = space::moved(std::move(form.surface[0].surface), -low);
  return form;
}

Point end_of(const space::RaySolid& solid) {
  Point end;
  for (const Point& p : solid.surface.points) end = {std::max(end.x, p.x), std::max(end.y, p.y), std::max(end.z, p.z)};
  return end;
}

bool is_box(const SolidForm& form, const Point& end) {
  const std::vector<Point>& points = form.surface[0].surface.points;
  const auto is_corner = [&](const Point& p) {
    return (p.x == 0 || p.x == end.x) && (p.y == 0 || p.y == end.y) && (p.z == 0 || p.z == end.z);
  };
  return points.size() == 8 && form.body.convex() && std::all_of(points.begin(), points.end(), is_corner);
}

/// Of what a triangle with corners a, b, c has above or below the plane z = 0, by its sense from above.
double volume_under(const Vector& a, const Vector& b, const Vector& c) {
  const double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  return area / 6 * (a.z + b.z + c.z);
}

/// The part of a triangle above z = height, its corners from there up.
std::vector<Vector> above(const std::array<Vector, 3>& corners, double height) {
  std::vector<Vector> result;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector p = corners[k] - Vector{0, 0, height}, q = corners[(k + 1) % 3] - Vector{0, 0, height};
    if (p.z >= 0) result.push_back(p);
    if ((p.z < 0) != (q.z < 0)) {
      const double t = p.z / (p.z - q.z);
      result.push_back({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y), 0});
    }
  }
  return result;
}

}  // namespace

void set_shape(SolidContainer& container, const plane::Shape& shape, int128 steps) {
  auto inside = std::make_shared<SolidForm>(form_of(shape));
  const Point end = end_of(inside->surface[0]);
  container.width = Fraction(end.x, steps);
  container.depth = Fraction(end.y, steps);
  container.height = Fraction(end.z, steps);
  if (!is_box(*inside, end)) container.inside = std::move(inside);
}

/// By the divergence of (0, 0, min(z, height)).
double volume_below(const SolidProblem& problem, const SolidContainer& container, double height) {
  const double whole = container.height.to_double();
  if (!container.inside)
    return container.width.to_double() * container.depth.to_double() * std::clamp(height, 0.0, whole);
  const double step = 1 / double(problem.steps());
  const space::Triangles& surface = container.inside->surface[0].surface;
  double sum = 0;
  for (const auto& face : surface.faces) {
    std::array<Vector, 3> corners;
    for (std::size_t k = 0; k < 3; ++k)
      corners[k] = space::scaled(step, exact::approx(surface.points[std::size_t(face[k])]));
    sum += volume_under(corners[0], corners[1], corners[2]);
    const std::vector<Vector> cut = above(corners, height);
    for (std::size_t k = 1; k + 1 < cut.size(); ++k) sum -= volume_under(cut[0], cut[k], cut[k + 1]);
  }
  return sum;
}

double volume_of(const SolidProblem& problem, const SolidContainer& container) {
  return volume_below(problem, container, container.height.to_double());
}

}  // namespace findspace::packing
