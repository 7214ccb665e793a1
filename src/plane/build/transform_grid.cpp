// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/build/transform_grid.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "findspace/error.h"
#include "plane/base/real_vector.h"
#include "plane/base/union_find.h"
#include "plane/complex/marked_curves.h"
#include "plane/contour/contour.h"

namespace findspace::plane {
namespace {

using exact::int128;
using exact::Real;
using exact::SupportingCurve;

constexpr int kBits = 60;  // of the fixed-point sine and cosine
constexpr int128 kOne = int128(1) << kBits;
constexpr int128 kPi = 3622009729038561421;  // pi * 2^60

int128 product(int128 p, int128 q) { return (p * q) >> kBits; }

/// Sum of Taylor's series from `term` on, whose factorial stands at `n`.
int128 series(int128 term, int n, int128 square) {
  int128 sum = 0;
  for (; term != 0; n += 2) {
    sum += term;
    term = -product(term, square) / ((n + 1) * (n + 2));
  }
  return sum;
}

/// A rotation about a grid point, the same on every machine.
class Rotation {
 public:
  Rotation(const GridPoint& about, int quarters, const Real& rest) : x_(about.x), y_(about.y) {
    int128 angle = exact::floor(rest * Real(kPi) / Real(180)), square = product(angle, angle);
    int128 s = series(angle, 1, square), c = series(kOne, 0, square);
    for (int k = 0; k < quarters; ++k) s = std::exchange(c, -s);
    sine_ = Real::ratio(s, kOne);
    cosine_ = Real::ratio(c, kOne);
  }

  RealVector operator()(const RealVector& p) const {
    Real dx = p.x - x_, dy = p.y - y_;
    return {x_ + cosine_ * dx - sine_ * dy, y_ + sine_ * dx + cosine_ * dy};
  }

 private:
  Real x_, y_, sine_, cosine_;
};

GridPoint rounded(const RealVector& p, Rounding& rounding) {
  int128 x = exact::round(p.x), y = exact::round(p.y);
  constexpr int128 kLimit = int128(1) << 41;
  if (x > kLimit || x < -kLimit || y > kLimit || y < -kLimit) {
    throw Error(ErrorCode::kOutOfRange, "a rotated shape leaves the grid: a coordinate exceeds 2^40 grid steps");
  }
  rounding.note(std::hypot((p.x - Real(x)).to_double(), (p.y - Real(y)).to_double()));
  return {std::int64_t(x), std::int64_t(y)};
}

/// The extreme points of the circle strictly inside its counter-clockwise arc from p to q (the whole circle where they
/// are one), in order.
std::vector<RealVector> extremes_inside(const SupportingCurve& circle, const RealVector& p, const RealVector& q) {
  const Real x = circle.center_x(), y = circle.center_y(), &r = circle.w();
  const std::array<RealVector, 4> extreme{{{x + r, y}, {x, y + r}, {x - r, y}, {x, y - r}}};
  int right = compare(p.x, x), up = compare(p.y, y);
  std::size_t next = right > 0 && up >= 0 ? 1 : right <= 0 && up > 0 ? 2 : right < 0 ? 3 : 0;
  bool whole = p == q;
  std::vector<RealVector> found;
  for (std::size_t k = 0; k < 4; ++k) {
    const RealVector& e = extreme[(next + k) % 4];
    if (whole ? !(e == p) : cross(q - p, e - p).sign() < 0) found.push_back(e);
  }
  return found;
}

class GridRotation {
 public:
  GridRotation(const CellComplex& c, Rotation rotation, Rounding& rounding)
      : c_(c), rotation_(std::move(rotation)), rounding_(rounding), to_(c.faces[0].mark), same_(c.vertices.size()) {}

  std::variant<CellComplex, CurveFault> run() {
    find_passed();
    place_.resize(c_.vertices.size());
    for (Index v = 0; v < c_.vertices.size(); ++v) {
      if (!passed_[v]) place_[v] = round(c_.geometry.exact(c_.vertices[v].point));
    }
    std::vector<char> done(c_.edges.size(), 0);
    for (Index e = 0; e < c_.edges.size(); ++e) {
      if (!done[e]) curves_.push_back(curve_of(e, done));
    }
    for (Curve& k : curves_) {
      if (k.from == kNone) continue;
      k.points = points_of(k);
      if (k.points.size() == 1 && !contract(k)) return CurveFault{double(k.points[0].x), double(k.points[0].y)};
    }
    add_points();
    for (const Curve& k : curves_) add(k);
    return std::move(to_).complex();
  }

 private:
  /// A segment, an arc between vertices that stay (counter-clockwise), or a whole circle (from == kNone).
  struct Curve {
    Index from = kNone, to = kNone, supporting_curve = 0;
    bool arc = false;
    MarkedCurves::Sides sides;
    std::vector<GridPoint> points;  // its rounded ends, and where an arc is cut
  };

  GridPoint round(const RealVector& p) { return rounded(rotation_(p), rounding_); }

  /// Vertices that only cut an arc in two: where a circle is leftmost or rightmost.
  void find_passed() {
    passed_.assign(c_.vertices.size(), 0);
    for (Index v = 0; v < c_.vertices.size(); ++v) {
      Index h = c_.vertices[v].out;
      if (h == kNone) continue;
      Index k = c_.clockwise(h);
      if (k == h || c_.clockwise(k) != h) continue;
      const Edge &e = c_.edges[h / 2], &f = c_.edges[k / 2];
      Mark m = c_.vertices[v].mark;
      bool one_circle =
          e.half * f.half < 0 && exact::same_supporting_curve(c_.supporting_curve(h / 2), c_.supporting_curve(k / 2));
      passed_[v] = one_circle && e.mark == m && f.mark == m;
    }
  }

