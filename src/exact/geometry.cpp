// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "exact/geometry.h"

#include <algorithm>
#include <numeric>

#include "exact/wide_int.h"

namespace findspace::exact {
namespace {

Approx from_interval(Interval r) {
  if (r.lo == r.hi) return {r.lo, 0};
  double v = r.lo + (r.hi - r.lo) / 2;
  return {v, std::max(r.hi - v, v - r.lo) * Approx::kGrow};
}

Approx from_real(const Real& r) { return from_interval(r.interval()); }

Approx from_int(int128 k) {
  if (std::int64_t n = std::int64_t(k); n == k && n <= (1ll << 53) && n >= -(1ll << 53)) return {double(n), 0};
  double v = double(k);
  constexpr int128 kExact = int128(1) << 53;
  return {v, k <= kExact && k >= -kExact ? 0.0 : std::abs(v) * Approx::kUnit * 2};
}

Approx from_double(double v, double error) { return {v, error}; }

/// Whether a coordinate may be held as a grid coordinate.
bool fits(const std::optional<int128>& c) {
  constexpr int128 kMost = int128(1) << 62;
  return c && *c <= kMost && *c >= -kMost;
}

int sign_of(int128 k) { return (k > 0) - (k < 0); }

int128 cross(const Carrier& p, const Carrier& q) { return int128(p.a) * q.b - int128(p.b) * q.a; }

/// A grid line whose crossings with others like it have numerators below 2^126.
bool is_narrow(const Carrier& l) {
  constexpr std::int64_t kNormal = std::int64_t(1) << 42;
  constexpr int128 kOffset = int128(1) << 83;
  return l.grid && !l.circle && l.a < kNormal && l.b < kNormal && l.b > -kNormal && l.c < kOffset && l.c > -kOffset;
}

/// Homogeneous coordinates of the crossing of two narrow lines: |x|, |y| < 2^126, 0 < weight < 2^85.
struct NarrowPoint {
  int128 x, y, weight;
};

NarrowPoint narrow_crossing(const Carrier& s, const Carrier& t) {
  int128 w = cross(s, t), x = s.c * t.b - t.c * s.b, y = t.c * s.a - s.c * t.a;
  return w > 0 ? NarrowPoint{x, y, w} : NarrowPoint{-x, -y, -w};
}

/// The length of a line's normal: the sum of the two squares is off by at most 2 ulps, its root by at most 2.
Approx normal_length(const Carrier& l) {
  double a = double(l.a), b = double(l.b), n = std::sqrt(a * a + b * b);
  return {n, n * (3 * Approx::kUnit)};
}

Approx line_offset(const Carrier& l) {
  if (l.real) return from_real(l.real->x);
  return l.grid ? from_int(l.c) : from_int(l.c) + from_real(l.w) * normal_length(l);
}

/// |a|, |b| < 2^53, so the doubles are exact. With u = 2^-53 the squared length is off by at most 2u (two roundings on
/// each path), its root by 2u (half of that and its own rounding), a quotient by 3u; 4u covers the terms of second
/// order.
void set_line_filter(Carrier& l) {
  double a = double(l.a), b = double(l.b), n = std::sqrt(a * a + b * b);
  double x = a / n, y = b / n;
  l.x = {x, std::abs(x) * (4 * Approx::kUnit)};
  l.y = {y, std::abs(y) * (4 * Approx::kUnit)};
  l.z = l.displaced() ? from_int(l.c) / normal_length(l) + from_real(l.w) : line_offset(l) / normal_length(l);
}

/// Squared radius times squared normal length minus squared unscaled distance: > 0 when line and circle cross.
Real crossing_discriminant(const Carrier& line, const Carrier& circle) {
  Real n2 = Real(int128(line.a) * line.a + int128(line.b) * line.b);
  Real h = Real(line.a) * circle.center_x() + Real(line.b) * circle.center_y() - line.offset();
  return circle.w * circle.w * n2 - h * h;
}

}  // namespace

std::int64_t make_primitive(std::int64_t& a, std::int64_t& b) {
  std::int64_t f = std::gcd(a, b);
  if (a < 0 || (a == 0 && b < 0)) f = -f;
  a /= f;
  b /= f;
  return f;
}

Carrier Carrier::line(std::int64_t a, std::int64_t b, int128 c) {
  Carrier l;
  l.a = a, l.b = b, l.c = c;
  set_line_filter(l);
  return l;
}

Carrier Carrier::line(std::int64_t a, std::int64_t b, const Real& c) {
  if (auto k = c.integer()) return line(a, b, *k);
  Carrier l;
  l.grid = false;
  l.a = a, l.b = b;
  l.real = std::make_shared<const RealPoint>(RealPoint{c, Real()});
  set_line_filter(l);
  return l;
}

Carrier Carrier::displaced_line(std::int64_t a, std::int64_t b, int128 c, const Real& shift) {
  if (shift.sign() == 0) return line(a, b, c);
  // An integer length gives a rational offset.
  int128 square = int128(a) * a + int128(b) * b, root = int128(std::llround(std::sqrt(double(square))));
  if (root * root == square) return line(a, b, Real(c) + shift * Real(root));
  Carrier l;
  l.grid = false;
  l.a = a, l.b = b, l.c = c, l.w = shift;
  set_line_filter(l);
  return l;
}

Carrier Carrier::circle_at(std::int64_t cx, std::int64_t cy, const Real& r) {
  Carrier k;
  k.circle = true;
  k.a = cx, k.b = cy, k.w = r;
  k.x = from_int(cx), k.y = from_int(cy), k.z = from_real(r);
  return k;
}

Carrier Carrier::circle_at(const Real& cx, const Real& cy, const Real& r) {
  auto ix = cx.integer(), iy = cy.integer();
  if (fits(ix) && fits(iy)) return circle_at(std::int64_t(*ix), std::int64_t(*iy), r);
  Carrier k;
  k.circle = true;
  k.grid = false;
  k.real = std::make_shared<const RealPoint>(RealPoint{cx, cy});
  k.w = r;
  k.x = from_real(cx), k.y = from_real(cy), k.z = from_real(r);
  return k;
}

bool same_carrier(const Carrier& p, const Carrier& q) {
  if (p.circle != q.circle) return false;
  if ((p.z - q.z).sign() != 0) return false;
  if (!p.circle) {
    if (p.a != q.a || p.b != q.b) return false;
    if (p.grid && q.grid) return p.c == q.c;
    if (p.displaced() && q.displaced() && p.c == q.c) return p.w == q.w;
    return p.offset() == q.offset();
  }
  if ((p.x - q.x).sign() != 0 || (p.y - q.y).sign() != 0) return false;
  bool same_center =
      p.grid && q.grid ? p.a == q.a && p.b == q.b : p.center_x() == q.center_x() && p.center_y() == q.center_y();
  return same_center && p.w == q.w;
}

std::uint32_t Geometry::add_line(std::int64_t a, std::int64_t b, int128 c) {
  Carrier& l = carriers.emplace_back();
  l.a = a, l.b = b, l.c = c;
  set_line_filter(l);
  return std::uint32_t(carriers.size() - 1);
}

std::uint32_t Geometry::add_parallel(const Carrier& line, std::int64_t x, std::int64_t y) {
  Carrier& l = carriers.emplace_back();
  l.a = line.a, l.b = line.b, l.x = line.x, l.y = line.y;
  l.c = int128(l.a) * x + int128(l.b) * y;
  l.z = from_int(l.c) / normal_length(l);
  return std::uint32_t(carriers.size() - 1);
}

std::uint32_t Geometry::add_grid_point(std::int64_t x, std::int64_t y) {
  Point& p = points.emplace_back();
  p.gx = x, p.gy = y, p.x = double(x), p.y = double(y);
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
    if (carriers[i].circle && carriers[j].circle) root = -root;
    std::swap(i, j);
  }
  p.i = i, p.j = j, p.root = std::int8_t(root);
  set_approx(p);
  points.push_back(p);
  return std::uint32_t(points.size() - 1);
}

