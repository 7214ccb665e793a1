// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// SVG path data, read exactly: `M L H V A C S Q T Z` in absolute and relative form, with implicit repetition and arc
// flags without separators. The frame of an elliptical arc is found in doubles. Source: SVG 1.1, chapter 8.3.
#pragma once

#include <span>
#include <string_view>

#include "exact/number/real.h"
#include "io/text/ellipse_arc.h"

namespace findspace::io {

/// Takes the commands of a path with absolute coordinates.
class PathSink {
 public:
  virtual ~PathSink() = default;
  virtual void move_to(const exact::Real& x, const exact::Real& y) = 0;
  virtual void line_to(const exact::Real& x, const exact::Real& y) = 0;
  /// radius > 0; `sweep`: the angle grows from the x axis towards the y axis.
  virtual void arc_to(const exact::Real& radius, bool large, bool sweep, const exact::Real& x,
                      const exact::Real& y) = 0;
  /// Control points of a Bezier curve behind the point where the path is.
  virtual void curve_to(std::span<const plane::CurvePoint> points) = 0;
  virtual void ellipse_to(const EllipseArc& arc, const exact::Real& x, const exact::Real& y) = 0;
  virtual void close() = 0;
};

/// Throws Error with the place "character N" (from 1), also for errors of the sink.
void read_svg_path(std::string_view data, PathSink& sink);

}  // namespace findspace::io
