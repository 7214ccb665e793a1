// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// SupportingCurves (supporting lines and circles), implicit points, and every sign the planar kernel needs about them.
//
// A line is a*x + b*y = c with (a, b) a primitive integer vector (a > 0, or a = 0 and b > 0) and c an integer, an
// integer plus w*sqrt(a^2+b^2) (a grid line displaced by w, kept unevaluated), or any exact real. A circle has a grid
// or a real centre and a real radius. A point is a grid point, a pair of exact reals, or "where supporting_curves i and
// j meet, root r": it is never replaced by rounded coordinates.
//
// Guarantee: every function that returns a sign or a truth value is exact. Stages: double with a running error bound;
// fixed-width integers where all data are grid lines and grid points; exact reals (closed forms, then a separation
// bound). Cost: a few nanoseconds in the first two stages, microseconds in the last.
// Source: the staging follows S2's predicates and the exact geometric computation paradigm (Yap 1997).
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "exact/number/real.h"
#include "exact/planar/approx.h"

namespace findspace::exact {

struct RealPoint {
  Real x, y;
};

struct SupportingCurve {
  bool circle = false;
  bool grid = true;           // line: the offset is the integer c; circle: the centre is (a, b)
  std::int64_t a = 0, b = 0;  // line: normal; circle: grid centre
  int128 c = 0;               // line: integer offset
  std::shared_ptr<const RealPoint>
      real;  // line: x = offset, null unless neither grid nor displaced; circle: centre unless grid
  Real w;    // circle: radius; line: displacement along its unit normal, 0 unless displaced
  // First stage: line: unit normal (x, y) and distance z of the origin; circle: centre (x, y), radius z.
  Approx x, y, z;

  static SupportingCurve line(std::int64_t a, std::int64_t b, int128 c);
  static SupportingCurve line(std::int64_t a, std::int64_t b, const Real& c);
  /// The line with offset c, moved along its unit normal by `shift`.
  static SupportingCurve displaced_line(std::int64_t a, std::int64_t b, int128 c, const Real& shift);
  static SupportingCurve circle_at(std::int64_t cx, std::int64_t cy, const Real& r);
  static SupportingCurve circle_at(const Real& cx, const Real& cy, const Real& r);
  bool displaced() const { return !circle && !grid && !real; }
  Real offset() const {
    return grid ? Real(c) : real ? real->x : Real(c) + w * sqrt(Real(int128(a) * a + int128(b) * b));
  }
  Real center_x() const { return grid ? Real(a) : real->x; }
  Real center_y() const { return grid ? Real(b) : real->y; }
};

/// Exactly the same point set.
bool same_supporting_curve(const SupportingCurve& p, const SupportingCurve& q);

/// Divides (a, b) by its greatest common divisor and makes it canonical (a > 0, or a = 0 and b > 0).
/// Returns the factor f with input = f * output (negative when the sign was flipped).
std::int64_t make_primitive(std::int64_t& a, std::int64_t& b);

struct Point {
  enum class Kind : std::uint8_t { kGrid, kCross, kReal };
  Kind kind = Kind::kGrid;
  std::int8_t root = 0;            // kCross: 0 for two lines, else the sign of the square root (see geometry.cpp)
  std::uint32_t i = 0, j = 0;      // kCross: supporting_curves, i < j; kReal: i indexes Geometry::reals
  std::int64_t gx = 0, gy = 0;     // kGrid
  double x = 0, y = 0, error = 0;  // |exact - (x, y)| <= error in each coordinate
};

class Geometry {
 public:
  std::vector<SupportingCurve> supporting_curves;
  std::vector<Point> points;
  std::vector<RealPoint> reals;

  std::uint32_t add(SupportingCurve c) {
    supporting_curves.push_back(std::move(c));
    return std::uint32_t(supporting_curves.size() - 1);
  }
  /// The line a*x + b*y = c, (a, b) primitive and canonical.
  std::uint32_t add_line(std::int64_t a, std::int64_t b, int128 c);
  /// The line through the grid point (x, y) parallel to a grid line, whose filter it shares.
  std::uint32_t add_parallel(const SupportingCurve& line, std::int64_t x, std::int64_t y);
  /// A grid line moved along its unit normal by `shift`, not 0; it shares the filter of its direction.
  std::uint32_t add_displaced(const SupportingCurve& line, const Real& shift);
  std::uint32_t add_grid_point(std::int64_t x, std::int64_t y);
  std::uint32_t add_real_point(const Real& x, const Real& y);
  /// The point where supporting_curves i and j meet; `root` as in `Meeting`. The supporting_curves must meet there.
  std::uint32_t add_crossing(std::uint32_t i, std::uint32_t j, int root);

