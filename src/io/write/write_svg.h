// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Pictures in SVG. A map shows the region of positions among the fixed shapes, with the moving shape at one position,
// frame, scale bar and legend; arcs are true arcs, an unbounded region is cut off at the frame and said to be so. A
// shape alone is written as a drawing in its unit, which reads back as the same shape. Keywords: vector graphics, plot,
// drawing, export.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "formula/language/units.h"
#include "io/draw/draw_arrows.h"
#include "io/draw/draw_dimensions.h"
#include "plane/query/summary.h"

namespace findspace::io {

struct NamedRegion {
  std::string name;
  const plane::Region* region = nullptr;
  bool behind = false;  // of a board: on its other side
};

/// What is filled in one colour: the copper of some layers, or the holes.
struct CopperLayer {
  std::string style;  // its class
  std::string text;   // in the legend; none: left out there
  std::vector<plane::Region> regions;
};

struct Picture {
  std::string title, subtitle;
  std::string panel;                                   // of several in one drawing: a name of its own for its frame
  exact::Real step;                                    // one grid step in the scene's unit
  std::string unit;                                    // its name, or empty
  const plane::Region* region = nullptr;               // the region, if there is one
  const plane::Summary* summary = nullptr;             // of the region
  const plane::Region* around = nullptr;               // positions of which the region is a part, drawn faintly
  std::string around_text = "all feasible positions";  // in the legend
  bool of_positions = true;                            // the region is one of positions; else it is a shape
  std::vector<CopperLayer> copper;                     // of a board, the lowest first, behind all else
  std::vector<NamedRegion> fixed;                      // in outline
  std::vector<NamedRegion> moving;                     // drawn at `position`
  std::vector<NamedRegion> rotated;                    // there too, rotated by the angle that is its name
  std::vector<NamedRegion> placed;                     // as `moving`, each where its region says
  std::string placed_text = "placed";                  // of them in the legend, with their number
  std::string placed_style = "moving";                 // their class
  std::vector<Arrow> arrows;                           // how they move
  std::vector<DimensionLine> dimensions;               // distances at `position`
  std::optional<plane::Place> nearest;                 // another position of `moving`, in dashes
  std::string nearest_text;                            // of it, in the legend
  bool y_down = false;                                 // the y axis runs downwards
  bool small_names = false;                            // a name may be small, so that it stands in its shape
  plane::Place home{};                                 // where `moving` is drawn if the region is empty
  std::optional<plane::Place> position;                // none: the sample of the region's largest component
};

std::string picture_svg(const Picture& picture);

/// The same with its size, in pixels.
struct SvgDrawing {
  std::string svg;
  double width, height;
};
SvgDrawing picture_drawing(const Picture& picture);

struct DrawingText {
  std::string text;
  std::string lost;  // what it does not say of the region, for people; empty if nothing
};

/// The region alone: a group of a path a face and a path a free curve, in the scene's unit, y turned down as SVG has
/// it. Throws Error(kUnsupported) for an unbounded region.
DrawingText shape_svg(const plane::Region& region, const exact::Real& step, std::string_view name,
                      std::optional<formula::Unit> unit);

}  // namespace findspace::io