void Geometry::set_approx(Point& p) const {
  Approx x, y;
  if (p.kind == Point::Kind::kReal) {
    x = from_real(reals[p.i].x), y = from_real(reals[p.i].y);
  } else {
    const Carrier* s = &carriers[p.i];
    const Carrier* t = &carriers[p.j];
    if (s->circle && !t->circle) std::swap(s, t);
    Approx root{double(p.root), 0};
    if (!t->circle && is_narrow(*s) && is_narrow(*t)) {
      NarrowPoint e = narrow_crossing(*s, *t);
      Approx det = from_int(e.weight);
      x = from_int(e.x) / det, y = from_int(e.y) / det;
    } else if (!t->circle) {
      Approx det = from_int(cross(*s, *t)), c1 = line_offset(*s), c2 = line_offset(*t);
      x = (c1 * from_int(t->b) - c2 * from_int(s->b)) / det;
      y = (from_int(s->a) * c2 - from_int(t->a) * c1) / det;
    } else if (!s->circle) {
      Approx h = s->x * t->x + s->y * t->y - s->z;
      Approx half = root * sqrt((t->z - h) * (t->z + h));
      x = t->x - h * s->x + half * s->y;
      y = t->y - h * s->y - half * s->x;
    } else {
      Approx dx = t->x - s->x, dy = t->y - s->y, l2 = dx * dx + dy * dy;
      Approx k = (l2 + (s->z - t->z) * (s->z + t->z)) / (l2 + l2);
      Approx half = root * sqrt(s->z * s->z / l2 - k * k);
      x = s->x + dx * k + dy * half;
      y = s->y + dy * k - dx * half;
    }
  }
  p.x = x.value, p.y = y.value;
  p.error = std::max(x.error, y.error);
}

