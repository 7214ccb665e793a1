// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/build/hull.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "exact/margins/plane.h"
#include "exact/planar/geometry_signs.h"
#include "findspace/error.h"
#include "plane/build/hull_wrap.h"
#include "plane/complex/marked_curves.h"
#include "plane/query/topology.h"

namespace findspace::plane {
namespace {

using exact::int128;
using exact::Real;
using exact::SupportingCurve;

constexpr int kDirectionBits = 41;

/// The direction as an integer vector, where it has one of that size. A ratio with such a denominator is the only one
/// that near to its value rounded to 84 bits, and a convergent of its continued fraction.
std::optional<std::array<std::int64_t, 2>> integer_direction(const RealVector& d) {
  constexpr int128 kLimit = int128(1) << kDirectionBits;
  constexpr int128 kScale = int128(1) << (2 * kDirectionBits + 2);
  bool steep = compare(abs(d.x), abs(d.y)) < 0;
  const Real& large = steep ? d.y : d.x;
  Real ratio = (steep ? d.x : d.y) / large;
  if (ratio.is_closed() && !ratio.is_rational()) return std::nullopt;
  const int128 value = exact::round(ratio * Real(kScale)), size = value < 0 ? -value : value;
  int128 left = size, right = kScale, p = 1, q = 0, last_p = 0, last_q = 1;
  for (;;) {  // the convergents p / q of size / kScale
    int128 whole = left / right;
    last_p = std::exchange(p, whole * p + last_p);
    last_q = std::exchange(q, whole * q + last_q);
    if (q > kLimit) return std::nullopt;
    int128 gap = p * kScale - q * size;
    if ((gap < 0 ? -gap : gap) <= q) break;
    left = std::exchange(right, left - whole * right);
  }
  int128 small = value < 0 ? -p : p, big = q;
  if (compare(ratio * Real(big), Real(small)) != 0) return std::nullopt;
  if (large.sign() < 0) {
    small = -small;
    big = -big;
  }
  std::array<std::int64_t, 2> result{std::int64_t(big), std::int64_t(small)};
  if (steep) std::swap(result[0], result[1]);
  return result;
}

exact::Refusal without_direction(const RealVector& at, double step) {
  const double x = at.x.to_double() * step, y = at.y.to_double() * step;
  Error error(
      ErrorCode::kUnsupported,
      fmt::format("the convex hull has a straight side without an integer direction, near ({:.10g}, {:.10g}): a "
                  "tangent of circles of different radii, or a line through computed corners",
                  x, y));
  return exact::Refusal(error.at(x, y));
}

/// The elements that may lie on the hull, and which cells of the set they are.
class Candidates {
 public:
  explicit Candidates(const Region& set) : set_(set) {
    StarMarks stars = star_marks(set);
    for (Index v = 0; v < set.vertices.size(); ++v) {
      if (stars.vertex_greatest[v] > 0) points_.push_back(v);
    }
    std::sort(points_.begin(), points_.end(), [&](Index v, Index w) {
      return compare_xy(set.geometry, set.vertices[v].point, set.vertices[w].point) < 0;
    });
    find_corners();
    for (Index e = 0; e < set.edges.size(); ++e) {
      if (stars.edge_greatest[e] > 0 && may_bulge(e)) add_arc(e);
    }
  }

  std::vector<HullElement> elements;
  std::size_t corners = 0;
  std::vector<Index> edge;  // per element: the edge of an arc

 private:
  RealVector place(Index v) const { return set_.geometry.exact(set_.vertices[v].point); }

  /// Sign of the turn p, q, r.
  int turn(Index p, Index q, Index r) const {
    const exact::Point &a = set_.point(p), &b = set_.point(q), &c = set_.point(r);
    auto is_grid = [](const exact::Point& x) { return x.kind == exact::Point::Kind::kGrid; };
    if (!is_grid(a) || !is_grid(b) || !is_grid(c)) return cross(place(q) - place(p), place(r) - place(p)).sign();
    int128 s = int128(b.gx - a.gx) * (c.gy - a.gy) - int128(b.gy - a.gy) * (c.gx - a.gx);
    return (s > 0) - (s < 0);
  }

