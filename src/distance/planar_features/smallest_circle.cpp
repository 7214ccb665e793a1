// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/planar_features/smallest_circle.h"

#include <algorithm>
#include <array>
#include <vector>

#include "exact/margins/planar_distance.h"

namespace findspace::distance {

using exact::Real;
using exact::RealPoint;
using plane::Index;

namespace {

constexpr int kMostRounds = 100;
constexpr std::size_t kMostTouching = 8;

struct Round {
  double x = 0, y = 0, r = -1;
  std::vector<std::array<double, 2>> through{};
  bool holds(const std::array<double, 2>& p) const {
    return plain_length(p[0] - x, p[1] - y) <= r + (r + std::abs(x) + std::abs(y)) * margin::kCircleNoise;
  }
};

using Points = std::vector<std::array<double, 2>>;

Round around(const std::array<double, 2>& p, const std::array<double, 2>& q) {
  return {(p[0] + q[0]) / 2, (p[1] + q[1]) / 2, plain_length(p[0] - q[0], p[1] - q[1]) / 2};
}

Round around(const std::array<double, 2>& p, const std::array<double, 2>& q, const std::array<double, 2>& r) {
  const double ax = q[0] - p[0], ay = q[1] - p[1], bx = r[0] - p[0], by = r[1] - p[1], d = 2 * (ax * by - ay * bx);
  if (d == 0) return {};
  const double a = ax * ax + ay * ay, b = bx * bx + by * by, x = (by * a - ay * b) / d, y = (ax * b - bx * a) / d;
  return {p[0] + x, p[1] + y, plain_length(x, y)};
}

/// The smallest circle around few points, two or three of which it keeps; all ways are tried.
Round around(Points& points) {
  Round best;
  const auto offer = [&](const Round& c, const Points& on) {
    if (c.r < 0 || (best.r >= 0 && c.r >= best.r)) return;
    if (std::all_of(points.begin(), points.end(), [&](const auto& p) { return c.holds(p); })) {
      best = c;
      best.through = on;
    }
  };
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      offer(around(points[i], points[j]), {points[i], points[j]});
      for (std::size_t k = 0; k < j; ++k)
        offer(around(points[i], points[j], points[k]), {points[i], points[j], points[k]});
    }
  if (best.r >= 0) points = best.through;
  return best;
}

/// The point of the feature farthest from (x, y).
std::array<double, 2> farthest_point(const BoundaryFeature& s, double x, double y) {
  const double dx = s.cx - x, dy = s.cy - y, d = plain_length(dx, dy);
  if (s.arc && d > 0 && s.has_direction(dx, dy)) return {s.cx + s.r * dx / d, s.cy + s.r * dy / d};
  if (plain_length(s.x0 - x, s.y0 - y) >= plain_length(s.x1 - x, s.y1 - y)) return {s.x0, s.y0};
  return {s.x1, s.y1};
}

/// The circle to rounding.
Round rounded(std::span<const BoundaryFeature> features) {
  Points points{{features[0].x0, features[0].y0}};
  Round c{features[0].x0, features[0].y0, 0, points};
  for (int round = 0; round < kMostRounds; ++round) {
    const auto far =
        std::max_element(features.begin(), features.end(), [&](const BoundaryFeature& s, const BoundaryFeature& t) {
          return s.farthest(c.x, c.y) < t.farthest(c.x, c.y);
        });
    const auto p = farthest_point(*far, c.x, c.y);
    if (c.holds(p)) break;
    points.push_back(p);
    const Round next = around(points);
    if (!(next.r > c.r)) break;
    c = next;
  }
  return c;
}

Real cross(const RealPoint& u, const RealPoint& v) { return u.x * v.y - u.y * v.x; }

class Proof {
 public:
  Proof(const plane::Region& set, std::span<const BoundaryFeature> features, const Round& about)
      : set_(set), features_(features), about_(about) {
    for (const BoundaryFeature& s : features)
      if (s.farthest(about.x, about.y) > about.r - margin::kNearCircle * size()) touching_.push_back(&s);
    // Those where the rounded circle touches first.
    std::stable_sort(touching_.begin(), touching_.end(),
                     [&](const BoundaryFeature* s, const BoundaryFeature* t) { return off_touch(*s) < off_touch(*t); });
    if (touching_.size() > kMostTouching) touching_.resize(kMostTouching);
    for (const BoundaryFeature* s : touching_) level_curves_.push_back(far_level_curve(set, *s));
  }

