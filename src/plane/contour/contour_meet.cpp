// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Segments meet segments by integer signs alone. With arcs, the same formulas run first over double intervals and, if
// a sign stays open there, over exact reals: `Solver<N>` is written once for both number types. A point of a circle
// lies on an arc of it exactly when it is not to the left of the chord first -> last, whatever the arc's angle.
#include "plane/contour/contour_meet.h"

#include <array>
#include <utility>

#include "exact/number/interval.h"

namespace findspace::plane {
namespace {

using exact::Interval;
using exact::Real;

int sign(int128 v) { return v > 0 ? 1 : v < 0 ? -1 : 0; }
int128 dot(GridPoint o, GridPoint a, GridPoint b) {
  return int128(a.x - o.x) * (b.x - o.x) + int128(a.y - o.y) * (b.y - o.y);
}
CommonPoint at(GridPoint p, bool along = false) { return {double(p.x), double(p.y), along}; }

/// p on the closed segment, given that it is on its line.
bool between(GridPoint p, const Span& s) { return dot(p, s.from, s.to) <= 0; }

std::optional<CommonPoint> collinear(const Span& f, const Span& g) {
  bool along = f.from != g.from && f.from != g.to && f.to != g.from && f.to != g.to;
  for (GridPoint p : {g.from, g.to}) {
    if (between(p, f)) return at(p, along || (between(g.from, f) && between(g.to, f)));
  }
  for (GridPoint p : {f.from, f.to}) {
    if (between(p, g)) return at(p, true);
  }
  return std::nullopt;
}

std::optional<CommonPoint> segments(const Span& f, const Span& g) {
  int128 a = cross(f.from, f.to, g.from), b = cross(f.from, f.to, g.to);
  if (sign(a) * sign(b) > 0) return std::nullopt;
  if (a == 0 && b == 0) return collinear(f, g);
  int128 c = cross(g.from, g.to, f.from), d = cross(g.from, g.to, f.to);
  if (sign(c) * sign(d) > 0) return std::nullopt;
  for (GridPoint p : {g.from, g.to}) {
    if (cross(f.from, f.to, p) == 0 && between(p, f)) return at(p);
  }
  if (c == 0) return at(f.from);
  if (d == 0) return at(f.to);
  double t = double(c) / (double(c) - double(d));
  return CommonPoint{double(f.from.x) + t * double(f.to.x - f.from.x),
                     double(f.from.y) + t * double(f.to.y - f.from.y)};
}

/// Two segments that share the vertex v as neighbours: only folding back onto each other is a fault.
std::optional<CommonPoint> joined_segments(const Span& f, const Span& g, GridPoint v) {
  GridPoint p = f.from == v ? f.to : f.from, q = g.from == v ? g.to : g.from;
  if (cross(v, p, q) != 0 || dot(v, p, q) < 0) return std::nullopt;
  return at(dot(v, p, p) < dot(v, q, q) ? p : q, true);
}

Interval number(const Real& v, const Interval*) { return v.interval(); }
Interval number(int128 v, const Interval*) { return exact::enclose(v); }
const Real& number(const Real& v, const Real*) { return v; }
Real number(int128 v, const Real*) { return Real(v); }
double middle(const Interval& v) { return (v.lo + v.hi) / 2; }
double middle(const Real& v) { return v.to_double(); }

template <class N>
class Solver {
 public:
  /// A sign stayed open: the answer means nothing.
  bool open = false;

  std::optional<CommonPoint> segment_arc(const Span& s, const Span& arc, const GridPoint* joined);
  std::optional<CommonPoint> arc_arc(const Span& f, const Span& g, const GridPoint* joined);

 private:
  struct Vector {
    N x, y;
  };
  struct Circle {
    Vector center;  // relative to `origin_`
    N r2;
  };

  static N make(int128 v) { return N(number(v, static_cast<const N*>(nullptr))); }
  static N make(const Real& v) { return N(number(v, static_cast<const N*>(nullptr))); }
  Vector relative(GridPoint p) const { return {make(int128(p.x - origin_.x)), make(int128(p.y - origin_.y))}; }
  Circle circle(const Span& s) const {
    N r = make(s.arc->r);
    return {{make(s.arc->cx) - make(origin_.x), make(s.arc->cy) - make(origin_.y)}, r * r};
  }
  static N cross(const Vector& a, const Vector& b) { return a.x * b.y - a.y * b.x; }
  static N dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y; }
  int sign(const N& v) {
    if constexpr (std::is_same_v<N, Interval>) {
      int s = exact::certain_sign(v);
      if (s == 0) open = true;
      return s;
    } else {
      return v.sign();
    }
  }
  /// Whether the point p / scale of the arc's circle (scale > 0) lies on the arc.
  bool on_arc(const Vector& p, const N& scale, const Span& arc) {
    Vector first = relative(arc.first()), last = relative(arc.last());
    Vector chord{last.x - first.x, last.y - first.y};
    return sign(cross(chord, {p.x - first.x * scale, p.y - first.y * scale})) <= 0;
  }
  CommonPoint meeting(const Vector& p, const N& scale) const {
    double d = middle(scale);
    return {middle(p.x) / d + double(origin_.x), middle(p.y) / d + double(origin_.y)};
  }
  std::optional<CommonPoint> joined_arcs(const Circle& c, const Vector& dc, const N& d2, const N& along, const Span& f,
                                         const Span& g, GridPoint v);

