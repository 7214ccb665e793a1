// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/solid_problem/container_shape.h"

#include <findspace/error.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include "exact/solid/space_sign.h"
#include "space/body/cell_parts.h"
#include "space/body/csg_solid.h"
#include "space/phi/plane_scan.h"
#include "space/polytope/polytope_sets.h"

namespace findspace::packing {
namespace {

using space::Point;
using space::Vector;

constexpr double kUnbounded = std::numeric_limits<double>::infinity();

/// What lies in all of `balls` and `flats` and in no `without`; coordinates are in steps / scale.
struct Cut {
  std::vector<space::BodyPart> balls, without;
  std::vector<space::Body> flats;
  std::int64_t scale = 1;
};

bool is_ball(const space::BodyPart& part) { return part.point() && part.radius.fraction(); }

bool is_flat(const space::Body& body) {
  return std::all_of(body.parts.begin(), body.parts.end(),
                     [](const space::BodyPart& p) { return p.core && p.radius.sign() == 0; });
}

Cut cut_of(const space::CsgSolid& solid) {
  Cut cut;
  cut.scale = solid.scale;
  const auto refuse = [] {
    throw Error(ErrorCode::kUnsupported,
                "a container is a solid with flat faces, a ball, what such have in common, or one less others");
  };
  if (solid.containers.empty()) refuse();
  for (const space::Body& body : solid.containers) {
    if (body.outside) throw Error(ErrorCode::kUnsupported, "a container is bounded");
    if (body.rounded > 0) refuse();
    if (body.parts.size() == 1 && is_ball(body.parts[0]))
      cut.balls.push_back(body.parts[0]);
    else if (is_flat(body))
      cut.flats.push_back(body);
    else
      refuse();
  }
  for (const space::Body& body : solid.obstacles)
    for (const space::BodyPart& part : body.parts) {
      if (body.outside || body.rounded > 0 || !(is_ball(part) || (part.core && part.radius.sign() == 0))) refuse();
      cut.without.push_back(part);
    }
  return cut;
}
/// Of one surface, or of parts that are exact.
SolidForm flat_form(const plane::Shape& shape, space::Body body) {
  SolidForm form;
  form.body = std::move(body);
  auto surfaces = space::try_ray_solids(shape);
  if (surfaces && surfaces->size() == 1 && !(*surfaces)[0].inner_walls)
    form.surface = *std::move(surfaces);
  else if (!surfaces && surfaces.refusal().fault())
    throw surfaces.refusal().error;
  else if (!form.is_exact())
    throw Error(ErrorCode::kOutOfRange, "the convex parts of a container have corners with too many digits");
  return form;
}

/// Low and high corners on the grid.
using GridBox = std::array<Point, 2>;

GridBox grid_box(const space::Body& body) {
  const space::Bounds3 box = space::bounds(body);
  const exact::Real scale(body.scale);
  const auto below = [&](const exact::Real& c) { return std::int64_t(exact::floor(c / scale)); };
  const auto above = [&](const exact::Real& c) { return -below(-c); };
  return {{{below(box.low[0]), below(box.low[1]), below(box.low[2])},
           {above(box.high[0]), above(box.high[1]), above(box.high[2])}}};
}

GridBox grid_box(const SolidForm& form) {
  if (form.surface.empty()) return grid_box(form.body);
  Point low, high;
  bool any = false;
  space::extend_box(form.surface, low, high, any);
  return {low, high};
}

/// That of all that hold it.
GridBox grid_box(const Cut& cut) {
  std::vector<space::Body> bodies = cut.flats;
  for (const space::BodyPart& ball : cut.balls) bodies.push_back({.parts = {ball}, .scale = cut.scale});
  GridBox result = grid_box(bodies[0]);
  for (const space::Body& body : bodies) {
    const auto [low, high] = grid_box(body);
    Point &l = result[0], &h = result[1];
    l = {std::max(l.x, low.x), std::max(l.y, low.y), std::max(l.z, low.z)};
    h = {std::min(h.x, high.x), std::min(h.y, high.y), std::min(h.z, high.z)};
  }
  const Point size = result[1] - result[0];
  if (size.x <= 0 || size.y <= 0 || size.z <= 0) throw Error(ErrorCode::kGeometry, "a container holds nothing");
  return result;
}

bool is_box(const SolidForm& form, const Point& end) {
  const std::vector<Point>& points = form.surface[0].surface.points;
  const auto is_corner = [&](const Point& p) {
    return (p.x == 0 || p.x == end.x) && (p.y == 0 || p.y == end.y) && (p.z == 0 || p.z == end.z);
  };
  return points.size() == 8 && form.body.convex() && std::all_of(points.begin(), points.end(), is_corner);
}

/// What the box from the origin has and the flat parts of a body lack, as cells.
space::Body rest_of_box(const space::Body& body, const Point& end) {
  std::vector<Point> corners;
  for (int k = 0; k < 8; ++k)
    corners.push_back({(k & 1) != 0 ? end.x * body.scale : 0, (k & 2) != 0 ? end.y * body.scale : 0,
                       (k & 4) != 0 ? end.z * body.scale : 0});
  const space::Polytope box = space::Polytope::hull(corners);
  std::vector<space::Polytope> parts;
  for (const space::BodyPart& part : body.parts) parts.push_back(*part.core);
  space::Body rest = space::body_of(space::parts_of_cells(space::difference_cells({&box, 1}, parts)));
  rest.scale *= body.scale;
  if (rest.rounded > 0) throw Error(ErrorCode::kOutOfRange, "a container has corners with too many digits");
  return rest;
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

/// By the divergence of (0, 0, min(z, height)).
double volume_below(const std::array<Vector, 3>& face, double height) {
  double sum = volume_under(face[0], face[1], face[2]);
  const std::vector<Vector> cut = above(face, height);
  for (std::size_t k = 1; k + 1 < cut.size(); ++k) sum -= volume_under(cut[0], cut[k], cut[k + 1]);
  return sum;
}

double volume_below(const space::Triangles& surface, double steps, double height) {
  double sum = 0;
  for (const auto& face : surface.faces) {
    std::array<Vector, 3> corners;
    for (std::size_t k = 0; k < 3; ++k)
      corners[k] = space::scaled(1 / steps, exact::approx(surface.points[std::size_t(face[k])]));
    sum += volume_below(corners, height);
  }
  return sum;
}

double volume_below(const space::Polytope& polytope, double steps, double height) {
  double sum = 0;
  const auto corner = [&](int v) {
    return space::scaled(1 / steps, exact::approx(polytope.vertices()[std::size_t(v)]));
  };
  for (int f = 0; f < polytope.facet_count(); ++f) {
    const std::vector<int> ring = polytope.circuit(f);
    for (std::size_t k = 1; k + 1 < ring.size(); ++k)
      sum += volume_below({corner(ring[0]), corner(ring[k]), corner(ring[k + 1])}, height);
  }
  return sum;
}

double volume_below(const space::BodyPart& ball, double steps, double height) {
  const double radius = ball.radius.to_double() / steps, low = double(ball.center.z) / steps - radius;
  const double up = std::clamp(height - low, 0.0, 2 * radius);
  return std::numbers::pi / 3 * up * up * (3 * radius - up);
}

/// One ball of which nothing is cut off; its box says so.
bool is_whole_ball(const SolidContainer& container, int128 steps) {
  const space::Body& inside = container.inside->body;
  if (!container.inside->has_balls() || !inside.convex() || container.lacks) return false;
  const exact::Real across = exact::Real(2) * inside.parts[0].radius;
  const Fraction sides[] = {container.width, container.depth, container.height};
  return std::none_of(std::begin(sides), std::end(sides), [&](const Fraction& side) {
    return in_steps(side, bounded_product(steps, inside.scale)) < across;
  });
}

/// The stretch of a line along x that a part holds; `steps` of its coordinates in a unit.
space::LineStretch stretch_of(const space::BodyPart& part, double steps, double y, double z) {
  if (!part.core) {
    const Vector c = space::scaled(1 / steps, exact::approx(part.center));
    const double radius = part.radius.to_double() / steps;
    const double square = radius * radius - (y - c.y) * (y - c.y) - (z - c.z) * (z - c.z);
    return square > 0 ? space::LineStretch{c.x - std::sqrt(square), c.x + std::sqrt(square)} : space::LineStretch{};
  }
  space::LineStretch result{-kUnbounded, kUnbounded};
  for (const space::Plane& plane : part.core->planes()) {
    const Vector n = exact::approx(plane.normal);
    const double rest = n.y * y + n.z * z + double(plane.offset) / steps;
    if (n.x == 0 && rest > 0) return {};
    if (n.x > 0) result.to = std::min(result.to, -rest / n.x);
    if (n.x < 0) result.from = std::max(result.from, -rest / n.x);
  }
  return result;
}

/// What the balls of an inside have in common, without what is lacking, on lines along x.
double volume_on_lines(const SolidContainer& container, double steps, double height) {
  constexpr int kLines = 128;  // each way
  const double width = container.width.to_double(), dy = container.depth.to_double() / kLines, dz = height / kLines;
  double sum = 0;
  std::vector<space::LineStretch> lacking;
  for (int k = 0; k < kLines * kLines; ++k) {
    const int row = k / kLines, line = k % kLines;
    const double y = (line + 0.5) * dy, z = (row + 0.5) * dz;
    space::LineStretch held{0, width};
    const auto visit = [&](const SolidForm& form, const auto& take) {
      for (const space::BodyPart& part : form.body.parts) take(stretch_of(part, steps * double(form.body.scale), y, z));
    };
    if (container.inside->has_balls())
      visit(*container.inside, [&](const space::LineStretch& t) {
        held = {std::max(held.from, t.from), std::min(held.to, t.to)};
      });
    lacking.clear();
    if (container.lacks) visit(*container.lacks, [&](const space::LineStretch& t) { lacking.push_back(t); });
    std::sort(lacking.begin(), lacking.end(), [](const auto& a, const auto& b) { return a.from < b.from; });
    double length = std::max(held.to - held.from, 0.0);
    for (const space::LineStretch& t : lacking) {
      length -= std::max(std::min(held.to, t.to) - std::max(held.from, t.from), 0.0);
      held.from = std::max(held.from, t.to);
    }
    sum += length;
  }
  return sum * dy * dz;
}

/// Of a shape with flat faces, its parts cells that do not overlap or its surface.
void set_flat(SolidContainer& container, SolidForm form, const GridBox& box) {
  const Point low = box[0], end = box[1] - low;
  form.body = space::translated(std::move(form.body), -low);
  if (!form.surface.empty()) {
    form.surface[0] = space::moved(std::move(form.surface[0]), -low);
    if (is_box(form, end)) return;
  } else {
    SolidForm rest{.body = rest_of_box(form.body, end)};
    if (rest.body.parts.empty()) return;
    container.lacks = std::make_shared<const SolidForm>(std::move(rest));
  }
  container.inside = std::make_shared<const SolidForm>(std::move(form));
}

/// What the box lacks of the sets with flat faces, and what is cut out, from the origin; the parts may overlap.
space::Body lacking(const Cut& cut, const GridBox& box) {
  const Point low = box[0];
  std::vector<space::Body> bodies;
  for (const space::Body& flat : cut.flats) bodies.push_back(rest_of_box(space::translated(flat, -low), box[1] - low));
  bodies.push_back(space::translated({.parts = cut.without, .scale = cut.scale}, -low));
  std::vector<const space::Body*> parts;
  for (const space::Body& body : bodies)
    if (!body.parts.empty()) parts.push_back(&body);
  return parts.empty() ? space::Body{} : space::united(parts);
}

void set_cut(SolidContainer& container, const Cut& cut, const GridBox& box) {
  const Point low = box[0], end = box[1] - low;
  SolidForm inside, lacks{.body = lacking(cut, box)};
  if (cut.balls.empty() && !lacks.has_balls()) {
    inside.body = rest_of_box(lacks.body, end);
    if (inside.body.parts.empty()) throw Error(ErrorCode::kGeometry, "a container holds nothing");
    return set_flat(container, std::move(inside), {Point{}, end});
  }
  inside.body =
      space::translated(cut.balls.empty() ? cut.flats[0] : space::Body{.parts = cut.balls, .scale = cut.scale}, -low);
  container.inside = std::make_shared<const SolidForm>(std::move(inside));
  if (!lacks.body.parts.empty()) container.lacks = std::make_shared<const SolidForm>(std::move(lacks));
}

}  // namespace

void set_shape(SolidContainer& container, const plane::Shape& shape, int128 steps) {
  exact::Tried<space::Body> body = space::try_body(shape);
  if (!body && body.refusal().fault()) throw body.refusal().error;
  if (body && body->outside) throw Error(ErrorCode::kUnsupported, "a container is bounded");
  GridBox box;
  if (body && !body->round()) {
    SolidForm form = flat_form(shape, *std::move(body));
    box = grid_box(form);
    set_flat(container, std::move(form), box);
  } else {
    const Cut cut = cut_of(body ? space::uncut(*std::move(body)) : space::csg_solid(shape));
    box = grid_box(cut);
    set_cut(container, cut, box);
  }
  const Point end = box[1] - box[0];
  container.width = Fraction(end.x, steps);
  container.depth = Fraction(end.y, steps);
  container.height = Fraction(end.z, steps);
}

double volume_below(const SolidProblem& problem, const SolidContainer& container, double height) {
  height = std::clamp(height, 0.0, container.height.to_double());
  const double box = container.width.to_double() * container.depth.to_double() * height;
  if (!container.inside) return box;
  const double steps = double(problem.steps());
  const SolidForm& inside = *container.inside;
  if (!inside.surface.empty()) return volume_below(inside.surface[0].surface, steps, height);
  if (is_whole_ball(container, problem.steps()))
    return volume_below(inside.body.parts[0], steps * double(inside.body.scale), height);
  if (inside.has_balls() || container.lacks->has_balls()) return volume_on_lines(container, steps, height);
  double sum = box;
  const space::Body& lacks = container.lacks->body;
  for (const space::BodyPart& part : lacks.parts) sum -= volume_below(*part.core, steps * double(lacks.scale), height);
  return sum;
}

double volume_of(const SolidProblem& problem, const SolidContainer& container) {
  return volume_below(problem, container, container.height.to_double());
}

}  // namespace findspace::packing
