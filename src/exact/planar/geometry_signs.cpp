// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "exact/planar/geometry_signs.h"

#include <algorithm>
#include <optional>

#include "exact/number/wide_int.h"
#include "exact/planar/geometry_stages.h"

namespace findspace::exact {
namespace {

Approx from_double(double v, double error) { return {v, error}; }

/// Homogeneous integer coordinates of a grid point or of the crossing of two grid lines; weight > 0.
struct FixedPoint {
  Int256 x, y;
  int128 weight;
};

bool is_fixed(const Geometry& g, const Point& p) {
  if (p.kind == Point::Kind::kGrid) return true;
  if (p.kind == Point::Kind::kReal) return false;
  const SupportingCurve &s = g.supporting_curves[p.i], &t = g.supporting_curves[p.j];
  return !s.circle && !t.circle && s.grid && t.grid;
}

FixedPoint fixed(const Geometry& g, const Point& p) {
  if (p.kind == Point::Kind::kGrid) return {Int256(int128(p.gx)), Int256(int128(p.gy)), 1};
  const SupportingCurve &s = g.supporting_curves[p.i], &t = g.supporting_curves[p.j];
  int128 w = cross(s, t);
  Int256 x = multiply(s.c, t.b) - multiply(t.c, s.b);
  Int256 y = multiply(t.c, s.a) - multiply(s.c, t.a);
  return w > 0 ? FixedPoint{x, y, w} : FixedPoint{-x, -y, -w};
}

bool same_definition(const Point& p, const Point& q) {
  return p.kind == q.kind && p.kind != Point::Kind::kGrid && p.i == q.i && p.j == q.j && p.root == q.root;
}

/// 128-bit coordinates of a grid point or of the crossing of two narrow lines.
bool narrow(const Geometry& g, const Point& p, NarrowPoint& out) {
  if (p.kind == Point::Kind::kGrid) {
    out = {p.gx, p.gy, 1};
    return true;
  }
  const SupportingCurve &s = g.supporting_curves[p.i], &t = g.supporting_curves[p.j];
  if (!is_narrow(s) || !is_narrow(t)) return false;
  out = narrow_crossing(s, t);
  return true;
}

int fixed_compare(const Geometry& g, const Point& p, const Point& q, bool x_axis) {
  NarrowPoint n, m;
  if (narrow(g, p, n) && narrow(g, q, m)) {
    auto order = multiply(x_axis ? n.x : n.y, m.weight) <=> multiply(x_axis ? m.x : m.y, n.weight);
    return (order > 0) - (order < 0);
  }
  FixedPoint f = fixed(g, p), h = fixed(g, q);
  auto order = multiply(x_axis ? f.x : f.y, h.weight) <=> multiply(x_axis ? h.x : h.y, f.weight);
  return (order > 0) - (order < 0);
}

/// Whether the second curve is the first one moved by integers: the same radius about grid points, or the same normal
/// and displacement. No allocation; false where that is not seen at once.
bool is_moved(const SupportingCurve& s, const SupportingCurve& t) {
  if (s.circle != t.circle || s.grid != t.grid || s.real() || t.real()) return false;
  if (!s.circle && (s.a != t.a || s.b != t.b)) return false;
  return &s.w() == &t.w() || (s.w().is_rational() && t.w().is_rational() && s.w() == t.w());
}

/// Of two lines: how far the offset of the first is beyond that of the second, which is that moved; where it is short.
std::optional<std::int64_t> gap_of(const SupportingCurve& s, const SupportingCurve& t) {
  const int128 gap = s.c - t.c;
  return fits(gap) ? std::optional(std::int64_t(gap)) : std::nullopt;
}

/// The order of the crossings of s with t and of u with v, where u and v are s and t moved by integers or fractions.
std::optional<int> order_if_moved(const SupportingCurve& s, const SupportingCurve& t, const SupportingCurve& u,
                                  const SupportingCurve& v, bool x_axis) {
  if (!is_moved(s, u) || !is_moved(t, v)) return std::nullopt;
  if (!s.circle && !t.circle) {
    const auto c = gap_of(s, u), d = gap_of(t, v);
    if (!c || !d) return std::nullopt;
    const int128 by = x_axis ? int128(*c) * t.b - int128(*d) * s.b : int128(*d) * s.a - int128(*c) * t.a;
    return sign_of(by) * sign_of(cross(s, t));
  }
  const bool first = s.circle;
  const int128 dx = first ? int128(s.a) - u.a : int128(t.a) - v.a, dy = first ? int128(s.b) - u.b : int128(t.b) - v.b;
  const auto follows = [&](const SupportingCurve& k, const SupportingCurve& l) {
    if (k.circle) return k.a - dx == l.a && k.b - dy == l.b;
    const auto gap = gap_of(k, l);
    return gap && fits(dx) && fits(dy) && k.a * dx + k.b * dy == *gap;
  };
  if (!(first ? follows(t, v) : follows(s, u))) return std::nullopt;
  return sign_of(x_axis ? dx : dy);
}

/// The order of two crossings of which one is the other moved, as in rows of equal shapes.
std::optional<int> compare_moved(const Geometry& g, const Point& p, const Point& q, bool x_axis) {
  if (p.kind != Point::Kind::kCross || q.kind != Point::Kind::kCross) return std::nullopt;
  const auto &s = g.supporting_curves[p.i], &t = g.supporting_curves[p.j];
  const auto &u = g.supporting_curves[q.i], &v = g.supporting_curves[q.j];
  if (p.root == q.root)
    if (const auto order = order_if_moved(s, t, u, v, x_axis)) return order;
  // The root of two circles counts from the first of them.
  const int swapped = u.circle && v.circle ? -q.root : q.root;
  return p.root == swapped ? order_if_moved(s, t, v, u, x_axis) : std::nullopt;
}

/// A circle about a grid point, and that of the coordinates.
struct Center {
  int128 along, across;
};
Center center(const SupportingCurve& circle, bool x_axis) {
  return x_axis ? Center{circle.a, circle.b} : Center{circle.b, circle.a};
}

/// The order of the crossings of circles of one radius, where the ways between their centres are the same but for
/// signs: the crossings then lie as far from the middle of the way, to one side.
std::optional<int> order_if_circles_mirrored(const SupportingCurve& s, const SupportingCurve& t, int p_root,
                                             const SupportingCurve& u, const SupportingCurve& v, int q_root,
                                             bool x_axis) {
  if (!is_moved(s, t) || !is_moved(s, u) || !is_moved(s, v)) return std::nullopt;
  const Center a = center(s, x_axis), b = center(t, x_axis), c = center(u, x_axis), d = center(v, x_axis);
  const auto as_far = [](int128 k, int128 l) { return k == l || k == -l; };
  const int128 p_across = b.across - a.across, q_across = d.across - c.across;
  if (!as_far(b.along - a.along, d.along - c.along) || !as_far(p_across, q_across)) return std::nullopt;
  if (p_root * sign_of(p_across) != q_root * sign_of(q_across)) return std::nullopt;
  return sign_of((a.along + b.along) - (c.along + d.along));
}

/// Of a circle about a grid point, a chord along the axis, at whose end a crossing lies.
struct Chord {
  const SupportingCurve* circle;
  int128 doubled_height;  // over the centre
  int side;
};

/// Where a grid line along the axis cuts a circle, or two equal circles across the axis cut each other.
std::optional<Chord> chord_of(const Geometry& g, const Point& p, bool x_axis) {
  const auto *s = &g.supporting_curves[p.i], *t = &g.supporting_curves[p.j];
  if (s->circle && !t->circle) std::swap(s, t);
  if (!t->circle || !t->grid) return std::nullopt;
  const Center at = center(*t, x_axis);
  if (!s->circle) {
    const bool is_along = s->grid && (x_axis ? s->a : s->b) == 0;
    return is_along ? std::optional(Chord{t, 2 * (at.across - s->c), p.root}) : std::nullopt;
  }
  if (!is_moved(*s, *t) || center(*s, x_axis).along != at.along) return std::nullopt;
  const int128 height = at.across - center(*s, x_axis).across;
  return Chord{t, height, p.root * sign_of(height)};
}

std::optional<int> order_of_chords(const Chord& p, const Chord& q, bool x_axis) {
  const int128 h = p.doubled_height, k = q.doubled_height;
  if (!is_moved(*p.circle, *q.circle) || p.side != q.side || (h != k && h != -k)) return std::nullopt;
  return sign_of(center(*p.circle, x_axis).along - center(*q.circle, x_axis).along);
}

/// Twice a coordinate where that is an integer seen at once: of grid points, of points on a grid line across the axis,
/// of those where a line along it touches a circle, and of those of two equal circles halfway between their centres.
std::optional<int128> doubled(const Geometry& g, const Point& p, bool x_axis) {
  if (p.kind == Point::Kind::kGrid) return 2 * int128(x_axis ? p.gx : p.gy);
  if (p.kind == Point::Kind::kReal) return std::nullopt;
  const SupportingCurve &s = g.supporting_curves[p.i], &t = g.supporting_curves[p.j];
  for (const SupportingCurve* k : {&s, &t})
    if (!k->circle && k->grid && (x_axis ? k->b : k->a) == 0) return 2 * k->c;
  if (s.circle != t.circle && p.root == 0) {
    const SupportingCurve &line = s.circle ? t : s, &circle = s.circle ? s : t;
    if (circle.grid && (x_axis ? line.a : line.b) == 0) return 2 * center(circle, x_axis).along;
  }
  if (!s.circle || !s.grid || !is_moved(s, t)) return std::nullopt;
  const Center a = center(s, x_axis), b = center(t, x_axis);
  return p.root == 0 || a.across == b.across ? std::optional(a.along + b.along) : std::nullopt;
}

/// The order of two crossings with circles of which one is the other moved and mirrored, as about boxes.
std::optional<int> compare_mirrored(const Geometry& g, const Point& p, const Point& q, bool x_axis) {
  if (p.kind != Point::Kind::kCross || q.kind != Point::Kind::kCross) return std::nullopt;
  const auto &s = g.supporting_curves[p.i], &t = g.supporting_curves[p.j];
  const auto &u = g.supporting_curves[q.i], &v = g.supporting_curves[q.j];
  if (s.circle && t.circle && s.grid && u.circle && v.circle)
    if (const auto order = order_if_circles_mirrored(s, t, p.root, u, v, q.root, x_axis)) return order;
  const auto chord = chord_of(g, p, x_axis), other = chord ? chord_of(g, q, x_axis) : std::nullopt;
  return other ? order_of_chords(*chord, *other, x_axis) : std::nullopt;
}

std::array<Approx, 2> tangent(const Geometry& g, std::uint32_t p, Heading h) {
  const SupportingCurve& k = g.supporting_curves[h.supporting_curve];
  Approx dx = k.y(), dy = -k.x();
  if (k.circle) {
    dx = k.y() - from_double(g.points[p].y, g.points[p].error);
    dy = from_double(g.points[p].x, g.points[p].error) - k.x();
  }
  if (h.forward) return {dx, dy};
  return {-dx, -dy};
}

std::array<Real, 2> exact_tangent(const Geometry& g, std::uint32_t p, Heading h) {
  const SupportingCurve& k = g.supporting_curves[h.supporting_curve];
  Real dx(k.b), dy(-k.a);
  if (k.circle) {
    RealPoint e = g.exact(p);
    dx = k.center_y() - e.y;
    dy = e.x - k.center_x();
  }
  if (h.forward) return {dx, dy};
  return {-dx, -dy};
}

}  // namespace

namespace detail {

int staged_compare(const Geometry& g, std::uint32_t p, std::uint32_t q, bool x_axis) {
  const Point &s = g.points[p], &t = g.points[q];
  if (s.kind == Point::Kind::kGrid && t.kind == Point::Kind::kGrid)
    return x_axis ? sign_of(int128(s.gx) - t.gx) : sign_of(int128(s.gy) - t.gy);
  if (p == q || same_definition(s, t)) return 0;
  if (is_fixed(g, s) && is_fixed(g, t)) return fixed_compare(g, s, t, x_axis);
  if (const auto order = compare_moved(g, s, t, x_axis)) return *order;
  if (const auto order = compare_mirrored(g, s, t, x_axis)) return *order;
  if (const auto a = doubled(g, s, x_axis))
    if (const auto b = doubled(g, t, x_axis)) return sign_of(*a - *b);
  return compare(exact_coordinate(g, s, x_axis), exact_coordinate(g, t, x_axis));
}

int staged_side(const Geometry& g, std::uint32_t p, std::uint32_t supporting_curve) {
  const Point& q = g.points[p];
  const SupportingCurve& k = g.supporting_curves[supporting_curve];
  if (q.kind == Point::Kind::kCross && (q.i == supporting_curve || q.j == supporting_curve)) return 0;
  Approx x = from_double(q.x, q.error), y = from_double(q.y, q.error);
  if (!k.circle) {
    Approx s = k.x() * x + k.y() * y - k.z();
    if (s.sign() != 0) return s.sign();
    if (k.grid && is_fixed(g, q)) {
      FixedPoint f = fixed(g, q);
      return (multiply(f.x, int128(k.a)) + multiply(f.y, int128(k.b)) - Int512(multiply(k.c, f.weight))).sign();
    }
    RealPoint e = g.exact(p);
    return (Real(k.a) * e.x + Real(k.b) * e.y - k.offset()).sign();
  }
  Approx dx = x - k.x(), dy = y - k.y();
  Approx s = dx * dx + dy * dy - k.z() * k.z();
  if (s.sign() != 0) return s.sign();
  RealPoint e = g.exact(p);
  Real ex = e.x - k.center_x(), ey = e.y - k.center_y();
  return compare(ex * ex + ey * ey, k.w() * k.w());
}

}  // namespace detail

int compare_xy(const Geometry& g, std::uint32_t p, std::uint32_t q) {
  if (p == q) return 0;
  int s = compare_x(g, p, q);
  return s != 0 ? s : compare_y(g, p, q);
}

int above_center(const Geometry& g, std::uint32_t p, std::uint32_t circle) {
  const SupportingCurve& k = g.supporting_curves[circle];
  Approx s = from_double(g.points[p].y, g.points[p].error) - k.y();
  return s.certain() ? s.sign() : compare(g.exact_y(p), k.center_y());
}

int right_of_center(const Geometry& g, std::uint32_t p, std::uint32_t circle) {
  const SupportingCurve& k = g.supporting_curves[circle];
  Approx s = from_double(g.points[p].x, g.points[p].error) - k.x();
  return s.certain() ? s.sign() : compare(g.exact_x(p), k.center_x());
}

bool touch_at(const Geometry& g, std::uint32_t p, std::uint32_t i, std::uint32_t j) {
  const Point& q = g.points[p];
  return q.kind == Point::Kind::kCross && q.root == 0 && std::min(i, j) == q.i && std::max(i, j) == q.j &&
         (g.supporting_curves[i].circle || g.supporting_curves[j].circle);
}

Meeting meet(const Geometry& g, std::uint32_t i, std::uint32_t j) {
  const SupportingCurve* s = &g.supporting_curves[i];
  const SupportingCurve* t = &g.supporting_curves[j];
  if (!s->circle && !t->circle) return {cross(*s, *t) != 0, {0, 0}};
  if (s->circle && !t->circle) std::swap(s, t);
  auto by_sign = [](int sign) { return sign > 0 ? Meeting{2, {-1, 1}} : sign == 0 ? Meeting{1, {0, 0}} : Meeting{}; };
  if (!s->circle) {
    Approx h = s->x() * t->x() + s->y() * t->y() - s->z();
    Approx square = (t->z() - h) * (t->z() + h);
    return by_sign(square.sign() != 0 ? square.sign() : crossing_discriminant(*s, *t).sign());
  }
  Approx dx = t->x() - s->x(), dy = t->y() - s->y(), l2 = dx * dx + dy * dy;
  Approx sum = s->z() + t->z(), difference = s->z() - t->z();
  int outer = (sum * sum - l2).sign(), inner = (l2 - difference * difference).sign();
  if (outer < 0 || inner < 0) return {};
  if (outer == 0 || inner == 0) {
    Real ex = t->center_x() - s->center_x(), ey = t->center_y() - s->center_y(), e2 = ex * ex + ey * ey;
    if (e2.sign() == 0) return {};
    Real plus = s->w() + t->w(), minus = s->w() - t->w();
    if (outer == 0) outer = compare(plus * plus, e2);
    if (inner == 0) inner = compare(e2, minus * minus);
  }
  return by_sign(std::min(outer, inner));
}

int turn(const Geometry& g, std::uint32_t p, Heading h, Heading k) {
  const SupportingCurve &s = g.supporting_curves[h.supporting_curve], &t = g.supporting_curves[k.supporting_curve];
  if (!s.circle && !t.circle) {
    int c = sign_of(cross(s, t));
    return h.forward == k.forward ? c : -c;
  }
  if (h.supporting_curve == k.supporting_curve || touch_at(g, p, h.supporting_curve, k.supporting_curve)) return 0;
  auto u = tangent(g, p, h), v = tangent(g, p, k);
  Approx c = u[0] * v[1] - u[1] * v[0];
  if (c.sign() != 0) return c.sign();
  auto e = exact_tangent(g, p, h), f = exact_tangent(g, p, k);
  return compare(e[0] * f[1], e[1] * f[0]);
}

int along(const Geometry& g, std::uint32_t p, Heading h, Heading k) {
  const SupportingCurve &s = g.supporting_curves[h.supporting_curve], &t = g.supporting_curves[k.supporting_curve];
  if (!s.circle && !t.circle) {
    int c = sign_of(int128(s.a) * t.a + int128(s.b) * t.b);
    return h.forward == k.forward ? c : -c;
  }
  auto u = tangent(g, p, h), v = tangent(g, p, k);
  Approx c = u[0] * v[0] + u[1] * v[1];
  if (c.sign() != 0) return c.sign();
  auto e = exact_tangent(g, p, h), f = exact_tangent(g, p, k);
  return (e[0] * f[0] + e[1] * f[1]).sign();
}

int compare_curvature(const Geometry& g, Heading h, Heading k) {
  const SupportingCurve &s = g.supporting_curves[h.supporting_curve], &t = g.supporting_curves[k.supporting_curve];
  int p = s.circle ? (h.forward ? 1 : -1) : 0, q = t.circle ? (k.forward ? 1 : -1) : 0;
  if (p != q) return p > q ? 1 : -1;
  if (p == 0) return 0;
  Approx gap = t.z() - s.z();
  int c = gap.sign() != 0 ? gap.sign() : compare(t.w(), s.w());  // smaller radius, larger curvature
  return p > 0 ? c : -c;
}

}  // namespace findspace::exact
