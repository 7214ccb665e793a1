// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/rotation/rotation_events.h"

#include <algorithm>
#include <cmath>

#include "exact/margins/plane.h"

namespace findspace::plane {
namespace {

using exact::ExactAngle;
using exact::Real;

/// An edge, or a vertex (p = q), in numbers, as far as the filter needs it.
struct RoughEdge {
  RoughPoint p, q, center;
  double radius = 0;
  bool arc = false;
  double least = 0, most = 0;  // about: of the distances of its points from the centre of rotation
};

RoughEdge rough_edge(const RotatedEdge& e) {
  RoughEdge r{rough(e.p), rough(e.q), {}, 0, e.arc};
  if (e.arc) {
    r.center = rough(e.center);
    r.radius = rough(e.radius);
    r.least = std::abs(length(r.center) - r.radius);
    r.most = length(r.center) + r.radius;
    return r;
  }
  const RoughPoint d = r.q - r.p;
  const double square = std::norm(d), part = square > 0 ? std::clamp(-dot(d, r.p) / square, 0.0, 1.0) : 0.0;
  r.least = length(r.p + part * d);
  r.most = std::max(length(r.p), length(r.q));
  return r;
}

/// The distance of a point of the edge's line or circle from the edge is at most about `tolerance`.
bool near(const RoughEdge& e, RoughPoint at, double tolerance) {
  if (e.arc) return cross(e.q - e.p, at - e.p) <= tolerance * std::abs(e.q - e.p) + tolerance * tolerance;
  const RoughPoint d = e.q - e.p;
  return dot(d, at - e.p) >= -tolerance * std::abs(d) && dot(d, at - e.q) <= tolerance * std::abs(d);
}

/// What is looked at many times, made once.
struct Side {
  std::vector<RealVector> vertices;
  std::vector<RotatedEdge> edges;
  std::vector<RoughEdge> rough_edges;
  double size = 1;  // at least the greatest distance from the centre of rotation

  explicit Side(const RotatedNet& net) {
    for (Index v = 0; v < net.vertex_count(); ++v) {
      vertices.push_back(net.vertex(v));
      size = std::max(size, std::abs(rough(vertices.back())));
    }
    for (const Index k : net.edges()) {
      edges.push_back(net.edge(k));
      const RoughEdge& e = rough_edges.emplace_back(rough_edge(edges.back()));
      size = std::max({size, std::abs(e.p), std::abs(e.q), std::abs(e.center) + e.radius});
    }
  }
};

class EventCollector {
 public:
  EventCollector(const Side& rotating, const Side& fixed)
      : t_(rotating), f_(fixed), tolerance_(std::max(t_.size, f_.size) * margin::kTangencyTolerance) {}

  std::vector<ExactAngle> run() {
    for (const RealVector& v : t_.vertices) {
      for (std::size_t k = 0; k < f_.edges.size(); ++k) vertex_on_edge(v, f_.edges[k], f_.rough_edges[k], false);
      for (const RealVector& w : f_.vertices) vertex_on_vertex(v, w);
    }
    for (const RealVector& w : f_.vertices) {
      for (std::size_t k = 0; k < t_.edges.size(); ++k) vertex_on_edge(w, t_.edges[k], t_.rough_edges[k], true);
    }
    for (std::size_t i = 0; i < t_.edges.size(); ++i) {
      for (std::size_t k = 0; k < f_.edges.size(); ++k) tangent(i, k);
    }
    return sorted();
  }

 private:
  /// a cos + b sin = c, where `plausible` (of the turn as a unit number) holds. `back`: of the turn by minus the angle.
  template <class Plausible>
  void add(const Real& a, const Real& b, const Real& c, bool back, Plausible plausible) {
    const double ra = rough(a), rb = rough(b), rc = rough(c), norm = std::hypot(ra, rb);
    if (std::abs(rc) > norm * (1 + margin::kTangencyTolerance) + tolerance_ * tolerance_) return;
    // Where doubles see no solution, perhaps there is a tangency: near the direction (a, b).
    const double ratio = norm > 0 ? std::clamp(rc / norm, -1.0, 1.0) : 0, spread = std::sqrt(1 - ratio * ratio);
    const RoughPoint middle = norm > 0 ? RoughPoint(ra, rb) / norm : RoughPoint(1, 0);
    if (norm > 0 && !plausible(middle * RoughPoint(ratio, spread)) && !plausible(middle * RoughPoint(ratio, -spread)))
      return;
    for (ExactAngle& t : rotations_where(a, b, c)) {
      if (!plausible(RoughPoint(t.cos.to_double(), t.sin.to_double()))) continue;
      found_.push_back(back ? -t : std::move(t));
    }
  }

