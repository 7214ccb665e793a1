// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <numeric>

#include "exact/planar/geometry_stages.h"

namespace findspace::exact {

void set_line_filter(SupportingCurve& l) {
  const SupportingCurve::LineFilter f = grid_line_filter(l.a, l.b, l.c);
  if (l.grid) return l.set_filter({f.x, f.x_error}, {f.y, f.y_error}, {f.z, f.z_error});
  l.set_filter({f.x, f.x_error}, {f.y, f.y_error},
               l.displaced() ? from_int(l.c) / normal_length(l) + from_real(l.w()) : line_offset(l) / normal_length(l));
}

std::int64_t make_primitive(std::int64_t& a, std::int64_t& b) {
  std::int64_t f = std::gcd(a, b);
  if (a < 0 || (a == 0 && b < 0)) f = -f;
  a /= f;
  b /= f;
  return f;
}

SupportingCurve SupportingCurve::line(std::int64_t a, std::int64_t b, int128 c) {
  return {a, b, c, grid_line_filter(a, b, c)};
}

SupportingCurve SupportingCurve::line(std::int64_t a, std::int64_t b, const Real& c) {
  if (auto k = c.integer()) return line(a, b, *k);
  SupportingCurve l;
  l.grid = false;
  l.a = a;
  l.b = b;
  l.reals = CurveReals({c, Real()}, Real());
  set_line_filter(l);
  return l;
}

SupportingCurve SupportingCurve::displaced_line(std::int64_t a, std::int64_t b, int128 c, const CurveReals& shift) {
  if (shift.w().sign() == 0) return line(a, b, c);
  // An integer length gives a rational offset.
  if (auto length = integer_length(a, b))
    return line(a, b, Real(c) + (*length == 1 ? shift.w() : shift.w() * Real(*length)));
  SupportingCurve l;
  l.grid = false;
  l.a = a;
  l.b = b;
  l.c = c;
  l.reals = shift;
  set_line_filter(l);
  return l;
}

SupportingCurve SupportingCurve::circle_at(std::int64_t cx, std::int64_t cy, const CurveReals& r) {
  SupportingCurve k;
  k.circle = true;
  k.a = cx;
  k.b = cy;
  k.reals = r;
  k.set_filter(from_int(cx), from_int(cy), from_real(r.w()));
  return k;
}

SupportingCurve SupportingCurve::circle_at(const Real& cx, const Real& cy, const Real& r) {
  auto ix = cx.integer(), iy = cy.integer();
  if (fits(ix) && fits(iy)) return circle_at(std::int64_t(*ix), std::int64_t(*iy), r);
  SupportingCurve k;
  k.circle = true;
  k.grid = false;
  k.reals = CurveReals({cx, cy}, r);
  k.set_filter(from_real(cx), from_real(cy), from_real(r));
  return k;
}

bool same_supporting_curve(const SupportingCurve& p, const SupportingCurve& q) {
  if (p.circle != q.circle) return false;
  if ((p.z() - q.z()).sign() != 0) return false;
  if (!p.circle) {
    if (p.a != q.a || p.b != q.b) return false;
    if (p.grid && q.grid) return p.c == q.c;
    if (p.displaced() && q.displaced() && p.c == q.c) return p.w() == q.w();
    return p.offset() == q.offset();
  }
  if ((p.x() - q.x()).sign() != 0 || (p.y() - q.y()).sign() != 0) return false;
  bool same_center =
      p.grid && q.grid ? p.a == q.a && p.b == q.b : p.center_x() == q.center_x() && p.center_y() == q.center_y();
  return same_center && p.w() == q.w();
}

}  // namespace findspace::exact
