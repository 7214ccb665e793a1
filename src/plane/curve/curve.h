// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Curves of drawings beyond arcs: Bezier curves of any degree, rational ones, elliptical arcs, B-splines and NURBS, all
// as one kind of thing: a chain of rational Bezier pieces. curve_arcs.h makes chains of circular arcs of them.
// Guarantee: every control point is enclosed by intervals; the two ends lie on the grid, where the caller has put them.
// Cost: O(degree^2) a piece. Source: Piegl and Tiller, "The NURBS Book" (1997).
// Keywords: Bezier, NURBS, knot insertion, blossom, conic section.
#pragma once

#include <span>
#include <vector>

#include "exact/number/real.h"
#include "plane/contour/shape.h"
#include "plane/curve/bernstein.h"

namespace findspace::plane {

/// x/w, y/w in grid steps from the curve's first point; `w` is empty where it is 1 throughout.
struct CurvePiece {
  IntervalPolynomial x, y, w;
  std::size_t degree() const { return x.size() - 1; }
};

struct Curve {
  GridPoint from, to;
  std::vector<CurvePiece> pieces;  // at least one; each begins where the one before ends
};

/// A point, or a vector, in grid steps.
struct CurvePoint {
  exact::Real x, y;
};

/// The Bezier curve of these control points, of which the first and the last are put at `from` and `to`. `weights`: one
/// a point, more than 0, or none. Throws Error: kUnsupported beyond degree 25, kBadValue for a weight.
Curve bezier_curve(std::span<const CurvePoint> points, std::span<const exact::Real> weights, GridPoint from,
                   GridPoint to);

/// The points center + u cos a + v sin a.
struct EllipseFrame {
  CurvePoint center, u, v;
};
/// The arc of an ellipse from angle `first` on by `sweep` radians, of either sign, at most 2 pi.
Curve ellipse_curve(const EllipseFrame& frame, double first, double sweep, GridPoint from, GridPoint to);

/// A B-spline, rational with `weights`: knots ascend, one more than points and degree together. It runs over the knots
/// degree to points.
struct Spline {
  std::size_t degree = 3;
  std::vector<exact::Real> knots;
  std::vector<CurvePoint> points;
  std::vector<exact::Real> weights;  // none, or one a point, more than 0
};
/// Throws Error(kBadValue) where numbers of knots, points and weights do not fit, knots descend, a weight is not above
/// 0 or the spline jumps (at a knot that comes more than `degree` times), kUnsupported beyond degree 25.
void check_spline(const Spline& spline);
/// Its first (or last) point, exactly.
CurvePoint spline_end(const Spline& spline, bool last);
Curve spline_curve(const Spline& spline, GridPoint from, GridPoint to);

/// The same control points but for the two ends, which move to these grid points.
Curve with_ends(Curve curve, GridPoint from, GridPoint to);

/// The same curve the other way round.
Curve reversed(const Curve& curve);

}  // namespace findspace::plane
