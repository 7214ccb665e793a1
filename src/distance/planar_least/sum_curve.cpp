// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/planar_least/sum_curve.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "plane/base/real_vector.h"
#include "plane/build/swept.h"
#include "plane/complex/overlay.h"
#include "plane/complex/primitives.h"
#include "plane/query/moved.h"
#include "plane/query/topology.h"

namespace findspace::distance {

using exact::Real;
using exact::RealPoint;
using plane::CellComplex;
using plane::Mark;
using plane::Region;
using plane::operator-;

namespace {

/// a*x + b*y + c + the sum of weight * |p - centre|.
struct Total {
  struct Cone {
    RealPoint centre;
    Real weight;
  };
  Real a{}, b{}, c{};
  std::vector<Cone> cones{};

  void add(const Summand& s, const LevelCurve& f);
};

/// A line says level = (a*x + b*y - c) / k, a circle level = (|q - centre| - c) / k; q = p + by, or by - p.
void Total::add(const Summand& s, const LevelCurve& f) {
  const Real w = s.weight / f.k, sense(s.reflected ? -1 : 1);
  if (!f.circle) {
    a = a + w * sense * f.a;
    b = b + w * sense * f.b;
    c = c + w * (f.a * s.by.x + f.b * s.by.y - f.c);
    return;
  }
  c = c - w * f.c;
  const RealPoint centre{sense * (f.a - s.by.x), sense * (f.b - s.by.y)};
  const auto known = std::find_if(cones.begin(), cones.end(), [&](const Cone& k) {
    return compare(k.centre.x, centre.x) == 0 && compare(k.centre.y, centre.y) == 0;
  });
  if (known == cones.end()) {
    cones.push_back({centre, w});
    return;
  }
  known->weight = known->weight + w;
  if (known->weight.sign() == 0) cones.erase(known);
}

Real square(const RealPoint& p) { return p.x * p.x + p.y * p.y; }

/// In the box: `sign` on the positive side of a closed set, 0 on its boundary.
CellComplex inside_of(const Region& closed, const plane::PieceBox& box, int sign) {
  const Region whole = filled_box(box), open = plane::interior(closed);
  return plane::overlay(std::array<const CellComplex*, 3>{&whole, &closed, &open}, [sign](std::span<const Mark> m) {
    return m[0] <= 0 ? Mark(0) : m[2] > 0 ? Mark(sign) : m[1] > 0 ? Mark(0) : Mark(-sign);
  });
}

CellComplex constant(const plane::PieceBox& box, int sign) {
  return plane::remark(filled_box(box), [sign](Mark m) { return Mark(m > 0 ? sign : 0); });
}

/// a*x + b*y + c; nothing where the direction is not a ratio of integers that fits the grid.
std::optional<CellComplex> of_line(const Real& a, const Real& b, const Real& c, const plane::PieceBox& box) {
  constexpr std::int64_t kLongest = std::int64_t{1} << 40;
  if (a.sign() == 0 && b.sign() == 0) return constant(box, c.sign());
  const auto normal = plane::primitive_direction({a, b});
  if (!normal || std::max(std::abs(normal->x), std::abs(normal->y)) > kLongest) return std::nullopt;
  // From the point of the line that is nearest to the middle, so far that the box lies within.
  const double size = 4 * (box.x1 - box.x0 + box.y1 - box.y0);
  const auto times = std::int64_t(std::ceil(size / double(std::max(std::abs(normal->x), std::abs(normal->y)))));
  const std::int64_t nx = normal->x * times, ny = normal->y * times;
  plane::Contour ring;
  for (const plane::GridPoint p : {plane::GridPoint{ny, -nx}, {ny + nx, ny - nx}, {nx - ny, nx + ny}, {-ny, nx}})
    ring.push_back({p});
  const Real mx = Real::from_double((box.x0 + box.x1) / 2), my = Real::from_double((box.y0 + box.y1) / 2);
  const Real back = -(a * mx + b * my + c) / (a * a + b * b);
  const bool inside_box_reach = std::abs(near_value(back * a)) + std::abs(near_value(back * b)) < size / 4;
  if (!inside_box_reach) return constant(box, -back.sign());
  return inside_of(plane::moved(plane::region_of_rings({&ring, 1}), {mx + back * a, my + back * b}), box, 1);
}

/// sign: of the function outside.
CellComplex of_circle(const RealPoint& centre, const Real& radius, int sign, const plane::PieceBox& box) {
  if (radius.sign() < 0) return constant(box, sign);
  if (radius.sign() == 0) {
    const plane::GridPoint origin{};
    const Region point = plane::moved(plane::region_of_points({&origin, 1}), centre);
    const Region whole = filled_box(box);
    return plane::overlay(std::array<const CellComplex*, 2>{&whole, &point},
                          [sign](std::span<const Mark> m) { return Mark(m[0] > 0 && m[1] <= 0 ? sign : 0); });
  }
  return inside_of(plane::moved(plane::region_of_disc(Real(), Real(), radius), centre), box, -sign);
}

}  // namespace

plane::Region filled_box(const plane::PieceBox& box) {
  const auto x0 = std::int64_t(box.x0), y0 = std::int64_t(box.y0), x1 = std::int64_t(box.x1), y1 = std::int64_t(box.y1);
  plane::Contour ring;
  for (const plane::GridPoint p : {plane::GridPoint{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}) ring.push_back({p});
  return plane::region_of_rings({&ring, 1});
}

std::optional<plane::SignMap> sign_of_forms(std::span<const Summand> summands, std::span<const LevelCurve> curves,
                                            const Real& level, const plane::PieceBox& box) {
  Total t;
  for (std::size_t k = 0; k < summands.size(); ++k) t.add(summands[k], curves[k]);
  t.c = t.c - level;
  const bool flat = t.a.sign() == 0 && t.b.sign() == 0;
  if (t.cones.empty()) return of_line(t.a, t.b, t.c, box);
  if (!flat) return std::nullopt;  // a parabola, or more
  const Total::Cone& first = t.cones.front();
  if (t.cones.size() == 1) return of_circle(first.centre, -t.c / first.weight, first.weight.sign(), box);
  if (t.cones.size() > 2 || t.c.sign() != 0) return std::nullopt;  // a hyperbola, or more
  const Total::Cone& second = t.cones.back();
  if (first.weight.sign() == second.weight.sign()) return constant(box, first.weight.sign());
  // u |p - m| < v |p - n| has the sign of u^2 |p - m|^2 - v^2 |p - n|^2.
  const Real u = first.weight * first.weight, v = second.weight * second.weight, by = u - v;
  const RealPoint &m = first.centre, &n = second.centre;
  const int turn = first.weight.sign();
  const Real sense(turn), two(2);
  if (by.sign() == 0)
    return of_line(sense * two * u * (n.x - m.x), sense * two * u * (n.y - m.y), sense * u * (square(m) - square(n)),
                   box);
  const RealPoint centre{(u * m.x - v * n.x) / by, (u * m.y - v * n.y) / by};
  const Real radius = sqrt(square(centre) - (u * square(m) - v * square(n)) / by);
  return of_circle(centre, radius, turn * by.sign(), box);
}

}  // namespace findspace::distance
