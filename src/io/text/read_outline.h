// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Outlines on their way from a file to a shape: chains of segments and arcs whose points are put on the grid as they
// come, in the numbers of the source times an exact scale. An arc keeps its radius or bulge; its centre is found anew
// from the ends on the grid, so both lie exactly on it. An arc that rises less than half a grid step over its chord is
// a segment. Curves beyond arcs stay curves with their ends on the grid, until outline_shapes.h knows on which side of
// them the material lies. Keywords: path builder, even-odd rule, contour.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "io/text/ellipse_arc.h"
#include "io/text/read_context.h"
#include "plane/contour/shape.h"

namespace findspace::io {

/// A run of edges; when open, the last edge is only its end point.
struct Chain {
  plane::Contour edges;
  bool closed = false;
  std::vector<std::shared_ptr<const plane::Curve>> curves{};  // none, or one an edge: the curve that it stands for
  std::string name{};                                         // of the part that it draws, where the file says one
};

struct Disc {
  plane::GridPoint center;
  exact::Real radius;  // in grid steps
  std::string name{};
};

/// What was drawn; outline_shapes.h makes shapes of it.
struct Drawing {
  std::vector<Chain> chains;
  std::vector<Disc> discs;
  std::vector<plane::GridPoint> points;
};

class Outline {
 public:
  /// Lengths are multiplied by `scale` (> 0) to be in the scene's unit.
  explicit Outline(ReadContext& context, exact::Real scale = 1) : context_(context), scale_(std::move(scale)) {}

  /// What is drawn from here on is called so.
  void set_name(std::string name) { name_ = std::move(name); }
  const std::string& name() const { return name_; }

  /// Begins a chain. A chain of one point and no edge is dropped, as SVG does.
  void move_to(const exact::Real& x, const exact::Real& y);
  void line_to(const exact::Real& x, const exact::Real& y);
  /// An arc of radius `radius` (> 0), the longer way round if `large`; nothing where it ends where it starts.
  void arc_to(const exact::Real& radius, bool large, bool ccw, const exact::Real& x, const exact::Real& y);
  /// An arc of bulge tan(angle/4), positive counter-clockwise; 0 is a segment.
  void bulge_to(const exact::Real& bulge, const exact::Real& x, const exact::Real& y);
  /// An arc through (mx, my); a full circle through it where (x, y) is the start.
  void through_to(const exact::Real& mx, const exact::Real& my, const exact::Real& x, const exact::Real& y);
  /// A Bezier curve through these control points behind the point where the chain is; `weights`: one a point, also of
  /// the first, or none.
  void curve_to(std::span<const plane::CurvePoint> points, std::span<const exact::Real> weights = {});
  /// The arc of an ellipse that begins where the chain is and ends at (x, y).
  void ellipse_to(const EllipseArc& arc, const exact::Real& x, const exact::Real& y);
  /// A B-spline that begins where the chain is.
  void spline_to(plane::Spline spline);
  /// Closes the chain; what follows without move_to begins at its first point.
  void close();
  /// Ends the chain without closing it; it is closed all the same if it has come back to its first point.
  void finish();

  void circle(const exact::Real& x, const exact::Real& y, const exact::Real& radius);
  void ellipse(const EllipseArc& whole);
  void point(const exact::Real& x, const exact::Real& y);

  /// Whether the chain in hand has come to this point.
  bool is_at(const exact::Real& x, const exact::Real& y);
  /// Without the chain in hand.
  const Drawing& drawn() const { return drawing_; }
  /// Finishes the chain in hand and gives away what was drawn.
  Drawing take();

 private:
  plane::GridPoint grid_point(const exact::Real& x, const exact::Real& y);
  void begin();
  void add(plane::ContourEdge edge, plane::GridPoint to);
  void add(plane::Curve curve);
  void end_chain(bool closed);
  plane::CurvePoint steps(const plane::CurvePoint& p) const;
  EllipseArc steps(const EllipseArc& arc) const;

  ReadContext& context_;
  exact::Real scale_;
  std::string name_;
  bool running_ = false;  // a chain has edges or could get some
  plane::Contour edges_;
  std::vector<std::shared_ptr<const plane::Curve>> curves_;
  plane::GridPoint start_, at_;
  Drawing drawing_;
};

}  // namespace findspace::io
