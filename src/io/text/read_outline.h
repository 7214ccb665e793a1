// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Outlines on their way from a file to a shape: chains of segments and arcs whose points are put on the grid as they
// come, in the numbers of the source times an exact scale. An arc keeps its radius or bulge; its centre is found anew
// from the ends on the grid, so both lie exactly on it. An arc that rises less than half a grid step over its chord is
// a segment. Keywords: path builder, even-odd rule, contour.
#pragma once

#include <string>
#include <vector>

#include "io/text/read_context.h"
#include "plane/contour/shape.h"

namespace findspace::io {

/// A run of edges; when open, the last edge is only its end point.
struct Chain {
  plane::Contour edges;
  bool closed = false;
};

class Outline {
 public:
  /// Lengths are multiplied by `scale` (> 0) to be in the scene's unit.
  explicit Outline(ReadContext& context, exact::Real scale = 1) : context_(context), scale_(std::move(scale)) {}

  /// Begins a chain. A chain of one point and no edge is dropped, as SVG does.
  void move_to(const exact::Real& x, const exact::Real& y);
  void line_to(const exact::Real& x, const exact::Real& y);
  /// An arc of radius `radius` (> 0), the longer way round if `large`; nothing where it ends where it starts.
  void arc_to(const exact::Real& radius, bool large, bool ccw, const exact::Real& x, const exact::Real& y);
  /// An arc of bulge tan(angle/4), positive counter-clockwise; 0 is a segment.
  void bulge_to(const exact::Real& bulge, const exact::Real& x, const exact::Real& y);
  /// An arc through (mx, my); a full circle through it where (x, y) is the start.
  void through_to(const exact::Real& mx, const exact::Real& my, const exact::Real& x, const exact::Real& y);
  /// Closes the chain; what follows without move_to begins at its first point.
  void close();
  /// Ends the chain without closing it; it is closed all the same if it has come back to its first point.
  void finish();

  void circle(const exact::Real& x, const exact::Real& y, const exact::Real& radius);
  void point(const exact::Real& x, const exact::Real& y);

  bool empty() const { return chains_.empty() && discs_.empty() && points_.empty() && !running_; }
  /// Joins open chains whose ends are the same grid point; throws Error(kGeometry) where more than two meet.
  void join_open_chains();
  int open_chains() const;
  int chains() const { return static_cast<int>(chains_.size()); }
  /// Whether the chain in hand has come to this point.
  bool is_at(const exact::Real& x, const exact::Real& y);

  /// Closed chains and circles by even-odd nesting, each outer ring with its holes one shape, or all as one where rings
  /// touch in common corners (plane/build/touching_rings.h); then the open chains as polylines, then the points.
  /// Finishes the chain in hand. Throws Error(kGeometry).
  std::vector<plane::ShapePtr> parts(const std::string& place);
  /// The same as one shape: the part, or the union of the parts.
  plane::ShapePtr shape(const std::string& place);
  /// All chains as polylines, also those that come back to their first point, and the points.
  plane::ShapePtr lines(const std::string& place);
  /// The first closed chain as outer ring, the others as its holes.
  plane::ShapePtr polygon(const std::string& place);

 private:
  struct Disc {
    plane::GridPoint center;
    exact::Real radius;  // in grid steps
  };

  plane::GridPoint grid_point(const exact::Real& x, const exact::Real& y);
  void begin();
  void add(plane::ContourEdge edge, plane::GridPoint to);
  plane::Contour ring_of(const Disc& disc);
  std::vector<plane::Contour> take_rings();
  void add_lines_and_points(std::vector<plane::ShapePtr>& all, const std::string& place);

  ReadContext& context_;
  exact::Real scale_;
  bool running_ = false;  // a chain has edges or could get some
  plane::Contour edges_;
  plane::GridPoint start_, at_;
  std::vector<Chain> chains_;
  std::vector<Disc> discs_;
  std::vector<plane::GridPoint> points_;
};

/// The shapes as one: a single one is itself, several are a union (a collection whose parts keep their names if asked).
plane::ShapePtr united(std::vector<plane::ShapePtr> parts, const std::string& place, bool collection = false);

}  // namespace findspace::io
