// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Packing problems and layouts as values. A strip lies at 0 <= y <= height and 0 <= x <= length; its length is sought.
// Sheets have a box from (0, 0) on, an outline in it, and zones that some parts may not enter. Of sheets the fewest are
// sought, the last as empty as possible; where they cannot hold all parts, the most valuable choice of parts.
// Parts are closed polygons with holes on a decimal grid: coordinates are integers of 10^-digits. A point q of a part
// goes to at + R(angle) M q: M turns x into -x where mirrored, R turns counter-clockwise about the part's origin.
// Where an angle is not a multiple of 90 degrees the turned part has its vertices rounded to the grid, and is exact
// from there on. Parts with arcs stay exact sets (round_part.h). Keywords: irregular strip packing, nesting, open
// dimension problem.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "exact/planar/lattice_signs.h"
#include "packing/problem/fraction.h"
#include "packing/problem/left_out.h"
#include "packing/problem/pair_condition.h"

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

class RoundPart;

struct Part {
  std::string name;
  int demand = 1;
  Polygon shape;                                // of a round part one about it
  std::vector<Fraction> angles = {0};           // degrees
  bool mirrored = false;                        // whether it may be turned over as well
  std::optional<Fraction> value = {};           // of a copy, where not all fit; without it its area
  std::shared_ptr<const RoundPart> round = {};  // the part itself, where that is not one polygon of the grid
  Fraction tilt = {};                           // degrees by which a copy may be off one of the angles

  /// The nearest of `angles`, and how many degrees off it the given one is, from -180 to 180.
  struct Off {
    std::size_t angle = 0;
    Fraction by;
  };
  Off nearest_angle(const Fraction& angle) const;
  bool allows(const Fraction& angle, bool is_mirrored) const;
};

/// What parts of some kinds, or of all, may not enter; or may not leave.
struct Zone {
  Polygon shape;
  std::vector<std::size_t> parts;               // that it keeps out, or
  bool holds = false;                           // that it holds: they lie within it
  std::shared_ptr<const RoundPart> round = {};  // as of a part
  std::shared_ptr<const RoundPart> about = {};  // of a round one that holds parts: what is about it
};

struct Sheet {
  std::string name;
  int count = 1;                 // how many there are
  std::optional<Fraction> cost;  // of one: cheap ones for their area are used first; else they are used in order
  Polygon shape;                 // its outline and holes; the box begins at (0, 0)
  std::vector<Zone> zones = {};
  std::shared_ptr<const RoundPart> round = {};  // as of a part
  std::shared_ptr<const RoundPart> about = {};  // of a round one: what is about it, and its holes
};
LatticeBox box_of(const Sheet& sheet);

struct Placed {
  std::size_t part = 0;
  int copy = 1;
  Fraction angle;
  bool mirrored = false;
  Fraction x, y;
  std::size_t sheet = 0;  // of the layout's
};

/// A copy that stands where it stands: `placed.sheet` counts the sheets of this kind. It is one of the part's demand.
struct FixedPart {
  Placed placed;
  std::size_t kind = 0;
};

struct Problem {
  std::string name;
  int digits = 0;             // the grid: steps of 10^-digits
  Fraction height;            // of a strip
  std::vector<Sheet> sheets;  // instead of a strip, or
  bool box = false;           // a rectangle of the least area, whose height is sought as well
  std::vector<Part> parts;
  Fraction gap;   // the least distance of any two parts; at 0 they may touch
  Fraction edge;  // the least distance of a part to the sides of the strip, its ends among them; to a sheet's outline
  std::vector<PairGap> pair_gaps;
  std::vector<PairCondition> conditions;
  std::vector<FixedPart> fixed;

  bool on_sheets() const { return !sheets.empty(); }
  /// Or sheets or zones.
  bool has_round_parts() const;
  /// How many copies are to be placed: the fixed ones stand already.
  int free_copies(std::size_t part) const;
  /// The least distance of copies of two parts.
  Fraction gap_of(std::size_t first, std::size_t second) const { return widest_gap(gap, pair_gaps, first, second); }

  int128 steps() const { return power_of_ten(digits); }  // in a unit
  std::size_t items() const;                             // the sum of demands
};

struct Layout {
  Fraction length;  // of the strip; of the last sheet what is used, its edge included
  std::vector<Placed> items;
  std::vector<LeftOut> left_out;
  std::vector<std::size_t> sheets = {};  // the kind of each sheet that is used
  Fraction height = {};                  // of the box, where one is sought
};

/// How many sheets of a kind hold fixed parts.
std::size_t sheets_with_fixed(const Problem& problem, std::size_t kind);
/// Whether a copy of the layout is that fixed part.
bool is_fixed_part(const Layout& layout, const Placed& item, const FixedPart& fixed);

/// The outline as a polygon of the grid: directions made right, repeated points dropped. Throws Error(kGeometry) where
/// a ring crosses itself or encloses nothing.
Polygon make_polygon(std::vector<Ring> rings, const std::string& place);

/// Whether the angle is a multiple of 90 degrees, which keeps the grid.
bool is_quarter(const Fraction& angle);

/// The part turned by an angle and mirrored before, on the grid.
Polygon rotated(const Polygon& shape, const Fraction& angle, bool mirrored);

/// The same of a part, and the least box of the grid about it. Of a round part the polygon is one about it.
Polygon rotated(const Part& part, const Fraction& angle, bool mirrored);
LatticeBox box_of(const Part& part, const Fraction& angle, bool mirrored);

/// What of the plane is not a place for a part on this sheet: a frame about the outline, unless that is a rectangle,
/// and each hole. Each is a part that does not move.
std::vector<Part> obstacles_of(const Problem& problem, const Sheet& sheet);
/// What the parts of a zone may not enter: the zone, or what is not the zone.
std::vector<Part> walls_of(const Problem& problem, const Sheet& sheet, const Zone& zone);
/// As wide as a frame about a sheet is: all parts of it that its edge can reach.
Polygon box_about(const Problem& problem, const LatticeBox& box);

/// Twice the area, in grid steps.
double twice_area(const Polygon& shape);
double twice_area(const Part& part);
double twice_area(const Sheet& sheet);
/// The area of all copies, and of those in a layout, in square units.
double area(const Problem& problem);
double area(const Problem& problem, const Layout& layout);
/// Of the strip or box.
inline const Fraction& height_of(const Problem& problem, const Layout& layout) {
  return problem.box ? layout.height : problem.height;
}
/// Where the highest item ends, the edge above it included.
Fraction top_of(const Problem& problem, const Layout& layout);
/// What a layout's container holds: the strip up to its length; its sheets, the last up to what is used of it.
double container_area(const Problem& problem, const Layout& layout);

}  // namespace findspace::packing
