// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/solid_depth/convex_overlap.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "exact/margins/packing.h"
#include "space/phi/contact_surface.h"

namespace findspace::packing {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

constexpr int kTangents = 256;  // about a ball: the planes stand out by a hundredth of the radius at most

void set_box(ConvexOverlap& overlap, const Vector& low, const Vector& high, double out) {
  overlap.low = low - Vector{out, out, out};
  overlap.high = high + Vector{out, out, out};
}

/// Of a face of A - B: on a side on which B is open, or of a tangent that cuts such a side's corners off.
bool is_open(const OpenSides& open, const Vector& n, bool is_tangent) {
  const std::array<double, 3> c{n.x, n.y, n.z};
  for (std::size_t k = 0; k < 3; ++k) {
    if (c[k] == 0 || !open[k][c[k] < 0 ? 1 : 0]) continue;
    if (is_tangent || (c[(k + 1) % 3] == 0 && c[(k + 2) % 3] == 0)) return true;
  }
  return false;
}

void open_box(const OpenSides& open, ConvexOverlap& overlap) {
  double* const low[] = {&overlap.low.x, &overlap.low.y, &overlap.low.z};
  double* const high[] = {&overlap.high.x, &overlap.high.y, &overlap.high.z};
  for (std::size_t k = 0; k < 3; ++k) {
    if (open[k][1]) *low[k] = -kFar;
    if (open[k][0]) *high[k] = kFar;
  }
}

/// The planes of A - B in units, farther out by the gap and the radius of a ball; `step` of the common grid.
void add_planes(const space::ContactSurface& surface, double step, double gap, double radius, const OpenSides& open,
                ConvexOverlap& overlap, std::vector<space::PlaneBlock>& blocks) {
  std::vector<Vector> normals, corners;
  std::vector<double> offsets;
  for (int f = 0; f < surface.facet_count(); ++f) {
    const space::Plane& plane = surface.raw_plane(f);
    const Vector n = exact::approx(plane.normal);
    const double size = space::length(n);
    if (is_open(open, n, false)) continue;
    normals.push_back((1 / size) * n);
    offsets.push_back(double(plane.offset) / size * step - gap - radius);
  }
  Vector low{kFar, kFar, kFar}, high{-kFar, -kFar, -kFar};
  for (const space::Point& p : surface.vertices()) {
    corners.push_back(step * exact::approx(p));
    low = least_of(low, corners.back());
    high = most_of(high, corners.back());
  }
  set_box(overlap, low, high, gap + radius);
  open_box(open, overlap);
  if (radius > 0)
    for (const Vector& n : spread_directions()) {
      if (is_open(open, n, true)) continue;
      double support = -kFar;
      for (const Vector& v : corners) support = std::max(support, space::dot(n, v));
      normals.push_back(n);
      offsets.push_back(-support - gap - radius);
    }
  const std::vector<space::PlaneBlock> packed = space::pack_planes(normals, offsets);
  blocks.insert(blocks.end(), packed.begin(), packed.end());
}

std::vector<space::BodyPart> rounded_parts(const space::Body& body, double factor) {
  std::vector<space::BodyPart> result;
  for (const space::BodyPart& part : body.parts) {
    std::vector<space::Point> points;
    for (const space::Point& p : part.vertices())
      points.push_back(
          {std::llround(double(p.x) * factor), std::llround(double(p.y) * factor), std::llround(double(p.z) * factor)});
    const exact::Real radius = exact::Real::from_double(part.radius.to_double() * factor);
    if (!part.core) result.push_back(space::part_of(points, radius));
    if (part.core && space::Polytope::try_hull(points)) result.push_back(space::part_of(points, radius));
  }
  return result;
}

double farthest(const space::Body& body) {
  double most = 1;
  for (const space::BodyPart& part : body.parts)
    for (const space::Point& p : part.vertices())
      most = std::max({most, std::abs(double(p.x)), std::abs(double(p.y)), std::abs(double(p.z))});
  return most / double(body.scale);
}

}  // namespace

/// Points of a spiral on the sphere.
std::vector<Vector> spread_directions() {
  std::vector<Vector> directions;
  const double turn = std::numbers::pi * (3 - std::sqrt(5.0));
  for (int k = 0; k < kTangents; ++k) {
    const double z = 1 - (2 * k + 1) / double(kTangents), r = std::sqrt(1 - z * z);
    directions.push_back({r * std::cos(turn * k), r * std::sin(turn * k), z});
  }
  return directions;
}

CommonParts common_parts(const space::Body& a, const space::Body& b, double steps) {
  if (const auto scale = common_scale(a, b))
    return {space::at_scale(a, *scale).parts, space::at_scale(b, *scale).parts, steps * double(*scale)};
  const double scale = double(space::kCoordinateLimit) / 4 / std::max(farthest(a), farthest(b));
  return {rounded_parts(a, scale / double(a.scale)), rounded_parts(b, scale / double(b.scale)), steps * scale};
}

