// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Dimension lines: the two places that attain a distance, joined, with its value beside the middle; a distance that
// breaks its condition in red. Two places that are one are a ring. Keywords: witness, closest features, annotation.
#pragma once

#include <string>
#include <vector>

#include "io/draw/draw_canvas.h"
#include "io/draw/draw_layout.h"
#include "io/draw/draw_legend.h"

namespace findspace::io {

struct DimensionLine {
  plane::Place from, to;
  std::string text;
  bool fails = false;
  double font = kFontSize;  // of its text
};

/// Lines given twice are drawn once, as failing if one of them is.
std::vector<DimensionLine> without_repetition(std::vector<DimensionLine> all);
std::string dimension_lines(const std::vector<DimensionLine>& all, const Frame& frame);
/// The middle of each one's text, in pixels: beside its line, clear of the others where there is space.
std::vector<plane::Place> text_places(const std::vector<DimensionLine>& all, const Frame& frame);
/// One entry for each kind there is.
std::vector<LegendEntry> dimension_entries(const std::vector<DimensionLine>& all);

}  // namespace findspace::io
