// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/rays/swept_pieces.h"

#include <algorithm>
#include <cmath>

#include "exact/margins/rounding.h"
#include "exact/margins/space.h"

namespace findspace::space {

std::pair<RealVector, RealVector> axes_across(const RealVector& way) {
  std::size_t least = 0;
  for (std::size_t k = 1; k < 3; ++k) {
    if (abs(way[k]) < abs(way[least])) least = k;
  }
  RealVector aside;
  aside[least] = exact::Real(1);
  const RealVector across = cross(aside, way);
  return {across, cross(way, across)};
}

namespace {

using exact::Real;

/// A plane of a set as the sweep meets it.
struct SweptPlane {
  const HalfSpace* plane;
  Real slope;           // along the direction
  std::vector<int> on;  // the vertices that lie on it, ascending
};

/// Those that touch the set: the others bound nothing.
std::vector<SweptPlane> planes_met(const ConvexRegion& set, const RealVector& way) {
  std::vector<std::vector<int>> on(set.planes().size());
  for (int v = 0; v < static_cast<int>(set.vertices().size()); ++v) {
    for (const int k : set.vertices()[static_cast<std::size_t>(v)].tight) on[static_cast<std::size_t>(k)].push_back(v);
  }
  std::vector<SweptPlane> out;
  for (std::size_t k = 0; k < on.size(); ++k) {
    const HalfSpace& h = set.planes()[k];
    if (!on[k].empty()) out.push_back({&h, dot(h.normal, way), std::move(on[k])});
  }
  return out;
}

std::size_t in_common(const std::vector<int>& a, const std::vector<int>& b) {
  std::size_t out = 0;
  for (auto i = a.begin(), k = b.begin(); i != a.end() && k != b.end();) {
    const bool less = *i <= *k, more = *k <= *i;
    out += less && more ? 1 : 0;
    i += less;
    k += more;
  }
  return out;
}

bool same_direction(const HalfSpace& a, const HalfSpace& b) {
  return dot(a.unit, b.unit) > 1 - margin::kSameDirection && is_zero(cross(a.normal, b.normal));
}

/// In order about the direction, which all hold. Those that look the same way are one plane, as all touch one set.
std::vector<HalfSpace> each_once(std::vector<HalfSpace> sides, const RealVector& way) {
  const auto [across, upward] = axes_across(way);
  const Vector first = space::rounded(across), second = space::rounded(upward);
  const auto angle = [&](const HalfSpace& h) { return std::atan2(dot(h.unit, second), dot(h.unit, first)); };
  std::stable_sort(sides.begin(), sides.end(), [&](const auto& a, const auto& b) { return angle(a) < angle(b); });
  sides.erase(std::unique(sides.begin(), sides.end(), same_direction), sides.end());
  if (sides.size() > 1 && same_direction(sides.front(), sides.back())) sides.pop_back();
  return sides;
}

/// The planes that hold the direction and bound the sum: those of the set, and of two that cross the direction in
/// opposite senses the positive combination that holds it (Fourier and Motzkin). The two meet where the
/// plane touches the set, in an edge where the set seen along the direction has an interior.
std::vector<HalfSpace> sides_of(const ConvexRegion& set, std::span<const SweptPlane> planes, const RealVector& way) {
  const bool broad = set.dimension() > 1 && std::none_of(planes.begin(), planes.end(), [&](const SweptPlane& p) {
                       return p.on.size() == set.vertices().size() && p.slope.sign() == 0;
                     });
  const std::size_t least = broad ? 2 : 1;
  std::vector<HalfSpace> out;
  for (const SweptPlane& p : planes) {
    const int side = p.slope.sign();
    if (side == 0 && p.on.size() >= least) out.push_back(*p.plane);
    if (side <= 0) continue;
    for (const SweptPlane& q : planes) {
      if (q.slope.sign() >= 0 || in_common(p.on, q.on) < least) continue;
      const Real of_p = -q.slope;
      RealVector normal = plus(scaled(of_p, p.plane->normal), scaled(p.slope, q.plane->normal));
      if (is_zero(normal)) continue;  // both sides of one plane
      out.emplace_back(std::move(normal), of_p * p.plane->offset + p.slope * q.plane->offset);
    }
  }
  return each_once(std::move(out), way);
}

void add(LinePiece& piece, HalfSpace plane, bool held) {
  piece.planes.push_back(std::move(plane));
  piece.held.push_back(held);
}

/// The plane moved along, unless it holds the direction.
bool add_moved(LinePiece& piece, const HalfSpace& h, const Real& slope, const Sweep& sweep) {
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
  const std::vector<SweptPlane> planes = planes_met(set, sweep.way);
  for (const SweptPlane& p : planes) add_moved(piece, *p.plane, p.slope, sweep);
  for (HalfSpace& side : sides_of(set, planes, sweep.way)) add(piece, std::move(side), true);
  const Vector way = space::rounded(sweep.way);
  find_box(piece, set.vertices(), scaled(sweep.from.to_double(), way), scaled(sweep.to.to_double(), way));
  return piece;
}

LinePiece swept_piece(const HalfSpace& set, const Sweep& sweep) {
  LinePiece piece;
  if (!add_moved(piece, set, dot(set.normal, sweep.way), sweep)) add(piece, set, true);
  piece.low = {-exact::kInfinity, -exact::kInfinity, -exact::kInfinity};
  piece.high = {exact::kInfinity, exact::kInfinity, exact::kInfinity};
  return piece;
}

namespace {

/// Along the way about the segment from p to q, which are one point or lie in the direction of the sweep.
LinePiece swept_cylinder(const RealVector& p, const RealVector& q, const Real& radius, const Sweep& sweep) {
  LinePiece piece =
      cylinder_piece(plus(p, scaled(sweep.from, sweep.way)), plus(q, scaled(sweep.to, sweep.way)), radius);
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
  const RealVector along = minus(q, p), normal = cross(along, sweep.way);
  if (is_zero(normal))
    return dot(along, sweep.way).sign() > 0 ? swept_cylinder(p, q, radius, sweep) : swept_cylinder(q, p, radius, sweep);
  const RealVector from = scaled(sweep.from, sweep.way), to = scaled(sweep.to, sweep.way);
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
  const auto looks = [&](std::size_t k) { return dot(cross(minus(at(k + 1), at(k)), normal), sweep.way).sign(); };
  std::vector<RealVector> ring;
  for (std::size_t k = 0; k < count; ++k) {
    const auto put = [&](int side) {
      ring.push_back(plus(at(k), scaled(side > 0 ? sweep.to : sweep.from, sweep.way)));
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
  add_end(set, radius, scaled(sweep.from, sweep.way), sweep.from_in, pieces);
  add_end(set, radius, scaled(sweep.to, sweep.way), sweep.to_in, pieces);
  for (const ConvexRegion::Vertex& v : set.vertices()) pieces.push_back(swept_cylinder(v.at, v.at, radius, sweep));
  for (const auto& [v, w] : set.edges())
    pieces.push_back(swept_edge(set.vertices()[v].at, set.vertices()[w].at, radius, sweep));
  for (const int k : set.facets()) {
    if (dot(set.planes()[k].normal, sweep.way).sign() == 0) pieces.push_back(swept_facet(set, k, radius, sweep));
  }
}

}  // namespace findspace::space
