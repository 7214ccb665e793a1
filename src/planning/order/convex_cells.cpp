// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "planning/order/convex_cells.h"

#include <algorithm>
#include <map>
#include <optional>

#include "exact/planar/geometry_signs.h"
#include "findspace/error.h"
#include "plane/complex/marked_curves.h"
#include "plane/query/locate.h"

namespace findspace::planning {

using exact::int128;
using exact::Real;
using exact::RealPoint;
using plane::Index;
using plane::Region;

namespace {

constexpr Index kNone = plane::kNone;

class Cells {
 public:
  Cells(const Region& r, bool closed) : r_(r), closed_(closed) {
    for (Index v = 0; v < r.vertices.size(); ++v) at_.push_back(r.geometry.exact(r.vertices[v].point));
  }

  std::vector<ConvexCell> run() {
    slabs();
    for (Index e = 0; e < r_.edges.size(); ++e)
      if (r_.edges[e].mark > 0 && !(closed_ && beside_face(e))) add_edge(e);
    for (Index v = 0; v < r_.vertices.size(); ++v)
      if (r_.vertices[v].mark > 0 && (!closed_ || r_.vertices[v].out == kNone)) add_point(at_[v]);
    return std::move(cells_);
  }

 private:
  bool beside_face(Index e) const { return r_.faces[r_.face(2 * e)].mark > 0 || r_.faces[r_.face(2 * e + 1)].mark > 0; }
  bool vertical(Index e) const { return r_.supporting_curve(e).b == 0; }
  const RealPoint& from(Index e) const { return at_[r_.edges[e].v0]; }
  const RealPoint& to(Index e) const { return at_[r_.edges[e].v1]; }

  HalfPlane less_x(const Real& x, bool strict) const { return {1, 0, x, strict}; }
  HalfPlane more_x(const Real& x, bool strict) const { return {-1, 0, -x, strict}; }
  /// Below (side = 1) or above (-1) the line of an edge that is not vertical.
  HalfPlane beyond(Index e, int side, bool strict) const {
    const exact::SupportingCurve& k = r_.supporting_curve(e);
    const bool keep = (k.b > 0) == (side > 0);
    return keep ? HalfPlane{k.a, k.b, k.offset(), strict} : HalfPlane{-k.a, -k.b, -k.offset(), strict};
  }

  void add_point(const RealPoint& p) {
    cells_.push_back({less_x(p.x, false), more_x(p.x, false), {0, 1, p.y, false}, {0, -1, -p.y, false}});
  }

  void add_edge(Index e) {
    const bool strict = !closed_;
    if (vertical(e)) {
      cells_.push_back(
          {less_x(from(e).x, false), more_x(from(e).x, false), {0, 1, to(e).y, strict}, {0, -1, -from(e).y, strict}});
    } else {
      cells_.push_back({beyond(e, 1, false), beyond(e, -1, false), less_x(to(e).x, strict), more_x(from(e).x, strict)});
    }
  }

  /// A trapezoid that goes on to the right until its floor or roof ends.
  struct Open {
    Index floor, roof;
    std::optional<Real> left;
  };

  void slabs() {
    std::vector<Real> xs;
    for (const RealPoint& p : at_) xs.push_back(p.x);
    std::sort(xs.begin(), xs.end());
    xs.erase(std::unique(xs.begin(), xs.end()), xs.end());
    std::vector<Open> open;
    for (std::size_t k = 0; k <= xs.size(); ++k) {
      std::optional<Real> left = k > 0 ? std::optional(xs[k - 1]) : std::nullopt;
      std::optional<Real> right = k < xs.size() ? std::optional(xs[k]) : std::nullopt;
      std::vector<Open> now = slab(left, right);
      advance(open, now, left);
      if (!closed_ && left) walls(*left);
    }
    for (const Open& o : open) close(o, std::nullopt);
  }

  /// Trapezoids of the slab; those that continue one of `open` over a vertical line without any vertex take its left
  /// end.
  void advance(std::vector<Open>& open, std::vector<Open>& now, const std::optional<Real>& at) {
    std::vector<char> used(open.size());
    for (Open& n : now) {
      for (std::size_t i = 0; i < open.size(); ++i) {
        if (open[i].floor != n.floor || open[i].roof != n.roof || !goes_through(n, *at)) continue;
        n.left = open[i].left;
        used[i] = 1;
      }
    }
    for (std::size_t i = 0; i < open.size(); ++i)
      if (!used[i]) close(open[i], at);
    open = std::move(now);
  }

  Real height(Index e, const Real& x) const {
    const exact::SupportingCurve& k = r_.supporting_curve(e);
    return (k.offset() - Real(k.a) * x) / Real(k.b);
  }
  /// No vertex on the line between floor and roof: nothing keeps the two trapezoids apart.
  bool goes_through(const Open& o, const Real& x) const {
    for (const RealPoint& p : at_) {
      if (!(p.x == x)) continue;
      if (o.floor != kNone && p.y <= height(o.floor, x)) continue;
      if (o.roof != kNone && p.y >= height(o.roof, x)) continue;
      return false;
    }
    return true;
  }

  void close(const Open& o, const std::optional<Real>& right) {
    ConvexCell cell;
    const bool strict = !closed_;
    if (o.left) cell.push_back(more_x(*o.left, strict));
    if (right) cell.push_back(less_x(*right, strict));
    if (o.floor != kNone) cell.push_back(beyond(o.floor, -1, strict));
    if (o.roof != kNone) cell.push_back(beyond(o.roof, 1, strict));
    cells_.push_back(std::move(cell));
  }