Geometry::Meeting Geometry::meet(std::uint32_t i, std::uint32_t j) const {
  const Carrier* s = &carriers[i];
  const Carrier* t = &carriers[j];
  if (!s->circle && !t->circle) return {cross(*s, *t) != 0, {0, 0}};
  if (s->circle && !t->circle) std::swap(s, t);
  auto by_sign = [](int sign) { return sign > 0 ? Meeting{2, {-1, 1}} : sign == 0 ? Meeting{1, {0, 0}} : Meeting{}; };
  if (!s->circle) {
    Approx h = s->x * t->x + s->y * t->y - s->z;
    Approx room = (t->z - h) * (t->z + h);
    return by_sign(room.sign() != 0 ? room.sign() : crossing_discriminant(*s, *t).sign());
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
  const Carrier* s = &carriers[p.i];
  const Carrier* t = &carriers[p.j];
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

namespace {

/// Homogeneous integer coordinates of a grid point or of the crossing of two grid lines; weight > 0.
struct FixedPoint {
  Int256 x, y;
  int128 weight;
};

bool is_fixed(const Geometry& g, const Point& p) {
  if (p.kind == Point::Kind::kGrid) return true;
  if (p.kind == Point::Kind::kReal) return false;
  const Carrier &s = g.carriers[p.i], &t = g.carriers[p.j];
  return !s.circle && !t.circle && s.grid && t.grid;
}

FixedPoint fixed(const Geometry& g, const Point& p) {
  if (p.kind == Point::Kind::kGrid) return {Int256(int128(p.gx)), Int256(int128(p.gy)), 1};
  const Carrier &s = g.carriers[p.i], &t = g.carriers[p.j];
  int128 w = cross(s, t);
  Int256 x = multiply(s.c, t.b) - multiply(t.c, s.b);
  Int256 y = multiply(t.c, s.a) - multiply(s.c, t.a);
  return w > 0 ? FixedPoint{x, y, w} : FixedPoint{-x, -y, -w};
}

bool same_definition(const Point& p, const Point& q) {
  return p.kind == q.kind && p.kind != Point::Kind::kGrid && p.i == q.i && p.j == q.j && p.root == q.root;
}

}  // namespace

namespace {

/// 128-bit coordinates of a grid point or of the crossing of two narrow lines.
bool narrow(const Geometry& g, const Point& p, NarrowPoint& out) {
  if (p.kind == Point::Kind::kGrid) {
    out = {p.gx, p.gy, 1};
    return true;
  }
  const Carrier &s = g.carriers[p.i], &t = g.carriers[p.j];
  if (!is_narrow(s) || !is_narrow(t)) return false;
  out = narrow_crossing(s, t);
  return true;
}

}  // namespace

int Geometry::fixed_compare(const Point& p, const Point& q, bool x_axis) const {
  NarrowPoint n, m;
  if (narrow(*this, p, n) && narrow(*this, q, m)) {
    auto order = multiply(x_axis ? n.x : n.y, m.weight) <=> multiply(x_axis ? m.x : m.y, n.weight);
    return (order > 0) - (order < 0);
  }
  FixedPoint f = fixed(*this, p), g = fixed(*this, q);
  auto order = multiply(x_axis ? f.x : f.y, g.weight) <=> multiply(x_axis ? g.x : g.y, f.weight);
  return (order > 0) - (order < 0);
}

int Geometry::staged_compare(std::uint32_t p, std::uint32_t q, bool x_axis) const {
  const Point &s = points[p], &t = points[q];
  if (s.kind == Point::Kind::kGrid && t.kind == Point::Kind::kGrid)
    return x_axis ? sign_of(int128(s.gx) - t.gx) : sign_of(int128(s.gy) - t.gy);
  if (p == q || same_definition(s, t)) return 0;
  if (is_fixed(*this, s) && is_fixed(*this, t)) return fixed_compare(s, t, x_axis);
  return x_axis ? compare(exact_x(p), exact_x(q)) : compare(exact_y(p), exact_y(q));
}

int Geometry::compare_xy(std::uint32_t p, std::uint32_t q) const {
  if (p == q) return 0;
  int s = compare_x(p, q);
  return s != 0 ? s : compare_y(p, q);
}

int Geometry::staged_side(std::uint32_t p, std::uint32_t carrier) const {
  const Point& q = points[p];
  const Carrier& k = carriers[carrier];
  if (q.kind == Point::Kind::kCross && (q.i == carrier || q.j == carrier)) return 0;
  Approx x = from_double(q.x, q.error), y = from_double(q.y, q.error);
  if (!k.circle) {
    Approx s = k.x * x + k.y * y - k.z;
    if (s.sign() != 0) return s.sign();
    if (k.grid && is_fixed(*this, q)) {
      FixedPoint f = fixed(*this, q);
      return (multiply(f.x, int128(k.a)) + multiply(f.y, int128(k.b)) - Int512(multiply(k.c, f.weight))).sign();
    }
    RealPoint e = exact(p);
    return (Real(k.a) * e.x + Real(k.b) * e.y - k.offset()).sign();
  }
  Approx dx = x - k.x, dy = y - k.y;
  Approx s = dx * dx + dy * dy - k.z * k.z;
  if (s.sign() != 0) return s.sign();
  RealPoint e = exact(p);
  Real ex = e.x - k.center_x(), ey = e.y - k.center_y();
  return compare(ex * ex + ey * ey, k.w * k.w);
}

int Geometry::above_center(std::uint32_t p, std::uint32_t circle) const {
  const Carrier& k = carriers[circle];
  Approx s = from_double(points[p].y, points[p].error) - k.y;
  return s.certain() ? s.sign() : compare(exact_y(p), k.center_y());
}

int Geometry::right_of_center(std::uint32_t p, std::uint32_t circle) const {
  const Carrier& k = carriers[circle];
  Approx s = from_double(points[p].x, points[p].error) - k.x;
  return s.certain() ? s.sign() : compare(exact_x(p), k.center_x());
}

std::array<Approx, 2> Geometry::tangent(std::uint32_t p, Heading h) const {
  const Carrier& k = carriers[h.carrier];
  Approx dx = k.y, dy = -k.x;
  if (k.circle)
    dx = k.y - from_double(points[p].y, points[p].error), dy = from_double(points[p].x, points[p].error) - k.x;
  if (h.forward) return {dx, dy};
  return {-dx, -dy};
}

std::array<Real, 2> Geometry::exact_tangent(std::uint32_t p, Heading h) const {
  const Carrier& k = carriers[h.carrier];
  Real dx(k.b), dy(-k.a);
  if (k.circle) {
    RealPoint e = exact(p);
    dx = k.center_y() - e.y, dy = e.x - k.center_x();
  }
  if (h.forward) return {dx, dy};
  return {-dx, -dy};
}

bool Geometry::touch_at(std::uint32_t p, std::uint32_t i, std::uint32_t j) const {
  const Point& q = points[p];
  return q.kind == Point::Kind::kCross && q.root == 0 && std::min(i, j) == q.i && std::max(i, j) == q.j &&
         (carriers[i].circle || carriers[j].circle);
}

int Geometry::turn(std::uint32_t p, Heading h, Heading k) const {
  const Carrier &s = carriers[h.carrier], &t = carriers[k.carrier];
  if (!s.circle && !t.circle) {
    int c = sign_of(cross(s, t));
    return h.forward == k.forward ? c : -c;
  }
  if (h.carrier == k.carrier || touch_at(p, h.carrier, k.carrier)) return 0;
  auto u = tangent(p, h), v = tangent(p, k);
  Approx c = u[0] * v[1] - u[1] * v[0];
  if (c.sign() != 0) return c.sign();
  auto e = exact_tangent(p, h), f = exact_tangent(p, k);
  return compare(e[0] * f[1], e[1] * f[0]);
}

int Geometry::along(std::uint32_t p, Heading h, Heading k) const {
  const Carrier &s = carriers[h.carrier], &t = carriers[k.carrier];
  if (!s.circle && !t.circle) {
    int c = sign_of(int128(s.a) * t.a + int128(s.b) * t.b);
    return h.forward == k.forward ? c : -c;
  }
  auto u = tangent(p, h), v = tangent(p, k);
  Approx c = u[0] * v[0] + u[1] * v[1];
  if (c.sign() != 0) return c.sign();
  auto e = exact_tangent(p, h), f = exact_tangent(p, k);
  return (e[0] * f[0] + e[1] * f[1]).sign();
}

int Geometry::compare_curvature(Heading h, Heading k) const {
  const Carrier &s = carriers[h.carrier], &t = carriers[k.carrier];
  int p = s.circle ? (h.forward ? 1 : -1) : 0, q = t.circle ? (k.forward ? 1 : -1) : 0;
  if (p != q) return p > q ? 1 : -1;
  if (p == 0) return 0;
  Approx gap = t.z - s.z;
  int c = gap.sign() != 0 ? gap.sign() : compare(t.w, s.w);  // smaller radius, larger curvature
  return p > 0 ? c : -c;
}

}  // namespace findspace::exact