  /// The corners of the hull of the vertices, counter-clockwise from the smallest.
  void find_corners() {
    std::vector<Index> hull;
    for (int pass = 0; pass < 2 && !points_.empty(); ++pass) {
      std::size_t base = hull.size();
      for (Index v : points_) {
        while (hull.size() >= base + 2 && turn(hull[hull.size() - 2], hull.back(), v) <= 0) hull.pop_back();
        hull.push_back(v);
      }
      if (points_.size() > 1) hull.pop_back();
      std::reverse(points_.begin(), points_.end());
    }
    if (points_.size() == 1) hull.pop_back();
    corners = hull.size();
    for (Index v : hull) elements.push_back({.center = place(v)});
    edge.assign(corners, kNone);
    // The half-planes of the corners' hull, in doubles: only to leave out circles well inside.
    for (std::size_t k = 0; k < corners; ++k) {
      const exact::Point &p = set_.point(hull[k]), &q = set_.point(hull[k + 1 == corners ? 0 : k + 1]);
      double x = q.x - p.x, y = q.y - p.y, length = std::hypot(x, y);
      if (length > 0) sides_.push_back({y / length, -x / length, (y * p.x - x * p.y) / length});
    }
  }

  /// An arc with the set beyond it, or with its circle inside the hull of the vertices, is not on the hull.
  bool may_bulge(Index e) const {
    if (!set_.is_arc(e)) return false;
    Index outer = set_.heading(2 * e).forward ? 2 * e + 1 : 2 * e;
    if (set_.faces[set_.face(outer)].mark > 0) return false;
    const SupportingCurve& k = set_.supporting_curve(e);
    return corners < 3 || std::any_of(sides_.begin(), sides_.end(), [&](const Side& s) {
             double reach = s.x * k.x().value + s.y * k.y().value + k.z().value;
             return reach + margin::kHullCandidate * (std::abs(reach) + std::abs(s.offset) + k.z().value + 1) >
                    s.offset;
           });
  }

  void add_arc(Index e) {
    const Edge& d = set_.edges[e];
    const SupportingCurve& k = set_.supporting_curve(e);
    HullElement arc{.center = {k.center_x(), k.center_y()}, .radius = k.w()};
    arc.low = place(d.half > 0 ? d.v1 : d.v0) - arc.center;
    arc.high = place(d.half > 0 ? d.v0 : d.v1) - arc.center;
    elements.push_back(std::move(arc));
    edge.push_back(e);
  }

  struct Side {
    double x, y, offset;
  };

  const Region& set_;
  std::vector<Index> points_;
  std::vector<Side> sides_;
};

class Hull {
 public:
  Hull(const Region& set, double step) : set_(set), step_(step), closed_(is_closed(set)), candidates_(set), to_(0) {}

  exact::Tried<Region> region() {
    curves_ = wrap(candidates_.elements, candidates_.corners);
    if (curves_.empty()) return set_;  // one point
    flat_ = curves_.size() == 2 && curves_[0].element == HullCurve::kSide && curves_[1].element == HullCurve::kSide;
    for (const HullCurve& c : curves_) corner_.push_back(to_.curves.geometry.add_real_point(c.from.x, c.from.y));
    for (std::size_t k = 0; k < (flat_ ? 1 : curves_.size()); ++k) {
      if (curves_[k].element != HullCurve::kSide)
        add_arc(k);
      else if (const auto direction = integer_direction(curves_[k].direction))
        add_side(k, *direction);
      else
        return without_direction(curves_[k].from, step_);
    }
    for (std::size_t k = 0; k < curves_.size(); ++k) to_.add_vertex(corner_[k], corner_mark(k));
    return std::get<CellComplex>(std::move(to_).complex());
  }

 private:
  std::size_t after(std::size_t k) const { return k + 1 == curves_.size() ? 0 : k + 1; }
  RealVector place(Index v) const { return set_.geometry.exact(set_.vertices[v].point); }
  Mark arc_mark(std::size_t element) const { return closed_ ? 1 : set_.edges[candidates_.edge[element]].mark; }

  void add_arc(std::size_t k) {
    const HullElement& e = candidates_.elements[curves_[k].element];
    Index circle = to_.curves.geometry.add(SupportingCurve::circle_at(e.center.x, e.center.y, e.radius));
    to_.curves.arc(circle, corner_[k], corner_[after(k)], true);
    to_.mark({.on = arc_mark(curves_[k].element), .left = 1, .right = 0});
  }

  /// The part of a side that belongs to the hull: between the first and the last point of the set on it.
  struct Reach {
    RealVector place;
    bool included;
  };

