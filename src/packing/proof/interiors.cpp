// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/proof/interiors.h"

#include <algorithm>
#include <optional>

namespace findspace::packing {
namespace {

using exact::cross_sign;
using exact::dot_sign;
using exact::turn_sign;

/// The directions strictly between `from` and `to`, counter-clockwise.
struct Sector {
  LatticePoint from, to;
};

bool same_direction(const LatticePoint& c, const LatticePoint& d) {
  return cross_sign(c, d) == 0 && dot_sign(c, d) > 0;
}

/// Whether d lies in the sector or is its first direction.
bool from_on(const Sector& s, const LatticePoint& d) {
  if (same_direction(s.from, d)) return true;
  if (same_direction(s.to, d)) return false;
  const int width = cross_sign(s.from, s.to);
  if (width > 0) return cross_sign(s.from, d) > 0 && cross_sign(d, s.to) > 0;
  if (width == 0) return cross_sign(s.from, d) > 0;
  return !(cross_sign(s.to, d) > 0 && cross_sign(d, s.from) > 0);
}

bool overlap(const Sector& s, const Sector& t) { return from_on(s, t.from) || from_on(t, s.from); }

struct RingEdge {
  const Ring* ring;
  std::size_t i;

  const LatticePoint& start() const { return (*ring)[i]; }
  const LatticePoint& end() const { return (*ring)[(i + 1) % ring->size()]; }
  const LatticePoint& before() const { return (*ring)[(i + ring->size() - 1) % ring->size()]; }
  int128 low_x() const { return std::min(start().x, end().x); }
  int128 high_x() const { return std::max(start().x, end().x); }
  int128 low_y() const { return std::min(start().y, end().y); }
  int128 high_y() const { return std::max(start().y, end().y); }
  bool meets_box(const RingEdge& e) const {
    return low_x() <= e.high_x() && e.low_x() <= high_x() && low_y() <= e.high_y() && e.low_y() <= high_y();
  }
  /// The interior at the start of the edge, and amid it.
  Sector at_start() const { return {end() - start(), before() - start()}; }
  Sector amid() const { return {end() - start(), start() - end()}; }
};

std::vector<RingEdge> edges_of(const Polygon& shape) {
  std::vector<RingEdge> edges;
  for (const Ring& ring : shape.rings)
    for (std::size_t i = 0; i < ring.size(); ++i) edges.push_back({&ring, i});
  return edges;
}

/// The interior at p, where p is the start of the edge or amid it; nothing where it is neither.
std::optional<Sector> sector_at(const RingEdge& e, const LatticePoint& p) {
  if (p == e.start()) return e.at_start();
  if (p == e.end() || turn_sign(e.start(), e.end(), p) != 0 || !exact::is_between(e.start(), e.end(), p))
    return std::nullopt;
  return e.amid();
}

/// Whether both interiors meet next to a point: whether all rings that pass there have a direction in common.
bool meet_at(const LatticePoint& p, const std::vector<RingEdge>& of_a, const std::vector<RingEdge>& of_b) {
  struct Corner {
    const Ring* ring;
    Sector sector;
  };
  std::vector<Corner> corners;
  for (const auto* edges : {&of_a, &of_b})
    for (const RingEdge& e : *edges)
      if (const auto sector = sector_at(e, p)) corners.push_back({e.ring, *sector});
  const auto is_in = [&](const Ring* ring, const LatticePoint& d) {
    return std::any_of(corners.begin(), corners.end(),
                       [&](const Corner& c) { return c.ring == ring && from_on(c.sector, d); });
  };
  const auto begins_common = [&](const Corner& first) {
    return std::all_of(corners.begin(), corners.end(),
                       [&](const Corner& c) { return is_in(c.ring, first.sector.from); });
  };
  return std::any_of(corners.begin(), corners.end(), begins_common);
}

/// Whether these edges touch where that is so.
bool enter_at(const RingEdge& e, const RingEdge& f, const std::vector<RingEdge>& of_a,
              const std::vector<RingEdge>& of_b) {
  if (const auto at = sector_at(f, e.start()); at && overlap(e.at_start(), *at) && meet_at(e.start(), of_a, of_b))
    return true;
  const auto at = sector_at(e, f.start());
  return at && overlap(*at, f.at_start()) && meet_at(f.start(), of_a, of_b);
}

bool cross(const RingEdge& e, const RingEdge& f) {
  return turn_sign(e.start(), e.end(), f.start()) * turn_sign(e.start(), e.end(), f.end()) < 0 &&
         turn_sign(f.start(), f.end(), e.start()) * turn_sign(f.start(), f.end(), e.end()) < 0;
}

bool has_vertex_inside(const Polygon& a, const Polygon& b) {
  for (const Ring& ring : a.rings)
    for (const LatticePoint& p : ring)
      if (side_of(b, p) > 0) return true;
  return false;
}

}  // namespace

int side_of(const Polygon& shape, const LatticePoint& point) {
  bool inside = false;
  for (const Ring& ring : shape.rings)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const LatticePoint &p = ring[i], &q = ring[(i + 1) % ring.size()];
      if (std::min(p.y, q.y) > point.y || std::max(p.y, q.y) < point.y) continue;
      const int turn = turn_sign(p, q, point);
      if (turn == 0 && exact::is_between(p, q, point)) return 0;
      if ((p.y <= point.y) != (q.y <= point.y)) inside ^= (turn > 0) == (q.y > p.y);
    }
  return inside ? 1 : -1;
}

