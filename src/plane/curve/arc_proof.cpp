// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "plane/curve/arc_proof.h"

#include <cmath>

namespace findspace::plane {
namespace {

using exact::certain_sign;
using exact::Interval;
using exact::Real;

constexpr int kMostHalvings = 6;
constexpr Interval kUnit{1, 1}, kHalf{0.5, 0.5};

struct Vector {
  Interval x, y;
};
Interval dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y; }
Interval cross(const Vector& a, const Vector& b) { return a.x * b.y - a.y * b.x; }
Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y}; }

Vector between(GridPoint from, GridPoint to) { return {exact::enclose(to.x - from.x), exact::enclose(to.y - from.y)}; }

Interval hull(const Interval& a, const Interval& b) { return {std::min(a.lo, b.lo), std::max(a.hi, b.hi)}; }

const Interval& weight(const CurvePiece& piece, std::size_t i) { return piece.w.empty() ? kUnit : piece.w[i]; }

/// The circle or line of an edge: e(p) = p.m - k |p|^2 / 2 about its first point, m the left normal there, k the signed
/// curvature. The distance to the left of the circle is 2 e / (1 + sqrt(1 - 2 k e)).
struct CurveEquation {
  Vector m;
  Interval k{};

  Vector normal_at(const Vector& p) const { return {m.x - k * p.x, m.y - k * p.y}; }
};

CurveEquation equation_of(const ContourEdge& edge, GridPoint to) {
  if (!edge.arc) {
    const Vector chord = between(edge.start, to);
    const Interval length = exact::sqrt(dot(chord, chord));
    return {{-chord.y / length, chord.x / length}, {}};
  }
  const Interval r = edge.arc->r.interval();
  Vector m{(edge.arc->cx - Real(edge.start.x)).interval() / r, (edge.arc->cy - Real(edge.start.y)).interval() / r};
  const Interval k = kUnit / r;
  if (edge.ccw) return {m, k};
  return {{-m.x, -m.y}, -k};
}

/// The value of e at which the distance is `d`.
Interval value_at(const CurveEquation& c, double d) {
  const Interval at{d, d};
  return at - c.k * at * at * kHalf;
}

class Proof {
 public:
  explicit Proof(const ArcClaim& claim)
      : claim_(claim),
        origin_(between(claim.origin, claim.edge.start)),
        chord_(between(claim.edge.start, claim.to)),
        equation_(equation_of(claim.edge, claim.to)) {}

  bool run() {
    const std::vector<CurvePiece>& stretch = *claim_.stretch;
    first_ = Vector{} - point(stretch.front(), 0);
    last_ = chord_ - point(stretch.back(), stretch.back().degree());
    if (!ends_fit()) return false;
    for (std::size_t i = 0; i < stretch.size(); ++i) {
      const bool first = i == 0 && claim_.meets_first, last = i + 1 == stretch.size() && claim_.meets_last;
      if (!holds(stretch[i], first, last, 0)) return false;
    }
    return true;
  }

 private:
  /// A control point, from the start of the edge.
  Vector point(const CurvePiece& piece, std::size_t i) const {
    const Interval& w = weight(piece, i);
    return Vector{piece.x[i] / w, piece.y[i] / w} - origin_;
  }

  bool sided() const { return claim_.side != CurveSide::kNear; }
  Interval towards_side(const Interval& v) const { return claim_.side == CurveSide::kLeft ? v : -v; }

  /// J at both ends, and the window.
  bool ends_fit() {
    const Interval d2 = dot(chord_, chord_), j0 = dot(first_, first_), j1 = dot(last_, last_);
    if (certain_sign(d2) <= 0) return false;
    if (!sided()) {
      // One step each way at most, which costs less than four steps of the bound.
      const double window = claim_.bound - 4;
      if (!(window > 0) || !(j0.hi <= 2) || !(j1.hi <= 2)) return false;
      return set_window(-window, window);
    }
    const double window = claim_.bound * kWindowPart;
    const bool left = claim_.side == CurveSide::kLeft;
    if (!set_window(left ? -window : 0, left ? 0 : window)) return false;
    if (!(exact::sqrt(d2).lo > exact::sqrt(j0).hi + exact::sqrt(j1).hi)) return false;
    return (claim_.meets_first || step_fits(first_, equation_.m)) &&
           (claim_.meets_last || step_fits(last_, equation_.normal_at(chord_)));
  }

  bool set_window(double low, double high) {
    const Interval most = Interval{2, 2} * equation_.k * Interval{claim_.bound, claim_.bound};
    if (!(most.hi < 1 && most.lo > -1)) return false;
    lowest_ = {low == 0 ? 0 : value_at(equation_, low).hi, 0};
    highest_ = {high == 0 ? 0 : value_at(equation_, high).lo, 0};
    lowest_.hi = lowest_.lo;
    highest_.hi = highest_.lo;
    return true;
  }

  /// J points to the side, and hardly along the circle: less than (1 - kWindowPart) of the bound once it is projected.
  bool step_fits(const Vector& j, const Vector& normal) const {
    if (!(towards_side(dot(normal, j)).lo >= 0)) return false;
    const Interval along = cross(normal, j);
    const double k = std::max(std::abs(equation_.k.lo), std::abs(equation_.k.hi));
    const double most = claim_.bound * (1 - kWindowPart) / 2 * (1 - k * claim_.bound);
    return std::max(std::abs(along.lo), std::abs(along.hi)) <= most;
  }