  std::optional<Circle> run() const {
    for (std::size_t i = 0; i < level_curves_.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (auto c = first_good(events(level_curves_[i], level_curves_[j]), {i, j})) return c;
    for (std::size_t i = 0; i < level_curves_.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        for (std::size_t k = 0; k < j; ++k)
          if (auto c = first_good(events(level_curves_[i], level_curves_[j], level_curves_[k]), {i, j, k})) return c;
    return std::nullopt;
  }

 private:
  double size() const { return about_.r + std::abs(about_.x) + std::abs(about_.y); }
  bool near(double a, double b) const { return std::abs(a - b) <= margin::kNearCircle * size(); }

  double off_touch(const BoundaryFeature& s) const {
    const auto far = farthest_point(s, about_.x, about_.y);
    double least = exact::kInfinity;
    for (const auto& p : about_.through) least = std::min(least, plain_length(p[0] - far[0], p[1] - far[1]));
    return least;
  }

  std::optional<Circle> first_good(const std::vector<Event>& all, const std::vector<std::size_t>& made_of) const {
    for (const Event& e : all) {
      if (!e.at || !near(near_value(e.level), about_.r) || !near(near_value(e.at->x), about_.x) ||
          !near(near_value(e.at->y), about_.y))
        continue;
      const Circle c{*e.at, e.level};
      if (between(c, made_of) && holds_all(c, made_of)) return c;
    }
    return std::nullopt;
  }

  /// The arc has a point at the greatest distance from the centre.
  bool reaches(const BoundaryFeature& s, const RealPoint& off) const {
    if (s.is_vertex() || (off.x.sign() == 0 && off.y.sign() == 0)) return true;
    // The direction from the arc's own centre to that point is `off`: in the arc's half, between its ends.
    const plane::Edge& e = set_.edges[s.cell.index];
    const exact::SupportingCurve& k = set_.supporting_curve(s.cell.index);
    const RealPoint first = set_.geometry.exact(set_.vertices[e.v0].point),
                    second = set_.geometry.exact(set_.vertices[e.v1].point);
    if (off.y.sign() * s.half < 0) return false;
    const Real length = sqrt(off.x * off.x + off.y * off.y), x = k.center_x() + k.w() * off.x / length;
    return first.x <= x && x <= second.x;
  }

  /// The centre is in the hull of the points of C on the circle: no other place is as near to all of them.
  bool between(const Circle& c, const std::vector<std::size_t>& made_of) const {
    std::vector<RealPoint> off;
    for (const std::size_t k : made_of) {
      off.push_back({level_curves_[k].a - c.center.x, level_curves_[k].b - c.center.y});
      if (off.back().x.sign() == 0 && off.back().y.sign() == 0) return false;
      if (!reaches(*touching_[k], off.back())) return false;
    }
    // Two circles touch on the line through their centres.
    if (off.size() == 2) return (off[0].x * off[1].x + off[0].y * off[1].y).sign() < 0;
    const int a = cross(off[0], off[1]).sign(), b = cross(off[1], off[2]).sign(), d = cross(off[2], off[0]).sign();
    return (a >= 0 && b >= 0 && d >= 0 && a + b + d > 1) || (a <= 0 && b <= 0 && d <= 0 && a + b + d < -1);
  }

  /// Nothing of C is outside the circle.
  bool holds_all(const Circle& c, const std::vector<std::size_t>& made_of) const {
    for (std::size_t k = 0; k < features_.size(); ++k) {
      const BoundaryFeature& s = features_[k];
      const auto is = [&](std::size_t m) { return touching_[m] == &s; };
      if (std::any_of(made_of.begin(), made_of.end(), is)) continue;
      if (s.farthest(about_.x, about_.y) < about_.r - margin::kInsideCircle * size()) continue;
      const LevelCurve f = far_level_curve(set_, s);
      const Real x = f.a - c.center.x, y = f.b - c.center.y;
      const auto full = [&](std::size_t m) { return same_circle(level_curves_[m], f); };
      if (std::any_of(made_of.begin(), made_of.end(), full)) continue;
      // Of an arc that does not reach the direction from the centre its ends count, which are features.
      if (s.arc && !reaches(s, {x, y})) continue;
      if (compare(sqrt(x * x + y * y) - f.c, c.radius) > 0) return false;
    }
    return true;
  }

  static bool same_circle(const LevelCurve& f, const LevelCurve& g) { return f.a == g.a && f.b == g.b && f.c == g.c; }

  const plane::Region& set_;
  std::span<const BoundaryFeature> features_;
  Round about_;
  std::vector<const BoundaryFeature*> touching_;
  std::vector<LevelCurve> level_curves_;
};

}  // namespace

std::optional<Circle> smallest_circle(const plane::Region& set, std::span<const BoundaryFeature> vertices_and_arcs) {
  if (vertices_and_arcs.empty()) return std::nullopt;
  if (set.vertices.size() == 1 && set.edges.empty()) return Circle{set.geometry.exact(set.vertices[0].point), Real()};
  return Proof(set, vertices_and_arcs, rounded(vertices_and_arcs)).run();
}

}  // namespace findspace::distance
