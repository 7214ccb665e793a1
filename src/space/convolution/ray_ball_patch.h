// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Where a line meets the patches of an offset surface, in one text for doubles with a bound (exact::Approx) and for
// real numbers. Heights are relative to the feature's base point; (x, y) is the line relative to it. Internal to
// ray_ball.
#pragma once

#include <algorithm>
#include <array>

#include "exact/margins/rounding.h"
#include "exact/planar/approx.h"
#include "space/convolution/ray_body.h"

namespace findspace::space {

template <class T>
struct BallPatchMeets {
  int count = 0;
  std::array<T, 2> height;
  /// 1: inside the patch, 0: at its seam or not certain, -1: outside.
  std::array<int, 2> where{-1, -1};
};

inline exact::Approx number(std::int64_t v, exact::Approx*) { return {static_cast<double>(v), 0}; }
inline exact::Approx number(int128 v, exact::Approx*) {
  const auto d = static_cast<double>(v);
  return {d, std::fabs(d) * margin::kRounding};
}
inline exact::Real number(int128 v, exact::Real*) { return exact::Real(v); }
inline exact::Real number(std::int64_t v, exact::Real*) { return exact::Real(v); }

template <class T>
using Triple3 = std::array<T, 3>;

template <class T>
Triple3<T> numbers(const Point& p) {
  T* kind = nullptr;
  return {number(p.x, kind), number(p.y, kind), number(p.z, kind)};
}
template <class T>
Triple3<T> numbers(const Wide3& p) {
  T* kind = nullptr;
  return {number(p.x, kind), number(p.y, kind), number(p.z, kind)};
}
template <class T>
T dot3(const Triple3<T>& a, const Triple3<T>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <class T>
Triple3<T> cross3(const Triple3<T>& a, const Triple3<T>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The plane of face f moved outward by the radius; base point: its first corner.
template <class T>
BallPatchMeets<T> meet_face(const RayBody& body, int f, const T& radius, const T& x, const T& y) {
  BallPatchMeets<T> meets;
  const Wide3& normal = body.normals[f];
  if (normal.z == 0) return meets;
  const Triple3<T> n = numbers<T>(normal);
  const Point c[3] = {Point{}, body.corner(f, 1) - body.corner(f, 0), body.corner(f, 2) - body.corner(f, 0)};
  meets.height[0] = (radius * sqrt(dot3(n, n)) - n[0] * x - n[1] * y) / n[2];
  meets.count = 1;
  meets.where[0] = 1;
  for (int k = 0; k < 3; ++k) {
    const Triple3<T> inward = cross3(n, numbers<T>(c[(k + 1) % 3] - c[k])), p = numbers<T>(c[k]);
    const Triple3<T> from{x - p[0], y - p[1], meets.height[0] - p[2]};
    meets.where[0] = std::min(meets.where[0], dot3(inward, from).sign());
  }
  return meets;
}

/// The cylinder about edge e, between the planes through its ends and those of its faces' normals; base point: its
/// start.
template <class T>
BallPatchMeets<T> meet_edge(const RayBody& body, const RayEdge& e, const T& radius, const T& x, const T& y) {
  BallPatchMeets<T> meets;
  const Point edge = body.points[e.to] - body.points[e.from];
  if (e.bend == 0 || (edge.x == 0 && edge.y == 0)) return meets;
  const Triple3<T> d = numbers<T>(edge);
  const T length = dot3(d, d), along = x * d[0] + y * d[1];
  const T a = d[0] * d[0] + d[1] * d[1], b = along * d[2];
  const T c = length * (x * x + y * y - radius * radius) - along * along;
  const T discriminant = b * b - a * c;
  const int real = discriminant.sign();
  if (real < 0) return meets;
  const T root = sqrt(discriminant);
  const Triple3<T> left = cross3(d, numbers<T>(body.normals[e.left])),
                   right = cross3(numbers<T>(body.normals[e.right]), d);
  meets.count = 2;
  for (int k = 0; k < 2; ++k) {
    meets.height[k] = (k == 0 ? b - root : b + root) / a;
    const T part = along + meets.height[k] * d[2];
    const Triple3<T> p{x, y, meets.height[k]};
    meets.where[k] =
        std::min({part.sign(), (length - part).sign(), e.bend * dot3(left, p).sign(), e.bend * dot3(right, p).sign()});
    if (real == 0) meets.where[k] = std::min(meets.where[k], 0);
  }
  return meets;
}

/// The sphere about a vertex; which part of it counts is a matter of the local index.
template <class T>
BallPatchMeets<T> meet_vertex(const T& radius, const T& x, const T& y) {
  BallPatchMeets<T> meets;
  const T square = radius * radius - x * x - y * y;
  const int real = square.sign();
  if (real < 0) return meets;
  const T root = sqrt(square);
  meets.count = 2;
  meets.height = {T() - root, root};
  meets.where = {real, real};
  return meets;
}

}  // namespace findspace::space