  Curve curve_of(Index e, std::vector<char>& done) const {
    Curve k{.supporting_curve = c_.edges[e].supporting_curve, .arc = c_.is_arc(e), .sides = {}, .points = {}};
    Index first = k.arc && !c_.heading(2 * e).forward ? 2 * e + 1 : 2 * e, last = first;
    k.sides = {c_.edges[e].mark, c_.faces[c_.face(first)].mark, c_.faces[c_.face(first ^ 1u)].mark};
    done[e] = 1;
    while (passed_[c_.target(last)]) {
      last = c_.next(last);
      if (last == first) return k;
      done[last / 2] = 1;
    }
    while (passed_[c_.origin(first)]) {
      first = CellComplex::twin(c_.clockwise(first));
      done[first / 2] = 1;
    }
    k.from = c_.origin(first);
    k.to = c_.target(last);
    return k;
  }

  std::vector<GridPoint> points_of(const Curve& k) {
    std::vector<GridPoint> points{place_[k.from]};
    if (k.arc) {
      const SupportingCurve& circle = c_.geometry.supporting_curves[k.supporting_curve];
      RealVector p = c_.geometry.exact(c_.vertices[k.from].point), q = c_.geometry.exact(c_.vertices[k.to].point);
      std::vector<RealVector> inside = extremes_inside(circle, p, q);
      RealVector center{circle.center_x(), circle.center_y()};
      bool is_long = inside.size() > 1 || dot(p - center, q - center).sign() < 0;
      for (std::size_t i = 0; is_long && i < inside.size(); ++i) {
        GridPoint cut = round(inside[i]);
        if (cut != points.back() && cut != place_[k.to]) points.push_back(cut);
      }
    }
    if (place_[k.to] != points.back()) points.push_back(place_[k.to]);
    return points;
  }

  /// A curve whose points fall together becomes one of them; false where marks disagree or a face would vanish.
  bool contract(const Curve& k) {
    Mark m = c_.vertices[k.from].mark;
    if (same_.find(k.from) == same_.find(k.to) || m != c_.vertices[k.to].mark || m != k.sides.on) return false;
    same_.unite(k.from, k.to);
    return true;
  }

  void add_points() {
    point_.assign(c_.vertices.size(), kNone);
    std::vector<char> has_curve(c_.vertices.size(), 0);
    std::vector<Mark> around(c_.vertices.size(), 0);
    for (const Curve& k : curves_) {
      if (k.from == kNone) continue;
      around[same_.find(k.from)] = k.sides.left;  // of all curves there when none is left
      if (k.points.size() > 1) has_curve[same_.find(k.from)] = has_curve[same_.find(k.to)] = 1;
    }
    for (Index v = 0; v < c_.vertices.size(); ++v) {
      if (passed_[v] || same_.find(v) != v) continue;
      const Vertex& w = c_.vertices[v];
      point_[v] = to_.curves.geometry.add_grid_point(place_[v].x, place_[v].y);
      if (has_curve[v])
        to_.add_vertex(point_[v], w.mark);
      else
        to_.add_isolated(point_[v], w.mark, w.out == kNone ? c_.faces[w.face].mark : around[v]);
    }
  }

  void add(const Curve& k) {
    if (k.from == kNone) {
      const SupportingCurve& circle = c_.geometry.supporting_curves[k.supporting_curve];
      GridPoint center = round({circle.center_x(), circle.center_y()});
      to_.curves.circle(to_.curves.geometry.add(SupportingCurve::circle_at(center.x, center.y, circle.w())));
    }
    Index at = k.from == kNone ? kNone : point_[same_.find(k.from)];
    for (std::size_t i = 1; i < k.points.size(); ++i) {
      const GridPoint &p = k.points[i - 1], &q = k.points[i];
      Index end = i + 1 == k.points.size() ? point_[same_.find(k.to)] : to_.curves.geometry.add_grid_point(q.x, q.y);
      if (k.arc) {
        ContourEdge e = radius_arc(p, q, c_.geometry.supporting_curves[k.supporting_curve].w(), false, true);
        to_.curves.arc(to_.curves.geometry.add(SupportingCurve::circle_at(e.arc->cx, e.arc->cy, e.arc->r)), at, end,
                       true);
      } else {
        to_.curves.segment(to_.curves.line(p, q), at, end, p < q);
      }
      at = end;
    }
    to_.mark(k.sides);
  }

  const CellComplex& c_;
  Rotation rotation_;
  Rounding& rounding_;
  MarkedCurves to_;
  UnionFind same_;  // vertices that fall together
  std::vector<char> passed_;
  std::vector<GridPoint> place_;
  std::vector<Index> point_;  // of the leading vertex
  std::vector<Curve> curves_;
};

}  // namespace

CellComplex rotated_on_grid(const CellComplex& c, const GridPoint& about, int quarters, const Real& rest, double step,
                            Rounding& rounding) {
  auto result = GridRotation(c, Rotation(about, quarters, rest), rounding).run();
  if (auto* region = std::get_if<CellComplex>(&result)) return std::move(*region);
  CurveFault fault = std::get<CurveFault>(result);
  throw Error(
      ErrorCode::kGeometry,
      fmt::format("rotated and put on the grid, the shape touches or crosses itself near ({:.10g}, {:.10g}); a finer "
                  "\"grid\" avoids it",
                  fault.x * step, fault.y * step))
      .at(fault.x * step, fault.y * step);
}

}  // namespace findspace::plane
