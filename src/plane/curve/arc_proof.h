// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The proof that one arc or segment, from grid point to grid point, follows a stretch of a curve within a bound and, if
// asked, on one side of it.
//
// Let J be the step from the stretch's first (last) point to the arc's first (last) point, e the signed distance from
// the arc's circle, positive to the left of the arc. What is proved:
//   * every point of the stretch is within `bound` of the arc and every point of the arc within `bound` of the stretch:
//     e lies in a window, the stretch runs forward along the chord and along the circle, and J is small beside it;
//   * on a side: the closed loop of the stretch, J, the arc backwards and J backwards is simple (at most touches
//     itself) and runs round its inside in the sense that this side asks for. Chains of such arcs then never go round a
//     point fewer times than the curve does (side kLeft of a curve with its material on the right), or never more.
// Method: e, the derivative along the chord, along the circle and across J are polynomials whose Bernstein coefficients
// are computed in intervals; where these do not decide the stretch is halved, six times at most. Guarantee: true means
// proved. Cost: microseconds. Keywords: arc spline, Hausdorff distance, one-sided approximation, winding number.
#pragma once

#include <vector>

#include "plane/contour/shape.h"
#include "plane/curve/curve.h"

namespace findspace::plane {

/// Where a chain of arcs lies beside its curve, looking along it.
enum class CurveSide { kNear = 0, kLeft = 1, kRight = -1 };

/// A stretch of a curve as pieces, and what replaces it.
struct ArcClaim {
  const std::vector<CurvePiece>* stretch = nullptr;
  GridPoint origin;  // of the pieces
  ContourEdge edge;  // from edge.start ...
  GridPoint to;      // ... to here
  double bound = 0;  // grid steps
  CurveSide side = CurveSide::kNear;
  bool meets_first = false, meets_last = false;  // the stretch begins (ends) exactly where the edge does
};

/// What the window of e leaves of the bound; the rest pays for J.
inline constexpr double kWindowPart = 0.875;

bool proved(const ArcClaim& claim);

/// The box of a stretch and the two grid points, in grid steps from `origin`, rounded outwards.
struct StretchBox {
  double x0, y0, x1, y1;
  double diameter() const;
};
StretchBox box_of(const std::vector<CurvePiece>& stretch, GridPoint origin, GridPoint a, GridPoint b);

/// The part of a piece between two parameters.
CurvePiece part_of(const CurvePiece& piece, double t0, double t1);

}  // namespace findspace::plane
