// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/touch_rays.h"

#include <findspace/error.h>

#include <algorithm>
#include <map>
#include <optional>

#include "space/piece_rays.h"

namespace findspace::space {
namespace {

using exact::Real;
using Key = std::array<double, 3>;

Key key(const Vector& v) { return {v.x, v.y, v.z}; }

/// Points and segments that were seen before, found by their rounded coordinates.
class Seen {
 public:
  bool add(const FlatPiece::Corner& a) { return add(a, a); }
  bool add(const FlatPiece::Corner& a, const FlatPiece::Corner& b) {
    const bool swap = key(b.near) < key(a.near);
    const RealVector &p = swap ? b.at : a.at, &q = swap ? a.at : b.at;
    auto& alike = known_[{key(swap ? b.near : a.near), key(swap ? a.near : b.near)}];
    const auto same = [&](const auto& other) {
      return (other.first == p && other.second == q) || (other.first == q && other.second == p);
    };
    if (std::any_of(alike.begin(), alike.end(), same)) return false;
    alike.emplace_back(p, q);
    return true;
  }

 private:
  std::map<std::pair<Key, Key>, std::vector<std::pair<RealVector, RealVector>>> known_;
};

void add_pieces(const FlatPiece& piece, const Real& radius, Seen& seen, std::vector<LinePiece>& out) {
  const std::size_t n = piece.corners.size();
  std::vector<RealVector> ring;
  for (std::size_t k = 0; k < n; ++k) {
    const FlatPiece::Corner &a = piece.corners[k], &b = piece.corners[(k + 1) % n];
    ring.push_back(a.at);
    if (seen.add(a)) out.push_back(ball_piece(a.at, radius));
    if (n > 1 && seen.add(a, b)) out.push_back(cylinder_piece(a.at, b.at, radius));
  }
  if (n > 2) out.push_back(slab_piece(ring, piece.plane->normal, radius));
}

/// Without the corners that are clearly no vertices of the hull.
std::vector<RealVector> outer_corners(const std::vector<FlatPiece>& pieces) {
  Seen seen;
  std::vector<const FlatPiece::Corner*> corners;
  std::vector<Point> points;
  const auto whole = [](double c) { return static_cast<std::int64_t>(std::llround(c)); };
  for (const FlatPiece& piece : pieces) {
    for (const FlatPiece::Corner& c : piece.corners) {
      if (!seen.add(c)) continue;
      corners.push_back(&c);
      points.push_back({whole(c.near.x), whole(c.near.y), whole(c.near.z)});
    }
  }
  std::vector<HalfSpace> planes;
  try {
    const Polytope hull = Polytope::hull(points);
    for (const Plane& p : hull.planes()) planes.emplace_back(p);
  } catch (const Error& e) {
    if (e.code() != ErrorCode::kGeometry) throw;  // flat: all of them
  }
  std::vector<RealVector> out;
  for (const FlatPiece::Corner* c : corners) {
    // The points were moved by less than a step, so what is two steps inside their hull lies in that of the corners.
    const bool inner = !planes.empty() && std::all_of(planes.begin(), planes.end(), [&](const HalfSpace& h) {
      return h.shadow_value(c->near) < -2 - h.error(c->near);
    });
    if (!inner) out.push_back(c->at);
  }
  return out;
}

}  // namespace

RaySourcePointer near_touching(const TouchPair& pair, const Real& level, const RayGrid& grid) {
  const Real radius = level * Real(pair.scale);
  const double room = radius.to_double() * (1 + 0x1p-40) + 2;
  const auto wanted = [&](const Vector& low, const Vector& high) {
    const Vector by{room, room, room};
    return PieceRays::any_line(grid, low - by, plus(high, by), pair.scale);
  };
  const TouchFrontier frontier = touch_frontier(pair.fixed, pair.moving, pair.side, wanted);
  Seen seen;
  std::vector<LinePiece> pieces;
  for (const FlatPiece& piece : frontier.pieces) add_pieces(piece, radius, seen, pieces);
  return std::make_unique<PieceRays>(pieces, pair.scale, grid);
}

RaySourcePointer all_touching_near(const TouchPair& pair, const Real& level, const RayGrid& grid) {
  const auto all = [](const Vector&, const Vector&) { return true; };
  const TouchFrontier frontier = touch_frontier(pair.fixed, pair.moving, pair.side, all);
  if (frontier.pieces.empty() || level.sign() < 0) return constant_rays(grid, 1);
  std::vector<LinePiece> balls;
  for (const RealVector& v : outer_corners(frontier.pieces)) balls.push_back(ball_piece(v, level * Real(pair.scale)));
  return std::make_unique<PieceRays>(balls, pair.scale, grid, PieceRays::Of::kIntersection);
}

}  // namespace findspace::space
