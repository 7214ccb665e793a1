// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The largest rectangle along the axes that the last sheet of a layout has left: it keeps the gap of all parts and lies
// on the sheet, outside its holes. Guarantee: what is returned is free by exact signs, and no side of it can move
// outwards (of parts with arcs: of polygons about them). None is larger where all edges run along the axes, there is no
// gap and there are no more than 1000 lines of corners each way; else it is the largest of a grid of such lines.
// Cost: that grid, some milliseconds. Source: largest rectangle under a histogram, row by row.
// Keywords: offcut, remnant, largest empty rectangle.
#pragma once

#include <optional>

#include "packing/problem/problem.h"

namespace findspace::packing {

struct Remnant {
  std::size_t sheet = 0;  // of the layout
  Fraction x, y, width, height;
};

/// Of a feasible layout on sheets; nothing where nothing is left, or the layout is not on sheets.
std::optional<Remnant> largest_remnant(const Problem& problem, const Layout& layout);

}  // namespace findspace::packing
