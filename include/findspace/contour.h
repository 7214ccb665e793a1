// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Rings and chains of segments and circular arcs, drawn point by point. An arc stays an arc. Its ends are put on the
// grid, and its centre is found anew from them, so both ends lie exactly on its circle. Cost: that of copying numbers;
// nothing is computed before a shape is made of it. Keywords: path, bulge, polyline with arcs, curve polygon.
#pragma once

#include <utility>
#include <vector>

#include "findspace/number.h"

namespace findspace {

class Contour {
 public:
  /// Where the ring or chain begins.
  explicit Contour(Point start) : start_(std::move(start)) {}

  /// A segment to a point.
  Contour& line_to(Point end);
  /// The arc of bulge tan(angle / 4), counter-clockwise where it is positive, as in DXF; 0 is a segment.
  Contour& bulge_to(Number bulge, Point end);
  /// The arc through a third point; a segment where all are on one line.
  Contour& arc_through(Point middle, Point end);
  /// The arc about a centre, counter-clockwise or clockwise, to a point as far from it as the one before.
  Contour& arc_about(Point center, Point end, bool counterclockwise = true);

  /// One segment or arc.
  struct Step {
    /// How it gets to its end.
    enum class Kind { kLine, kBulge, kThrough, kAboutLeft, kAboutRight };
    /// As its makers say.
    Kind kind;
    Point end, by;  // `by`: the bulge as x, the third point, or the centre
  };
  /// Where it begins.
  const Point& start() const { return start_; }
  /// What follows, in order.
  const std::vector<Step>& steps() const { return steps_; }

 private:
  Point start_;
  std::vector<Step> steps_;
};

}  // namespace findspace
