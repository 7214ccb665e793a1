// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// SupportingCurves (supporting lines and circles) and implicit points: what the planar kernel speaks about. Every sign
// about them is in geometry_signs.h.
//
// A line is a*x + b*y = c with (a, b) a primitive integer vector (a > 0, or a = 0 and b > 0) and c an integer, an
// integer plus w*sqrt(a^2+b^2) (a grid line displaced by w, kept unevaluated), or any exact real. A circle has a grid
// or a real centre and a real radius. A point is a grid point, a pair of exact reals, or "where supporting curves i and
// j meet, root r": it is never replaced by rounded coordinates.
//
// Guarantee: exact; beside each curve and point stand doubles with certain error bounds. Cost: a crossing takes some
// tens of nanoseconds, its exact coordinates microseconds.
// Source: the exact geometric computation paradigm (Yap 1997).
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "exact/number/real.h"
#include "exact/planar/approx.h"
#include "exact/planar/curve_reals.h"

namespace findspace::exact {

struct SupportingCurve {
  /// Of a grid line: its unit normal and distance from the origin, off by no more than the bounds.
  struct LineFilter {
    double x, y, z;
    ErrorBound x_error, y_error, z_error;
  };

  SupportingCurve() = default;
  /// A grid line.
  SupportingCurve(std::int64_t normal_x, std::int64_t normal_y, int128 offset, const LineFilter& f)
      : c(offset),
        a(normal_x),
        b(normal_y),
        x_error_(f.x_error),
        y_error_(f.y_error),
        z_error_(f.z_error),
        x_(f.x),
        y_(f.y),
        z_(f.z) {}

  /// A line parallel to another.
  SupportingCurve(const SupportingCurve& line, int128 offset, double z, ErrorBound z_error)
      : c(offset),
        a(line.a),
        b(line.b),
        x_error_(line.x_error_),
        y_error_(line.y_error_),
        z_error_(z_error),
        x_(line.x_),
        y_(line.y_),
        z_(z) {}

  int128 c = 0;               // line: integer offset, before it is displaced
  std::int64_t a = 0, b = 0;  // line: normal; circle: grid centre
  bool circle = false;
  bool grid = true;  // line: the offset is the integer c; circle: the centre is (a, b)

 private:
  ErrorBound x_error_, y_error_, z_error_;  // here for their size: this is most of what large sets are made of

 public:
  /// Circle: radius; line: displacement along its unit normal, 0 unless displaced. The point: of a circle its centre
  /// unless that is a grid point; of a line its x is the offset, and null unless that is neither an integer nor
  /// displaced.
  CurveReals reals;

  const Real& w() const { return reals.w(); }
  const RealPoint* real() const { return reals.point(); }
  /// First stage: line: unit normal (x, y) and distance z of the origin; circle: centre (x, y), radius z.
  Approx x() const { return {x_, x_error_}; }
  Approx y() const { return {y_, y_error_}; }
  Approx z() const { return {z_, z_error_}; }
  void set_filter(const Approx& x, const Approx& y, const Approx& z) {
    x_ = x.value;
    y_ = y.value;
    z_ = z.value;
    x_error_ = x.error;
    y_error_ = y.error;
    z_error_ = z.error;
  }

  static SupportingCurve line(std::int64_t a, std::int64_t b, int128 c);
  static SupportingCurve line(std::int64_t a, std::int64_t b, const Real& c);
  /// The line with offset c, moved along its unit normal by `shift`.
  static SupportingCurve displaced_line(std::int64_t a, std::int64_t b, int128 c, const CurveReals& shift);
  /// `r`: the radius, shared by circles that are given the same one.
  static SupportingCurve circle_at(std::int64_t cx, std::int64_t cy, const CurveReals& r);
  static SupportingCurve circle_at(std::int64_t cx, std::int64_t cy, const Real& r) {
    return circle_at(cx, cy, CurveReals(r));
  }
  static SupportingCurve circle_at(const Real& cx, const Real& cy, const Real& r);
  bool displaced() const { return !circle && !grid && !real(); }
  Real offset() const {
    return grid ? Real(c) : real() ? real()->x : Real(c) + w() * sqrt(Real(int128(a) * a + int128(b) * b));
  }
  Real center_x() const { return grid ? Real(a) : real()->x; }
  Real center_y() const { return grid ? Real(b) : real()->y; }

 private:
  double x_ = 0, y_ = 0, z_ = 0;
};
static_assert(sizeof(SupportingCurve) == 80);

/// Exactly the same point set.
bool same_supporting_curve(const SupportingCurve& p, const SupportingCurve& q);

/// Divides (a, b) by its greatest common divisor and makes it canonical (a > 0, or a = 0 and b > 0).
/// Returns the factor f with input = f * output (negative when the sign was flipped).
std::int64_t make_primitive(std::int64_t& a, std::int64_t& b);

struct Point {
  enum class Kind : std::uint8_t { kGrid, kCross, kReal };
  Point() = default;
  /// A grid point.
  Point(std::int64_t grid_x, std::int64_t grid_y) : x(double(grid_x)), y(double(grid_y)), gx(grid_x), gy(grid_y) {}

  Kind kind = Kind::kGrid;
  std::int8_t root = 0;  // kCross: 0 for two lines, else the sign of the square root (see geometry.cpp)
  ErrorBound error;      // |exact - (x, y)| <= error in each coordinate
  double x = 0, y = 0;
  union {
    std::int64_t gx = 0;  // kGrid
    std::uint32_t i;      // kCross: supporting curves, i < j; kReal: i indexes Geometry::reals
  };
  union {
    std::int64_t gy = 0;
    std::uint32_t j;
  };
};
static_assert(sizeof(Point) == 40);

/// A store: curves and points are numbered in the order in which they were added. References into it end with the
/// next `add`, but may be given to that one.
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
  /// The lines through each two neighbours of `count` > 0 grid points from `first` on, and through the last and `next`.
  void add_lines(std::uint32_t first, std::uint32_t count, std::uint32_t next);
  std::uint32_t add_grid_point(std::int64_t x, std::int64_t y) {
    points.emplace_back(x, y);
    return std::uint32_t(points.size() - 1);
  }
  std::uint32_t add_real_point(const Real& x, const Real& y);
  /// The point where supporting curves i and j meet; `root` as in `Meeting` (geometry_signs.h). They must meet there.
  std::uint32_t add_crossing(std::uint32_t i, std::uint32_t j, int root);
  /// The point that this adds.
  Point crossing(std::uint32_t i, std::uint32_t j, int root) const;

  RealPoint exact(std::uint32_t p) const;
  Real exact_x(std::uint32_t p) const { return exact(p).x; }
  Real exact_y(std::uint32_t p) const { return exact(p).y; }
};

}  // namespace findspace::exact
