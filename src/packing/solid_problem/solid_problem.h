// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Packing problems and layouts in space as values. A container stands on the floor 0 <= x <= width, 0 <= y <= depth,
// 0 <= z; the height that it needs is sought. Parts are unions of convex polytopes, or what closed meshes enclose, on a
// decimal grid: coordinates are integers of 10^-digits. A part stands in one of its forms, which are its shape turned
// by rotations that take axes to axes: a point q of the shape goes to at + R q. Where the convex parts of a mesh had to
// be rounded (convex_parts.h), they serve the search; proofs take the surface. Keywords: open dimension problem,
// three-dimensional strip packing, irregular packing.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "packing/problem/fraction.h"
#include "space/body/body.h"
#include "space/convolution/ray_solids.h"

namespace findspace::packing {

/// Rows of a matrix of determinant 1 whose entries are 0, 1 and -1.
using AxisRotation = std::array<std::array<int, 3>, 3>;
inline constexpr AxisRotation kAsGiven{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
/// All 24, or the four about the z axis.
std::vector<AxisRotation> axis_rotations(bool upright);

/// A shape as it can stand.
struct SolidForm {
  AxisRotation rotation = kAsGiven;
  space::Body body;                           // convex parts without radius
  std::vector<space::RaySolid> surface = {};  // the boundary of what they stand for; may be missing where exact

  bool is_exact() const { return body.rounded == 0; }
};
/// A form that is as given, turned.
SolidForm turned(const SolidForm& form, const AxisRotation& rotation);

struct SolidPart {
  std::string name;
  int demand = 1;
  std::vector<SolidForm> forms;  // at least one
  bool disjoint = true;          // no two convex parts of a form overlap
};

/// Low and high corners in grid steps.
struct SolidBox {
  std::array<Fraction, 3> low, high;
};

struct SolidProblem {
  std::string name;
  int digits = 0;         // the grid: steps of 10^-digits
  Fraction width, depth;  // of the floor, along x and y
  Fraction gap;           // the least distance of any two parts; at 0 they may touch
  Fraction edge;          // the least distance of a part to the walls, the floor and the lid
  std::vector<SolidPart> parts;

  int128 steps() const { return power_of_ten(digits); }  // in a unit
  std::size_t items() const;                             // the sum of demands
};

struct SolidPlaced {
  std::size_t part = 0;
  int copy = 1;
  std::size_t form = 0;  // of the part's
  std::array<Fraction, 3> at;
};

struct SolidLayout {
  Fraction height;
  std::vector<SolidPlaced> items;
};

/// The scale at which two bodies have whole coordinates both, where that is in range.
std::optional<std::int64_t> common_scale(const space::Body& a, const space::Body& b);
/// A whole number of units or a part of one, in steps of which `steps` are a unit.
exact::Real in_steps(const Fraction& value, int128 steps);
/// The least box about the form, in units.
SolidBox box_of(const SolidProblem& problem, const SolidForm& form);
inline const SolidForm& form_of(const SolidProblem& problem, const SolidPlaced& item) {
  return problem.parts[item.part].forms[item.form];
}
/// Whether it stands on the floor within the edges.
bool fits(const SolidProblem& problem, const SolidBox& box);
/// In cubic units, as doubles find it; not less than the true one where convex parts overlap.
double volume_of(const SolidProblem& problem, const SolidPart& part);
/// Of all copies.
double volume(const SolidProblem& problem);

/// Throws Error: a floor without area, a part wider than the floor in each of its forms.
void check(const SolidProblem& problem, const std::string& place);

}  // namespace findspace::packing
