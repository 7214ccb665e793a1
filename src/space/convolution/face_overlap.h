// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Whether two triangles, one of each body, show that the interiors meet: 1 to 4 of ray_overlap.h, at positions on rays
// or at any real ones. A spot is a corner of a body and whether it is of the moved one; what `By` says of the position
// is passed to the exact signs of spots (sign_volume, sign_side, sign_turn, compare_coordinate). Guarantee: exact in
// every degenerate position. Cost: some ten signs. Source: crossing test as in Guigue and Devillers 2003.
#pragma once

#include <algorithm>
#include <array>
#include <utility>

#include "exact/solid/moved_sign.h"
#include "space/convolution/ray_body.h"

namespace findspace::space::faces {

/// A face of a body where it stands.
template <class Spot>
struct Placed {
  const RayBody& body;
  int face = 0;
  Point shift;
  bool raised = false;
  std::array<Spot, 3> corner;

  Placed(const RayBody& of, int f, const Point& by, bool up) : body(of), face(f), shift(by), raised(up) {
    for (int k = 0; k < 3; ++k) corner[k] = point(body.faces[f][k]);
  }
  Spot point(int v) const { return {body.points[v] + shift, raised}; }
  exact::SpotPlane<Spot> plane() const { return {corner[0], body.normals[face], body.normal_approx[face]}; }
  const RayEdge& edge(int k) const { return body.edges[body.face_edges[face][k]]; }
  /// The corner of face g opposite to edge e.
  Spot apex(int g, const RayEdge& e) const {
    for (const int v : body.faces[g]) {
      if (v != e.from && v != e.to) return point(v);
    }
    return point(e.from);
  }
  /// The coordinate along which the normal is not 0, and its sign there.
  std::pair<int, int> axis() const {
    const Wide3& n = body.normals[face];
    if (n.x != 0) return {0, exact::sign(n.x)};
    if (n.y != 0) return {1, exact::sign(n.y)};
    return {2, exact::sign(n.z)};
  }
};

template <class Spot, class By>
struct Pair {
  const Placed<Spot>& f;
  const Placed<Spot>& g;
  const By& by;
  std::array<int, 3> f_side{}, g_side{};  // the corners of f against the plane of g, and of g against that of f

