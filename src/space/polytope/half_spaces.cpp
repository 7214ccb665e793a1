// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// On the line of every two planes the part below all others is an interval, and its ends are vertices. A pointed
// unbounded set has an unbounded edge, so it is found out on the way.
#include "space/polytope/half_spaces.h"

#include <findspace/error.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace findspace::space {
namespace {

using exact::Real;
using RealPoint = std::array<Real, 3>;

Real dot(const RealPoint& a, const RealPoint& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

RealPoint cross(const RealPoint& a, const RealPoint& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

struct RealPlane {
  RealPoint normal;
  Real offset;
};

/// An end of the interval on a line: the parameter, and the plane that sets it (-1: none yet) with its slope.
struct End {
  Real at, slope;
  int plane = -1;
};

/// Adds the ends of the part of the line of planes i and j that lies below all planes.
void add_edge(const std::vector<RealPlane>& planes, std::size_t i, std::size_t j, std::vector<PlaneVertex>& out) {
  const RealPoint &n = planes[i].normal, &m = planes[j].normal, d = cross(n, m);
  const Real size = dot(d, d);
  if (size.sign() == 0) return;
  const RealPoint s = cross(m, d), t = cross(d, n);
  RealPoint base;
  for (int k = 0; k < 3; ++k) base[k] = -(planes[i].offset * s[k] + planes[j].offset * t[k]) / size;
  End low, high;
  for (int k = 0; k < static_cast<int>(planes.size()); ++k) {
    const Real slope = dot(planes[k].normal, d);
    const Real value = dot(planes[k].normal, base) + planes[k].offset;
    if (slope.sign() == 0) {
      if (value.sign() > 0) return;
      continue;
    }
    const Real at = -value / slope;
    if (slope.sign() > 0 && (high.plane < 0 || at < high.at)) high = {at, slope, k};
    if (slope.sign() < 0 && (low.plane < 0 || low.at < at)) low = {at, slope, k};
    if (low.plane >= 0 && high.plane >= 0 && high.at < low.at) return;
  }
  if (low.plane < 0 || high.plane < 0)
    throw Error(ErrorCode::kGeometry, "the intersection of the half spaces is unbounded");
  for (const End& end : {low, high}) {
    PlaneVertex vertex;
    for (int k = 0; k < 3; ++k) vertex.at[k] = base[k] + end.at * d[k];
    vertex.determinant = end.slope.integer().value_or(0);
    out.push_back(std::move(vertex));
  }
}

/// The nearest grid point, and how far it is.
Point on_grid(const RealPoint& p, double& moved) {
  std::array<std::int64_t, 3> c{};
  double square = 0;
  for (int k = 0; k < 3; ++k) {
    if (abs(p[k]) > Real(kCoordinateLimit)) {
      throw Error(ErrorCode::kOutOfRange, "a vertex of the half spaces exceeds 2^40 grid steps");
    }
    c[k] = static_cast<std::int64_t>(round(p[k]));
    const double rest = (p[k] - Real(c[k])).to_double();
    square += rest * rest;
  }
  moved = std::sqrt(square);
  return {c[0], c[1], c[2]};
}

}  // namespace

std::vector<PlaneVertex> half_space_vertices(std::span<const Plane> planes) {
  std::vector<RealPlane> real;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const Plane& p = planes[i];
    if (exact::is_zero(p.normal))
      throw Error(ErrorCode::kBadValue, "half space " + std::to_string(i) + " has no normal");
    real.push_back({{Real(p.normal.x), Real(p.normal.y), Real(p.normal.z)}, Real(p.offset)});
  }
  std::vector<PlaneVertex> vertices;
  for (std::size_t i = 0; i < real.size(); ++i) {
    for (std::size_t j = i + 1; j < real.size(); ++j) add_edge(real, i, j, vertices);
  }
  return vertices;
}

Polytope Polytope::from_half_spaces(std::span<const Plane> planes, Repair* repair) {
  std::vector<Point> points;
  std::map<Point, double> moves;
  for (const PlaneVertex& vertex : half_space_vertices(planes)) {
    double moved = 0;
    points.push_back(on_grid(vertex.at, moved));
    if (moved > 0) moves[points.back()] = moved;
  }
  if (points.empty()) {
    throw Error(ErrorCode::kGeometry, "the intersection of the half spaces is empty, or unbounded without an edge");
  }
  const Polytope result = hull(points);
  if (repair != nullptr) {
    *repair = {};
    repair->rounded = static_cast<int>(moves.size());
    for (const auto& [point, distance] : moves) repair->moved = std::max(repair->moved, distance);
  }
  return result;
}

}  // namespace findspace::space