  /// How two different supporting_curves meet: 0, 1 or 2 points. Root values to give to add_crossing; a tangency has
  /// one point.
  struct Meeting {
    int count = 0;
    std::array<int, 2> root{0, 0};
  };
  Meeting meet(std::uint32_t i, std::uint32_t j) const;

  Real exact_x(std::uint32_t p) const;
  Real exact_y(std::uint32_t p) const;
  RealPoint exact(std::uint32_t p) const;

  int compare_x(std::uint32_t p, std::uint32_t q) const {
    int s = filtered(points[p].x, points[q].x, points[p].error + points[q].error);
    return s != 0 ? s : staged_compare(p, q, true);
  }
  int compare_y(std::uint32_t p, std::uint32_t q) const {
    int s = filtered(points[p].y, points[q].y, points[p].error + points[q].error);
    return s != 0 ? s : staged_compare(p, q, false);
  }
  /// Lexicographic: x first, then y. 0 exactly when the points are equal.
  int compare_xy(std::uint32_t p, std::uint32_t q) const;
  /// Line: sign of a*x + b*y - c. Circle: sign of the squared distance to the centre minus the squared radius.
  int side(std::uint32_t p, std::uint32_t supporting_curve) const {
    const Point& q = points[p];
    const SupportingCurve& k = supporting_curves[supporting_curve];
    if (q.kind != Point::Kind::kGrid || !k.grid || k.circle) return staged_side(p, supporting_curve);
    int128 s = int128(k.a) * q.gx + int128(k.b) * q.gy - k.c;
    return (s > 0) - (s < 0);
  }
  /// Circle: sign of (y of p) - (y of the centre).
  int above_center(std::uint32_t p, std::uint32_t circle) const;
  /// Circle: sign of (x of p) - (x of the centre).
  int right_of_center(std::uint32_t p, std::uint32_t circle) const;
  bool lies_on(std::uint32_t p, std::uint32_t supporting_curve) const { return side(p, supporting_curve) == 0; }

  /// Is p by its definition the only common point of supporting_curves i and j, not both lines? (False may be for want
  /// of knowledge.)
  bool touch_at(std::uint32_t p, std::uint32_t i, std::uint32_t j) const;

  /// A direction of travel at a point: along a line, or along a circle's tangent there. `forward` on a line is
  /// (b, -a), on a circle counter-clockwise.
  struct Heading {
    std::uint32_t supporting_curve = 0;
    bool forward = true;
  };
  /// Sign of the cross product of the two tangent directions at p: +1 when `k` is to the left of `h`.
  int turn(std::uint32_t p, Heading h, Heading k) const;
  /// Sign of the dot product of the two tangent directions at p.
  int along(std::uint32_t p, Heading h, Heading k) const;
  /// Sign of curvature(h) - curvature(k), curvature positive when rotating left.
  int compare_curvature(Heading h, Heading k) const;

 private:
  /// Sign of x - y where it exceeds `error` (inflated for its rounding) and the rounding of the difference, 2^-52 of
  /// it.
  static int filtered(double x, double y, double error) {
    double gap = x - y, tolerance = error * Approx::kGrow + std::abs(gap) * Approx::kUnit * 2;
    return (gap > tolerance) - (gap < -tolerance);
  }
  int staged_compare(std::uint32_t p, std::uint32_t q, bool x_axis) const;
  int staged_side(std::uint32_t p, std::uint32_t supporting_curve) const;
  void set_approx(Point& p) const;
  RealPoint crossing(const Point& p) const;
  int fixed_compare(const Point& p, const Point& q, bool x_axis) const;
  std::array<Approx, 2> tangent(std::uint32_t p, Heading h) const;
  std::array<Real, 2> exact_tangent(std::uint32_t p, Heading h) const;
};

}  // namespace findspace::exact
