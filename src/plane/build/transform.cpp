// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/build/transform.h"

#include <utility>

#include "exact/planar/geometry_signs.h"
#include "findspace/error.h"
#include "plane/build/transform_grid.h"
#include "plane/complex/extent.h"
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
  if (!is_within(c, kGridLimit))
    throw Error(ErrorCode::kOutOfRange, "a moved shape leaves the grid: a coordinate exceeds 2^40 grid steps");
}

SupportingCurve shifted(const SupportingCurve& k, const GridPoint& by) {
  if (k.circle) {
    return k.grid ? SupportingCurve::circle_at(k.a + by.x, k.b + by.y, k.reals)
                  : SupportingCurve::circle_at(k.real()->x + Real(by.x), k.real()->y + Real(by.y), k.w());
  }
  int128 step = int128(k.a) * by.x + int128(k.b) * by.y;
  return k.real() ? SupportingCurve::line(k.a, k.b, k.real()->x + Real(step))
                  : SupportingCurve::displaced_line(k.a, k.b, k.c + step, k.reals);
}

/// What takes a set to another one: a rotation by 90 degrees about the origin, or the reflection in the y axis.
enum class Isometry { kQuarterTurn, kMirror };

template <class Number>
std::pair<Number, Number> image(Isometry by, const Number& x, const Number& y) {
  return by == Isometry::kMirror ? std::pair(-x, y) : std::pair(-y, x);
}

/// The line or circle moved; `flipped` where the line's direction is the opposite one.
SupportingCurve image(Isometry by, const SupportingCurve& k, bool& flipped) {
  flipped = false;
  if (k.circle) {
    if (!k.grid) {
      const auto [x, y] = image(by, k.real()->x, k.real()->y);
      return SupportingCurve::circle_at(x, y, k.w());
    }
    const auto [x, y] = image(by, k.a, k.b);
    return SupportingCurve::circle_at(x, y, k.reals);
  }
  auto [a, b] = image(by, k.a, k.b);
  flipped = exact::make_primitive(a, b) < 0;
  if (k.real()) return SupportingCurve::line(a, b, flipped ? -k.real()->x : k.real()->x);
  return flipped ? SupportingCurve::displaced_line(a, b, -k.c, -k.w())
                 : SupportingCurve::displaced_line(a, b, k.c, k.reals);
}

/// The points and supporting curves moved, in the same order. A reflection takes what is left of a curve to its right.
Geometry image(Isometry by, const Geometry& g) {
  Geometry to;
  std::vector<char> flipped;
  for (const SupportingCurve& k : g.supporting_curves) {
    bool flip = false;
    to.add(image(by, k, flip));
    flipped.push_back(flip);
  }
  for (const exact::Point& p : g.points) {
    if (p.kind == exact::Point::Kind::kGrid) {
      const auto [x, y] = image(by, p.gx, p.gy);
      to.add_grid_point(x, y);
    } else if (p.kind == exact::Point::Kind::kReal) {
      const auto [x, y] = image(by, g.reals[p.i].x, g.reals[p.i].y);
      to.add_real_point(x, y);
    } else {
      const bool other = (flipped[p.i] != flipped[p.j]) != (by == Isometry::kMirror);
      to.add_crossing(p.i, p.j, other ? -p.root : p.root);
    }
  }
  return to;
}

/// Circles are cut at other places, or from the other end, so the complex is made anew.
CellComplex image(Isometry by, const CellComplex& c) {
  const bool mirror = by == Isometry::kMirror;
  MarkedCurves to(c.faces[0].mark);
  to.curves.geometry = image(by, c.geometry);
  for (Index e = 0; e < c.edges.size(); ++e) {
    const Edge& edge = c.edges[e];
    Index p = c.vertices[edge.v0].point, q = c.vertices[edge.v1].point;
    if (edge.half == 0)
      to.curves.segment(edge.supporting_curve, p, q, compare_xy(to.curves.geometry, p, q) < 0);
    else
      to.curves.arc(edge.supporting_curve, p, q, (edge.half < 0) != mirror);
    const Mark left = c.faces[c.face(2 * e)].mark, right = c.faces[c.face(2 * e + 1)].mark;
    to.mark({edge.mark, mirror ? right : left, mirror ? left : right});
  }
  for (const Vertex& v : c.vertices) {
    if (v.out == kNone)
      to.add_isolated(v.point, v.mark, c.faces[v.face].mark);
    else
      to.add_vertex(v.point, v.mark);
  }
  return std::get<CellComplex>(std::move(to).complex());
}

CellComplex quarter_turn(const CellComplex& c) { return image(Isometry::kQuarterTurn, c); }

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

CellComplex mirrored_in_y_axis(const CellComplex& c) { return image(Isometry::kMirror, c); }

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
