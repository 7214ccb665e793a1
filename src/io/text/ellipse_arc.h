// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Elliptical arcs as the formats give them, as a frame and angles (plane/curve/curve.h). The frame is found in doubles:
// it is the ellipse that is read, at most a few roundings from the one that was meant. Source: SVG 1.1, F.6.
#pragma once

#include "plane/curve/curve.h"

namespace findspace::io {

struct EllipseArc {
  plane::EllipseFrame frame;
  double first = 0, sweep = 0;  // radians
};

/// The arc of SVG from (x0, y0) to (x1, y1): radii rx, ry > 0, axes turned by `degrees`; radii that are too small grow.
struct SvgArc {
  double x0, y0, rx, ry, degrees;
  bool large, sweep;
  double x1, y1;
};
EllipseArc ellipse_arc(const SvgArc& arc);

/// The circular arc of this bulge, as an arc of an ellipse.
EllipseArc bulge_ellipse(double x0, double y0, double bulge, double x1, double y1);

/// The point of the arc's ellipse at the angle `turn` beyond its first.
plane::CurvePoint ellipse_point(const EllipseArc& arc, double turn);

/// A whole ellipse with its axes along x and y.
EllipseArc whole_ellipse(const exact::Real& x, const exact::Real& y, const exact::Real& rx, const exact::Real& ry);

}  // namespace findspace::io