  GridPoint origin_;
};

template <class N>
std::optional<CommonPoint> Solver<N>::segment_arc(const Span& s, const Span& arc, const GridPoint* joined) {
  GridPoint from = joined && *joined == s.to ? s.to : s.from, to = from == s.from ? s.to : s.from;
  origin_ = from;
  Vector d = relative(to);
  Circle c = circle(arc);
  // |t d - c|^2 = r^2, that is  a t^2 - 2 b t + k = 0, for t = num / a in [0, 1].
  N a = dot(d, d), b = dot(d, c.center);
  auto found = [&](const N& num, bool strict) -> std::optional<CommonPoint> {
    int low = sign(num);
    if (low < 0 || (strict && low == 0) || sign(a - num) < 0) return std::nullopt;
    Vector p{d.x * num, d.y * num};
    if (!on_arc(p, a, arc)) return std::nullopt;
    return meeting(p, a);
  };
  if (joined) return found(b + b, true);  // one root is t = 0, the sum of both is 2b/a
  N k = dot(c.center, c.center) - c.r2;
  N discriminant = b * b - a * k;
  int kind = sign(discriminant);
  if (kind < 0 || open) return std::nullopt;
  N root = sqrt(discriminant);
  if (auto m = found(b - root, false)) return m;
  return kind == 0 ? std::nullopt : found(b + root, false);
}

template <class N>
std::optional<CommonPoint> Solver<N>::joined_arcs(const Circle& c, const Vector& dc, const N& d2, const N& along,
                                                  const Span& f, const Span& g, GridPoint v) {
  // The other common point is v mirrored in the line of the centres; times d2 all is polynomial.
  Vector w = relative(v);
  if (sign(cross(dc, {w.x - c.center.x, w.y - c.center.y})) == 0) return std::nullopt;  // tangent there
  Vector p{(c.center.x + c.center.x - w.x) * d2 + along * dc.x, (c.center.y + c.center.y - w.y) * d2 + along * dc.y};
  if (!on_arc(p, d2, f) || !on_arc(p, d2, g)) return std::nullopt;
  return meeting(p, d2);
}

template <class N>
std::optional<CommonPoint> Solver<N>::arc_arc(const Span& f, const Span& g, const GridPoint* joined) {
  origin_ = f.from;
  Circle c = circle(f), e = circle(g);
  Vector dc{e.center.x - c.center.x, e.center.y - c.center.y};
  N d2 = dot(dc, dc);
  N along = d2 + c.r2 - e.r2;
  if (joined) return joined_arcs(c, dc, d2, along, f, g, *joined);
  N twice = d2 + d2;
  N square = (twice + twice) * c.r2 - along * along;
  int kind = sign(square);
  if (kind < 0 || open) return std::nullopt;
  N root = sqrt(square);
  Vector projection{c.center.x * twice + along * dc.x, c.center.y * twice + along * dc.y};
  for (int side : {1, -1}) {
    if (kind == 0 && side < 0) break;
    Vector p = side > 0 ? Vector{projection.x - root * dc.y, projection.y + root * dc.x}
                        : Vector{projection.x + root * dc.y, projection.y - root * dc.x};
    if (on_arc(p, twice, f) && on_arc(p, twice, g)) return meeting(p, twice);
  }
  return std::nullopt;
}

/// Grid point p of the arc's circle: whether it lies on the arc.
bool holds(const Span& arc, GridPoint p) { return cross(arc.first(), arc.last(), p) <= 0; }

std::optional<CommonPoint> same_circle(const Span& f, const Span& g, const GridPoint* joined, bool both) {
  if (both) return f.first() == g.first() ? std::optional(at(f.first(), true)) : std::nullopt;
  auto is_joint = [&](GridPoint p) { return joined && p == *joined; };
  for (GridPoint p : {g.from, g.to}) {
    if (!is_joint(p) && holds(f, p)) return at(p, p != f.from && p != f.to);
  }
  for (GridPoint p : {f.from, f.to}) {
    if (!is_joint(p) && holds(g, p)) return at(p, p != g.from && p != g.to);
  }
  return std::nullopt;
}

bool concentric(const Span& f, const Span& g) {
  return compare(f.arc->cx, g.arc->cx) == 0 && compare(f.arc->cy, g.arc->cy) == 0;
}

/// No end of the segment is on the arc's side of its chord, and not both are on the chord's line.
bool segment_behind(const Span& s, const Span& arc) {
  return cross(arc.first(), arc.last(), s.from) > 0 && cross(arc.first(), arc.last(), s.to) > 0;
}

template <class Question>
std::optional<CommonPoint> staged(Question ask) {
  Solver<Interval> fast;
  std::optional<CommonPoint> answer = ask(fast);
  if (!fast.open) return answer;
  Solver<Real> exact;
  return ask(exact);
}

}  // namespace

std::optional<CommonPoint> meet(const Span& f, const Span& g, const GridPoint* joined, bool both) {
  if (!f.arc && !g.arc) {
    if (both) return at(f.from, true);
    return joined ? joined_segments(f, g, *joined) : segments(f, g);
  }
  if (f.arc && g.arc) {
    if (concentric(f, g)) {
      if (compare(f.arc->r, g.arc->r) != 0) return std::nullopt;
      return same_circle(f, g, joined, both);
    }
    if (both) return std::nullopt;
    return staged([&](auto& solver) { return solver.arc_arc(f, g, joined); });
  }
  if (both) return std::nullopt;
  const Span& segment = f.arc ? g : f;
  const Span& arc = f.arc ? f : g;
  if (segment_behind(segment, arc)) return std::nullopt;
  return staged([&](auto& solver) { return solver.segment_arc(segment, arc, joined); });
}

}  // namespace findspace::plane
