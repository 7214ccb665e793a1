// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Chains of arcs for curves: the bound and the side hold at sampled points, and arcs are as few as theory says.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "findspace/error.h"
#include "plane/curve/curve_arcs.h"

namespace findspace::plane {
namespace plane_curve {

using exact::Real;

struct P {
  double x, y;
};

double value(const IntervalPolynomial& a, double t) {
  std::vector<double> c;
  for (const exact::Interval& i : a) c.push_back((i.lo + i.hi) / 2);
  for (std::size_t n = c.size() - 1; n > 0; --n)
    for (std::size_t i = 0; i < n; ++i) c[i] += t * (c[i + 1] - c[i]);
  return c[0];
}

P at(const CurvePiece& p, double t) {
  const double w = p.w.empty() ? 1 : value(p.w, t);
  return {value(p.x, t) / w, value(p.y, t) / w};
}

std::vector<P> samples(const Curve& curve, int a_piece) {
  std::vector<P> all;
  for (const CurvePiece& piece : curve.pieces)
    for (int k = 0; k <= a_piece; ++k) all.push_back(at(piece, double(k) / a_piece));
  return all;
}

/// Distance to an edge, positive to its left; coordinates from `origin`.
double left_of(const ContourEdge& e, GridPoint to, GridPoint origin, P p) {
  const P a{double(e.start.x - origin.x), double(e.start.y - origin.y)};
  const P b{double(to.x - origin.x), double(to.y - origin.y)};
  const double ux = b.x - a.x, uy = b.y - a.y, length = std::hypot(ux, uy);
  const double ends = std::min(std::hypot(p.x - a.x, p.y - a.y), std::hypot(p.x - b.x, p.y - b.y));
  const double side = (ux * (p.y - a.y) - uy * (p.x - a.x)) / length;
  if (!e.arc) {
    const double along = (ux * (p.x - a.x) + uy * (p.y - a.y)) / length;
    return along < 0 || along > length ? std::copysign(ends, side) : side;
  }
  const double cx = (e.arc->cx - Real(origin.x)).to_double(), cy = (e.arc->cy - Real(origin.y)).to_double();
  const double r = e.arc->r.to_double(), d = std::hypot(p.x - cx, p.y - cy);
  const double mid = (a.x - cx) * (b.y - cy) - (a.y - cy) * (b.x - cx);  // below half a circle
  auto turn = [&](P v, P w) { return (v.x - cx) * (w.y - cy) - (v.y - cy) * (w.x - cx); };
  const double sign = e.ccw ? 1 : -1;
  EXPECT_GT(sign * mid, 0);
  const bool inside = sign * turn(a, p) >= 0 && sign * turn(p, b) >= 0;
  return inside ? sign * (r - d) : std::copysign(ends, sign * (r - d));
}

double nearest(const ArcChain& chain, const Curve& curve, P p) {
  double best = INFINITY;
  for (std::size_t k = 0; k < chain.edges.size(); ++k) {
    const GridPoint to = k + 1 < chain.edges.size() ? chain.edges[k + 1].start : curve.to;
    best = std::min(best, std::abs(left_of(chain.edges[k], to, curve.from, p)));
  }
  return best;
}

/// Points of the chain, those of its arcs so near to each other that a step misses them by less than 1.
std::vector<P> points_of(const ArcChain& chain, const Curve& curve) {
  std::vector<P> all;
  for (std::size_t k = 0; k < chain.edges.size(); ++k) {
    const ContourEdge& e = chain.edges[k];
    const GridPoint to = k + 1 < chain.edges.size() ? chain.edges[k + 1].start : curve.to;
    const P a{double(e.start.x - curve.from.x), double(e.start.y - curve.from.y)};
    all.push_back(a);
    if (!e.arc) continue;
    const double cx = (e.arc->cx - Real(curve.from.x)).to_double(), cy = (e.arc->cy - Real(curve.from.y)).to_double();
    const P u{a.x - cx, a.y - cy}, v{double(to.x - curve.from.x) - cx, double(to.y - curve.from.y) - cy};
    const double sweep = std::atan2(u.x * v.y - u.y * v.x, u.x * v.x + u.y * v.y);
    const int count = 1 + int(std::abs(sweep) * std::sqrt(e.arc->r.to_double() / 8));
    for (int i = 1; i < count; ++i) {
      const double c = std::cos(sweep * i / count), s = std::sin(sweep * i / count);
      all.push_back({cx + u.x * c - u.y * s, cy + u.x * s + u.y * c});
    }
  }
  all.push_back({double(curve.to.x - curve.from.x), double(curve.to.y - curve.from.y)});
  return all;
}

/// How often the points go round p, closed by the step from the last to the first.
int winding(const std::vector<P>& ring, P p) {
  int count = 0;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const P &a = ring[k], &b = ring[(k + 1) % ring.size()];
    const double turn = (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
    if (a.y <= p.y && b.y > p.y && turn > 0) ++count;
    if (a.y > p.y && b.y <= p.y && turn < 0) --count;
  }
  return count;
}

bool capped(const ArcChain& chain, GridPoint origin, P p) {
  for (const CapBox& c : chain.caps)
    if (p.x >= double(c.low.x - origin.x) && p.x <= double(c.high.x - origin.x) && p.y >= double(c.low.y - origin.y) &&
        p.y <= double(c.high.y - origin.y))
      return true;
  return false;
}

/// Points beside the curve: the chain goes round none in the wrong sense, and far ones as the curve does.
void expect_side(const Curve& curve, double bound, CurveSide side, const ArcChain& chain) {
  const std::vector<P> fine = samples(curve, 4000), arcs = points_of(chain, curve);
  const double towards = double(static_cast<int>(side));
  for (std::size_t k = 7; k + 1 < fine.size(); k += 397) {
    const double dx = fine[k + 1].x - fine[k].x, dy = fine[k + 1].y - fine[k].y, length = std::hypot(dx, dy);
    if (!(length > 0)) continue;
    for (double away : {-1.2, -0.5, -0.1, 0.1, 0.3, 0.6, 1.2}) {
      const P p{fine[k].x - dy / length * away * bound, fine[k].y + dx / length * away * bound};
      const int difference = winding(arcs, p) - winding(fine, p);
      const bool beside = nearest(chain, curve, p) <= bound;
      if (!beside) {
        EXPECT_EQ(difference, 0);
      }
      if (side != CurveSide::kNear && !capped(chain, curve.from, p)) {
        EXPECT_LE(difference * towards, 0) << p.x << " " << p.y;
      }
    }
  }
}

void expect_bound(const Curve& curve, double bound, CurveSide side) {
  const ArcChain chain = arcs_of(curve, bound, side);
  for (const P& p : samples(curve, 120)) EXPECT_LE(nearest(chain, curve, p), bound);
  expect_side(curve, bound, side, chain);
}

void expect_bounds(const Curve& curve, double bound) {
  for (CurveSide side : {CurveSide::kNear, CurveSide::kLeft, CurveSide::kRight}) expect_bound(curve, bound, side);
}

Curve bezier(const std::vector<GridPoint>& p, std::vector<Real> weights = {}) {
  std::vector<CurvePoint> points;
  for (GridPoint q : p) points.push_back({Real(q.x), Real(q.y)});
  return bezier_curve(points, weights, p.front(), p.back());
}

Curve whole_ellipse(std::int64_t a, std::int64_t b) {
  const EllipseFrame frame{{Real(0), Real(0)}, {Real(a), Real(0)}, {Real(0), Real(b)}};
  return ellipse_curve(frame, 0, 2 * std::numbers::pi, {a, 0}, {a, 0});
}

TEST(PlaneCurve, BoundAndSideHold) {
  expect_bounds(bezier({{0, 0}, {3000000, 8000000}, {9000000, -4000000}, {10000000, 1000000}}), 1000);
  expect_bounds(bezier({{0, 0}, {5000000, 9000000}, {10000000, 0}}), 100);
  expect_bounds(bezier({{0, 0}, {4000000, 9000000}, {8000000, 0}}, {1, Real::ratio(1, 3), 2}), 1000);
  expect_bounds(whole_ellipse(30000000, 7000000), 1000);
  expect_bounds(whole_ellipse(30000000, 100000), 1000);
}

TEST(PlaneCurve, CuspsAndLoops) {
  expect_bounds(bezier({{0, 0}, {10000000, 10000000}, {0, 10000000}, {10000000, 0}}), 1000);          // a cusp
  expect_bounds(bezier({{0, 0}, {20000000, 10000000}, {-10000000, 10000000}, {10000000, 0}}), 1000);  // a loop
  expect_bounds(bezier({{0, 0}, {0, 0}, {5000000, 5000000}, {9000000, 0}}), 1000);   // no speed at its start
  expect_bounds(bezier({{0, 0}, {9000000, 0}, {-3000000, 0}, {5000000, 0}}), 1000);  // to and fro on a line
  expect_bounds(bezier({{0, 0}, {300, 500}, {200, -100}, {10, 10}}), 1000);          // smaller than the bound
}

TEST(PlaneCurve, Splines) {
  Spline s;
  s.degree = 3;
  for (int k : {0, 0, 0, 0, 1, 2, 2, 3, 4, 4, 4, 4}) s.knots.push_back(Real(k));
  for (auto [x, y] :
       std::vector<std::pair<int, int>>{{0, 0}, {1, 3}, {4, 5}, {6, -2}, {9, 1}, {11, 7}, {13, 0}, {15, 2}})
    s.points.push_back({Real(x * 1000000), Real(y * 1000000)});
  check_spline(s);
  expect_bounds(spline_curve(s, {0, 0}, {15000000, 2000000}), 500);
  s.weights = {1, 2, 1, 3, 1, 1, Real::ratio(1, 2), 1};
  expect_bounds(spline_curve(s, {0, 0}, {15000000, 2000000}), 500);
  EXPECT_EQ(compare(spline_end(s, true).x, Real(15000000)), 0);
  s.knots.pop_back();
  EXPECT_THROW(check_spline(s), Error);
}

/// Where a knot comes once more than the degree, the pieces beside it have no control point in common.
TEST(PlaneCurve, SplinesThatJumpAreRefused) {
  const auto spline = [](std::size_t degree, const std::vector<int>& knots, const std::vector<int>& xs) {
    Spline s{degree, {}, {}, {}};
    for (int k : knots) s.knots.push_back(Real(k));
    for (int x : xs) s.points.push_back({Real(x), Real(x % 2)});
    return s;
  };
  EXPECT_THROW(check_spline(spline(2, {0, 0, 0, 1, 1, 1, 2, 2, 2}, {0, 1, 2, 8, 9, 10})), Error);
  EXPECT_THROW(check_spline(spline(1, {0, 0, 1, 1, 2, 2}, {0, 1, 9, 10})), Error);
  EXPECT_THROW(check_spline(spline(1, {0, 0, 1, 1, 1, 2, 2}, {0, 1, 5, 9, 10})), Error);
  EXPECT_NO_THROW(check_spline(spline(2, {0, 0, 0, 1, 1, 1, 2, 2, 2}, {0, 1, 2, 2, 9, 10})));
  EXPECT_NO_THROW(check_spline(spline(2, {0, 0, 0, 1, 1, 2, 2, 2}, {0, 1, 2, 9, 10})));
  EXPECT_NO_THROW(check_spline(spline(1, {0, 0, 0, 1, 1, 1}, {7, 0, 1, 8})));  // beyond its ends
}

TEST(PlaneCurve, BezierPiecesOfASplineAreItsCurve) {
  // A uniform quadratic B-spline is known at its knots: the middles of its legs.
  Spline s{2, {}, {}, {}};
  for (int k = 0; k < 7; ++k) s.knots.push_back(Real(k));
  for (auto [x, y] : std::vector<std::pair<int, int>>{{0, 0}, {100, 200}, {300, 0}, {400, 400}})
    s.points.push_back({Real(x), Real(y)});
  const Curve c = spline_curve(s, {50, 100}, {350, 200});
  ASSERT_EQ(c.pieces.size(), 2u);
  EXPECT_NEAR(at(c.pieces[0], 1).x, 200 - 50, 1e-9);
  EXPECT_NEAR(at(c.pieces[0], 1).y, 100 - 100, 1e-9);
}

TEST(PlaneCurve, AReversedCurveIsTheSame) {
  const Curve c = bezier({{5, 7}, {3000000, 8000000}, {9000000, -4000000}, {10000000, 1000000}}), r = reversed(c);
  const P a = at(c.pieces[0], 0.25), b = at(r.pieces[0], 0.75);
  EXPECT_NEAR(a.x + 5, b.x + 10000000, 1e-3);
  EXPECT_NEAR(a.y + 7, b.y + 1000000, 1e-3);
}

/// Integral of the third root of the derivative of the curvature.
double third_root_length(double a, double b) {
  constexpr int kSteps = 200000;
  double sum = 0, before = 0;
  for (int k = 0; k <= kSteps; ++k) {
    const double t = 2 * std::numbers::pi * k / kSteps;
    const double speed = std::hypot(a * std::sin(t), b * std::cos(t)), curvature = a * b / std::pow(speed, 3);
    if (k > 0)
      sum += std::cbrt(std::abs(curvature - before) / (speed * 2 * std::numbers::pi / kSteps)) * speed * 2 *
             std::numbers::pi / kSteps;
    before = curvature;
  }
  return sum;
}

TEST(PlaneCurve, ArcsAreAsFewAsTheThirdRootOfTheBound) {
  const double a = 40000000, b = 20000000;
  const Curve ellipse = whole_ellipse(std::int64_t(a), std::int64_t(b));
  for (double bound : {64.0, 1000.0, 20000.0}) {
    const double best = third_root_length(a, b) / std::cbrt(125 * bound),
                 biarcs = third_root_length(a, b) * 2 / std::cbrt(324 * bound);
    const auto count = double(arcs_of(ellipse, bound, CurveSide::kNear).edges.size());
    RecordProperty("arcs", int(count));
    EXPECT_LE(count, best * 1.15 + 5) << bound;
    EXPECT_LT(count, biarcs) << bound;
    const auto sided = double(arcs_of(ellipse, bound, CurveSide::kLeft).edges.size());
    EXPECT_LE(sided, best * 1.15 * std::cbrt(2 / kWindowPart) + 6) << bound;
    std::printf("bound %g: %g arcs, %g on a side; theory %.1f, biarcs %.1f\n", bound, count, sided, best, biarcs);
  }
}

TEST(PlaneCurve, WhatIsRefused) {
  const Curve c = bezier({{0, 0}, {5000000, 9000000}, {10000000, 0}});
  EXPECT_THROW(arcs_of(c, 10, CurveSide::kNear), Error);
  EXPECT_THROW(bezier(std::vector<GridPoint>(40, {1, 2})), Error);
  EXPECT_THROW(bezier({{0, 0}, {1, 1}, {2, 0}}, {1, 0, 1}), Error);
}

}  // namespace plane_curve
}  // namespace findspace::plane
