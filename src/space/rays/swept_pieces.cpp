// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/rays/swept_pieces.h"

#include <algorithm>

#include "exact/margins/rounding.h"

namespace findspace::space {
namespace {

using exact::Real;

/// A point of the plane across the sweep.
using Shade = std::array<Real, 2>;

Real turn(const Shade& a, const Shade& b, const Shade& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// The corners of the hull, counter-clockwise: one, two or more.
std::vector<Shade> hull_of(std::vector<Shade> points) {
  const auto before = [](const Shade& a, const Shade& b) {
    const int first = compare(a[0], b[0]);
    return first != 0 ? first < 0 : a[1] < b[1];
  };
  std::sort(points.begin(), points.end(), before);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<Shade> ring;
  const auto chain = [&](const Shade& p, std::size_t start) {
    while (ring.size() >= start + 2 && turn(ring[ring.size() - 2], ring.back(), p).sign() <= 0) ring.pop_back();
    ring.push_back(p);
  };
  for (const Shade& p : points) chain(p, 0);
  const std::size_t lower = ring.size() - 1;
  for (std::size_t k = points.size() - 1; k-- > 0;) chain(points[k], lower);
  ring.pop_back();
  return ring;
}

/// Half planes (a, b, c), a x + b y + c <= 0, that meet in the hull of the corners.
std::vector<std::array<Real, 3>> sides_of(const std::vector<Shade>& corners) {
  std::vector<std::array<Real, 3>> out;
  const auto side = [&](const Real& a, const Real& b, const Shade& at) {
    out.push_back({a, b, -(a * at[0] + b * at[1])});
  };
  if (corners.size() == 1) {
    for (const int s : {1, -1}) {
      side(Real(s), Real(), corners[0]);
      side(Real(), Real(s), corners[0]);
    }
    return out;
  }
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Shade &p = corners[k], &q = corners[(k + 1) % corners.size()];
    side(q[1] - p[1], p[0] - q[0], p);
    if (corners.size() == 2) side(p[0] - q[0], p[1] - q[1], p);  // its end
  }
  return out;
}

void add(LinePiece& piece, HalfSpace plane, bool held) {
  piece.planes.push_back(std::move(plane));
  piece.held.push_back(held);
}

/// The plane moved along, unless it holds the direction.
bool add_moved(LinePiece& piece, const HalfSpace& h, const Sweep& sweep) {
  const Real slope = dot(h.normal, sweep.unit);
  const int side = slope.sign();
  if (side == 0) return false;
  const Real& by = side > 0 ? sweep.to : sweep.from;
  add(piece, HalfSpace(h.normal, h.offset - by * slope), side > 0 ? sweep.to_in : sweep.from_in);
  return true;
}

void find_box(LinePiece& piece, std::span<const ConvexRegion::Vertex> vertices, const Vector& first,
              const Vector& second) {
  piece.low = piece.high = plus(vertices[0].near, first);
  double size = 1;
  for (const ConvexRegion::Vertex& v : vertices) {
    for (const Vector& by : {first, second}) {
      const Vector p = plus(v.near, by);
      piece.low = {std::min(piece.low.x, p.x), std::min(piece.low.y, p.y), std::min(piece.low.z, p.z)};
      piece.high = {std::max(piece.high.x, p.x), std::max(piece.high.y, p.y), std::max(piece.high.z, p.z)};
      size = std::max({size, size_of(v.near), size_of(p)});
    }
  }
  const double tolerance = margin::kWiderBox * size;
  piece.low = piece.low - Vector{tolerance, tolerance, tolerance};
  piece.high = plus(piece.high, {tolerance, tolerance, tolerance});
}

}  // namespace

LinePiece whole_piece(const ConvexRegion& set) {
  LinePiece piece;
  piece.planes.assign(set.planes().begin(), set.planes().end());
  find_box(piece, set.vertices(), {}, {});
  return piece;
}

LinePiece swept_piece(const ConvexRegion& set, const Sweep& sweep) {
  LinePiece piece;
  for (const HalfSpace& h : set.planes()) add_moved(piece, h, sweep);
  RealVector aside;
  std::size_t least = 0;
  for (std::size_t k = 1; k < 3; ++k) {
    if (abs(sweep.unit[k]) < abs(sweep.unit[least])) least = k;
  }
  aside[least] = Real(1);
  const RealVector across = cross(aside, sweep.unit), upward = cross(sweep.unit, across);
  std::vector<Shade> approx;
  for (const ConvexRegion::Vertex& v : set.vertices()) approx.push_back({dot(across, v.at), dot(upward, v.at)});
  for (const auto& [a, b, c] : sides_of(hull_of(std::move(approx))))
    add(piece, HalfSpace(plus(scaled(a, across), scaled(b, upward)), c), true);
  const Vector unit = space::rounded(sweep.unit);
  find_box(piece, set.vertices(), scaled(sweep.from.to_double(), unit), scaled(sweep.to.to_double(), unit));
  return piece;
}

LinePiece swept_piece(const HalfSpace& set, const Sweep& sweep) {
  LinePiece piece;
  if (!add_moved(piece, set, sweep)) add(piece, set, true);
  piece.low = {-exact::kInfinity, -exact::kInfinity, -exact::kInfinity};
  piece.high = {exact::kInfinity, exact::kInfinity, exact::kInfinity};
  return piece;
}

namespace {

/// Along the way about the segment from p to q, which are one point or lie in the direction of the sweep.
LinePiece swept_cylinder(const RealVector& p, const RealVector& q, const Real& radius, const Sweep& sweep) {
  LinePiece piece =
      cylinder_piece(plus(p, scaled(sweep.from, sweep.unit)), plus(q, scaled(sweep.to, sweep.unit)), radius);
  piece.held = {sweep.from_in, sweep.to_in};
  piece.held_round = true;
  return piece;
}

/// About the polygon, both faces of the slab held.
LinePiece held_slab(std::span<const RealVector> ring, const RealVector& normal, const Real& radius) {
  LinePiece piece = slab_piece(ring, normal, radius);
  piece.held.assign(piece.planes.size(), 0);
  piece.held[0] = piece.held[1] = 1;
  return piece;
}

LinePiece swept_edge(const RealVector& p, const RealVector& q, const Real& radius, const Sweep& sweep) {
  const RealVector along = minus(q, p), normal = cross(along, sweep.unit);
  if (is_zero(normal))
    return dot(along, sweep.unit).sign() > 0 ? swept_cylinder(p, q, radius, sweep)
                                             : swept_cylinder(q, p, radius, sweep);
  const RealVector from = scaled(sweep.from, sweep.unit), to = scaled(sweep.to, sweep.unit);
  const RealVector ring[4] = {plus(p, from), plus(q, from), plus(q, to), plus(p, to)};
  return held_slab(ring, normal, radius);
}

/// A facet in whose plane the direction lies: every side goes with the end that it looks at.
LinePiece swept_facet(const ConvexRegion& set, int facet, const Real& radius, const Sweep& sweep) {
  const RealVector& normal = set.planes()[facet].normal;
  const std::vector<int> circuit = set.circuit(facet);
  const std::size_t count = circuit.size();
  const auto at = [&](std::size_t k) -> const RealVector& { return set.vertices()[circuit[k % count]].at; };
  // The side from vertex k on: + if it looks along the sweep.
  const auto looks = [&](std::size_t k) { return dot(cross(minus(at(k + 1), at(k)), normal), sweep.unit).sign(); };
  std::vector<RealVector> ring;
  for (std::size_t k = 0; k < count; ++k) {
    const auto put = [&](int side) {
      ring.push_back(plus(at(k), scaled(side > 0 ? sweep.to : sweep.from, sweep.unit)));
    };
    const int before = looks(k + count - 1), after = looks(k);
    if (before != 0) put(before);
    if (after != 0 && after != before) put(after);
  }
  return held_slab(ring, normal, radius);
}

/// P grown, where an end of the sweep puts it.
void add_end(const ConvexRegion& set, const Real& radius, const RealVector& by, bool held,
             std::vector<LinePiece>& pieces) {
  std::vector<LinePiece> end;
  add_round_pieces(set, radius, end);
  for (LinePiece& piece : end) {
    if (held) hold(piece);
    pieces.push_back(moved(std::move(piece), by));
  }
}

}  // namespace

void add_swept_pieces(const ConvexRegion& set, const Real& radius, const Sweep& sweep, std::vector<LinePiece>& pieces) {
  if (radius.sign() == 0 || set.vertices().size() > 1) pieces.push_back(swept_piece(set, sweep));
  if (radius.sign() == 0) return;
  add_end(set, radius, scaled(sweep.from, sweep.unit), sweep.from_in, pieces);
  add_end(set, radius, scaled(sweep.to, sweep.unit), sweep.to_in, pieces);
  for (const ConvexRegion::Vertex& v : set.vertices()) pieces.push_back(swept_cylinder(v.at, v.at, radius, sweep));
  for (const auto& [v, w] : set.edges())
    pieces.push_back(swept_edge(set.vertices()[v].at, set.vertices()[w].at, radius, sweep));
  for (const int k : set.facets()) {
    if (dot(set.planes()[k].normal, sweep.unit).sign() == 0) pieces.push_back(swept_facet(set, k, radius, sweep));
  }
}

}  // namespace findspace::space
