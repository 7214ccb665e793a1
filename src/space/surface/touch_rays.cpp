// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/surface/touch_rays.h"

#include <findspace/error.h>

#include <algorithm>
#include <map>
#include <optional>

#include "exact/margins/rounding.h"
#include "space/rays/piece_rays.h"

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

/// The ball about a corner, the cylinder about the edge that follows, or the slab about all.
struct About {
  enum class Form { kBall, kCylinder, kSlab } form;
  const FlatPiece* piece;
  std::size_t corner = 0;

  LinePiece made(const Real& radius) const {
    const auto& corners = piece->corners;
    const RealVector &at = corners[corner].at, &next = corners[(corner + 1) % corners.size()].at;
    if (form == Form::kBall) return ball_piece(at, radius);
    if (form == Form::kCylinder) return cylinder_piece(at, next, radius);
    std::vector<RealVector> ring;
    for (const FlatPiece::Corner& c : corners) ring.push_back(c.at);
    return slab_piece(ring, piece->plane->normal, radius);
  }
};

/// Each once.
std::vector<About> about(const std::vector<FlatPiece>& pieces) {
  Seen seen;
  std::vector<About> out;
  for (const FlatPiece& piece : pieces) {
    const std::size_t n = piece.corners.size();
    for (std::size_t k = 0; k < n; ++k) {
      const FlatPiece::Corner &a = piece.corners[k], &b = piece.corners[(k + 1) % n];
      if (seen.add(a)) out.push_back({About::Form::kBall, &piece, k});
      if (n > 1 && seen.add(a, b)) out.push_back({About::Form::kCylinder, &piece, k});
    }
    if (n > 2) out.push_back({About::Form::kSlab, &piece});
  }
  return out;
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
  if (const auto hull = Polytope::try_hull(points)) {  // flat: all of them
    for (const Plane& p : hull->planes()) planes.emplace_back(p);
  }
  std::vector<RealVector> out;
  for (const FlatPiece::Corner* c : corners) {
    // The points were moved by less than a step, so what is two steps inside their hull lies in that of the corners.
    const bool inner = !planes.empty() && std::all_of(planes.begin(), planes.end(), [&](const HalfSpace& h) {
      return h.approx_value(c->near) < -2 - h.error(c->near);
    });
    if (!inner) out.push_back(c->at);
  }
  return out;
}

}  // namespace

RaySourcePointer near_touching(const TouchPair& pair, const Real& level, const RayGrid& grid) {
  const double tolerance = level.to_double() * (1 + margin::kWiderBox) + 2;
  const auto wanted = [&](const Vector& low, const Vector& high) {
    const Vector by{tolerance, tolerance, tolerance};
    return PieceRays::any_line(grid, low - by, plus(high, by), 1);
  };
  const std::optional<TouchFrontier> frontier = touch_frontier(*pair.a, *pair.b, pair.side, wanted, pair.most_pairs);
  if (!frontier) return nullptr;
  const std::vector<About> all = about(frontier->pieces);
  const auto made = [&](std::size_t k) { return all[k].made(level); };
  return std::make_unique<PieceRays>(all.size(), made, 1, grid);
}

RaySourcePointer all_touching_near(const TouchPair& pair, const Real& level, const RayGrid& grid) {
  const auto all = [](const Vector&, const Vector&) { return true; };
  const std::optional<TouchFrontier> frontier = touch_frontier(*pair.a, *pair.b, pair.side, all, pair.most_pairs);
  if (!frontier) return nullptr;
  if (frontier->pieces.empty() || level.sign() < 0) return constant_rays(grid, 1);
  std::vector<LinePiece> balls;
  for (const RealVector& v : outer_corners(frontier->pieces)) balls.push_back(ball_piece(v, level));
  return std::make_unique<PieceRays>(balls, 1, grid, PieceRays::Of::kIntersection);
}

}  // namespace findspace::space
