// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/rays/line_pieces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "exact/margins/rounding.h"

namespace findspace::space {
namespace {

using exact::Real;

void widen(Vector& low, Vector& high, double by) {
  const double tolerance = by * (1 + margin::kWiderBox) + margin::kWiderBox * (size_of(low) + size_of(high)) + 1;
  low = low - Vector{tolerance, tolerance, tolerance};
  high = plus(high, {tolerance, tolerance, tolerance});
}

void box_of(std::span<const RealVector> points, LinePiece& piece) {
  piece.low = piece.high = space::rounded(points[0]);
  for (const RealVector& p : points) {
    const Vector q = space::rounded(p);
    piece.low = {std::min(piece.low.x, q.x), std::min(piece.low.y, q.y), std::min(piece.low.z, q.z)};
    piece.high = {std::max(piece.high.x, q.x), std::max(piece.high.y, q.y), std::max(piece.high.z, q.z)};
  }
  widen(piece.low, piece.high, piece.radius.to_double());
}

/// The same direction with coprime whole components, if its own are whole: short numbers are quick.
RealVector shortened(const RealVector& v) {
  exact::int128 common = 0;
  for (const Real& c : v) {
    const auto whole = c.integer();
    if (!whole) return v;
    common = exact::gcd(common, *whole);
  }
  return common > 1 ? scaled(Real::ratio(1, common), v) : v;
}

}  // namespace

LinePiece cylinder_piece(const RealVector& p, const RealVector& q, const Real& radius) {
  LinePiece piece;
  piece.round = true;
  piece.base = p;
  piece.tip = q;
  piece.direction = shortened(minus(q, p));
  piece.radius = radius;
  piece.planes.emplace_back(negated(piece.direction), dot(piece.direction, p));
  piece.planes.emplace_back(piece.direction, -dot(piece.direction, q));
  const RealVector ends[2] = {p, q};
  box_of(ends, piece);
  return piece;
}

LinePiece slab_piece(std::span<const RealVector> ring, const RealVector& long_normal, const Real& radius) {
  LinePiece piece;
  const RealVector normal = shortened(long_normal);
  piece.radius = radius;
  const Real reach = radius * sqrt(dot(normal, normal)), level = dot(normal, ring[0]);
  piece.planes.emplace_back(normal, -(level + reach));
  piece.planes.emplace_back(negated(normal), level - reach);
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const RealVector out = shortened(cross(minus(ring[(k + 1) % ring.size()], ring[k]), normal));
    if (!is_zero(out)) piece.planes.emplace_back(out, -dot(out, ring[k]));
  }
  box_of(ring, piece);
  return piece;
}

LinePiece polytope_piece(std::vector<HalfSpace> planes, const Vector& low, const Vector& high) {
  LinePiece piece;
  piece.planes = std::move(planes);
  piece.low = low;
  piece.high = high;
  if (std::isfinite(size_of(low)) && std::isfinite(size_of(high))) widen(piece.low, piece.high, 0);
  return piece;
}

LinePiece ball_piece(const RealVector& center, const Real& radius) {
  LinePiece piece;
  piece.round = true;
  piece.base = piece.tip = center;
  piece.radius = radius;
  box_of(std::span(&center, 1), piece);
  return piece;
}

void add_round_pieces(const ConvexRegion& set, const Real& radius, std::vector<LinePiece>& pieces) {
  for (const ConvexRegion::Vertex& v : set.vertices()) pieces.push_back(ball_piece(v.at, radius));
  for (const auto& [v, w] : set.edges())
    pieces.push_back(cylinder_piece(set.vertices()[v].at, set.vertices()[w].at, radius));
  const int dimension = set.dimension();
  if (dimension < 2) return;
  for (const int k : set.facets()) {
    std::vector<RealVector> ring;
    for (const int v : set.circuit(k)) ring.push_back(set.vertices()[v].at);
    pieces.push_back(slab_piece(ring, set.planes()[k].normal, radius));
    if (dimension == 2 && ring.size() == set.vertices().size())
      break;  // the polygon itself; its other side is the same
  }
}

void hold(LinePiece& piece) {
  piece.held.assign(piece.planes.size(), 1);
  piece.held_round = true;
}

LinePiece moved(LinePiece piece, const RealVector& by) {
  for (HalfSpace& h : piece.planes) h = HalfSpace(h.normal, h.offset - dot(h.normal, by));
  piece.base = plus(piece.base, by);
  piece.tip = plus(piece.tip, by);
  const Vector near = space::rounded(by);
  piece.low = plus(piece.low, near);
  piece.high = plus(piece.high, near);
  widen(piece.low, piece.high, 0);
  return piece;
}

void drop_repeated(std::vector<LinePiece>& pieces) {
  std::map<std::array<double, 6>, std::vector<std::size_t>> seen;  // by the rounded ends
  std::vector<LinePiece> kept;
  for (LinePiece& piece : pieces) {
    if (piece.round) {
      RealVector p = piece.base, q = piece.tip;
      const auto key = [](const Vector& a, const Vector& b) { return std::array{a.x, a.y, a.z, b.x, b.y, b.z}; };
      if (key(space::rounded(q), {}) < key(space::rounded(p), {})) std::swap(p, q);
      auto& alike = seen[key(space::rounded(p), space::rounded(q))];
      const bool known = std::any_of(alike.begin(), alike.end(), [&](std::size_t k) {
        const LinePiece& other = kept[k];
        return other.radius == piece.radius && other.held_round == piece.held_round && other.held == piece.held &&
               ((other.base == p && other.tip == q) || (other.base == q && other.tip == p));
      });
      if (known) continue;
      alike.push_back(kept.size());
    }
    kept.push_back(std::move(piece));
  }
  pieces = std::move(kept);
}

}  // namespace findspace::space
