// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/build/transform.h"

#include <cmath>
#include <utility>

#include "exact/planar/geometry_signs.h"
#include "findspace/error.h"
#include "plane/build/transform_grid.h"
#include "plane/complex/marked_curves.h"
#include "plane/sum/minkowski.h"

namespace findspace::plane {
namespace {

using exact::Geometry;
using exact::int128;
using exact::Real;
using exact::SupportingCurve;

constexpr double kGridLimit = 0x1p40;  // no sign: the size of the grid

void check_range(const CellComplex& c) {
  for (Index v = 0; v < c.vertices.size(); ++v) {
    const exact::Point& p = c.point(v);
    if (std::abs(p.x) - p.error <= kGridLimit && std::abs(p.y) - p.error <= kGridLimit) continue;
    throw Error(ErrorCode::kOutOfRange, "a moved shape leaves the grid: a coordinate exceeds 2^40 grid steps");
  }
}

SupportingCurve shifted(const SupportingCurve& k, const GridPoint& by) {
  if (k.circle) {
    return k.grid ? SupportingCurve::circle_at(k.a + by.x, k.b + by.y, k.w)
                  : SupportingCurve::circle_at(k.real->x + Real(by.x), k.real->y + Real(by.y), k.w);
  }
  int128 step = int128(k.a) * by.x + int128(k.b) * by.y;
  return k.real ? SupportingCurve::line(k.a, k.b, k.real->x + Real(step))
                : SupportingCurve::displaced_line(k.a, k.b, k.c + step, k.w);
}

/// The line or circle rotated by 90 degrees about the origin; `flipped` where the line's direction is the opposite one.
SupportingCurve quarter_rotated(const SupportingCurve& k, bool& flipped) {
  flipped = false;
  if (k.circle) {
    return k.grid ? SupportingCurve::circle_at(-k.b, k.a, k.w) : SupportingCurve::circle_at(-k.real->y, k.real->x, k.w);
  }
  std::int64_t a = -k.b, b = k.a;
  flipped = exact::make_primitive(a, b) < 0;
  if (k.real) return SupportingCurve::line(a, b, flipped ? -k.real->x : k.real->x);
  return flipped ? SupportingCurve::displaced_line(a, b, -k.c, -k.w) : SupportingCurve::displaced_line(a, b, k.c, k.w);
}

/// The points and supporting curves rotated by 90 degrees about the origin, in the same order.
Geometry quarter_rotated(const Geometry& g) {
  Geometry to;
  std::vector<char> flipped;
  for (const SupportingCurve& k : g.supporting_curves) {
    bool flip = false;
    to.add(quarter_rotated(k, flip));
    flipped.push_back(flip);
  }
  for (const exact::Point& p : g.points) {
    if (p.kind == exact::Point::Kind::kGrid) {
      to.add_grid_point(-p.gy, p.gx);
    } else if (p.kind == exact::Point::Kind::kReal) {
      to.add_real_point(-g.reals[p.i].y, g.reals[p.i].x);
    } else {
      to.add_crossing(p.i, p.j, flipped[p.i] != flipped[p.j] ? -p.root : p.root);
    }
  }
  return to;
}

/// By 90 degrees counter-clockwise about the origin. Circles are cut at other places, so the complex is made anew.
CellComplex quarter_turn(const CellComplex& c) {
  MarkedCurves to(c.faces[0].mark);
  to.curves.geometry = quarter_rotated(c.geometry);
  for (Index e = 0; e < c.edges.size(); ++e) {
    const Edge& edge = c.edges[e];
    Index p = c.vertices[edge.v0].point, q = c.vertices[edge.v1].point;
    if (edge.half == 0)
      to.curves.segment(edge.supporting_curve, p, q, compare_xy(to.curves.geometry, p, q) < 0);
    else
      to.curves.arc(edge.supporting_curve, p, q, edge.half < 0);
    to.mark({edge.mark, c.faces[c.face(2 * e)].mark, c.faces[c.face(2 * e + 1)].mark});
  }
  for (const Vertex& v : c.vertices) {
    if (v.out == kNone)
      to.add_isolated(v.point, v.mark, c.faces[v.face].mark);
    else
      to.add_vertex(v.point, v.mark);
  }
  return std::get<CellComplex>(std::move(to).complex());
}

}  // namespace

CellComplex translated(CellComplex c, const GridPoint& by) {
  Geometry moved;
  for (const SupportingCurve& k : c.geometry.supporting_curves) moved.add(shifted(k, by));
  for (const exact::Point& p : c.geometry.points) {
    if (p.kind == exact::Point::Kind::kGrid) {
      moved.add_grid_point(p.gx + by.x, p.gy + by.y);
    } else if (p.kind == exact::Point::Kind::kReal) {
      const exact::RealPoint& r = c.geometry.reals[p.i];
      moved.add_real_point(r.x + Real(by.x), r.y + Real(by.y));
    } else {
      moved.add_crossing(p.i, p.j, p.root);  // supporting curves keep their order and direction, so roots stay
    }
  }
  c.geometry = std::move(moved);
  check_range(c);
  return c;
}

CellComplex rotated(const CellComplex& c, const GridPoint& about, const Real& degrees, double step,
                    Rounding& rounding) {
  int128 quarters = exact::floor(degrees / Real(90));
  Real rest = degrees - Real(quarters) * Real(90);
  int turns = int(((quarters % 4) + 4) % 4);
  if (rest.sign() != 0) {
    CellComplex result = rotated_on_grid(c, about, turns, rest, step, rounding);
    check_range(result);
    return result;
  }
  // About the origin, then the centre is moved back to where it was.
  const std::int64_t x = about.x, y = about.y;
  switch (turns) {
    case 1:
      return translated(quarter_turn(c), {x + y, y - x});
    case 2:
      return translated(mirrored(c), {2 * x, 2 * y});
    case 3:
      return translated(mirrored(quarter_turn(c)), {x - y, y + x});
    default:
      return c;
  }
}

}  // namespace findspace::plane
