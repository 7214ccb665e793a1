// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "exact/planar/geometry.h"

#include <algorithm>

#include "exact/planar/geometry_stages.h"

namespace findspace::exact {
namespace {

/// Squared radius times squared normal length minus squared unscaled distance: > 0 when line and circle cross.
Real crossing_discriminant(const SupportingCurve& line, const SupportingCurve& circle) {
  Real n2 = Real(int128(line.a) * line.a + int128(line.b) * line.b);
  Real h = Real(line.a) * circle.center_x() + Real(line.b) * circle.center_y() - line.offset();
  return circle.w * circle.w * n2 - h * h;
}

}  // namespace

std::uint32_t Geometry::add_line(std::int64_t a, std::int64_t b, int128 c) {
  SupportingCurve& l = supporting_curves.emplace_back();
  l.a = a;
  l.b = b;
  l.c = c;
  set_line_filter(l);
  return std::uint32_t(supporting_curves.size() - 1);
}

std::uint32_t Geometry::add_parallel(const SupportingCurve& line, std::int64_t x, std::int64_t y) {
  SupportingCurve& l = supporting_curves.emplace_back();
  l.a = line.a;
  l.b = line.b;
  l.x = line.x;
  l.y = line.y;
  l.c = int128(l.a) * x + int128(l.b) * y;
  set_distance_through(l, x, y);
  return std::uint32_t(supporting_curves.size() - 1);
}

std::uint32_t Geometry::add_displaced(const SupportingCurve& line, const Real& shift) {
  if (integer_length(line.a, line.b)) return add(SupportingCurve::displaced_line(line.a, line.b, line.c, shift));
  SupportingCurve& l = supporting_curves.emplace_back();
  l.grid = false;
  l.a = line.a;
  l.b = line.b;
  l.c = line.c;
  l.w = shift;
  l.x = line.x;
  l.y = line.y;
  l.z = line.z + from_real(shift);
  return std::uint32_t(supporting_curves.size() - 1);
}

std::uint32_t Geometry::add_grid_point(std::int64_t x, std::int64_t y) {
  Point& p = points.emplace_back();
  p.gx = x;
  p.gy = y;
  p.x = double(x);
  p.y = double(y);
  return std::uint32_t(points.size() - 1);
}

std::uint32_t Geometry::add_real_point(const Real& x, const Real& y) {
  auto ix = x.integer(), iy = y.integer();
  if (fits(ix) && fits(iy)) return add_grid_point(std::int64_t(*ix), std::int64_t(*iy));
  Point p;
  p.kind = Point::Kind::kReal;
  p.i = std::uint32_t(reals.size());
  reals.push_back({x, y});
  set_approx(p);
  points.push_back(p);
  return std::uint32_t(points.size() - 1);
}

std::uint32_t Geometry::add_crossing(std::uint32_t i, std::uint32_t j, int root) {
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
  set_approx(p);
  points.push_back(p);
  return std::uint32_t(points.size() - 1);
}

void Geometry::set_approx(Point& p) const {
  Approx x, y;
  if (p.kind == Point::Kind::kReal) {
    x = from_real(reals[p.i].x);
    y = from_real(reals[p.i].y);
  } else {
    const SupportingCurve* s = &supporting_curves[p.i];
    const SupportingCurve* t = &supporting_curves[p.j];
    if (s->circle && !t->circle) std::swap(s, t);
    Approx root{double(p.root), 0};
    if (!t->circle && is_narrow(*s) && is_narrow(*t)) {
      NarrowPoint e = narrow_crossing(*s, *t);
      Approx det = from_int(e.weight);
      x = from_int(e.x) / det;
      y = from_int(e.y) / det;
    } else if (!t->circle) {
      Approx det = from_int(cross(*s, *t)), c1 = line_offset(*s), c2 = line_offset(*t);
      x = (c1 * from_int(t->b) - c2 * from_int(s->b)) / det;
      y = (from_int(s->a) * c2 - from_int(t->a) * c1) / det;
    } else if (!s->circle) {
      Approx h = s->x * t->x + s->y * t->y - s->z;
      if (p.root == 0 && h.sign() != 0) {  // the line touches the circle: |h| is the radius
        Approx r = h.sign() > 0 ? t->z : -t->z;
        x = t->x - r * s->x;
        y = t->y - r * s->y;
      } else {
        Approx half = root * sqrt((t->z - h) * (t->z + h));
        x = t->x - h * s->x + half * s->y;
        y = t->y - h * s->y - half * s->x;
      }
    } else {
      Approx dx = t->x - s->x, dy = t->y - s->y, l2 = dx * dx + dy * dy;
      Approx k = (l2 + (s->z - t->z) * (s->z + t->z)) / (l2 + l2);
      Approx half = root * sqrt(s->z * s->z / l2 - k * k);
      x = s->x + dx * k + dy * half;
      y = s->y + dy * k - dx * half;
    }
  }
  p.x = x.value;
  p.y = y.value;
  p.error = std::max(x.error, y.error);
}

Geometry::Meeting Geometry::meet(std::uint32_t i, std::uint32_t j) const {
  const SupportingCurve* s = &supporting_curves[i];
  const SupportingCurve* t = &supporting_curves[j];
  if (!s->circle && !t->circle) return {cross(*s, *t) != 0, {0, 0}};
  if (s->circle && !t->circle) std::swap(s, t);
  auto by_sign = [](int sign) { return sign > 0 ? Meeting{2, {-1, 1}} : sign == 0 ? Meeting{1, {0, 0}} : Meeting{}; };
  if (!s->circle) {
    Approx h = s->x * t->x + s->y * t->y - s->z;
    Approx tolerance = (t->z - h) * (t->z + h);
    return by_sign(tolerance.sign() != 0 ? tolerance.sign() : crossing_discriminant(*s, *t).sign());
  }
  Approx dx = t->x - s->x, dy = t->y - s->y, l2 = dx * dx + dy * dy;
  Approx sum = s->z + t->z, difference = s->z - t->z;
  int outer = (sum * sum - l2).sign(), inner = (l2 - difference * difference).sign();
  if (outer < 0 || inner < 0) return {};
  if (outer == 0 || inner == 0) {
    Real ex = t->center_x() - s->center_x(), ey = t->center_y() - s->center_y(), e2 = ex * ex + ey * ey;
    if (e2.sign() == 0) return {};
    Real plus = s->w + t->w, minus = s->w - t->w;
    if (outer == 0) outer = compare(plus * plus, e2);
    if (inner == 0) inner = compare(e2, minus * minus);
  }
  return by_sign(std::min(outer, inner));
}

RealPoint Geometry::crossing(const Point& p) const {
  const SupportingCurve* s = &supporting_curves[p.i];
  const SupportingCurve* t = &supporting_curves[p.j];
  if (s->circle && !t->circle) std::swap(s, t);
  if (!t->circle) {
    Real det(cross(*s, *t)), c1 = s->offset(), c2 = t->offset();
    return {(c1 * Real(t->b) - c2 * Real(s->b)) / det, (Real(s->a) * c2 - Real(t->a) * c1) / det};
  }
  if (!s->circle) {
    Real a(s->a), b(s->b), n2(int128(s->a) * s->a + int128(s->b) * s->b);
    Real h = a * t->center_x() + b * t->center_y() - s->offset();
    Real half = p.root == 0 ? Real() : Real(int(p.root)) * sqrt(crossing_discriminant(*s, *t));
    return {t->center_x() + (b * half - a * h) / n2, t->center_y() - (a * half + b * h) / n2};
  }
  Real dx = t->center_x() - s->center_x(), dy = t->center_y() - s->center_y(), l2 = dx * dx + dy * dy;
  Real r2 = s->w * s->w, k = (l2 + r2 - t->w * t->w) / Real(2);
  Real half = p.root == 0 ? Real() : Real(int(p.root)) * sqrt(r2 * l2 - k * k);
  return {s->center_x() + (dx * k + dy * half) / l2, s->center_y() + (dy * k - dx * half) / l2};
}

RealPoint Geometry::exact(std::uint32_t p) const {
  const Point& q = points[p];
  if (q.kind == Point::Kind::kGrid) return {Real(q.gx), Real(q.gy)};
  if (q.kind == Point::Kind::kReal) return reals[q.i];
  return crossing(q);
}

Real Geometry::exact_x(std::uint32_t p) const { return exact(p).x; }
Real Geometry::exact_y(std::uint32_t p) const { return exact(p).y; }

}  // namespace findspace::exact