void add_overlap(const space::BodyPart& p, const space::BodyPart& q, double step, double gap, const OpenSides& open,
                 ConvexOverlap& overlap, std::vector<space::PlaneBlock>& blocks) {
  const double radius = step * (p.radius + q.radius).to_double();
  const auto add = [&](const space::ContactSurface& surface) {
    add_planes(surface, step, gap, radius, open, overlap, blocks);
  };
  if (p.core && q.core) return add(space::ContactSurface(*p.core, *q.core));
  if (p.core) return add(space::ContactSurface(*p.core, q.center));
  if (q.core) return add(space::ContactSurface(p.center, *q.core));
  const Vector center = step * (exact::approx(p.center) - exact::approx(q.center));
  overlap.kind = ConvexOverlap::Kind::kBall;
  overlap.radius = radius + gap;
  set_box(overlap, center, center, overlap.radius);
}

void add_about(std::span<const Vector> normals, std::span<const double> offsets, double reach, ConvexOverlap& overlap,
               std::vector<space::PlaneBlock>& blocks) {
  std::vector<double> below;
  for (const double offset : offsets) below.push_back(-offset);
  const std::vector<space::PlaneBlock> packed = space::pack_planes(normals, below);
  blocks.insert(blocks.end(), packed.begin(), packed.end());
  overlap.kind = ConvexOverlap::Kind::kAbout;
  overlap.radius = reach;
  overlap.low = {-kFar, -kFar, -kFar};
  overlap.high = {kFar, kFar, kFar};
}

void add_overlap(const space::BodyPart& p, double steps, const Vector& normal, double offset, double gap,
                 ConvexOverlap& overlap, std::vector<space::PlaneBlock>& blocks) {
  double least = kFar;
  for (const space::Point& v : p.vertices()) least = std::min(least, space::dot(normal, exact::approx(v)));
  const double out = (least - p.radius.to_double()) / steps + offset - gap;
  const Vector way = -1.0 * normal;
  const std::vector<space::PlaneBlock> packed = space::pack_planes({&way, 1}, {&out, 1});
  blocks.insert(blocks.end(), packed.begin(), packed.end());
  overlap.low = {-kFar, -kFar, -kFar};
  overlap.high = {kFar, kFar, kFar};
}

double ConvexOverlap::depth(const Vector& u) const {
  if (!may_hold(u)) return 0;
  const double out = value(u);
  return out < 0 ? -out : 0;
}

Facing ConvexOverlap::facing(const Vector& u) const {
  if (kind == Kind::kBall) {
    const Vector way = u - center();
    const double size = space::length(way);
    return {size - radius, size > 0 ? (1 / size) * way : Vector{0, 0, 1}};
  }
  const space::Highest top = highest(u);
  const space::PlaneBlock& b = planes[std::size_t(top.plane) / 8];
  return {top.value, {b.x[top.plane % 8], b.y[top.plane % 8], b.z[top.plane % 8]}};
}

/// |u + t way - center| < radius, where the line comes deeper than `shallow`.
space::LineStretch ConvexOverlap::stretch_of_ball(const Vector& u, const Vector& way, double shallow) const {
  const Vector from = u - center();
  const double square = space::dot(way, way), middle = -space::dot(from, way) / square;
  const double nearest = space::length(from + middle * way);
  if (nearest >= radius - shallow) return {};
  const double half = std::sqrt((radius * radius - nearest * nearest) / square);
  return {middle - half, middle + half};
}

/// No plane is steeper than the axis: what is deeper than `shallow` is more than twice as long.
space::LineStretch ConvexOverlap::stretch_on_axis(std::size_t axis, const Vector& u, double sense,
                                                  double shallow) const {
  const std::array<double, 3> at{u.x, u.y, u.z};
  const auto [from, to] = space::scan_axis(on_axes[axis], at[axis == 0 ? 1 : 0], at[axis == 2 ? 1 : 2], shallow);
  if (!(to - from > 2 * shallow)) return {};
  return sense > 0 ? space::LineStretch{from - at[axis], to - at[axis]}
                   : space::LineStretch{at[axis] - to, at[axis] - from};
}

space::LineStretch ConvexOverlap::stretch(const Vector& u, const Vector& way, double shallow) const {
  if (kind == Kind::kBall) return stretch_of_ball(u, way, shallow);
  if (way.y == 0 && way.z == 0 && std::abs(way.x) == 1) return stretch_on_axis(0, u, way.x, shallow);
  if (way.z == 0 && way.x == 0 && std::abs(way.y) == 1) return stretch_on_axis(1, u, way.y, shallow);
  if (way.x == 0 && way.y == 0 && std::abs(way.z) == 1) return stretch_on_axis(2, u, way.z, shallow);
  const space::LineStretch deep = space::scan_line(planes.data(), planes.size(), u, way, shallow, margin::kAlongPlane);
  if (!(deep.from < deep.to)) return deep;
  return space::scan_line(planes.data(), planes.size(), u, way, 0, margin::kAlongPlane);
}

/// The highest plane is convex along the line.
double ConvexOverlap::lowest_on(const Vector& u, const Vector& way) const {
  constexpr int kHalvings = 50;
  double to = (space::length(u) + radius) / space::length(way), from = -to;
  for (int k = 0; k < kHalvings; ++k) {
    const double middle = 0.5 * (from + to);
    const space::Highest top = highest(u + middle * way);
    const space::PlaneBlock& b = planes[std::size_t(top.plane) / 8];
    const std::size_t lane = std::size_t(top.plane) % 8;
    (space::dot({b.x[lane], b.y[lane], b.z[lane]}, way) > 0 ? to : from) = middle;
  }
  return 0.5 * (from + to);
}

}  // namespace findspace::packing
