// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Which way a ring runs, and what it encloses.
#include <algorithm>

#include "plane/contour/contour.h"
#include "plane/contour/contour_meet.h"

namespace findspace::plane {
namespace {

using exact::Real;

/// The direction in which the edge leaves its end `at`, as a vector with exact coordinates, and its curvature's sign
/// and radius, positive to the left.
struct Departure {
  Real x, y;
  int bend = 0;
  Real radius;
};

Departure departure(const Span& s, GridPoint at) {
  GridPoint other = at == s.from ? s.to : s.from;
  if (!s.arc) return {Real(other.x - at.x), Real(other.y - at.y), 0, {}};
  Real dx = Real(at.x) - s.arc->cx, dy = Real(at.y) - s.arc->cy;
  bool ccw = (at == s.first());
  return ccw ? Departure{-dy, dx, 1, s.arc->r} : Departure{dy, -dx, -1, s.arc->r};
}

int compare_bend(const Departure& a, const Departure& b) {
  if (a.bend != b.bend) return a.bend < b.bend ? -1 : 1;
  return a.bend == 0 ? 0 : a.bend * compare(b.radius, a.radius);
}

/// Orientation at a vertex with the ring all to its right (or straight above and below): counter-clockwise when the
/// ring comes in above the way it goes out.
int orientation_at(const Span& in, const Span& out) {
  Departure u = departure(out, out.from), w = departure(in, in.to);
  int turn = (u.x * w.y - u.y * w.x).sign();
  if (turn != 0) return turn;
  if ((u.x * w.x + u.y * w.y).sign() < 0) return u.y.sign() < 0 ? 1 : -1;
  return compare_bend(u, w) < 0 ? 1 : -1;
}

/// How far `d` is turned from `u` counter-clockwise: 0 hardly, 1 less than half, 2 half, 3 more, 4 nearly all of it.
int turned(const Departure& u, const Departure& d) {
  const int turn = (u.x * d.y - u.y * d.x).sign();
  if (turn != 0) return turn > 0 ? 1 : 3;
  if ((u.x * d.x + u.y * d.y).sign() < 0) return 2;
  return compare_bend(d, u) > 0 ? 0 : 4;
}

/// Whether `d` comes before `e`, both being turned from `u` counter-clockwise.
bool is_before(const Departure& u, const Departure& d, const Departure& e) {
  const int far = turned(u, d), farther = turned(u, e);
  if (far != farther) return far < farther;
  const int turn = (d.x * e.y - d.y * e.x).sign();
  return turn != 0 ? turn > 0 : compare_bend(d, e) < 0;
}

bool is_along(const Departure& d, const Departure& e) {
  return (d.x * e.y - d.y * e.x).sign() == 0 && (d.x * e.x + d.y * e.y).sign() > 0 && compare_bend(d, e) == 0;
}

}  // namespace

int side_of_departure(const Contour& ring, int way, std::size_t k, const Span& edge) {
  const Departure d = departure(edge, edge.from), out = departure(span_of(ring, k), ring[k].start);
  const Departure in = departure(span_of(ring, k == 0 ? ring.size() - 1 : k - 1), ring[k].start);
  if (is_along(d, out) || is_along(d, in)) return 0;
  const bool left = is_before(out, d, in);
  return left == (way > 0) ? 1 : -1;
}

Contour reversed(const Contour& ring) {
  Contour result;
  result.reserve(ring.size());
  for (std::size_t k = 0; k < ring.size(); ++k) {
    std::size_t i = ring.size() - 1 - k;
    ContourEdge edge = ring[i];
    edge.start = end_of(ring, i);
    edge.ccw = !edge.ccw || !edge.arc;
    result.push_back(std::move(edge));
  }
  return result;
}

int orientation(const Contour& ring) {
  std::size_t low = 0, n = ring.size();
  for (std::size_t i = 1; i < n; ++i) {
    if (ring[i].start < ring[low].start) low = i;
  }
  // The ring is convex at its leftmost vertex, the lowest of them.
  if (straight(ring)) {
    return cross(ring[low == 0 ? n - 1 : low - 1].start, ring[low].start, ring[low + 1 == n ? 0 : low + 1].start) > 0
               ? 1
               : -1;
  }
  Real left(ring[low].start.x);
  int answer = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (!ring[i].arc) continue;
    Real x = ring[i].arc->cx - ring[i].arc->r;
    if (compare(x, left) >= 0) continue;
    GridPoint a = span_of(ring, i).first(), b = span_of(ring, i).last();
    Real side = Real(b.x - a.x) * (ring[i].arc->cy - Real(a.y)) - Real(b.y - a.y) * (x - Real(a.x));
    if (side.sign() >= 0) continue;  // the circle's leftmost point is not on this arc
    left = x;
    answer = ring[i].ccw ? 1 : -1;
  }
  if (answer != 0) return answer;
  return orientation_at(span_of(ring, low == 0 ? n - 1 : low - 1), span_of(ring, low));
}

bool encloses(const Contour& ring, GridPoint p) {
  bool inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    GridPoint a = ring[i].start, b = end_of(ring, i);
    int128 side = cross(a, b, p);
    // A point on the chord counts as a little right of it and, far less, above: one rule for both tests below.
    if (side == 0) side = b.y != a.y ? a.y - b.y : b.x - a.x;
    if ((a.y > p.y) != (b.y > p.y) && (side > 0) == (b.y > a.y)) inside = !inside;
    if (!ring[i].arc || (side < 0) != ring[i].ccw) continue;
    Real dx = Real(p.x) - ring[i].arc->cx, dy = Real(p.y) - ring[i].arc->cy;
    if (compare(dx * dx + dy * dy, ring[i].arc->r * ring[i].arc->r) < 0) inside = !inside;  // between chord and arc
  }
  return inside;
}

}  // namespace findspace::plane