  /// Halves where the coefficients do not decide; false where an end fails.
  bool holds(const CurvePiece& piece, bool first, bool last, int depth) const {
    if (in_window(piece, first, last) && runs_forward(piece)) return true;
    if (depth == kMostHalvings || outside_at_an_end(piece, first, last)) return false;
    return holds(part_of(piece, 0, 0.5), first, false, depth + 1) &&
           holds(part_of(piece, 0.5, 1), false, last, depth + 1);
  }

  /// Coefficients of e w^2 and of w^2.
  void values(const CurvePiece& piece, IntervalPolynomial& e, IntervalPolynomial& w2) const {
    IntervalPolynomial x, y, w;
    for (std::size_t i = 0; i < piece.x.size(); ++i) {
      w.push_back(weight(piece, i));
      x.push_back(piece.x[i] - origin_.x * w[i]);
      y.push_back(piece.y[i] - origin_.y * w[i]);
    }
    const IntervalPolynomial m = sum(scaled(x, equation_.m.x), scaled(y, equation_.m.y));
    e = difference(product(m, w), scaled(sum(product(x, x), product(y, y)), equation_.k * kHalf));
    w2 = product(w, w);
  }

  bool in_window(const CurvePiece& piece, bool first, bool last) const {
    IntervalPolynomial e, w2;
    values(piece, e, w2);
    for (std::size_t i = 0; i < e.size(); ++i) {
      if ((i == 0 && first) || (i + 1 == e.size() && last)) continue;  // e is 0 there
      if (!((e[i] - lowest_ * w2[i]).lo >= 0) || !((highest_ * w2[i] - e[i]).lo >= 0)) return false;
    }
    return true;
  }

  bool outside_at_an_end(const CurvePiece& piece, bool first, bool last) const {
    auto outside = [&](std::size_t i) {
      const Vector p = point(piece, i);
      const Interval e = dot(p, equation_.m) - equation_.k * kHalf * dot(p, p);
      return (e - lowest_).hi < 0 || (highest_ - e).hi < 0;
    };
    return (!first && outside(0)) || (!last && outside(piece.degree()));
  }

  /// The derivative has a part along the chord, along the circle and, where J is, across it.
  bool runs_forward(const CurvePiece& piece) const {
    Vector box = point(piece, 0);
    for (std::size_t i = 1; i < piece.x.size(); ++i) {
      const Vector p = point(piece, i);
      box = {hull(box.x, p.x), hull(box.y, p.y)};
    }
    const Vector normal = equation_.normal_at(box), along{normal.y, -normal.x};
    IntervalPolynomial dx = hodograph(piece.x), dy = hodograph(piece.y);
    if (!piece.w.empty()) {
      const IntervalPolynomial dw = hodograph(piece.w);
      dx = difference(product(dx, piece.w), product(dw, piece.x));
      dy = difference(product(dy, piece.w), product(dw, piece.y));
    }
    for (std::size_t i = 0; i < dx.size(); ++i) {
      const Vector d{dx[i], dy[i]};
      if (certain_sign(dot(d, chord_)) <= 0 || certain_sign(dot(d, along)) <= 0) return false;
      if (!sided()) continue;
      if (!claim_.meets_first && certain_sign(towards_side(cross(d, first_))) <= 0) return false;
      if (!claim_.meets_last && certain_sign(towards_side(cross(d, last_))) <= 0) return false;
    }
    return true;
  }

  const ArcClaim& claim_;
  Vector origin_, chord_;
  CurveEquation equation_;
  Vector first_{}, last_{};        // J
  Interval lowest_{}, highest_{};  // of e
};

}  // namespace

bool proved(const ArcClaim& claim) { return Proof(claim).run(); }

double StretchBox::diameter() const {
  const Vector d = Vector{{x1, x1}, {y1, y1}} - Vector{{x0, x0}, {y0, y0}};
  return exact::sqrt(dot(d, d)).hi;
}

StretchBox box_of(const std::vector<CurvePiece>& stretch, GridPoint origin, GridPoint a, GridPoint b) {
  StretchBox box{double(a.x - origin.x), double(a.y - origin.y), double(a.x - origin.x), double(a.y - origin.y)};
  auto add = [&](const Interval& x, const Interval& y) {
    box = {std::min(box.x0, x.lo), std::min(box.y0, y.lo), std::max(box.x1, x.hi), std::max(box.y1, y.hi)};
  };
  const Vector end = between(origin, b);
  add(end.x, end.y);
  for (const CurvePiece& piece : stretch)
    for (std::size_t i = 0; i < piece.x.size(); ++i) add(piece.x[i] / weight(piece, i), piece.y[i] / weight(piece, i));
  return {std::floor(box.x0), std::floor(box.y0), std::ceil(box.x1), std::ceil(box.y1)};
}

CurvePiece part_of(const CurvePiece& piece, double t0, double t1) {
  auto part = [&](const IntervalPolynomial& a) {
    if (a.empty()) return a;
    IntervalPolynomial left = t1 < 1 ? split(a, {t1, t1}).first : a;
    return t0 > 0 ? split(std::move(left), Interval{t0, t0} / Interval{t1, t1}).second : left;
  };
  return {part(piece.x), part(piece.y), part(piece.w)};
}

}  // namespace findspace::plane
