// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/solid_depth/ball_walls.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "exact/margins/packing.h"
#include "space/polytope/min_ball.h"

namespace findspace::packing {
namespace {

constexpr double kDualGrid = 0x1p36;  // no sign: a grid of the search

/// A ball that the position lies in.
struct Reach {
  Vector center;
  double radius;
};

class Places {
 public:
  Places(const space::Body& body, double steps, const ContainerWalls::Ball& ball, double edge) {
    std::vector<space::RealVector> ends;
    for (const space::BodyPart& part : body.parts) {
      const double radius = part.radius.to_double() / steps;
      for (const space::Point& p : part.vertices()) {
        const Vector at = (1 / steps) * exact::approx(p);
        reaches_.push_back({ball.center - at, ball.radius - edge - radius});
        for (const Vector& axis : {Vector{radius, 0, 0}, Vector{0, radius, 0}, Vector{0, 0, radius}}) {
          ends.push_back(space::real(at + axis));
          if (radius > 0) ends.push_back(space::real(at - axis));
          if (radius <= 0) break;
        }
      }
    }
    middle_ = ball.center - space::rounded(space::min_ball(ends).center);
    room_ = std::numeric_limits<double>::infinity();
    for (const Reach& r : reaches_) room_ = std::min(room_, r.radius - space::length(middle_ - r.center));
  }

  const Vector& middle() const { return middle_; }
  /// How far every way from the middle is free.
  double room() const { return room_; }

  /// How far it is free in a direction, and the normal of the plane that touches there.
  Facing end(const Vector& way) const {
    Facing result{std::numeric_limits<double>::infinity(), way};
    for (const Reach& r : reaches_) {
      const Vector from = middle_ - r.center;
      const double along = space::dot(from, way);
      const double t = std::sqrt(along * along + r.radius * r.radius - space::dot(from, from)) - along;
      if (t < result.value) result = {t, (1 / r.radius) * (from + t * way)};
    }
    return result;
  }

 private:
  std::vector<Reach> reaches_;
  Vector middle_;
  double room_;
};

/// The cube of this half side, of negative size where nothing fits.
std::vector<ContainerWalls::Plane> cube_about(const Vector& middle, double half) {
  std::vector<ContainerWalls::Plane> planes;
  for (const Vector& axis : {Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, 1}})
    for (const double sign : {-1.0, 1.0}) planes.push_back({sign * axis, half + sign * space::dot(axis, middle)});
  return planes;
}

/// Points n / h of the planes n . x = h that touch the places from the middle, on a grid.
std::vector<space::Point> dual_points(const Places& places, double scale) {
  std::vector<space::Point> points;
  for (const Vector& way : spread_directions()) {
    const Facing end = places.end(way);
    const Vector p = (scale / (end.value * space::dot(end.normal, way))) * end.normal;
    points.push_back({std::llround(p.x), std::llround(p.y), std::llround(p.z)});
  }
  return points;
}

/// By how much the polytope of these planes has to shrink: corners are facets of the dual.
double shrinking(const Places& places, const space::Polytope& dual, double scale) {
  double least = 1;
  for (const space::Plane& facet : dual.planes()) {
    const Vector normal = exact::approx(facet.normal);
    const double size = space::length(normal), far = scale * size / -double(facet.offset);
    least = std::min(least, places.end((1 / size) * normal).value / far);
  }
  return least;
}

}  // namespace

std::vector<ContainerWalls::Plane> ball_walls(const space::Body& body, double steps, const ContainerWalls::Ball& ball,
                                              double edge) {
  const Places places(body, steps, ball, edge);
  const double room = places.room();
  if (room < margin::kNoOverlap * ball.radius) return cube_about(places.middle(), std::min(room, 0.0));
  const double scale = kDualGrid * room;  // planes are no nearer than that
  const auto dual = space::Polytope::try_hull(dual_points(places, scale));
  if (!dual) return cube_about(places.middle(), room / std::numbers::sqrt3);
  const double shrunk = shrinking(places, *dual, scale);
  std::vector<ContainerWalls::Plane> planes;
  for (const space::Point& p : dual->vertices()) {
    const Vector way = exact::approx(p);
    const double size = space::length(way);
    const Vector normal = (1 / size) * way;
    planes.push_back({normal, shrunk * scale / size + space::dot(normal, places.middle())});
  }
  return planes;
}

/// A ball at u is about a part at -u.
void add_ball_walls(const space::Body& body, double steps, const ContainerWalls::Ball& ball, double edge,
                    ConvexOverlap& overlap, std::vector<space::PlaneBlock>& blocks) {
  std::vector<Vector> normals;
  std::vector<double> offsets;
  for (const ContainerWalls::Plane& plane : ball_walls(body, steps, ball, edge)) {
    normals.push_back(-1.0 * plane.normal);
    offsets.push_back(plane.offset);
  }
  double reach = space::length(ball.center) + ball.radius;
  for (const space::BodyPart& part : body.parts)
    for (const space::Point& p : part.vertices())
      reach = std::max(reach, space::length(ball.center) + ball.radius + space::length(exact::approx(p)) / steps);
  add_about(normals, offsets, reach, overlap, blocks);
}

}  // namespace findspace::packing