  std::vector<Index> edges_over(const std::optional<Real>& left, const std::optional<Real>& right) const {
    std::vector<Index> over;
    if (!left || !right) return over;
    for (Index e = 0; e < r_.edges.size(); ++e)
      if (!vertical(e) && from(e).x <= *left && *right <= to(e).x) over.push_back(e);
    const Real middle = (*left + *right) * Real::ratio(1, 2);
    std::vector<std::pair<Real, Index>> heights;
    for (Index e : over) heights.emplace_back(height(e, middle), e);
    std::sort(heights.begin(), heights.end(), [](const auto& p, const auto& q) { return p.first < q.first; });
    for (std::size_t k = 0; k < over.size(); ++k) over[k] = heights[k].second;
    return over;
  }

  std::vector<Open> slab(const std::optional<Real>& left, const std::optional<Real>& right) const {
    const std::vector<Index> over = edges_over(left, right);
    std::vector<Open> out;
    for (std::size_t k = 0; k <= over.size(); ++k) {
      const Index floor = k > 0 ? over[k - 1] : kNone, roof = k < over.size() ? over[k] : kNone;
      // The face above an edge is on the left of its half-edge to the right.
      const Index face = floor != kNone ? r_.face(2 * floor) : roof != kNone ? r_.face(2 * roof + 1) : 0;
      if (r_.faces[face].mark > 0) out.push_back({floor, roof, left});
    }
    return out;
  }

  /// The open segments of a vertical line that lie in faces of the set.
  void walls(const Real& x) {
    std::vector<Real> ys;
    for (const RealPoint& p : at_)
      if (p.x == x) ys.push_back(p.y);
    for (Index e = 0; e < r_.edges.size(); ++e)
      if (!vertical(e) && from(e).x < x && x < to(e).x) ys.push_back(height(e, x));
    std::sort(ys.begin(), ys.end());
    ys.erase(std::unique(ys.begin(), ys.end()), ys.end());
    plane::Locator locator(r_);
    for (std::size_t k = 0; k <= ys.size(); ++k) {
      const Real y = k == 0           ? ys[0] - Real(1)
                     : k == ys.size() ? ys[k - 1] + Real(1)
                                      : (ys[k - 1] + ys[k]) * Real::ratio(1, 2);
      const plane::Cell cell = locator.locate({x, y});
      if (cell.dimension != 2 || r_.faces[cell.index].mark <= 0) continue;
      ConvexCell wall{less_x(x, false), more_x(x, false)};
      if (k > 0) wall.push_back({0, -1, -ys[k - 1], true});
      if (k < ys.size()) wall.push_back({0, 1, ys[k], true});
      cells_.push_back(std::move(wall));
    }
  }

  const Region& r_;
  bool closed_;
  std::vector<RealPoint> at_;
  std::vector<ConvexCell> cells_;
};

constexpr int128 kLargest = int128(1) << 62;

/// The fraction n / d, by its continued fraction.
std::pair<std::int64_t, std::int64_t> as_fraction(Real x) {
  int128 n0 = 0, d0 = 1, n1 = 1, d1 = 0;
  while (true) {
    const int128 whole = exact::floor(x);
    const bool fits = whole < kLargest && -whole < kLargest;
    const int128 n = fits ? whole * n1 + n0 : kLargest, d = fits ? whole * d1 + d0 : kLargest;
    if (n >= kLargest || -n >= kLargest || d >= kLargest)
      throw Error(ErrorCode::kUnsupported,
                  "a region's edge has a direction that is not a ratio of integers below 2^62");
    n0 = n1;
    d0 = d1;
    n1 = n;
    d1 = d;
    const Real rest = x - Real(whole);
    if (rest.sign() == 0) return {std::int64_t(n1), std::int64_t(d1)};
    x = Real(1) / rest;
  }
}

exact::SupportingCurve line_through(const RealPoint& p, const RealPoint& q) {
  const Real dx = q.x - p.x, dy = q.y - p.y;
  std::int64_t a = 1, b = 0;
  if (dx.sign() != 0) {
    const auto [rise, run] = as_fraction(dy / dx);
    a = -rise;
    b = run;
    exact::make_primitive(a, b);
  }
  return exact::SupportingCurve::line(a, b, Real(a) * p.x + Real(b) * p.y);
}

}  // namespace

bool is_straight(const Region& region) {
  return std::all_of(region.edges.begin(), region.edges.end(), [](const plane::Edge& e) { return e.half == 0; });
}

std::vector<ConvexCell> convex_cells(const Region& region, bool closed) { return Cells(region, closed).run(); }

Region convex_region(std::span<const RealPoint> corners, bool closed) {
  plane::MarkedCurves curves(0);
  auto& geometry = curves.curves.geometry;
  std::vector<Index> points;
  for (const RealPoint& p : corners) points.push_back(geometry.add_real_point(p.x, p.y));
  const std::size_t n = points.size();
  if (n == 1) {
    curves.add_isolated(points[0], 1, 0);
    return std::get<plane::CellComplex>(std::move(curves).complex());
  }
  for (std::size_t k = 0; k < (n == 2 ? 1 : n); ++k) {
    const Index p = points[k], q = points[(k + 1) % n];
    const Index line = geometry.add(line_through(corners[k], corners[(k + 1) % n]));
    curves.curves.segment(line, p, q, compare_xy(geometry, p, q) < 0);
    curves.mark({plane::Mark(closed || n == 2), plane::Mark(n > 2), 0});
  }
  for (Index p : points) curves.add_vertex(p, plane::Mark(closed));
  return std::get<plane::CellComplex>(std::move(curves).complex());
}

}  // namespace findspace::planning