  int volume(const Spot& a, const Spot& b, const Spot& c, const Spot& d) const { return sign_volume(a, b, c, d, by); }
  int side(const Placed<Spot>& of, const Spot& p) const { return sign_side(of.plane(), p, by); }
  int turn(const Spot& a, const Spot& b, const Spot& c, int axis) const { return sign_turn(a, b, c, axis, by); }
};

inline bool both_sides(const std::array<int, 3>& s) {
  return std::max({s[0], s[1], s[2]}) > 0 && std::min({s[0], s[1], s[2]}) < 0;
}

/// The corner that is alone on its side (none of the others strictly on it).
inline int lonely(const std::array<int, 3>& s) {
  for (int k = 0; k < 3; ++k) {
    if (s[k] != 0 && s[(k + 1) % 3] != s[k] && s[(k + 2) % 3] != s[k]) return k;
  }
  return 0;
}

/// 1: open triangle through open triangle, in planes that cross.
template <class Spot, class By>
bool cross(const Pair<Spot, By>& pair) {
  const int i = lonely(pair.f_side), j = lonely(pair.g_side);
  const auto &f = pair.f.corner, &g = pair.g.corner;
  Spot p1 = f[i], q1 = f[(i + 1) % 3], r1 = f[(i + 2) % 3];
  Spot p2 = g[j], q2 = g[(j + 1) % 3], r2 = g[(j + 2) % 3];
  if (pair.f_side[i] < 0) std::swap(q2, r2);
  if (pair.g_side[j] < 0) std::swap(q1, r1);
  return pair.volume(p1, q1, p2, q2) < 0 && pair.volume(p1, r1, r2, p2) < 0;
}

/// Whether the open segment u v, in the plane of `t`, meets the open triangle: no side separates them, nor the
/// segment's line.
template <class Spot, class By>
bool segment_in_face(const Pair<Spot, By>& pair, const Placed<Spot>& t, const Spot& u, const Spot& v) {
  const auto [axis, sense] = t.axis();
  int least = 2, most = -2;
  for (int k = 0; k < 3; ++k) {
    const Spot &a = t.corner[k], &b = t.corner[(k + 1) % 3];
    if (pair.turn(a, b, u, axis) * sense <= 0 && pair.turn(a, b, v, axis) * sense <= 0) return false;
    const int s = pair.turn(u, v, a, axis);
    least = std::min(least, s);
    most = std::max(most, s);
  }
  return least < 0 && most > 0;
}

/// 4: open triangles overlap in one plane.
template <class Spot, class By>
bool overlap_in_plane(const Pair<Spot, By>& pair) {
  const auto separates = [&](const Placed<Spot>& t, const Placed<Spot>& other) {
    const auto [axis, sense] = t.axis();
    for (int k = 0; k < 3; ++k) {
      bool out = true;
      for (const Spot& c : other.corner) {
        out = out && pair.turn(t.corner[k], t.corner[(k + 1) % 3], c, axis) * sense <= 0;
      }
      if (out) return true;
    }
    return false;
  };
  return !separates(pair.f, pair.g) && !separates(pair.g, pair.f);
}

/// 2: edge `e` of `of` lies in the plane of `t`. Whether it runs inside t and its dihedral angle reaches behind t.
template <class Spot, class By>
bool edge_reaches(const Pair<Spot, By>& pair, const Placed<Spot>& of, const RayEdge& e, const Placed<Spot>& t) {
  const int left = pair.side(t, of.apex(e.left, e)), right = pair.side(t, of.apex(e.right, e));
  if (left >= 0 && right >= 0 && e.bend >= 0) return false;  // flat in the plane of t: the triangles decide (4)
  return segment_in_face(pair, t, of.point(e.from), of.point(e.to));
}

/// Half-planes about the line from a to b, given by points.
template <class Spot, class By>
struct About {
  const Pair<Spot, By>& pair;
  const Spot &a, &b;

