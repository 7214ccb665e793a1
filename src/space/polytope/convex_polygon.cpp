// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/polytope/convex_polygon.h"

#include <findspace/error.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "exact/margins/rounding.h"

namespace findspace::space {
namespace {

int turn(const Point2& e, const Point2& f) { return exact::sign(int128(e.x) * f.y - int128(e.y) * f.x); }
Point2 operator-(const Point2& a, const Point2& b) { return {a.x - b.x, a.y - b.y}; }

}  // namespace

ConvexPolygon ConvexPolygon::hull(std::span<const Point2> points) {
  std::vector<Point2> sorted(points.begin(), points.end());
  for (const Point2& p : sorted) {
    if (std::max({p.x, -p.x, p.y, -p.y}) > kCoordinateLimit) {
      throw Error(ErrorCode::kOutOfRange, "a coordinate exceeds 2^40 grid steps");
    }
  }
  std::sort(sorted.begin(), sorted.end());
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  std::vector<Point2> ring;
  const auto chain = [&](auto begin, auto end) {
    const std::size_t base = ring.size();
    for (auto p = begin; p != end; ++p) {
      while (ring.size() >= base + 2 && turn(ring.back() - ring[ring.size() - 2], *p - ring.back()) <= 0)
        ring.pop_back();
      ring.push_back(*p);
    }
    ring.pop_back();  // the other chain begins with it
  };
  if (!sorted.empty()) {
    chain(sorted.begin(), sorted.end());
    chain(sorted.rbegin(), sorted.rend());
  }
  if (ring.size() < 3) {
    throw Error(ErrorCode::kGeometry, sorted.empty() ? "a polygon needs interior, but it has no points"
                                      : sorted.size() == 1
                                          ? "a polygon needs interior, but all its points are one point"
                                          : "a polygon needs interior, but its points lie on one line");
  }
  ConvexPolygon polygon;
  polygon.vertices_ = std::move(ring);
  return polygon;
}

ConvexPolygon ConvexPolygon::point(const Point2& at) {
  if (std::max({at.x, -at.x, at.y, -at.y}) > kCoordinateLimit)
    throw Error(ErrorCode::kOutOfRange, "a coordinate exceeds 2^40 grid steps");
  ConvexPolygon polygon;
  polygon.vertices_ = {at};
  return polygon;
}

PlanarPhi::PlanarPhi(const ConvexPolygon& p, const ConvexPolygon& q) {
  // The hull begins with the lowest point; of the reflected Q that is the highest one of Q.
  const auto ps = p.vertices(), qs = q.vertices();
  const std::size_t n = ps.size(), m = qs.size();
  const std::size_t sides_p = p.is_point() ? 0 : n, sides_q = q.is_point() ? 0 : m;
  const auto q0 = static_cast<std::size_t>(std::max_element(qs.begin(), qs.end()) - qs.begin());
  const auto round = [](std::size_t k, std::size_t count) { return k < count ? k : k - count; };
  for (std::size_t i = 0, j = 0; i < sides_p || j < sides_q;) {
    const std::size_t a = round(i, n), b = round(q0 + j, m);
    const Point2 e = ps[round(a + 1, n)] - ps[a], f = qs[b] - qs[round(b + 1, m)];
    const int order = i == sides_p ? -1 : j == sides_q ? 1 : turn(e, f);
    const Point2 along = order >= 0 ? e : f;
    const std::int64_t g = std::gcd(along.x, along.y);
    PlanarEdge edge;
    edge.start = ps[a] - qs[b];
    edge.normal = {along.y / g, -along.x / g};
    edge.offset = -(int128(edge.normal.x) * edge.start.x + int128(edge.normal.y) * edge.start.y);
    edge.contact = order > 0 ? PlanarContact::kEV : order < 0 ? PlanarContact::kVE : PlanarContact::kEE;
    edge.feature_p = static_cast<int>(a);
    edge.feature_q = static_cast<int>(b);
    edges_.push_back(edge);
    if (order >= 0) ++i;
    if (order <= 0) ++j;
  }
  for (const PlanarEdge& edge : edges_) {
    const auto x = static_cast<double>(edge.normal.x), y = static_cast<double>(edge.normal.y);
    const double size = std::sqrt(x * x + y * y);
    unit_normals_.push_back({x / size, y / size});
    offsets_.push_back(static_cast<double>(edge.offset) / size);
    reach_ = std::max(reach_, std::fabs(offsets_.back()));
  }
}

double PlanarPhi::value(int e, const Vector2& u) const {
  return (unit_normals_[e].x * u.x + unit_normals_[e].y * u.y) + offsets_[e];
}

/// As for PhiFunction::error_bound, with one product and one sum less.
double PlanarPhi::error_bound(const Vector2& u) const {
  return margin::kRoundings16 * (std::fabs(u.x) + std::fabs(u.y) + reach_);
}

int PlanarPhi::highest(const Vector2& u, double& most) const {
  int best = 0;
  most = -std::numeric_limits<double>::infinity();
  for (int e = 0; e < static_cast<int>(edges_.size()); ++e) {
    const double v = value(e, u);
    if (v > most) {
      most = v;
      best = e;
    }
  }
  return best;
}

double PlanarPhi::max_form(const Vector2& u) const {
  double most = 0;
  highest(u, most);
  return most;
}

double PlanarPhi::normalised(const Vector2& u) const {
  const double most = max_form(u);
  if (most <= 0) return most;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    if (value(static_cast<int>(i), u) < 0) continue;
    const Point2 p = edges_[i].start, e = edges_[(i + 1) % edges_.size()].start - p;
    const auto ex = static_cast<double>(e.x), ey = static_cast<double>(e.y);
    const double wx = u.x - static_cast<double>(p.x), wy = u.y - static_cast<double>(p.y);
    const double t = std::clamp((wx * ex + wy * ey) / (ex * ex + ey * ey), 0.0, 1.0);
    least = std::min(least, std::hypot(wx - t * ex, wy - t * ey));
  }
  return std::max(least, most);
}

int PlanarPhi::sign(const Vector2& u) const {
  double most = 0;
  highest(u, most);
  const double bound = error_bound(u);
  if (most > bound) return 1;
  if (most < -bound) return -1;
  int sign = -1;
  for (std::size_t i = 0; i < edges_.size() && sign < 1; ++i) {
    if (value(static_cast<int>(i), u) < -bound) continue;
    const PlanarEdge& e = edges_[i];
    sign = std::max(sign, exact::sign_plane_at({e.normal.x, e.normal.y, 0}, e.offset, u.x, u.y, 0));
  }
  return sign;
}

Vector2 PlanarPhi::gradient(const Vector2& u) const {
  double most = 0;
  return unit_normals_[highest(u, most)];
}

}  // namespace findspace::space
