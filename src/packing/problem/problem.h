// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Packing problems and layouts as values. A strip lies at 0 <= y <= height and 0 <= x <= length; its length is sought.
// Parts are closed polygons with holes on a decimal grid: coordinates are integers of 10^-digits. A point q of a part
// goes to at + R(angle) M q: M turns x into -x where mirrored, R turns counter-clockwise about the part's origin.
// Where an angle is no multiple of 90 degrees the turned part has its vertices rounded to the grid, and is exact from
// there on. Keywords: irregular strip packing, nesting, open dimension problem.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "exact/planar/lattice_signs.h"
#include "packing/problem/fraction.h"

namespace findspace::packing {

using exact::LatticePoint;
using Ring = std::vector<LatticePoint>;

/// A closed set: the outer ring counter-clockwise, holes clockwise, no repeated points.
struct Polygon {
  std::vector<Ring> rings;
};

struct LatticeBox {
  LatticePoint low, high;
};
/// The least box about a polygon.
LatticeBox box_of(const Polygon& shape);

struct Part {
  std::string name;
  int demand = 1;
  Polygon shape;
  std::vector<Fraction> angles = {0};  // degrees
};

struct Problem {
  std::string name;
  int digits = 0;  // the grid: steps of 10^-digits
  Fraction height;
  std::vector<Part> parts;
  Fraction gap;   // the least distance of any two parts; at 0 they may touch
  Fraction edge;  // the least distance of a part to the sides of the strip, its ends among them

  int128 steps() const { return power_of_ten(digits); }  // in a unit
  std::size_t items() const;                             // the sum of demands
};

struct Placed {
  std::size_t part = 0;
  int copy = 1;
  Fraction angle;
  bool mirrored = false;
  Fraction x, y;
};

struct LeftOut {
  std::size_t part = 0;
  int copies = 0;
  std::string why;
};

struct Layout {
  Fraction length;
  std::vector<Placed> items;
  std::vector<LeftOut> left_out;
};

/// The outline as a polygon of the grid: directions made right, repeated points dropped. Throws Error(kGeometry) where
/// a ring crosses itself or encloses nothing.
Polygon make_polygon(std::vector<Ring> rings, const std::string& place);

/// Whether the angle is a multiple of 90 degrees, which keeps the grid.
bool is_quarter(const Fraction& angle);

/// The part turned by an angle and mirrored before, on the grid.
Polygon turned(const Polygon& shape, const Fraction& angle, bool mirrored);

/// Twice the area, in grid steps.
double twice_area(const Polygon& shape);
/// The area of all copies, in square units.
double area(const Problem& problem);

}  // namespace findspace::packing
