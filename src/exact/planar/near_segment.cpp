// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "exact/planar/near_segment.h"

#include "exact/planar/geometry_stages.h"

namespace findspace::exact {
namespace {

/// Signs that are all negative where the point is in the disc about an end, or in the strip. N: Approx or Real.
template <class N>
struct Place {
  N x, y, ax, ay, bx, by, r;

  N beyond_disc(const N& cx, const N& cy) const {
    N dx = x - cx, dy = y - cy;
    return dx * dx + dy * dy - r * r;
  }
  N before_start() const { return (ax - x) * (bx - ax) + (ay - y) * (by - ay); }
  N past_end() const { return (x - bx) * (bx - ax) + (y - by) * (by - ay); }
  N beside() const {
    N dx = bx - ax, dy = by - ay, c = (x - ax) * dy - (y - ay) * dx;
    return c * c - r * r * (dx * dx + dy * dy);
  }
};

/// +1: all negative; -1: one is positive; 0: not known.
int all_negative(std::initializer_list<int> signs) {
  int result = 1;
  for (int s : signs) {
    if (s > 0) return -1;
    if (s == 0) result = 0;
  }
  return result;
}

}  // namespace

bool is_nearer(const Geometry& g, std::uint32_t point, const GridSegment& s, const Real& distance) {
  const Point& p = g.points[point];
  auto number = [](std::int64_t k) { return from_int(k); };
  const Place<Approx> at{{p.x, p.error}, {p.y, p.error}, number(s.ax),       number(s.ay),
                         number(s.bx),   number(s.by),   from_real(distance)};
  const int disc_a = all_negative({at.beyond_disc(at.ax, at.ay).sign()});
  const int disc_b = all_negative({at.beyond_disc(at.bx, at.by).sign()});
  const int strip = all_negative({at.before_start().sign(), at.past_end().sign(), at.beside().sign()});
  if (disc_a > 0 || disc_b > 0 || strip > 0) return true;
  if (disc_a < 0 && disc_b < 0 && strip < 0) return false;
  const RealPoint e = g.exact(point);
  const Place<Real> in{e.x, e.y, Real(s.ax), Real(s.ay), Real(s.bx), Real(s.by), distance};
  if (disc_a == 0 && in.beyond_disc(in.ax, in.ay).sign() < 0) return true;
  if (disc_b == 0 && in.beyond_disc(in.bx, in.by).sign() < 0) return true;
  return strip == 0 && in.before_start().sign() < 0 && in.past_end().sign() < 0 && in.beside().sign() < 0;
}

}  // namespace findspace::exact
