// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "plane/curve/curve.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "findspace/error.h"

namespace findspace::plane {
namespace {

using exact::Interval;
using exact::Real;

constexpr Interval kOne{1, 1};

Interval from_origin(const Real& v, std::int64_t origin) { return (v - Real(origin)).interval(); }

void check_degree(std::size_t degree) {
  if (degree < 1 || degree > kMostDegree)
    throw Error(ErrorCode::kUnsupported, fmt::format("a curve of degree {}; 1 to {} are read", degree, kMostDegree));
}

void check_weights(std::span<const Real> weights, std::size_t points) {
  if (!weights.empty() && weights.size() != points)
    throw Error(ErrorCode::kBadValue, fmt::format("{} weights for {} points", weights.size(), points));
  for (const Real& w : weights)
    if (w.sign() <= 0) throw Error(ErrorCode::kBadValue, "a weight of a curve must be more than 0");
}

/// A control point in homogeneous coordinates.
struct Homogeneous {
  Interval x, y, w = kOne;
};

Homogeneous operator*(const Interval& f, const Homogeneous& p) { return {f * p.x, f * p.y, f * p.w}; }
Homogeneous operator+(const Homogeneous& a, const Homogeneous& b) { return {a.x + b.x, a.y + b.y, a.w + b.w}; }

std::vector<Homogeneous> homogeneous(std::span<const CurvePoint> points, std::span<const Real> weights,
                                     GridPoint origin) {
  std::vector<Homogeneous> out;
  for (std::size_t i = 0; i < points.size(); ++i) {
    Homogeneous p{from_origin(points[i].x, origin.x), from_origin(points[i].y, origin.y)};
    out.push_back(weights.empty() ? p : weights[i].interval() * p);
  }
  return out;
}

CurvePiece piece_of(const std::vector<Homogeneous>& points, bool rational) {
  CurvePiece piece;
  for (const Homogeneous& p : points) {
    piece.x.push_back(p.x);
    piece.y.push_back(p.y);
    if (rational) piece.w.push_back(p.w);
  }
  return piece;
}

/// The two ends lie exactly where they were put.
void pin_ends(Curve& curve) {
  CurvePiece &first = curve.pieces.front(), &last = curve.pieces.back();
  first.x.front() = first.y.front() = Interval{};
  const Interval w = last.w.empty() ? kOne : last.w.back();
  last.x.back() = exact::enclose(curve.to.x - curve.from.x) * w;
  last.y.back() = exact::enclose(curve.to.y - curve.from.y) * w;
}

/// Control points from another origin.
void shift(Curve& curve, GridPoint old, GridPoint origin) {
  const Interval dx = exact::enclose(old.x - origin.x), dy = exact::enclose(old.y - origin.y);
  for (CurvePiece& piece : curve.pieces) {
    for (std::size_t i = 0; i < piece.x.size(); ++i) {
      const Interval w = piece.w.empty() ? kOne : piece.w[i];
      piece.x[i] = piece.x[i] + dx * w;
      piece.y[i] = piece.y[i] + dy * w;
    }
  }
}

/// The exact unit vector in the direction of an angle near `angle`.
struct UnitVector {
  Interval c, s;
};
UnitVector unit_vector(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  const Interval ci{c, c}, si{s, s}, length = exact::sqrt(ci * ci + si * si);
  return {ci / length, si / length};
}

/// Position `r` of the triangular scheme: between knot j and knot j + degree - r + 1.
template <class T, class P>
P blossom(const std::vector<T>& knots, std::vector<P> d, std::size_t degree, std::size_t span,
          const std::vector<T>& arguments) {
  for (std::size_t r = 1; r <= degree; ++r) {
    for (std::size_t k = degree; k >= r; --k) {
      const std::size_t j = span - degree + k;
      const T width = knots[j + degree - r + 1] - knots[j];
      const T a = (arguments[r - 1] - knots[j]) / width, b = (knots[j + degree - r + 1] - arguments[r - 1]) / width;
      d[k] = b * d[k - 1] + a * d[k];
    }
  }
  return d[degree];
}

struct RealHomogeneous {
  Real x, y, w;
};
RealHomogeneous operator*(const Real& f, const RealHomogeneous& p) { return {f * p.x, f * p.y, f * p.w}; }
RealHomogeneous operator+(const RealHomogeneous& a, const RealHomogeneous& b) {
  return {a.x + b.x, a.y + b.y, a.w + b.w};
}

/// Knot spans that have a length, by their first knot.
std::vector<std::size_t> spans_of(const Spline& s) {
  std::vector<std::size_t> spans;
  for (std::size_t i = s.degree; i < s.points.size(); ++i)
    if (s.knots[i] < s.knots[i + 1]) spans.push_back(i);
  return spans;
}

/// Where a knot comes more often than the degree says, the pieces beside it end and begin at control points of their
/// own.
void check_unbroken(const Spline& s) {
  const std::vector<std::size_t> spans = spans_of(s);
  for (std::size_t k = 1; k < spans.size(); ++k) {
    const std::size_t ends = spans[k - 1], begins = spans[k] - s.degree;
    if (begins <= ends || (s.points[ends].x == s.points[begins].x && s.points[ends].y == s.points[begins].y)) continue;
    throw Error(ErrorCode::kBadValue, fmt::format("the spline jumps at its knot {:.10g}, from control point {} to {}",
                                                  s.knots[spans[k]].to_double(), ends, begins));
  }
}

}  // namespace

Curve bezier_curve(std::span<const CurvePoint> points, std::span<const Real> weights, GridPoint from, GridPoint to) {
  check_degree(points.size() - 1);
  check_weights(weights, points.size());
  Curve curve{from, to, {piece_of(homogeneous(points, weights, from), !weights.empty())}};
  pin_ends(curve);
  return curve;
}

Curve ellipse_curve(const EllipseFrame& frame, double first, double sweep, GridPoint from, GridPoint to) {
  Curve curve{from, to, {}};
  const Interval cx = from_origin(frame.center.x, from.x), cy = from_origin(frame.center.y, from.y);
  const Interval ux = frame.u.x.interval(), uy = frame.u.y.interval();
  const Interval vx = frame.v.x.interval(), vy = frame.v.y.interval();
  auto placed = [&](const Interval& c, const Interval& s, const Interval& w) {
    return Homogeneous{cx * w + ux * c + vx * s, cy * w + uy * c + vy * s, w};
  };
  const int count = std::max(1, int(std::ceil(std::abs(sweep) / (std::numbers::pi / 2) - 0.001)));
  for (int k = 0; k < count; ++k) {
    const UnitVector a = unit_vector(first + sweep * k / count), b = unit_vector(first + sweep * (k + 1) / count);
    // The tangents meet at (a + b) / (1 + a.b), and the weight there is the cosine of half the angle.
    const Interval w = exact::sqrt((kOne + a.c * b.c + a.s * b.s) / Interval{2, 2}), twice = w + w;
    curve.pieces.push_back(piece_of(
        {placed(a.c, a.s, kOne), placed((a.c + b.c) / twice, (a.s + b.s) / twice, w), placed(b.c, b.s, kOne)}, true));
  }
  pin_ends(curve);
  return curve;
}

void check_spline(const Spline& s) {
  check_degree(s.degree);
  check_weights(s.weights, s.points.size());
  if (s.points.size() <= s.degree)
    throw Error(ErrorCode::kBadValue,
                fmt::format("{} control points are too few for degree {}", s.points.size(), s.degree));
  if (s.knots.size() != s.points.size() + s.degree + 1)
    throw Error(ErrorCode::kBadValue,
                fmt::format("{} knots for {} control points of degree {}; {} are needed", s.knots.size(),
                            s.points.size(), s.degree, s.points.size() + s.degree + 1));
  if (!std::is_sorted(s.knots.begin(), s.knots.end())) throw Error(ErrorCode::kBadValue, "knots must ascend");
  if (spans_of(s).empty()) throw Error(ErrorCode::kBadValue, "all knots are equal");
  check_unbroken(s);
}

CurvePoint spline_end(const Spline& s, bool last) {
  const std::vector<std::size_t> spans = spans_of(s);
  const std::size_t span = last ? spans.back() : spans.front();
  std::vector<RealHomogeneous> d;
  for (std::size_t i = span - s.degree; i <= span; ++i) {
    const Real w = s.weights.empty() ? Real(1) : s.weights[i];
    d.push_back({s.points[i].x * w, s.points[i].y * w, w});
  }
  const std::vector<Real> arguments(s.degree, s.knots[last ? span + 1 : span]);
  const RealHomogeneous p = blossom(s.knots, std::move(d), s.degree, span, arguments);
  return {p.x / p.w, p.y / p.w};
}

Curve spline_curve(const Spline& s, GridPoint from, GridPoint to) {
  std::vector<Interval> knots;
  for (const Real& t : s.knots) knots.push_back((t - s.knots.front()).interval());
  const std::vector<Homogeneous> points = homogeneous(s.points, s.weights, from);
  Curve curve{from, to, {}};
  for (const std::size_t span : spans_of(s)) {
    const std::vector<Homogeneous> d(points.begin() + std::ptrdiff_t(span - s.degree),
                                     points.begin() + std::ptrdiff_t(span + 1));
    std::vector<Homogeneous> bezier;
    for (std::size_t k = 0; k <= s.degree; ++k) {
      std::vector<Interval> arguments(s.degree, knots[span]);
      std::fill_n(arguments.begin(), k, knots[span + 1]);
      bezier.push_back(blossom(knots, d, s.degree, span, arguments));
    }
    curve.pieces.push_back(piece_of(bezier, !s.weights.empty()));
  }
  pin_ends(curve);
  return curve;
}

Curve with_ends(Curve curve, GridPoint from, GridPoint to) {
  shift(curve, curve.from, from);
  curve.from = from;
  curve.to = to;
  pin_ends(curve);
  return curve;
}

Curve reversed(const Curve& curve) {
  Curve out = curve;
  std::reverse(out.pieces.begin(), out.pieces.end());
  for (CurvePiece& piece : out.pieces)
    for (IntervalPolynomial* c : {&piece.x, &piece.y, &piece.w}) std::reverse(c->begin(), c->end());
  return with_ends(std::move(out), curve.to, curve.from);
}

}  // namespace findspace::plane
