// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "exact/planar/geometry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "exact/number/primitive.h"
#include "exact/planar/geometry_stages.h"
#include "exact/planar/parallel_line.h"

namespace findspace::exact {
namespace {

using ApproxPoint = std::array<Approx, 2>;

/// A narrow grid line whose crossings with others like it are made of products of 64-bit integers.
bool is_short(const SupportingCurve& l) {
  constexpr std::int64_t kNormal = std::int64_t(1) << 42;
  return l.c == std::int64_t(l.c) && l.grid && !l.circle && l.a < kNormal && l.b < kNormal && l.b > -kNormal;
}

/// By a divisor other than 0; a quotient of 0 has no sign.
Approx quotient(int128 dividend, const Approx& divisor) {
  const Approx q = from_int(dividend) / divisor;
  return {q.value + 0.0, q.error};
}

ApproxPoint approx_crossing_of_lines(const SupportingCurve& s, const SupportingCurve& t) {
  if (is_short(s) && is_short(t)) {
    const std::int64_t c = std::int64_t(s.c), d = std::int64_t(t.c);
    const Approx det = from_int(cross(s, t));
    return {quotient(int128(c) * t.b - int128(d) * s.b, det), quotient(int128(d) * s.a - int128(c) * t.a, det)};
  }
  if (is_narrow(s) && is_narrow(t)) {
    NarrowPoint e = narrow_crossing(s, t);
    Approx det = from_int(e.weight);
    return {from_int(e.x) / det, from_int(e.y) / det};
  }
  Approx det = from_int(cross(s, t)), c1 = line_offset(s), c2 = line_offset(t);
  return {(c1 * from_int(t.b) - c2 * from_int(s.b)) / det, (from_int(s.a) * c2 - from_int(t.a) * c1) / det};
}

ApproxPoint approx_crossing_of_line(const SupportingCurve& line, const SupportingCurve& circle, int root) {
  Approx h = line.x() * circle.x() + line.y() * circle.y() - line.z();
  if (root == 0 && h.sign() != 0) {  // the line touches the circle: |h| is the radius
    Approx r = h.sign() > 0 ? circle.z() : -circle.z();
    return {circle.x() - r * line.x(), circle.y() - r * line.y()};
  }
  Approx half = Approx{double(root), 0} * sqrt((circle.z() - h) * (circle.z() + h));
  return {circle.x() - h * line.x() + half * line.y(), circle.y() - h * line.y() - half * line.x()};
}

ApproxPoint approx_crossing_of_circles(const SupportingCurve& s, const SupportingCurve& t, int root) {
  Approx dx = t.x() - s.x(), dy = t.y() - s.y(), l2 = dx * dx + dy * dy;
  Approx k = (l2 + (s.z() - t.z()) * (s.z() + t.z())) / (l2 + l2);
  Approx half = Approx{double(root), 0} * sqrt(s.z() * s.z() / l2 - k * k);
  return {s.x() + dx * k + dy * half, s.y() + dy * k - dx * half};
}

ApproxPoint approx_crossing(const Geometry& g, const Point& p) {
  const SupportingCurve* s = &g.supporting_curves[p.i];
  const SupportingCurve* t = &g.supporting_curves[p.j];
  if (s->circle && !t->circle) std::swap(s, t);
  if (!t->circle) return approx_crossing_of_lines(*s, *t);
  if (!s->circle) return approx_crossing_of_line(*s, *t, p.root);
  return approx_crossing_of_circles(*s, *t, p.root);
}

void set_approx(Point& p, const ApproxPoint& at) {
  p.x = at[0].value;
  p.y = at[1].value;
  p.error = std::max(at[0].error, at[1].error);
}

/// Both coordinates, or one alone: that costs less, and along an axis no root.
enum class Wanted : std::uint8_t { kBoth, kX, kY };

/// Of two curves, an upright line, or a level one: its offset is the one x, or y, of its points.
const SupportingCurve* line_across(const SupportingCurve& s, const SupportingCurve& t, bool upright) {
  for (const SupportingCurve* k : {&s, &t})
    if (!k->circle && (upright ? k->b == 0 : k->a == 0)) return k;
  return nullptr;
}

RealPoint exact_crossing(const Geometry& g, const Point& p, Wanted wanted = Wanted::kBoth) {
  const bool with_x = wanted != Wanted::kY, with_y = wanted != Wanted::kX;
  const SupportingCurve* s = &g.supporting_curves[p.i];
  const SupportingCurve* t = &g.supporting_curves[p.j];
  if (wanted != Wanted::kBoth)
    if (const SupportingCurve* line = line_across(*s, *t, with_x)) return {line->offset(), line->offset()};
  if (s->circle && !t->circle) std::swap(s, t);
  if (!t->circle) {
    Real det(cross(*s, *t)), c1 = s->offset(), c2 = t->offset();
    return {with_x ? (c1 * Real(t->b) - c2 * Real(s->b)) / det : Real(),
            with_y ? (Real(s->a) * c2 - Real(t->a) * c1) / det : Real()};
  }
  if (!s->circle) {
    Real a(s->a), b(s->b), n2(int128(s->a) * s->a + int128(s->b) * s->b);
    Real h = a * t->center_x() + b * t->center_y() - s->offset();
    const bool rooted = p.root != 0 && ((with_x && s->b != 0) || (with_y && s->a != 0));
    Real half = rooted ? Real(int(p.root)) * sqrt(crossing_discriminant(*s, *t)) : Real();
    return {with_x ? t->center_x() + (b * half - a * h) / n2 : Real(),
            with_y ? t->center_y() - (a * half + b * h) / n2 : Real()};
  }
  Real dx = t->center_x() - s->center_x(), dy = t->center_y() - s->center_y(), l2 = dx * dx + dy * dy;
  Real r2 = s->w() * s->w(), k = (l2 + r2 - t->w() * t->w()) / Real(2);
  const auto counts = [](const Real& d) { return !d.is_rational() || d.sign() != 0; };
  const bool rooted = p.root != 0 && ((with_x && with_y) || counts(with_x ? dy : dx));
  Real half = rooted ? Real(int(p.root)) * sqrt(r2 * l2 - k * k) : Real();
  return {with_x ? s->center_x() + (dx * k + dy * half) / l2 : Real(),
          with_y ? s->center_y() + (dy * k - dx * half) / l2 : Real()};
}

/// Whether searches may go by the numbers alone: what they compare exactly differs by 2^-43 of the sizes or so.
bool is_known(const ApproxPoint& at) {
  constexpr double kKnown = 0x1p-43;
  return at[0].error + at[1].error <= kKnown * (std::abs(at[0].value) + std::abs(at[1].value));
}

/// Of curves that nearly coincide, whose crossing numbers tell little of; of circles about centres that they do not
/// tell apart nothing.
ApproxPoint rounded(const RealPoint& p) {
  const ApproxPoint near{from_real(p.x), from_real(p.y)};
  if (is_known(near)) return near;
  const auto digits = [](const Real& r) {
    const double v = r.to_double();
    return Approx{v, std::abs(v) * (4 * Approx::kUnit) + Approx::kTiny};
  };
  return {digits(p.x), digits(p.y)};
}

}  // namespace

Real exact_coordinate(const Geometry& g, const Point& p, bool x_axis) {
  if (p.kind == Point::Kind::kGrid) return Real(x_axis ? p.gx : p.gy);
  if (p.kind == Point::Kind::kReal) return x_axis ? g.reals[p.i].x : g.reals[p.i].y;
  const RealPoint at = exact_crossing(g, p, x_axis ? Wanted::kX : Wanted::kY);
  return x_axis ? at.x : at.y;
}

std::uint32_t Geometry::add_line(std::int64_t a, std::int64_t b, int128 c) {
  supporting_curves.emplace_back(a, b, c, grid_line_filter(a, b, c));
  return std::uint32_t(supporting_curves.size() - 1);
}

void Geometry::add_lines(std::uint32_t first, std::uint32_t count, std::uint32_t next) {
  std::array<Normal, 24> normals;
  for (const Point *p = &points[first], *last = p + count - 1; count > 0;) {
    const std::uint32_t some = std::min(count, std::uint32_t(normals.size()));
    for (std::uint32_t k = 0; k < some; ++k) {
      const Point& q = p + k == last ? points[next] : p[k + 1];
      normals[k] = {q.gy - p[k].gy, p[k].gx - q.gx};
    }
    make_primitive({normals.data(), some});
    for (std::uint32_t k = 0; k < some; ++k, ++p) {
      const auto [a, b] = normals[k];
      const int128 c = int128(a) * p->gx + int128(b) * p->gy;
      supporting_curves.emplace_back(a, b, c, grid_line_filter(a, b, c));
    }
    count -= some;
  }
}

std::uint32_t Geometry::add_parallel(const SupportingCurve& line, std::int64_t x, std::int64_t y) {
  return add(parallel_line(line, x, y));
}

std::uint32_t Geometry::add_real_point(const Real& x, const Real& y) {
  auto ix = x.integer(), iy = y.integer();
  if (fits(ix) && fits(iy)) return add_grid_point(std::int64_t(*ix), std::int64_t(*iy));
  Point p;
  p.kind = Point::Kind::kReal;
  p.i = std::uint32_t(reals.size());
  p.j = 0;
  set_approx(p, {from_real(x), from_real(y)});
  reals.push_back({x, y});
  points.push_back(p);
  return std::uint32_t(points.size() - 1);
}

Point Geometry::crossing(std::uint32_t i, std::uint32_t j, int root) const {
  Point p;
  p.kind = Point::Kind::kCross;
  // The root is defined for the order (line, circle), and for two circles for the order given by the smaller index.
  if (j < i) {
    if (supporting_curves[i].circle && supporting_curves[j].circle) root = -root;
    std::swap(i, j);
  }
  p.i = i;
  p.j = j;
  p.root = std::int8_t(root);
  const ApproxPoint near = approx_crossing(*this, p);
  set_approx(p, is_known(near) ? near : rounded(exact_crossing(*this, p)));
  return p;
}

std::uint32_t Geometry::add_crossing(std::uint32_t i, std::uint32_t j, int root) {
  points.push_back(crossing(i, j, root));
  return std::uint32_t(points.size() - 1);
}

RealPoint Geometry::exact(std::uint32_t p) const {
  const Point& q = points[p];
  if (q.kind == Point::Kind::kGrid) return {Real(q.gx), Real(q.gy)};
  if (q.kind == Point::Kind::kReal) return reals[q.i];
  return exact_crossing(*this, q);
}

}  // namespace findspace::exact