  /// A point v, rotated (or the edge rotated back), on an edge.
  void vertex_on_edge(const RealVector& v, const RotatedEdge& e, const RoughEdge& r, bool back) {
    const RoughPoint at = rough(v);
    const double far = length(at);
    if (far > r.most + tolerance_ || far < r.least - tolerance_) return;
    const auto plausible = [&](RoughPoint rotation) { return near(r, at * rotation, tolerance_); };
    if (!e.arc) {
      const RealVector n = left_normal(e.q - e.p);
      return add(plane::dot(n, v), plane::cross(v, n), plane::dot(n, e.p), back, plausible);
    }
    // |R v - z|^2 = r^2
    const RealVector& z = e.center;
    const Real two(2), c = plane::dot(v, v) + plane::dot(z, z) - e.radius * e.radius;
    add(two * plane::dot(z, v), two * plane::cross(v, z), c, back, plausible);
  }

  void vertex_on_vertex(const RealVector& v, const RealVector& w) {
    if (std::abs(std::abs(rough(v)) - std::abs(rough(w))) > tolerance_) return;
    const Real square = plane::dot(v, v);
    if (square.sign() == 0 || !(square == plane::dot(w, w))) return;
    found_.push_back({plane::dot(v, w) / square, plane::cross(v, w) / square});
  }

  void tangent(std::size_t i, std::size_t k) {
    const RotatedEdge &e = t_.edges[i], &f = f_.edges[k];
    const RoughEdge &r = t_.rough_edges[i], &s = f_.rough_edges[k];
    if (r.least > s.most + tolerance_ || s.least > r.most + tolerance_) return;
    if (e.arc && f.arc) return circles(i, k);
    if (f.arc) return line_and_circle(e, r, f, s, true);
    if (e.arc) return line_and_circle(f, s, e, r, false);
  }

  /// The circle, rotated (or the line rotated back: then `back`, and the circle stands still), touches the line.
  void line_and_circle(const RotatedEdge& line, const RoughEdge& l, const RotatedEdge& circle, const RoughEdge& o,
                       bool back) {
    const RealVector n = left_normal(line.q - line.p);
    const RoughPoint rn = RoughPoint(0, 1) * (l.q - l.p);
    const Real length = sqrt(plane::dot(n, n)), level = plane::dot(n, line.p), reach = circle.radius * length;
    const Real a = plane::dot(n, circle.center), b = plane::cross(circle.center, n);
    for (int side : {-1, 1}) {
      // The centre lies `side` radii along n from the line; the touching point is there and back.
      const RoughPoint projection = rn / std::abs(rn) * (o.radius * -side);
      const auto plausible = [&](RoughPoint rotation) {
        const RoughPoint at = o.center * rotation + projection;
        return near(l, at, tolerance_) && near(o, at / rotation, tolerance_);
      };
      add(a, b, side > 0 ? level + reach : level - reach, back, plausible);
    }
  }

  void circles(std::size_t i, std::size_t k) {
    const RotatedEdge &e = t_.edges[i], &f = f_.edges[k];
    const RoughEdge &r = t_.rough_edges[i], &s = f_.rough_edges[k];
    const Real a = Real(2) * plane::dot(e.center, f.center), b = Real(2) * plane::cross(e.center, f.center);
    const Real squares = plane::dot(e.center, e.center) + plane::dot(f.center, f.center);
    for (int side : {-1, 1}) {
      const Real reach = side > 0 ? e.radius + f.radius : e.radius - f.radius;
      const auto plausible = [&](RoughPoint rotation) {
        const RoughPoint z = r.center * rotation, way = s.center - z;
        if (std::abs(way) <= tolerance_) return true;  // one circle on the other
        const double to = side > 0 || r.radius > s.radius ? r.radius : -r.radius;
        const RoughPoint at = z + way / std::abs(way) * to;
        return near(r, at / rotation, tolerance_) && near(s, at, tolerance_);
      };
      add(a, b, squares - reach * reach, false, plausible);
    }
  }

  std::vector<ExactAngle> sorted() {
    std::vector<std::pair<double, ExactAngle>> keyed;
    for (ExactAngle& t : found_) keyed.emplace_back(exact::Angle{t, Real(0)}.degrees(), std::move(t));
    const auto order = [](const auto& p, const auto& q) {
      if (std::abs(p.first - q.first) > margin::kTangencyTolerance) return p.first < q.first ? -1 : 1;
      return compare(exact::Angle{p.second, Real(0)}, exact::Angle{q.second, Real(0)});
    };
    std::sort(keyed.begin(), keyed.end(), [&](const auto& p, const auto& q) { return order(p, q) < 0; });
    std::vector<ExactAngle> out;
    for (std::size_t k = 0; k < keyed.size(); ++k) {
      if (k == 0 || order(keyed[k - 1], keyed[k]) != 0) out.push_back(keyed[k].second);
    }
    return out;
  }

  const Side &t_, &f_;
  double tolerance_;
  std::vector<ExactAngle> found_;
};

}  // namespace

std::vector<ExactAngle> contact_rotations(const RotatedNet& rotating, const RotatedNet& fixed) {
  const Side t(rotating), f(fixed);
  return EventCollector(t, f).run();
}

}  // namespace findspace::plane
