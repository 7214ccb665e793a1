// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/convolution/ray_distance.h"

#include <array>
#include <cmath>

#include "exact/margins/rounding.h"
#include "exact/margins/space.h"
#include "space/polytope/near_features.h"

namespace findspace::space {
namespace {

using exact::Real;

using near::dot;
using near::minus;
using near::Triple;

template <class T>
Triple<T> cross(const Triple<T>& a, const Triple<T>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double magnitude(double v) { return std::fabs(v); }
Real magnitude(const Real& v) { return abs(v); }
template <class T>
T size(const Triple<T>& a) {
  return magnitude(a[0]) + magnitude(a[1]) + magnitude(a[2]);
}

/// The squared distance from the origin to the segment.
template <class T>
T to_segment(const Triple<T>& a, const Triple<T>& b) {
  const Triple<T> e = minus(b, a);
  const T along = T(0) - dot(a, e), length = dot(e, e);
  if (!(along > T(0))) return dot(a, a);
  if (!(along < length)) return dot(b, b);
  const T part = along / length;
  const Triple<T> projection{a[0] + part * e[0], a[1] + part * e[1], a[2] + part * e[2]};
  return dot(projection, projection);
}

/// The squared distance from the origin to the triangle. `slack`: how far outside (relative to the size of the terms)
/// the projection on the plane still counts as inside: for doubles, so that they never claim too much.
template <class T>
T to_triangle(const Triple<Triple<T>>& c, const T& slack) {
  const Triple<T> n = cross(minus(c[1], c[0]), minus(c[2], c[0]));
  T least = to_segment(c[0], c[1]);
  for (int k = 1; k < 3; ++k) {
    const T other = to_segment(c[k], c[(k + 1) % 3]);
    if (other < least) least = other;
  }
  bool inside = true;
  for (int k = 0; k < 3; ++k) {
    const Triple<T> out = cross(minus(c[(k + 1) % 3], c[k]), n);
    const T side = dot(out, c[k]);  // how far inside the projection of the origin is
    inside = inside && !(side + slack * size(out) * size(c[k]) < T(0));
  }
  if (!inside) return least;
  const T height = dot(n, c[0]), plane = height * height / dot(n, n);
  return plane < least ? plane : least;
}

double gap(double low, double high, double at) { return at < low ? low - at : at > high ? at - high : 0; }

}  // namespace

SurfaceDistance::SurfaceDistance(const RayBody& body, const Real& distance)
    : body_(body), tree_(body), squared_(distance * distance), distance_(distance.to_double()) {}

bool SurfaceDistance::certainly_nearer(std::int64_t x, std::int64_t y, double z, double error,
                                       std::vector<int>& close) const {
  const double px = static_cast<double>(x), py = static_cast<double>(y);
  const auto box_gap = [&](const GridBox& b) {
    const double gx = gap(static_cast<double>(b.low.x), static_cast<double>(b.high.x), px);
    const double gy = gap(static_cast<double>(b.low.y), static_cast<double>(b.high.y), py);
    const double gz = gap(static_cast<double>(b.low.z), static_cast<double>(b.high.z), z);
    return std::sqrt(gx * gx + gy * gy + gz * gz);
  };
  // Beside the error of z: coordinates below 2^40 relative to the place, and the roundings of the formulas.
  const double blur = 2 * error + margin::kDistanceBlur * distance_ +
                      margin::kRoundings8 * (std::fabs(px) + std::fabs(py) + std::fabs(z));
  int stack[64], depth = 0;
  stack[depth++] = 0;
  while (depth > 0) {
    const BoxTree::Node& node = tree_.nodes()[stack[--depth]];
    if (box_gap(node.box) > distance_ + blur) continue;
    if (node.count == 0) {
      const bool first = box_gap(tree_.nodes()[node.first].box) < box_gap(tree_.nodes()[node.first + 1].box);
      stack[depth++] = node.first + (first ? 1 : 0);
      stack[depth++] = node.first + (first ? 0 : 1);
      continue;
    }
    for (int i = node.first; i < node.first + node.count; ++i) {
      Triple<Triple<double>> c;
      for (int k = 0; k < 3; ++k) {
        const Point& p = body_.corner(tree_.face(i), k);
        c[k] = {static_cast<double>(p.x - x), static_cast<double>(p.y - y), static_cast<double>(p.z) - z};
      }
      const double distance = std::sqrt(to_triangle(c, margin::kOnFace));
      if (distance < distance_ - blur) return true;
      if (distance <= distance_ + blur) close.push_back(tree_.face(i));
    }
  }
  return false;
}

int SurfaceDistance::compare_exactly(std::int64_t x, std::int64_t y, const Real& z,
                                     const std::vector<int>& faces) const {
  int least = 1;
  for (const int f : faces) {
    Triple<Triple<Real>> c;
    for (int k = 0; k < 3; ++k) {
      const Point& p = body_.corner(f, k);
      c[k] = {Real(p.x - x), Real(p.y - y), Real(p.z) - z};
    }
    least = std::min(least, exact::compare(to_triangle(c, Real(0)), squared_));
    if (least < 0) break;
  }
  return least;
}

}  // namespace findspace::space