bool interiors_meet(const Polygon& a, const Polygon& b) {
  const std::vector<RingEdge> of_a = edges_of(a), of_b = edges_of(b);
  for (const RingEdge& e : of_a)
    for (const RingEdge& f : of_b)
      if (e.meets_box(f) && (cross(e, f) || enter_at(e, f, of_a, of_b))) return true;
  return has_vertex_inside(a, b) || has_vertex_inside(b, a);
}

namespace {

/// Whether two edges that do not cross are nearer than `distance`.
bool are_nearer(const RingEdge& e, const RingEdge& f, int128 distance) {
  if (e.low_x() - f.high_x() >= distance || f.low_x() - e.high_x() >= distance) return false;
  if (e.low_y() - f.high_y() >= distance || f.low_y() - e.high_y() >= distance) return false;
  return exact::is_nearer(e.start(), f.start(), f.end(), distance) ||
         exact::is_nearer(f.start(), e.start(), e.end(), distance);
}

/// Whether they have more than a point in common.
bool run_along(const RingEdge& e, const RingEdge& f) {
  const bool overlap_in_x = std::max(e.low_x(), f.low_x()) < std::min(e.high_x(), f.high_x());
  const bool overlap_in_y = std::max(e.low_y(), f.low_y()) < std::min(e.high_y(), f.high_y());
  return (overlap_in_x || overlap_in_y) && e.meets_box(f) && turn_sign(e.start(), e.end(), f.start()) == 0 &&
         turn_sign(e.start(), e.end(), f.end()) == 0;
}

/// How often the rings run counter-clockwise about a point on none of them.
int winding(const Polygon& shape, const LatticePoint& point) {
  int result = 0;
  for (const RingEdge& e : edges_of(shape)) {
    const bool up = e.start().y <= point.y, to_up = e.end().y <= point.y;
    if (up == to_up) continue;
    const int turn = turn_sign(e.start(), e.end(), point);
    if (up && turn > 0) ++result;
    if (to_up && turn < 0) --result;
  }
  return result;
}

/// Of two polygons whose rings do not meet: whether a ring of one lies in the other.
bool has_ring_inside(const Polygon& a, const Polygon& b) {
  return std::any_of(a.rings.begin(), a.rings.end(), [&](const Ring& ring) { return winding(b, ring[0]) != 0; });
}

}  // namespace

bool are_nearer(const Polygon& a, const Polygon& b, int128 distance) {
  const std::vector<RingEdge> of_a = edges_of(a), of_b = edges_of(b);
  for (const RingEdge& e : of_a)
    for (const RingEdge& f : of_b)
      if (are_nearer(e, f, distance)) return true;
  return false;
}

bool run_along(const Polygon& a, const Polygon& b) {
  const std::vector<RingEdge> of_a = edges_of(a), of_b = edges_of(b);
  return std::any_of(of_a.begin(), of_a.end(), [&](const RingEdge& e) {
    return std::any_of(of_b.begin(), of_b.end(), [&](const RingEdge& f) { return run_along(e, f); });
  });
}

bool are_apart(const Polygon& a, const Polygon& b, int128 distance) {
  const std::vector<RingEdge> of_a = edges_of(a), of_b = edges_of(b);
  for (const RingEdge& e : of_a)
    for (const RingEdge& f : of_b)
      if ((e.meets_box(f) && cross(e, f)) || are_nearer(e, f, distance + 1)) return false;
  return !has_ring_inside(a, b) && !has_ring_inside(b, a);
}

}  // namespace findspace::packing