  int turn(const Spot& p, const Spot& q) const { return pair.volume(a, b, p, q); }
  bool same(const Spot& p, const Spot& q) const {
    if (turn(p, q) != 0) return false;
    for (int axis = 0; axis < 3; ++axis) {
      const int s = pair.turn(a, b, p, axis);
      if (s != 0) return s == pair.turn(a, b, q, axis);
    }
    return false;
  }
  /// Whether p lies strictly inside the angle from `right` counter-clockwise to `left`.
  bool inside(const Spot& right, const Spot& p, const Spot& left) const {
    if (same(p, right) || same(p, left)) return false;
    return (turn(right, p) > 0) + (turn(p, left) > 0) + (turn(left, right) > 0) >= 2;
  }
};

/// 3: edges e of f and d of g on one line: whether they overlap in length, and their solids about them.
template <class Spot, class By>
bool edges_overlap(const Pair<Spot, By>& pair, const RayEdge& e, const RayEdge& d) {
  const Spot a = pair.f.point(e.from), b = pair.f.point(e.to), p = pair.g.point(d.from), q = pair.g.point(d.to);
  int axis = 0;
  while (compare_coordinate(a, b, axis, pair.by) == 0) ++axis;
  const auto order = [&](const Spot& x, const Spot& y) { return compare_coordinate(x, y, axis, pair.by); };
  const bool rising = order(a, b) < 0, along = (order(p, q) < 0) == rising;
  const Spot &low = rising ? a : b, &high = rising ? b : a;
  const Spot &from = order(p, q) < 0 ? p : q, &to = order(p, q) < 0 ? q : p;
  if (order(from, high) >= 0 || order(low, to) >= 0) return false;
  const About<Spot, By> about{pair, a, b};
  const Spot left = pair.f.apex(e.left, e), right = pair.f.apex(e.right, e);
  const Spot other_left = pair.g.apex(along ? d.left : d.right, d);
  const Spot other_right = pair.g.apex(along ? d.right : d.left, d);
  return about.inside(right, other_left, left) || about.inside(right, other_right, left) ||
         about.inside(other_right, left, other_left) || about.inside(other_right, right, other_left) ||
         (about.same(left, other_left) && about.same(right, other_right));
}

inline bool in_plane(const std::array<int, 3>& side, int k) { return side[k] == 0 && side[(k + 1) % 3] == 0; }

template <class Spot, class By>
bool edges_show(const Pair<Spot, By>& pair) {
  const bool coplanar = pair.g_side == std::array<int, 3>{};
  for (int k = 0; k < 3; ++k) {
    if (in_plane(pair.g_side, k) && edge_reaches(pair, pair.g, pair.g.edge(k), pair.f)) return true;
    if (in_plane(pair.f_side, k) && edge_reaches(pair, pair.f, pair.f.edge(k), pair.g)) return true;
    if (!in_plane(pair.f_side, k)) continue;
    const int axis = pair.f.axis().first;
    for (int m = 0; m < 3; ++m) {
      if (!in_plane(pair.g_side, m)) continue;
      const Spot &a = pair.f.corner[k], &b = pair.f.corner[(k + 1) % 3];
      if (coplanar &&
          (pair.turn(a, b, pair.g.corner[m], axis) != 0 || pair.turn(a, b, pair.g.corner[(m + 1) % 3], axis) != 0))
        continue;
      if (edges_overlap(pair, pair.f.edge(k), pair.g.edge(m))) return true;
    }
  }
  return false;
}

/// Whether they cross as in 1 for all that is known of the position; signs may be 0 where they are not.
template <class Spot, class By>
bool surely_cross(const RayBody& a, int f, const RayBody& b, int g, const By& by) {
  const Placed<Spot> first(a, f, {}, false), second(b, g, {}, true);
  Pair<Spot, By> pair{first, second, by, {}, {}};
  const auto surely_both = [](const std::array<int, 3>& s) { return s[0] * s[1] * s[2] != 0 && both_sides(s); };
  for (int k = 0; k < 3; ++k) pair.g_side[k] = pair.side(first, second.corner[k]);
  if (!surely_both(pair.g_side)) return false;
  for (int k = 0; k < 3; ++k) pair.f_side[k] = pair.side(second, first.corner[k]);
  return surely_both(pair.f_side) && cross(pair);
}

/// B stands at `whole` and, by the signs, `by` beyond.
template <class Spot, class By>
bool overlap(const RayBody& a, int f, const RayBody& b, int g, const Point& whole, const By& by) {
  const Placed<Spot> first(a, f, {}, false), second(b, g, whole, true);
  Pair<Spot, By> pair{first, second, by, {}, {}};
  for (int k = 0; k < 3; ++k) pair.g_side[k] = pair.side(first, second.corner[k]);
  const auto apart = [](const std::array<int, 3>& s) { return s[0] != 0 && s[0] == s[1] && s[1] == s[2]; };
  if (apart(pair.g_side)) return false;
  for (int k = 0; k < 3; ++k) pair.f_side[k] = pair.side(second, first.corner[k]);
  if (apart(pair.f_side)) return false;
  if (both_sides(pair.f_side) && both_sides(pair.g_side) && cross(pair)) return true;
  const auto [axis, sense] = first.axis();
  const Wide3& n = b.normals[g];
  const bool coplanar = pair.g_side == std::array<int, 3>{};
  const bool alike = exact::sign(axis == 0 ? n.x : axis == 1 ? n.y : n.z) == sense;
  if (coplanar && alike && overlap_in_plane(pair)) return true;
  return edges_show(pair);
}

}  // namespace findspace::space::faces