  void add_side(std::size_t k, const std::array<std::int64_t, 2>& direction) {
    const HullCurve& side = curves_[k];
    std::int64_t a = direction[1], b = -direction[0];
    exact::make_primitive(a, b);
    Index line = to_.curves.geometry.add(SupportingCurve::line(a, b, Real(a) * side.from.x + Real(b) * side.from.y));
    bool right = side.direction.x.sign() > 0 || (side.direction.x.sign() == 0 && side.direction.y.sign() > 0);
    Index from = corner_[k], to = corner_[after(k)];
    auto piece = [&](Index p, Index q, Mark on) {
      to_.curves.segment(line, p, q, right);
      to_.mark({.on = on, .left = Mark(!flat_), .right = 0});
    };
    if (closed_) return piece(from, to, 1);
    std::optional<std::array<Reach, 2>> reach = reach_on(k);
    if (!reach) return piece(from, to, 0);
    const auto& [first, last] = *reach;
    auto point = [&](const Reach& r) {
      if (r.place == side.from) return from;
      if (r.place == curves_[after(k)].from) return to;
      Index p = to_.curves.geometry.add_real_point(r.place.x, r.place.y);
      to_.add_vertex(p, r.included);
      return p;
    };
    Index p = point(first), q = first.place == last.place ? p : point(last);
    if (p != from) piece(from, p, 0);
    if (p != q) piece(p, q, 1);
    if (q != to) piece(q, to, 0);
  }

  /// First and last point of the set, or of its closure where an edge of the set ends there, on side k.
  std::optional<std::array<Reach, 2>> reach_on(std::size_t k) const {
    const HullCurve& side = curves_[k];
    std::optional<std::array<Reach, 2>> reach;
    auto take = [&](const RealVector& at, bool included) {
      if (!reach) reach = {{{at, included}, {at, included}}};
      int first = dot(at - (*reach)[0].place, side.direction).sign(),
          last = dot(at - (*reach)[1].place, side.direction).sign();
      if (first < 0) (*reach)[0] = {at, included};
      if (last > 0) (*reach)[1] = {at, included};
    };
    auto is_on = [&](const RealVector& at) { return cross(side.direction, at - side.from).sign() == 0; };
    std::vector<char> on(set_.vertices.size(), 0);
    for (Index v = 0; v < set_.vertices.size(); ++v) {
      RealVector at = place(v);
      on[v] = is_on(at);
      if (on[v] && set_.vertices[v].mark > 0) take(at, true);
    }
    for (Index e = 0; e < set_.edges.size(); ++e) {
      const Edge& d = set_.edges[e];
      if (d.mark <= 0 || d.half != 0 || !on[d.v0] || !on[d.v1]) continue;
      take(place(d.v0), set_.vertices[d.v0].mark > 0);
      take(place(d.v1), set_.vertices[d.v1].mark > 0);
    }
    for (std::size_t i = candidates_.corners; i < candidates_.elements.size(); ++i) {
      const HullElement& e = candidates_.elements[i];
      if (arc_mark(i) <= 0 || !touches(e, side)) continue;
      RealVector normal = right_normal(side.direction);
      take(e.center + (e.radius / sqrt(dot(normal, normal))) * normal, true);
    }
    return reach;
  }

  /// Does the arc touch the side's line at a place that is not an end of it?
  static bool touches(const HullElement& e, const HullCurve& side) {
    RealVector normal = right_normal(side.direction);
    if (cross(e.low, normal).sign() <= 0 || cross(normal, e.high).sign() <= 0) return false;
    Real gap = dot(normal, side.from - e.center);
    return gap * gap == e.radius * e.radius * dot(normal, normal);
  }

  /// An extreme point belongs to the hull where it belongs to the set.
  Mark corner_mark(std::size_t k) const {
    if (closed_) return 1;
    for (Index v = 0; v < set_.vertices.size(); ++v) {
      if (place(v) == curves_[k].from) return set_.vertices[v].mark;
    }
    std::size_t before = k == 0 ? curves_.size() - 1 : k - 1;
    return arc_mark(curves_[k].element != HullCurve::kSide ? curves_[k].element : curves_[before].element);
  }

  const Region& set_;
  double step_;
  bool closed_;
  Candidates candidates_;
  std::vector<HullCurve> curves_;
  bool flat_ = false;  // a segment
  MarkedCurves to_;
  std::vector<Index> corner_;  // points of the corners
};

}  // namespace

exact::Tried<Region> try_hull(const Region& set, double step) {
  if (is_empty(set)) return set;
  if (!is_bounded(set)) return CellComplex::uniform(1);
  return Hull(set, step).region();
}

Region hull(const Region& set, double step) { return try_hull(set, step).or_throw(); }

}  // namespace findspace::plane
