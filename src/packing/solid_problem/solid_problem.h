// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Packing problems and layouts in space as values. A container stands on the floor 0 <= x <= width, 0 <= y <= depth,
// 0 <= z; the height that it needs is sought. Or there are containers of given sizes: of these the fewest are sought,
// the last as low as possible; where they cannot hold all parts, the most valuable choice of parts. A container is a
// box, or a solid of its own. Parts are unions of convex polytopes and balls, or what closed meshes
// enclose, on a decimal grid: coordinates are integers of 10^-digits. A part stands in one of its forms, which are its
// shape turned by rotations of rational entries: a point q of the shape goes to at + R q, exactly. Where the convex
// parts of a mesh had to be rounded (convex_parts.h), they serve the search; proofs take the surface. Keywords: open
// dimension problem, three-dimensional strip packing, container loading, irregular packing.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "packing/problem/fraction.h"
#include "packing/problem/left_out.h"
#include "packing/problem/pair_condition.h"
#include "space/body/body.h"
#include "space/convolution/ray_solids.h"
#include "space/shape/rotation.h"

namespace findspace::packing {

/// Rows of an orthogonal matrix of determinant 1.
using SolidRotation = std::array<std::array<Fraction, 3>, 3>;
/// That which turns nothing.
SolidRotation as_given();
/// Those that take axes to axes: all 24, or the four about the z axis.
std::vector<SolidRotation> axis_rotations(bool upright);

/// A shape as it can stand.
struct SolidForm {
  SolidRotation rotation = as_given();
  space::Body body;                           // polytopes without radius, and balls
  std::vector<space::RaySolid> surface = {};  // the boundary of what they stand for; may be missing where exact
  std::int64_t surface_scale = 1;             // its coordinates are in grid steps / surface_scale

  bool is_exact() const { return body.rounded == 0; }
  bool has_balls() const { return body.round(); }
};
/// A form that is as given, turned. Throws Error(kOutOfRange) where its corners have too many digits then.
SolidForm turned(const SolidForm& form, const SolidRotation& rotation);

struct SolidPart {
  std::string name;
  int demand = 1;
  std::vector<SolidForm> forms;        // at least one
  bool disjoint = true;                // no two convex parts of a form overlap
  std::optional<Fraction> value = {};  // of a copy, where not all fit; without it its volume
  // Where they may overlap: of the polytopes of a form together, in cubic grid steps.
  std::optional<exact::Real> flat_volume = {};
};

/// From (0, 0, 0) to (width, depth, height).
struct SolidContainer {
  std::string name;
  int count = 1;                 // how many there are
  std::optional<Fraction> cost;  // of one: cheap ones for their volume are used first; else they are used in order
  Fraction width, depth, height;
  // What it holds where it is not its box (container_shape.h): what one surface encloses, or what all of some balls do,
  // or convex parts; and what those balls, or the box of the parts, have and the container lacks.
  std::shared_ptr<const SolidForm> inside = {};
  std::shared_ptr<const SolidForm> lacks = {};
};

struct SolidPlaced {
  std::size_t part = 0;
  int copy = 1;
  std::size_t form = 0;  // of the part's
  std::array<Fraction, 3> at;
  std::size_t container = 0;  // of the layout's
};

/// A copy that stands already, on the floor or in a container.
struct FixedSolid {
  SolidPlaced placed;    // `container` counts those of the kind; the copy's number is not used
  std::size_t kind = 0;  // of container
};

/// Low and high corners in units.
struct SolidBox {
  std::array<Fraction, 3> low, high;
};

struct SolidProblem {
  std::string name;
  int digits = 0;         // the grid: steps of 10^-digits
  Fraction width, depth;  // of the floor, along x and y, or
  std::vector<SolidContainer> containers = {};
  Fraction gap;   // the least distance of any two parts; at 0 they may touch
  Fraction edge;  // the least distance of a part to the walls, the floor and the lid
  std::vector<SolidPart> parts;
  std::vector<PairGap> pair_gaps = {};
  std::vector<PairCondition> conditions = {};
  std::vector<FixedSolid> fixed = {};

  bool in_containers() const { return !containers.empty(); }
  /// Whether there is a condition between copies of two parts.
  bool are_tied(std::size_t first, std::size_t second) const { return are_between(conditions, first, second); }
  /// The least distance of copies of two parts, and the widest of all.
  Fraction gap_of(std::size_t first, std::size_t second) const { return widest_gap(gap, pair_gaps, first, second); }
  Fraction widest_gap_of_all() const;
  int128 steps() const { return power_of_ten(digits); }  // in a unit
  std::size_t items() const;                             // the sum of demands
  /// How many copies are to be placed: the fixed ones stand already.
  int free_copies(std::size_t part) const;
};

struct SolidLayout {
  Fraction height;  // of the last container what is used, its edge included
  std::vector<SolidPlaced> items;
  std::vector<LeftOut> left_out = {};
  std::vector<std::size_t> containers = {};  // the kind of each that is used
  Fraction lower_bound = 0;                  // no layout is lower: what a search has proved
};

/// How many containers of a kind hold fixed solids.
std::size_t containers_with_fixed(const SolidProblem& problem, std::size_t kind);
/// Whether a copy of the layout is that fixed solid.
bool is_fixed_solid(const SolidLayout& layout, const SolidPlaced& item, const FixedSolid& fixed);
/// Whether it is one of them.
bool is_fixed_solid(const SolidProblem& problem, const SolidLayout& layout, const SolidPlaced& item);
/// The fixed solids alone, in the containers that hold them.
SolidLayout layout_of_fixed(const SolidProblem& problem);

/// The scale at which two bodies have whole coordinates both, where that is in range.
std::optional<std::int64_t> common_scale(const space::Body& a, const space::Body& b);
/// A whole number of units or a part of one, in steps of which `steps` are a unit.
exact::Real in_steps(const Fraction& value, int128 steps);
/// The least box about the form, in units.
SolidBox box_of(const SolidProblem& problem, const SolidForm& form);
inline const SolidForm& form_of(const SolidProblem& problem, const SolidPlaced& item) {
  return problem.parts[item.part].forms[item.form];
}
/// Whether it stands on the floor within the edges, or in a container.
bool fits(const SolidProblem& problem, const SolidBox& box);
/// The forms of a part: its shape turned by each rotation. Throws Error: kUnsupported unless it is a bounded solid with
/// flat faces, a ball or a union of such; kOutOfRange where it has too many digits.
void set_forms(SolidPart& part, const plane::Shape& shape, const std::vector<SolidRotation>& rotations);
/// Of which all entries are rational. Throws Error(kBadValue) for a rounded one.
SolidRotation exact_rotation(const space::Rotation& rotation);
/// In cubic units, as doubles find it; not less than the true one where balls overlap other parts.
double volume_of(const SolidProblem& problem, const SolidPart& part);
/// Of all copies, and of those in a layout.
double volume(const SolidProblem& problem);
double volume(const SolidProblem& problem, const SolidLayout& layout);
/// What a layout's container holds up to its height; its containers, the last up to what is used of it.
double container_volume(const SolidProblem& problem, const SolidLayout& layout);

/// Throws Error: a floor without area, a part wider than the floor in each of its forms.
void check(const SolidProblem& problem, const std::string& place);

}  // namespace findspace::packing
