// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// How a region looks: faces that belong are filled; an edge of theirs is solid where it belongs and dashed where it
// does not; curves and points without area stand out; a point that differs from the curves it ends is a full or a
// hollow dot.
#pragma once

#include <string>
#include <vector>

#include "io/draw/draw_canvas.h"

namespace findspace::io {

/// What a picture of a region contains, for its legend.
struct RegionParts {
  bool faces = false, closed_edges = false, open_edges = false, curves = false, points = false;
  bool full_dots = false, hollow_dots = false, unbounded = false;
};
RegionParts parts_of(const plane::Region& region);

/// The filled faces, to lie below; and edges, curves and points, to lie above.
std::string region_faces(const CurveNet& net, const Frame& frame);
std::string region_lines(const CurveNet& net, const Frame& frame);

/// A shape of the scene: fill and outline in the classes NAME and NAME-line, moved by `offset`.
std::string outline(const CurveNet& net, const Frame& frame, std::string_view style, const plane::Place& offset = {});

/// Shapes in one colour, as one path: where they overlap nothing is seen of it.
std::string filled(const std::vector<plane::Region>& shapes, const exact::Real& step, const Frame& frame,
                   std::string_view style);

/// The same parts for other renderers: path data, and places in the frame.
struct RegionDrawing {
  std::string faces, closed, open, free;           // path data, to thirteen digits
  std::vector<plane::Place> points, full, hollow;  // isolated points; ends that belong; ends that do not
};
RegionDrawing region_drawing(const CurveNet& net, const Frame& frame);

}  // namespace findspace::io
